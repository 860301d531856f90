#include "ui/canvas/canvas_scene.h"

#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

// More points than this are not drawn in a frame if fewer, further apart, can stand for them.
constexpr std::size_t kMostPointsInFrame = 20'000;
constexpr double kCoarsestSpacing = 8; ///< pixels

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
    entry.item->setZValue(curve.isOnTop ? 2 : entry.isActive ? 1 : 0);
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::setSelection(Selection selection) {
    selection_ = std::move(selection);
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::setHovered(std::optional<GripRef> grip) {
    if (std::exchange(hovered_, grip) == grip)
        return;
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::setGhost(std::optional<Point> place) {
    if (std::exchange(ghost_, place) != place)
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
    if (std::exchange(sight_.devicePixelRatio, ratio) != ratio)
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
    colors_ = {palette.color(QPalette::Highlight), grid_.ink};
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
        std::size_t count = 0;
        for (Entry& entry : entries_) {
            if (!entry.isPrepared)
                entry.item->prepare(sight_);
            entry.isPrepared = true;
            count += entry.item->pointCount();
        }
        if (count <= kMostPointsInFrame || sight_.fineness.spacing >= kCoarsestSpacing)
            return;
        sight_.fineness.spacing *= 2;
        for (Entry& entry : entries_)
            entry.isPrepared = false;
    }
}

void CanvasScene::prepareHighlights() {
    const std::optional<Point> hovered = hovered_ ? placeOf(*hovered_) : std::nullopt;
    highlights_ = highlights(selectedPlaces(), hovered, colors_, sight_.viewport, sight_.devicePixelRatio);
    areHighlightsPrepared_ = true;
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
        all = united(all, boxOf(entry.item->figure()));
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
    if (ghost_)
        paintGhost(*painter, sight_.viewport.toPixels(*ghost_), colors_);
    if (band_)
        paintRubberBand(*painter, *band_, colors_);
}

} // namespace kriva::ui
