#include "ui/canvas/canvas_scene.h"

#include "ui/canvas/base/qt_geometry.h"
#include "ui/canvas/drawing/difference.h"

#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <array>
#include <utility>

namespace kriva::ui {

CanvasScene::CanvasScene(QObject* parent)
    : QGraphicsScene(parent) {
    setItemIndexMethod(NoIndex);
}

void CanvasScene::setCurves(std::vector<CanvasCurve> curves) {
    curves_.set(std::move(curves));
    selectedPlaces_.reset();
    areHighlightsPrepared_ = false;
    update();
    Q_EMIT curvesChanged();
}

void CanvasScene::updateCurves(std::vector<CanvasCurve> curves) {
    const bool areAllDue = std::ranges::all_of(curves, &CanvasCurve::isFigureDue);
    for (CanvasCurve& curve : curves)
        curves_.update(std::move(curve));
    if (areAllDue)
        return;
    selectedPlaces_.reset();
    updateIn(curves_.prepare(sight_));
    followHighlights();
    Q_EMIT curvesChanged();
}

void CanvasScene::updateCurve(CanvasCurve curve) {
    std::vector<CanvasCurve> one;
    one.push_back(std::move(curve));
    updateCurves(std::move(one));
}

void CanvasScene::setSelection(Selection selection) {
    const bool isChanged = selection != selection_;
    selection_ = std::move(selection);
    selectedPlaces_.reset();
    followHighlights();
    if (isChanged)
        Q_EMIT selectionChanged();
}

void CanvasScene::setHovered(std::optional<GripRef> grip) {
    if (std::exchange(hovered_, grip) != grip)
        followHighlights();
}

void CanvasScene::setPointedOut(Points places) {
    if (places == pointedOut_)
        return;
    pointedOut_ = std::move(places);
    followHighlights();
}

void CanvasScene::setGhost(std::optional<Point> place) {
    updateAround(std::exchange(ghost_, place));
    updateAround(ghost_);
}

void CanvasScene::setRubberBand(std::optional<QRectF> band) {
    band_ = band;
    update();
}

void CanvasScene::setSnap(std::optional<Snap> snap) {
    const std::optional<Snap> before = std::exchange(snap_, snap);
    for (const std::optional<Snap>& shown : {before, snap_})
        updateAround(shown ? std::optional(shown->at) : std::nullopt);
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
    if (std::exchange(grid_.hasGrid, isShown) == isShown)
        return;
    update();
    Q_EMIT gridShownChanged(isShown);
}

void CanvasScene::setAxesShown(bool areShown) {
    grid_.hasAxes = areShown;
    sight_.hasAxes = areShown;
    invalidate();
}

void CanvasScene::invalidate() {
    curves_.invalidate();
    areHighlightsPrepared_ = false;
    update();
}

void CanvasScene::prepare() {
    curves_.prepare(sight_);
    if (!areHighlightsPrepared_)
        prepareHighlights();
}

void CanvasScene::prepareHighlights() {
    const std::optional<Point> hovered = hovered_ ? curves_.placeOf(*hovered_) : std::nullopt;
    highlights_ =
        highlights(selectedPlaces(), hovered, pointedOut_, colors_, {sight_.viewport, sight_.devicePixelRatio});
    areHighlightsPrepared_ = true;
}

void CanvasScene::followHighlights() {
    const std::vector<Stamps> before = std::move(highlights_);
    prepareHighlights();
    updateIn(differenceOfEach(before, highlights_, sight_.devicePixelRatio));
}

void CanvasScene::updateIn(const Box& changed) {
    if (!changed.isEmpty())
        update(toQt(changed));
}

void CanvasScene::updateAround(std::optional<Point> place) {
    if (place)
        updateIn(grown(boxOf(std::array{sight_.viewport.toPixels(*place)}), kPlaceReach));
}

Hit CanvasScene::hitAt(QPointF pixel) {
    prepare();
    return kriva::ui::hitAt(pixel, curves_.targets(), sight_.viewport, selection_);
}

Selection CanvasScene::pointsIn(const QRectF& pixels) const {
    return kriva::ui::pointsIn(pixels, curves_.targets(), sight_.viewport);
}

std::optional<Snap> CanvasScene::snapOf(const SnappingPlace& place) const {
    return kriva::ui::snapOf(place, curves_.snapTargets(), sight_.viewport, grid_.hasGrid);
}

const Points& CanvasScene::selectedPlaces() {
    if (!selectedPlaces_)
        selectedPlaces_ = curves_.placesOf(selection_);
    return *selectedPlaces_;
}

void CanvasScene::drawBackground(QPainter* painter, const QRectF& rectangle) {
    painter->fillRect(rectangle, grid_.paper);
    paintGrid(*painter, sight_.viewport, grid_, sight_.texts);
}

void CanvasScene::drawForeground(QPainter* painter, const QRectF&) {
    for (const Stamps& stamps : highlights_)
        paint(*painter, stamps, sight_.devicePixelRatio);
    if (snap_)
        paintSnap(*painter, *snap_, colors_, sight_.viewport);
    if (ghost_)
        paintGhost(*painter, sight_.viewport.toPixels(*ghost_), colors_);
    if (band_)
        paintRubberBand(*painter, *band_, colors_);
}

} // namespace kriva::ui
