#include "core/io/svg/paths/svg_transform.h"

#include "core/io/svg/paths/svg_scanner.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace kriva {
namespace {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

Affine rotation(double degrees) {
    const double cosine = std::cos(radians(degrees));
    const double sine = std::sin(radians(degrees));
    return {cosine, sine, -sine, cosine, 0, 0};
}

std::optional<Affine> transformOf(std::string_view name, const std::vector<double>& n) {
    const std::size_t count = n.size();
    if (name == "matrix" && count == 6)
        return Affine{n[0], n[1], n[2], n[3], n[4], n[5]};
    if (name == "translate" && (count == 1 || count == 2))
        return translation({n[0], count == 2 ? n[1] : 0});
    if (name == "scale" && (count == 1 || count == 2))
        return scaling(n[0], count == 2 ? n[1] : n[0]);
    if (name == "rotate" && count == 1)
        return rotation(n[0]);
    if (name == "rotate" && count == 3)
        return translation({n[1], n[2]}) * rotation(n[0]) * translation({-n[1], -n[2]});
    if (name == "skewX" && count == 1)
        return Affine{1, 0, std::tan(radians(n[0])), 1, 0, 0};
    if (name == "skewY" && count == 1)
        return Affine{1, std::tan(radians(n[0])), 0, 1, 0, 0};
    return {};
}

} // namespace

std::optional<Affine> readTransform(std::string_view text) {
    constexpr std::size_t kMostNumbers = 6;
    SvgScanner scanner(text);
    Affine all;
    scanner.skipBlanks();
    while (!scanner.isAtEnd()) {
        const std::string_view name = scanner.letters();
        scanner.skipBlanks();
        if (!scanner.take('('))
            return {};
        scanner.skipBlanks();
        std::vector<double> numbers;
        while (numbers.size() <= kMostNumbers) {
            const std::optional<double> number = scanner.number();
            if (!number)
                break;
            numbers.push_back(*number);
        }
        const std::optional<Affine> next = transformOf(name, numbers);
        if (!next || !scanner.take(')'))
            return {};
        all = all * *next;
        scanner.skipSeparator();
    }
    return all;
}

} // namespace kriva
