#include "ui/sheets/results/curve_results.h"

#include "ui/sheets/shown_sheet.h"

namespace kriva::ui {
namespace {

/// None without a curve; that it is incomplete is one as well.
std::vector<Result> resultsOf(const std::optional<Curve>& curve) {
    if (!curve)
        return {};
    if (isIncomplete(*curve))
        return {{Caption::incomplete, {}, std::string()}};
    return results(*curve);
}

std::optional<Curve> activeOnView(const ShownSheet& sheet) {
    const Curve* curve = sheet.shown(sheet.activeSerial());
    return curve ? std::optional(*curve) : std::nullopt;
}

} // namespace

CurveResults::CurveResults(ShownSheet& sheet, QObject* parent)
    : QObject(parent)
    , work_([this, &sheet]() -> LatestWork::Work {
        return [this, curve = activeOnView(sheet)]() -> LatestWork::Take {
            return [this, results = resultsOf(curve)] { take(results); };
        };
    }) {
    connect(&sheet.document(), &OpenDocument::replaced, &work_, &LatestWork::startOver);
    connect(&sheet.document(), &OpenDocument::curvesChanged, &work_, &LatestWork::startOver);
    connect(&sheet.document(), &OpenDocument::viewChanged, &work_, &LatestWork::startOver);
    connect(&sheet, &ShownSheet::shownCurveChanged, &work_, [this, &sheet](Serial serial) {
        if (serial == sheet.activeSerial())
            work_.doSoon();
    });
}

void CurveResults::take(std::vector<Result> results) {
    results_ = std::move(results);
    Q_EMIT changed();
}

} // namespace kriva::ui
