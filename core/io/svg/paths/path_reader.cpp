#include "core/io/svg/paths/path_reader.h"

#include "core/curve/limits.h"
#include "core/io/svg/paths/subpaths.h"
#include "core/io/svg/paths/svg_scanner.h"

#include <array>
#include <cmath>
#include <utility>

namespace kriva {
namespace {

class PathReader {
  public:
    explicit PathReader(std::string_view data)
        : data_(data)
        , scanner_(data) {}

    [[nodiscard]] std::variant<std::vector<Path>, FileError> read() && {
        scanner_.skipBlanks();
        while (!scanner_.isAtEnd()) {
            if (!command())
                return errorAtByte(FileProblem::notPathData, data_, scanner_.position());
            if (subpaths_.pieces() > limits::kPointsInSheet)
                return errorOfFile(FileProblem::tooManyPoints, {static_cast<double>(limits::kPointsInSheet)});
        }
        return std::move(subpaths_).take();
    }

  private:
    /// Far beyond all that can be drawn, so that relative coordinates never leave the range of doubles.
    static constexpr double kMostNumber = 1e100;

    /// What a shorthand mirrors: the last control point of a command of its own kind.
    enum class Kind { other, quadratic, cubic };

    /// The next command with its arguments, or the next arguments of the one before.
    bool command() {
        const char next = scanner_.rest().front();
        const bool isNamed = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
        if (isNamed) {
            letter_ = next;
            scanner_.take(next);
            scanner_.skipBlanks();
        } else if (letter_ == 'M' || letter_ == 'm') {
            letter_ = letter_ == 'M' ? 'L' : 'l'; // further points of a "move to" are lines
        } else if (letter_ == '\0' || letter_ == 'Z' || letter_ == 'z') {
            return false;
        }
        if (!isStarted_ && letter_ != 'M' && letter_ != 'm')
            return false;
        isStarted_ = true;
        const Kind before = std::exchange(kind_, Kind::other);
        return draw(before);
    }

    bool draw(Kind before) {
        const Vector from = isRelative() ? subpaths_.at() - Point{} : Vector{};
        switch (letter_ | 0x20) {
        case 'm':
            return take<2>([&](const auto& n) { subpaths_.moveTo(Point{n[0], n[1]} + from); });
        case 'l':
            return take<2>([&](const auto& n) { subpaths_.lineTo(Point{n[0], n[1]} + from); });
        case 'h':
            return take<1>([&](const auto& n) { subpaths_.lineTo({n[0] + from.x, subpaths_.at().y}); });
        case 'v':
            return take<1>([&](const auto& n) { subpaths_.lineTo({subpaths_.at().x, n[0] + from.y}); });
        case 'c':
            return take<6>([&](const auto& n) {
                cubicTo(Point{n[0], n[1]} + from, Point{n[2], n[3]} + from, Point{n[4], n[5]} + from);
            });
        case 's':
            return take<4>([&](const auto& n) {
                cubicTo(mirrorOf(Kind::cubic, before), Point{n[0], n[1]} + from, Point{n[2], n[3]} + from);
            });
        case 'q':
            return take<4>([&](const auto& n) { quadraticTo(Point{n[0], n[1]} + from, Point{n[2], n[3]} + from); });
        case 't':
            return take<2>([&](const auto& n) {
                quadraticTo(mirrorOf(Kind::quadratic, before), Point{n[0], n[1]} + from);
            });
        case 'a':
            return arc(from);
        case 'z':
            subpaths_.close();
            return true;
        default:
            return false;
        }
    }

    template <std::size_t count, class Draw>
    bool take(Draw draw) {
        std::array<double, count> numbers{};
        for (double& number : numbers) {
            const std::optional<double> read = scanner_.number();
            if (!read || std::abs(*read) > kMostNumber)
                return false;
            number = *read;
        }
        draw(numbers);
        return true;
    }

    bool arc(Vector from) {
        EllipticalArc arc;
        const auto shape = [&](const auto& n) {
            arc.radiusX = n[0];
            arc.radiusY = n[1];
            arc.rotation = n[2];
        };
        if (!take<3>(shape))
            return false;
        const std::optional<bool> isLarge = scanner_.flag();
        const std::optional<bool> isPositive = isLarge ? scanner_.flag() : std::nullopt;
        if (!isPositive)
            return false;
        arc.isLarge = *isLarge;
        arc.isPositive = *isPositive;
        return take<2>([&](const auto& n) { subpaths_.arcTo(arc, Point{n[0], n[1]} + from); });
    }

    void cubicTo(Point first, Point second, Point to) {
        subpaths_.cubicTo(first, second, to);
        kind_ = Kind::cubic;
        control_ = second;
    }
    void quadraticTo(Point control, Point to) {
        subpaths_.quadraticTo(control, to);
        kind_ = Kind::quadratic;
        control_ = control;
    }
    [[nodiscard]] Point mirrorOf(Kind wanted, Kind before) const {
        return before == wanted ? mirrored(control_, subpaths_.at()) : subpaths_.at();
    }
    [[nodiscard]] bool isRelative() const { return letter_ >= 'a'; }

    std::string_view data_;
    SvgScanner scanner_;
    Subpaths subpaths_;
    char letter_ = '\0';
    bool isStarted_ = false;
    Kind kind_ = Kind::other; ///< of the piece before
    Point control_;           ///< its last control point, where it is a curve
};

} // namespace

std::variant<std::vector<Path>, FileError> readPathData(std::string_view data) {
    return PathReader(data).read();
}

} // namespace kriva
