#include "core/io/svg/paths/svg_view_box.h"

#include "core/io/svg/paths/svg_scanner.h"

#include <algorithm>
#include <array>

namespace kriva {

std::optional<ViewBox> readViewBox(std::string_view text) {
    SvgScanner scanner(text);
    scanner.skipBlanks();
    std::array<double, 4> numbers{};
    for (double& number : numbers) {
        const std::optional<double> read = scanner.number();
        if (!read)
            return {};
        number = *read;
    }
    if (!scanner.isAtEnd() || !(numbers[2] > 0 && numbers[3] > 0))
        return {};
    return ViewBox{numbers[0], numbers[1], numbers[2], numbers[3]};
}

Affine mapInto(const SvgViewport& size, const ViewBox& box, bool isStretched) {
    double scaleX = size.width / box.width;
    double scaleY = size.height / box.height;
    Vector room;
    if (!isStretched) {
        scaleX = scaleY = std::min(scaleX, scaleY);
        room = {(size.width - scaleX * box.width) / 2, (size.height - scaleY * box.height) / 2};
    }
    return translation(room) * scaling(scaleX, scaleY) * translation({-box.x, -box.y});
}

} // namespace kriva
