#include "ui/canvas/drawing/stamps.h"

#include "ui/canvas/base/qt_geometry.h"
#include "ui/figures/figure_ink.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace kriva::ui {
namespace {

/// The squares of a view, and which of them hold a mark already.
class Squares {
  public:
    Squares(QSizeF size, double side)
        : side_(side)
        , columns_(static_cast<std::size_t>(size.width() / side) + 1)
        , isTaken_(columns_ * (static_cast<std::size_t>(size.height() / side) + 1)) {}

    /// False if the square of this place is taken already.
    bool take(QPointF place) {
        const auto column = static_cast<std::size_t>(place.x() / side_);
        const auto row = static_cast<std::size_t>(place.y() / side_);
        const bool wasTaken = isTaken_[row * columns_ + column];
        isTaken_[row * columns_ + column] = true;
        return !wasTaken;
    }

  private:
    double side_;
    std::size_t columns_;
    std::vector<bool> isTaken_;
};

// Every curve may have its own colour, and colours come and go while one is chosen.
constexpr std::size_t kMostPictures = 256;

[[nodiscard]] bool hasSameMarks(const RoleStyle& a, const RoleStyle& b) {
    return a.marker == b.marker && a.markerSize == b.markerSize && a.markerWidth == b.markerWidth &&
           a.color == b.color && a.markerFill == b.markerFill;
}

// So few marks are drawn twice rather than looked at for being in the same place.
constexpr std::size_t kFew = 64;

} // namespace

QPixmap markPicture(const RoleStyle& style, double devicePixelRatio) {
    const double scale = kPixelsPerPoint * devicePixelRatio;
    // An odd side has a pixel in its middle; two more leave room for antialiasing.
    const int side = 2 * static_cast<int>(std::ceil((style.markerSize + style.markerWidth) * scale / 2)) + 3;
    QPixmap picture(side, side);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMark(painter, style, {side / 2.0, side / 2.0}, scale);
    return picture;
}

QPixmap MarkPictures::picture(const RoleStyle& style, double devicePixelRatio) {
    const auto known = std::ranges::find_if(entries_, [&](const Entry& entry) {
        return entry.devicePixelRatio == devicePixelRatio && hasSameMarks(entry.style, style);
    });
    if (known != entries_.end())
        return known->picture;
    if (entries_.size() == kMostPictures)
        entries_.clear();
    return entries_.emplace_back(style, devicePixelRatio, markPicture(style, devicePixelRatio)).picture;
}

Stamps stampsAt(std::span<const Point> points, QPixmap picture, const StampView& view) {
    Stamps stamps{std::move(picture), {}};
    const QPoint middle(stamps.picture.width() / 2, stamps.picture.height() / 2);
    // A mark is seen if any of its pixels is.
    const double margin = middle.x();
    const QSizeF size = view.viewport.size * view.devicePixelRatio + QSizeF(2 * margin, 2 * margin);
    const bool areFew = points.size() <= kFew && view.spacing == 1;
    Squares squares(areFew ? QSizeF() : size, view.spacing);
    for (const Point p : points) {
        if (static_cast<double>(stamps.places.size()) > view.most)
            break;
        const QPointF pixel = view.viewport.toPixels(p) * view.devicePixelRatio;
        const QPointF place = pixel + QPointF(margin, margin);
        const bool isSeen = 0 <= place.x() && place.x() < size.width() && 0 <= place.y() && place.y() < size.height();
        if (isSeen && (areFew || squares.take(place)))
            stamps.places.push_back(pixel.toPoint() - middle);
    }
    return stamps;
}

void paint(QPainter& painter, const Stamps& stamps, double devicePixelRatio) {
    painter.save();
    painter.scale(1 / devicePixelRatio, 1 / devicePixelRatio);
    for (const QPoint place : stamps.places)
        painter.drawPixmap(place, stamps.picture);
    painter.restore();
}

} // namespace kriva::ui
