#include "core/io/svg/svg_path.h"

#include "core/io/drawn_pieces.h"
#include "core/io/plain_number.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

void append(std::string& text, char letter, std::span<const Point> points, int decimals) {
    if (!text.empty())
        text += ' ';
    text += letter;
    for (const Point p : points)
        text.append(" ").append(plainNumber(p.x, decimals)).append(",").append(plainNumber(p.y, decimals));
}

} // namespace

std::string pathData(const Path& path, const Page& page, int decimals) {
    constexpr char kLetters[] = {'M', 'L', 'Q', 'C'};
    std::string text;
    forEachDrawnPiece(path, page, [&](std::span<const Point> piece) {
        if (text.empty())
            append(text, kLetters[0], piece.first(1), decimals);
        append(text, kLetters[piece.size() - 1], piece.subspan(1), decimals);
    });
    return path.isClosed && !text.empty() ? text + " Z" : text;
}

int decimalsOf(const Page& page) {
    const double side = std::max(page.width, page.height);
    return std::max(0, 13 - static_cast<int>(std::floor(std::log10(side))));
}

} // namespace kriva
