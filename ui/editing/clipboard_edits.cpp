#include "ui/editing/clipboard_edits.h"

#include "core/document/sheet_figure.h"
#include "core/figure/style/page.h"
#include "ui/clipboard/clip.h"
#include "ui/editing/sheet_editor.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>

namespace kriva::ui {
namespace {

[[nodiscard]] std::optional<Fragment> selectedFragment(const SheetEditor& editor) {
    const Curve* curve = editor.activeCurve();
    if (!curve)
        return {};
    const std::vector<int> points = editor.selectedPoints();
    return points.empty() ? Fragment{Fragment::Content::curve, *curve} : fragmentOf(*curve, points);
}

[[nodiscard]] double pageScale(const SheetEditor& editor) {
    return pageOf(boxOf(figureOfCurves(editor.sheet(), editor.index())), editor.sheet().view.mmPerUnit).mmPerUnit;
}

} // namespace

bool copyToClipboard(const SheetEditor& editor) {
    const std::optional<Fragment> fragment = selectedFragment(editor);
    if (fragment)
        QGuiApplication::clipboard()->setMimeData(clipOf(*fragment, pageScale(editor)).release());
    return fragment.has_value();
}

void cutToClipboard(SheetEditor& editor) {
    editor.document().endGesture();
    if (!copyToClipboard(editor))
        return;
    const std::vector<int> points = editor.selectedPoints();
    if (points.empty())
        editor.deleteCurve(editor.activeSerial(), {QT_TRANSLATE_NOOP("Step", "Cut the curve")});
    else
        editor.removePoints(editor.activeSerial(), points, Removal::refitted,
                            StepLabel{QT_TRANSLATE_NOOP("Step", "Cut points")});
}

QString pasteFromClipboard(SheetEditor& editor) {
    const QMimeData nothing;
    const QMimeData* clip = QGuiApplication::clipboard()->mimeData();
    auto read = readClip(clip ? *clip : nothing, editor.index());
    if (const QString* refusal = std::get_if<QString>(&read))
        return *refusal;
    if (std::vector<Curve>* curves = std::get_if<std::vector<Curve>>(&read)) {
        editor.addCurves(std::move(*curves), {QT_TRANSLATE_NOOP("Step", "Paste curves")});
        return {};
    }
    const Fragment& fragment = std::get<Fragment>(read);
    if (fragment.content == Fragment::Content::points)
        editor.append(fragment.curve, {QT_TRANSLATE_NOOP("Step", "Paste points")});
    else
        editor.addCurve(withView(fragment.curve, {}), {QT_TRANSLATE_NOOP("Step", "Paste the curve")});
    return {};
}

void duplicateSelected(SheetEditor& editor) {
    editor.document().endGesture();
    const std::vector<int> points = editor.selectedPoints();
    if (points.empty())
        editor.duplicateCurve(editor.activeSerial());
    else
        editor.append(fragmentOf(*editor.activeCurve(), points).curve, {QT_TRANSLATE_NOOP("Step", "Duplicate points")});
}

} // namespace kriva::ui
