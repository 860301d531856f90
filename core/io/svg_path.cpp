#include "core/io/svg_path.h"

#include "core/bezier/cubic_pieces.h"
#include "core/io/xml_text.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

class PathText {
  public:
    explicit PathText(int decimals)
        : decimals_(decimals) {}

    void command(char letter, std::span<const Point> points) {
        if (!text_.empty())
            text_ += ' ';
        text_ += letter;
        for (const Point p : points)
            text_.append(" ").append(plainNumber(p.x, decimals_)).append(",").append(plainNumber(p.y, decimals_));
    }
    /// A piece that goes on from where the one before ended.
    void piece(std::span<const Point> points) {
        constexpr char kLetters[] = {'L', 'Q', 'C'};
        if (points.size() <= 4)
            return command(kLetters[points.size() - 2], points.subspan(1));
        for (const Cubic& cubic : cubicPieces(points, {kCubicTolerance}))
            command('C', std::span(cubic).subspan(1));
    }
    [[nodiscard]] std::string take(bool isClosed) && {
        if (isClosed)
            text_ += " Z";
        return std::move(text_);
    }

  private:
    std::string text_;
    int decimals_;
};

} // namespace

std::string pathData(const Path& path, const Page& page, int decimals) {
    PathText text(decimals);
    Points points;
    bool isStarted = false;
    forEachPiece(path, [&](std::span<const Point> piece) {
        if (piece.size() < 2)
            return;
        points.clear();
        for (const Point p : piece)
            points.push_back(onPage(page, p));
        if (!isStarted)
            text.command('M', std::span(points).first(1));
        isStarted = true;
        text.piece(points);
    });
    return isStarted ? std::move(text).take(path.isClosed) : std::string();
}

int decimalsOf(const Page& page) {
    const double side = std::max(page.width, page.height);
    return std::max(0, 13 - static_cast<int>(std::floor(std::log10(side))));
}

} // namespace kriva
