#include "ui/canvas/drawing/difference.h"

#include "ui/canvas/base/qt_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <tuple>

namespace kriva::ui {
namespace {

// Pixels that no eye sees. The handles of a chain move all along it, each a part as far as the one before.
constexpr double kUnseen = 1.0 / 32;
// Pixels around a line or mark, for antialiasing and the rounding to device pixels.
constexpr double kMargin = 2;

/// What two lists do not share at their beginning and at their end, with `around` more elements on both sides.
template <class Element, class IsSame>
std::pair<std::span<const Element>, std::span<const Element>>
differing(std::span<const Element> a, std::span<const Element> b, std::size_t around, IsSame isSame) {
    const std::size_t shorter = std::min(a.size(), b.size());
    std::size_t front = 0;
    while (front < shorter && isSame(a[front], b[front]))
        ++front;
    if (front == a.size() && front == b.size())
        return {};
    std::size_t back = 0;
    while (back + front < shorter && isSame(a[a.size() - 1 - back], b[b.size() - 1 - back]))
        ++back;
    front -= std::min(front, around);
    back -= std::min(back, around);
    return {a.subspan(front, a.size() - front - back), b.subspan(front, b.size() - front - back)};
}

bool isNear(QPointF a, QPointF b) {
    return std::abs(a.x() - b.x()) <= kUnseen && std::abs(a.y() - b.y()) <= kUnseen;
}

std::span<const QPointF> pointsOf(const QPolygonF& polyline) {
    return {polyline.constData(), static_cast<std::size_t>(polyline.size())};
}

std::span<const QLineF> linesOf(const PreparedStroke& stroke) {
    return {stroke.lines.constData(), static_cast<std::size_t>(stroke.lines.size())};
}

/// A joint reaches to the lines on either side; dashes move along the whole of a polyline.
Box differenceOfPolylines(const QPolygonF& before, const QPolygonF& after, bool isDashed) {
    const auto [was, is] = differing(pointsOf(before), pointsOf(after), 1, isNear);
    if (was.empty() && is.empty())
        return {};
    return isDashed ? united(boxOf(pointsOf(before)), boxOf(pointsOf(after))) : united(boxOf(was), boxOf(is));
}

Box differenceOfLines(std::span<const QLineF> before, std::span<const QLineF> after) {
    const auto isSame = [](const QLineF& a, const QLineF& b) {
        return isNear(a.p1(), b.p1()) && isNear(a.p2(), b.p2());
    };
    const auto [was, is] = differing(before, after, 0, isSame);
    Box changed;
    for (const auto lines : {was, is})
        for (const QLineF& line : lines)
            changed = united(changed, boxOf(std::array{line.p1(), line.p2()}));
    return changed;
}

/// Room for a label whatever its font turns out to be.
Box roomOf(const PlacedLabel& label) {
    constexpr double kLetter = 2 * kTextSize * kPixelsPerPoint;
    const double width =
        kLetter * static_cast<double>(label.text.size() + label.subscript.size() + label.suffix.size());
    const Point at = toCore(kPixelsPerMillimetre * toQt(label.baseline));
    return {at.x - width, at.y - kLetter, at.x + width, at.y + kLetter};
}

/// Places are those of the pictures' top left corners, in device pixels.
Box roomOf(std::span<const QPoint> places, const QPixmap& picture, double devicePixelRatio) {
    Box box;
    for (const QPoint place : places) {
        extend(box, toCore(QPointF(place) / devicePixelRatio));
        extend(box, toCore(QPointF(place.x() + picture.width(), place.y() + picture.height()) / devicePixelRatio));
    }
    return box;
}

} // namespace

Box difference(const PreparedStroke& before, const PreparedStroke& after) {
    const bool isDashed = after.pen.style() == Qt::CustomDashLine || !after.dashes.empty();
    Box changed;
    if (before.pen != after.pen || before.polylines.size() != after.polylines.size())
        for (const PreparedStroke* stroke : {&before, &after})
            for (const QPolygonF& polyline : stroke->polylines)
                changed = united(changed, boxOf(pointsOf(polyline)));
    else if (!before.lines.empty() || !after.lines.empty())
        changed = differenceOfLines(linesOf(before), linesOf(after));
    else
        for (std::size_t i = 0; i < after.polylines.size(); ++i)
            changed = united(changed, differenceOfPolylines(before.polylines[i], after.polylines[i], isDashed));
    return changed.isEmpty() ? changed : grown(changed, std::max(before.pen.widthF(), after.pen.widthF()) + kMargin);
}

Box difference(const Stamps& before, const Stamps& after, double devicePixelRatio) {
    std::span<const QPoint> was = before.places;
    std::span<const QPoint> is = after.places;
    if (before.picture.cacheKey() == after.picture.cacheKey())
        std::tie(was, is) = differing(was, is, 0, std::equal_to<QPoint>());
    const Box changed =
        united(roomOf(was, before.picture, devicePixelRatio), roomOf(is, after.picture, devicePixelRatio));
    return changed.isEmpty() ? changed : grown(changed, kMargin);
}

Box difference(const std::vector<PlacedLabel>& before, const std::vector<PlacedLabel>& after) {
    const auto [was, is] = differing(std::span<const PlacedLabel>(before), std::span<const PlacedLabel>(after), 0,
                                     std::equal_to<PlacedLabel>());
    Box changed;
    for (const auto labels : {was, is})
        for (const PlacedLabel& label : labels)
            changed = united(changed, roomOf(label));
    return changed;
}

} // namespace kriva::ui
