#include "core/figure/label_placement.h"

#include "core/figure/obstacles.h"
#include "core/figure/role_style.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <tuple>

namespace kriva {
namespace {

// The shape of a text in parts of its size, as in common serif fonts.
constexpr double kLetterWidth = 0.52;
constexpr double kCapitalHeight = 0.68;
constexpr double kMiddleHeight = 0.31; ///< of small letters and capitals alike, above the baseline
constexpr double kDescent = 0.08;
constexpr double kSubscriptDescent = 0.26;

/// Between a point and its label, in millimetres: the half of a mark and a little air.
constexpr double kDistance = 1.5;

/// Between two labels, in millimetres.
constexpr double kAir = 0.4;

constexpr std::size_t kMostSearched = 300;

/// From the point towards the label; in page coordinates, so y grows downwards.
constexpr double kHalf = 1 / std::numbers::sqrt2;
constexpr std::array<Vector, 8> kDirections{
    {{kHalf, -kHalf}, {0, -1}, {-kHalf, -kHalf}, {1, 0}, {-1, 0}, {kHalf, kHalf}, {0, 1}, {-kHalf, kHalf}}};

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The number of characters, not of bytes.
double lengthOf(std::string_view utf8) {
    return static_cast<double>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

PlacedLabel unplaced(const Label& label, const TextSource& texts) {
    PlacedLabel placed;
    if (label.caption != Caption::none)
        placed.text = texts.translate(label.caption);
    if (label.caption != Caption::none && (label.number || !label.text.empty()))
        placed.text += "\u00a0"; // "Run 3" stays on one line
    if (label.number)
        placed.text += texts.number(label.number->value, label.number->decimals);
    placed.text += label.text;
    placed.subscript = label.subscript;
    placed.suffix = label.suffix;
    placed.isVariable = placed.text == label.text && label.text.size() == 1 && isLetter(label.text[0]);
    placed.role = label.role;
    return placed;
}

Box boxBeside(Point point, Vector direction, const PlacedLabel& label) {
    constexpr double kText = kTextSize * kMillimetresPerPoint;
    constexpr double kSubscript = kSubscriptSize * kMillimetresPerPoint;
    const double width = kLetterWidth * (kText * (lengthOf(label.text) + lengthOf(label.suffix)) +
                                         kSubscript * lengthOf(label.subscript));
    const double height = kText * (kCapitalHeight + (label.subscript.empty() ? kDescent : kSubscriptDescent));
    // The label touches the circle around its point with the middle of a side or with a corner.
    const Point touch = point + kDistance * direction;
    const auto start = [](double at, double size, double towards) {
        return towards > 0.1 ? at : towards < -0.1 ? at - size : at - size / 2;
    };
    const double x = start(touch.x, width, direction.x);
    const double y = start(touch.y, height, direction.y);
    return {x, y, x + width, y + height};
}

void put(PlacedLabel& label, Point point, Vector direction) {
    constexpr double kText = kTextSize * kMillimetresPerPoint;
    const Box box = boxBeside(point, direction, label);
    const bool isBeside = std::abs(direction.y) < 0.1;
    label.anchor = direction.x > 0.1 ? TextAnchor::start : direction.x < -0.1 ? TextAnchor::end : TextAnchor::middle;
    label.baseline = {point.x + kDistance * direction.x,
                      isBeside ? point.y + kMiddleHeight * kText : box.ymin + kCapitalHeight * kText};
}

/// Away from the neighbours of a point in the list of labels: outwards of a polygon's corner, straight on behind its
/// ends. Nothing where the neighbours are in its place.
Vector outwards(std::span<const Point> points, std::size_t index) {
    const auto towards = [&](std::size_t neighbour) {
        const Vector way = points[neighbour] - points[index];
        return length(way) > 0 ? way / length(way) : Vector{};
    };
    const Vector before = index > 0 ? towards(index - 1) : Vector{};
    const Vector after = index + 1 < points.size() ? towards(index + 1) : Vector{};
    const Vector sum = -(before + after);
    if (length(sum) > 0.05)
        return sum / length(sum);
    // In the middle of a straight line: to its upper side.
    const Vector across{after.y, -after.x};
    return across.y > 0 ? -across : across;
}

/// Where a label asks to stand; nothing for the side that labels have unless they ask.
Vector asked(LabelSide side) {
    switch (side) {
    case LabelSide::aboveRight:
        break;
    case LabelSide::aboveLeft:
        return {-kHalf, -kHalf};
    case LabelSide::belowLeft:
        return {-kHalf, kHalf};
    case LabelSide::belowRight:
        return {kHalf, kHalf};
    case LabelSide::left:
        return {-1, 0};
    case LabelSide::right:
        return {1, 0};
    case LabelSide::above:
        return {0, -1};
    case LabelSide::below:
        return {0, 1};
    }
    return {};
}

bool isExact(LabelSide side) {
    return side == LabelSide::left || side == LabelSide::right || side == LabelSide::above || side == LabelSide::below;
}

/// What stands in the way of a label, in millimetres of line that it would hide and the like.
double cost(const Box& box, const Obstacles& obstacles, const Page& page) {
    constexpr double kOutside = 100;
    const bool isInside = box.xmin >= 0 && box.ymin >= 0 && box.xmax <= page.width && box.ymax <= page.height;
    return obstacles.covered(box) + (isInside ? 0 : kOutside);
}

/// The best direction for a label: clear of obstacles first, the wanted way second, up and right last.
Vector bestDirection(const PlacedLabel& label, Point point, Vector wanted, const Obstacles& obstacles,
                     const Page& page) {
    Vector best;
    double least = std::numeric_limits<double>::infinity();
    for (const Vector direction : kDirections) {
        const double turn = 1 - dot(direction, wanted);
        constexpr double kTurnCost = 0.8;
        const double total = kTurnCost * turn + cost(boxBeside(point, direction, label), obstacles, page);
        if (total < least - 1e-9) { // rounding does not choose among directions that are equally good
            least = total;
            best = direction;
        }
    }
    return best;
}

std::vector<Label> withoutRepetition(const std::vector<Label>& labels) {
    std::vector<Label> different;
    std::set<std::tuple<double, double, std::string_view, double, std::string_view, std::string_view, std::string_view>>
        known;
    for (const Label& label : labels)
        if (known
                .emplace(label.at.x, label.at.y, label.caption.words(), label.number ? label.number->value : 0,
                         label.text, label.subscript, label.suffix)
                .second)
            different.push_back(label);
    return different;
}

} // namespace

std::vector<std::vector<PlacedLabel>> placedLabels(const Figure& figure, const Page& page, const TextSource& texts) {
    std::size_t count = 0;
    for (const Layer& layer : figure.layers)
        count += layer.labels.size();
    Obstacles obstacles = count > 0 && count <= kMostSearched ? obstaclesOf(figure, page) : Obstacles();
    std::vector<std::vector<PlacedLabel>> result;
    for (const Layer& layer : figure.layers) {
        const std::vector<Label> labels = withoutRepetition(layer.labels);
        Points points;
        for (const Label& label : labels)
            points.push_back(onPage(page, label.at));
        std::vector<PlacedLabel>& placed = result.emplace_back();
        for (std::size_t i = 0; i < labels.size(); ++i) {
            PlacedLabel label = unplaced(labels[i], texts);
            const Vector wanted = outwards(points, i) + asked(labels[i].side);
            const Vector direction = isExact(labels[i].side) ? asked(labels[i].side)
                                                             : bestDirection(label, points[i], wanted, obstacles, page);
            put(label, points[i], direction);
            if (count <= kMostSearched)
                obstacles.addText(grown(boxBeside(points[i], direction, label), kAir));
            placed.push_back(std::move(label));
        }
    }
    return result;
}

} // namespace kriva
