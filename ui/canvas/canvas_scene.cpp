#include "ui/canvas/canvas_scene.h"

#include "ui/canvas/qt_geometry.h"

#include <QPainter>
#include <QPalette>

#include <algorithm>

namespace kriva::ui {
namespace {

// More points than this are not drawn in a frame if fewer, further apart, can stand for them.
constexpr std::size_t kMostPointsInFrame = 20'000;
constexpr double kCoarsestSpacing = 8; ///< pixels
constexpr double kBandOpacity = 0.15;

// Selected and hovered grips are larger than any mark and differ from each other without colour, too: filled and ring.
constexpr double kSelectedSize = 6; ///< points
constexpr double kHoveredSize = 8.5;
constexpr double kHighlightOutline = 1.2;

[[nodiscard]] Color toColor(const QColor& color) {
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

} // namespace

CanvasScene::CanvasScene(QObject* parent)
    : QGraphicsScene(parent) {
    setItemIndexMethod(NoIndex);
}

void CanvasScene::setCurves(std::vector<CanvasCurve> curves) {
    clear();
    entries_.clear();
    entries_.reserve(curves.size());
    for (CanvasCurve& curve : curves) {
        Entry& entry = entries_.emplace_back();
        entry.serial = curve.serial;
        entry.item = new FigureItem;
        addItem(entry.item);
        fill(entry, std::move(curve));
    }
}

void CanvasScene::updateCurve(CanvasCurve curve) {
    const auto entry = std::ranges::find(entries_, curve.serial, &Entry::serial);
    if (entry != entries_.end())
        fill(*entry, std::move(curve));
}

void CanvasScene::fill(Entry& entry, CanvasCurve curve) {
    entry.grips = std::move(curve.grips);
    entry.isActive = curve.isActive;
    entry.isPrepared = false;
    entry.item->setFigure(std::move(curve.figure));
    entry.item->setZValue(entry.isActive ? 1 : 0);
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::setSelection(Selection selection) {
    selection_ = std::move(selection);
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::setHovered(std::optional<GripRef> grip) {
    if (hovered_ == grip)
        return;
    hovered_ = grip;
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::setRubberBand(std::optional<QRectF> band) {
    band_ = band;
    update();
}

void CanvasScene::setMapping(const Viewport& mapping) {
    sight_.viewport = mapping;
    setSceneRect(sight_.rectangle());
    invalidate();
}

void CanvasScene::setDevicePixelRatio(double ratio) {
    if (sight_.devicePixelRatio == ratio)
        return;
    sight_.devicePixelRatio = ratio;
    invalidate();
}

void CanvasScene::setTheme(Theme theme) {
    sight_.theme = theme;
    invalidate();
}

void CanvasScene::setTexts(TextSource texts) {
    sight_.texts = std::move(texts);
    invalidate();
}

void CanvasScene::setColorsAndFont(const QPalette& palette, const QFont& font) {
    grid_.font = font;
    grid_.ink = palette.color(QPalette::Text);
    grid_.paper = palette.color(QPalette::Base);
    highlight_ = palette.color(QPalette::Highlight);
    invalidate();
}

void CanvasScene::setGridShown(bool isShown) {
    grid_.hasGrid = isShown;
    update();
}

void CanvasScene::setAxesShown(bool areShown) {
    grid_.hasAxes = areShown;
    update();
}

void CanvasScene::invalidate() {
    for (Entry& entry : entries_)
        entry.isPrepared = false;
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::prepare() {
    prepareItems();
    if (!areHighlightsPrepared_)
        prepareHighlights();
}

void CanvasScene::prepareItems() {
    // A new view starts finer than the last one needed: what was crowded may be gone.
    if (std::ranges::none_of(entries_, &Entry::isPrepared))
        sight_.fineness.spacing = std::max(Fineness().spacing, sight_.fineness.spacing / 2);
    for (;;) {
        for (Entry& entry : entries_)
            if (!entry.isPrepared)
                entry.item->prepare(sight_);
        for (Entry& entry : entries_)
            entry.isPrepared = true;
        if (pointCount() <= kMostPointsInFrame || sight_.fineness.spacing >= kCoarsestSpacing)
            return;
        sight_.fineness.spacing *= 2;
        for (Entry& entry : entries_)
            entry.isPrepared = false;
    }
}

void CanvasScene::prepareHighlights() {
    Points hovered;
    if (hovered_)
        if (const auto at = placeOf(*hovered_))
            hovered.push_back(*at);
    const Color accent = toColor(highlight_);
    const RoleStyle filled{toColor(grid_.ink), 0, {}, Marker::circle, kSelectedSize, kHighlightOutline, accent};
    const RoleStyle ring{accent, 0, {}, Marker::ring, kHoveredSize, kHighlightOutline, {}};
    const double ratio = sight_.devicePixelRatio;
    highlights_ = {stampsAt(selectedPlaces(), markPicture(filled, ratio), sight_.viewport, ratio),
                   stampsAt(hovered, markPicture(ring, ratio), sight_.viewport, ratio)};
    areHighlightsPrepared_ = true;
}

std::size_t CanvasScene::pointCount() const {
    std::size_t count = 0;
    for (const Entry& entry : entries_)
        count += entry.item->pointCount();
    return count;
}

std::vector<HitTarget> CanvasScene::targets() const {
    std::vector<HitTarget> found;
    found.reserve(entries_.size());
    for (const Entry& entry : entries_)
        found.push_back({entry.serial, entry.isActive, entry.grips, entry.item->curveLines()});
    return found;
}

Hit CanvasScene::hitAt(QPointF pixel) {
    prepare();
    return kriva::ui::hitAt(pixel, targets(), sight_.viewport, selection_);
}

Selection CanvasScene::pointsIn(const QRectF& pixels) const {
    return kriva::ui::pointsIn(pixels, targets(), sight_.viewport);
}

std::vector<GripRef> CanvasScene::points() const {
    std::vector<GripRef> found;
    for (const Entry& entry : entries_)
        for (const Grip& grip : entry.grips)
            if (grip.id.kind == GripKind::point)
                found.push_back({entry.serial, grip.id});
    return found;
}

std::optional<Point> CanvasScene::placeOf(const GripRef& grip) const {
    const auto entry = std::ranges::find(entries_, grip.serial, &Entry::serial);
    if (entry == entries_.end())
        return std::nullopt;
    const auto found = std::ranges::find(entry->grips, grip.id, &Grip::id);
    return found == entry->grips.end() ? std::nullopt : std::optional(found->at);
}

Box CanvasScene::box() const {
    Box all;
    for (const Entry& entry : entries_) {
        all = united(all, controlBox(entry.item->figure()));
        for (const Grip& grip : entry.grips)
            extend(all, grip.at);
    }
    return all;
}

Points CanvasScene::selectedPlaces() const {
    Points places;
    for (const Entry& entry : entries_)
        for (const Grip& grip : entry.grips)
            if (selection_.contains({entry.serial, grip.id}))
                places.push_back(grip.at);
    return places;
}

void CanvasScene::drawBackground(QPainter* painter, const QRectF& rectangle) {
    painter->fillRect(rectangle, grid_.paper);
    paintGrid(*painter, sight_.viewport, grid_, sight_.texts);
}

void CanvasScene::drawForeground(QPainter* painter, const QRectF&) {
    for (const Stamps& stamps : highlights_)
        paint(*painter, stamps, sight_.devicePixelRatio);
    if (!band_)
        return;
    QColor fill = highlight_;
    fill.setAlphaF(static_cast<float>(kBandOpacity));
    painter->setPen(highlight_);
    painter->setBrush(fill);
    painter->drawRect(*band_);
}

} // namespace kriva::ui
