#include "ui/sheets/canvas_content.h"

#include "core/figure/page.h"
#include "ui/sheets/curve_name.h"

namespace kriva::ui {
namespace {

constexpr double kPixelsPerMillimetre = 96 / 25.4;

} // namespace

CanvasContent::CanvasContent(const ShownSheet& sheet, const SheetRelations& relations, CanvasView& canvas)
    : sheet_(sheet)
    , relations_(relations)
    , canvas_(canvas) {
    const auto ifMine = [this](SheetIndex changed) {
        if (changed == sheet_.index())
            showAll();
    };
    OpenDocument& document = sheet.document();
    connect(&document, &OpenDocument::replaced, this, &CanvasContent::start);
    connect(&document, &OpenDocument::curvesChanged, this, ifMine);
    connect(&document, &OpenDocument::viewChanged, this, ifMine);
    connect(&sheet, &ShownSheet::shownCurveChanged, this, &CanvasContent::update);
    connect(&sheet, &ShownSheet::selectionChanged, this, [this] { canvas_.setSelection(sheet_.selection()); });
    connect(&sheet, &ShownSheet::pointedOutChanged, this, [this](bool areNew) {
        const Points& places = sheet_.pointedOut();
        canvas_.setPointedOut(places);
        if (areNew && !places.empty())
            canvas_.reveal(places.front());
    });
    connect(&relations, &SheetRelations::changed, this, [this] { canvas_.updateCurve(this->relations()); });
}

CanvasCurve CanvasContent::curve(Serial serial) const {
    const Curve& curve = *sheet_.shown(serial);
    const int index = *sheet_.document().indexOf(sheet_.index(), serial);
    CanvasCurve shown;
    shown.serial = serial;
    shown.isActive = serial == sheet_.activeSerial();
    shown.name = curveName(curve, index);
    if (viewOf(curve).isShown) {
        FigureContext context = contextOf(sheet_.sheet(), index);
        if (shown.isActive)
            context.stage = sheet_.layerStage();
        shown.figure = shownLayers(figureOf(curve, context), layersOf(sheet_.index()), context);
        shown.grips = drawnGrips(curve, context);
    }
    return shown;
}

CanvasCurve CanvasContent::relations() const {
    CanvasCurve shown;
    shown.isOnTop = true;
    shown.figure = shownLayers(relations_.relations().figure, layersOf(sheet_.index()), {.view = &sheet_.sheet().view});
    return shown;
}

void CanvasContent::start() {
    showAll();
    followPage();
    canvas_.fitAll();
    canvas_.setTool(Tool::edit); // a click adds nothing that nobody asked for, in an empty sheet either
}

void CanvasContent::showAll() {
    std::vector<CanvasCurve> curves;
    for (const Serial serial : sheet_.document().serials(sheet_.index()))
        curves.push_back(curve(serial));
    curves.push_back(relations());
    canvas_.setCurves(std::move(curves));
    canvas_.setGhost(std::nullopt);
    canvas_.setSelection(sheet_.selection());
}

void CanvasContent::update(Serial serial) {
    canvas_.updateCurve(curve(serial));
    canvas_.setGhost(std::nullopt); // the next move of the pointer shows it where it is then
}

void CanvasContent::followPage() {
    const Box box = boxOf(figureOfCurves(sheet_.sheet(), sheet_.index()));
    canvas_.setUnitScale(pageOf(box, sheet_.sheet().view.mmPerUnit).mmPerUnit * kPixelsPerMillimetre);
}

} // namespace kriva::ui
