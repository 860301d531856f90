#include "ui/editing/canvas_content.h"

#include "core/document/sheet_figure.h"
#include "core/figure/style/page.h"
#include "ui/editing/sheet/curve_name.h"

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

constexpr double kPixelsPerMillimetre = 96 / 25.4;

// Steps of 25 nanoseconds: what is drawn within the frame, and what is drawn beside it before the rest has its turn.
constexpr std::uint64_t kStepsOfFrame = 1'600'000;
constexpr std::uint64_t kStepsOfBatch = 4'000'000;

} // namespace

CanvasContent::CanvasContent(const ShownSheet& sheet, const SheetRelations& relations, CanvasView& canvas)
    : sheet_(sheet)
    , relations_(relations)
    , canvas_(canvas)
    , worker_(sheet.workers(), [this](std::vector<CanvasCurve> drawn) { take(std::move(drawn)); }) {
    const auto ifMine = [this](SheetIndex changed) {
        if (changed == sheet_.index())
            showAll();
    };
    OpenDocument& document = sheet.document();
    connect(&document, &OpenDocument::replaced, this, &CanvasContent::start);
    connect(&document, &OpenDocument::curvesChanged, this, ifMine);
    connect(&document, &OpenDocument::viewChanged, this, ifMine);
    connect(&sheet, &ShownSheet::shownCurveChanged, this, &CanvasContent::update);
    connect(&sheet, &ShownSheet::selectionChanged, this, [this] { canvas_.scene().setSelection(sheet_.selection()); });
    connect(&sheet, &ShownSheet::pointedOutChanged, this, [this](bool areNew) {
        const Points& places = sheet_.pointedOut();
        canvas_.scene().setPointedOut(places);
        if (areNew && !places.empty())
            canvas_.reveal(places.front());
    });
    connect(&relations, &SheetRelations::changed, this, [this] { canvas_.scene().updateCurve(this->relations()); });
}

bool CanvasContent::isShown(Serial serial) const {
    return viewOf(*sheet_.shown(serial)).isShown;
}

FigureContext CanvasContent::contextOf(Serial serial) const {
    const int index = *sheet_.document().indexOf(sheet_.index(), serial);
    return kriva::contextOf(sheet_.sheet(), index, sheet_.layerStage());
}

CanvasCurve CanvasContent::undrawn(Serial serial) const {
    CanvasCurve curve;
    curve.serial = serial;
    curve.isActive = serial == sheet_.activeSerial();
    curve.name = curveName(*sheet_.shown(serial), *sheet_.document().indexOf(sheet_.index(), serial));
    return curve;
}

CanvasCurve CanvasContent::drawnNow(Serial serial) const {
    CanvasCurve curve = undrawn(serial);
    WorkBudget unlimited;
    if (isShown(serial))
        (void)draw(curve, *sheet_.shown(serial), contextOf(serial), unlimited);
    return curve;
}

CanvasCurve CanvasContent::due(Serial serial) const {
    CanvasCurve curve = undrawn(serial);
    DrawnCurve points = drawnPoints(*sheet_.shown(serial), contextOf(serial));
    curve.figure = std::move(points.figure);
    curve.grips = std::move(points.grips);
    curve.isFigureDue = true;
    return curve;
}

std::uint64_t CanvasContent::stepsToDraw(Serial serial) const {
    return isShown(serial) ? drawingSteps(*sheet_.shown(serial)) : 0;
}

CanvasCurve CanvasContent::relations() const {
    CanvasCurve shown;
    shown.isOnTop = true;
    shown.figure = figureOfRelations(sheet_.sheet(), sheet_.index(), relations_.relations());
    return shown;
}

void CanvasContent::start() {
    isNew_ = true;
    showAll();
    followPage();
    canvas_.fitAll();
    canvas_.setTool(Tool::edit); // a click adds nothing that nobody asked for, in an empty sheet either
}

void CanvasContent::showAll() {
    worker_.cancel();
    due_.clear();
    const std::vector<Serial>& serials = sheet_.document().serials(sheet_.index());
    std::uint64_t steps = 0;
    for (const Serial serial : serials)
        steps += stepsToDraw(serial);
    std::vector<CanvasCurve> curves;
    for (const Serial serial : serials) {
        const bool isDue = steps > kStepsOfFrame && isShown(serial);
        curves.push_back(isDue ? due(serial) : drawnNow(serial));
        if (isDue)
            due_.push_back(serial);
    }
    curves.push_back(relations());
    canvas_.scene().setCurves(std::move(curves));
    canvas_.scene().setGhost(std::nullopt);
    canvas_.scene().setSelection(sheet_.selection());
    isNew_ = isNew_ && !due_.empty();
    drawNext();
}

void CanvasContent::update(Serial serial) {
    const bool isFirstDue = worker_.isWorking(); // what it draws may be this curve, as it was
    if (isFirstDue || stepsToDraw(serial) > kStepsOfFrame) {
        canvas_.scene().updateCurve(due(serial));
        std::erase(due_, serial);
        due_.insert(due_.begin(), serial);
        drawNext();
    } else {
        canvas_.scene().updateCurve(drawnNow(serial));
    }
    canvas_.scene().setGhost(std::nullopt); // the next move of the pointer shows it where it is then
}

void CanvasContent::drawNext() {
    if (worker_.isWorking() || due_.empty())
        return;
    std::vector<CurveToDraw> batch;
    std::uint64_t steps = 0;
    std::size_t count = 0;
    while (count < due_.size() && steps < kStepsOfBatch) {
        const Serial serial = due_[count++];
        steps += stepsToDraw(serial);
        batch.push_back({undrawn(serial), sheet_.snapshot(serial), contextOf(serial)});
    }
    due_.erase(due_.begin(), due_.begin() + static_cast<std::ptrdiff_t>(count));
    worker_.start(std::move(batch), sheet_.sheet().view);
}

void CanvasContent::take(std::vector<CanvasCurve> drawn) {
    for (CanvasCurve& curve : drawn) // what changed meanwhile is taken hold of as it is now
        if (std::ranges::find(due_, curve.serial) != due_.end())
            curve.grips = due(curve.serial).grips;
    canvas_.scene().updateCurves(std::move(drawn));
    if (due_.empty() && std::exchange(isNew_, false)) {
        followPage();
        canvas_.fitAllAgain();
    }
    drawNext();
}

void CanvasContent::followPage() {
    const Box box = canvas_.scene().curves().boxOfFigures();
    canvas_.setUnitScale(pageOf(box, sheet_.sheet().view.mmPerUnit).mmPerUnit * kPixelsPerMillimetre);
}

} // namespace kriva::ui
