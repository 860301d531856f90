#include "ui/tabs/sheet_actions.h"

#include <QCoreApplication>
#include <QWidget>

#include <algorithm>

namespace kriva::ui {

SheetActions::SheetActions(SheetEditor& editor, const SheetUi& ui, QWidget& canvas)
    : QObject(&canvas)
    , editor_(editor)
    , canvas_(canvas) {
    addNumber(ui.number);
    std::optional<SheetAction::Group> group;
    for (const SheetAction& what : ui.actions) {
        if (std::exchange(group, what.group) != what.group)
            addSeparator();
        add(what);
    }
    const auto ifMine = [this](SheetIndex sheet) {
        if (sheet == editor_.index())
            follow();
    };
    connect(&editor, &SheetEditor::selectionChanged, this, &SheetActions::follow);
    // A gesture's previews need not be followed one by one: where it changed something it ends with a step.
    connect(&editor.document(), &OpenDocument::curveChanged, this, [this, ifMine](SheetIndex sheet) {
        if (!editor_.document().hasGesture())
            ifMine(sheet);
    });
    connect(&editor.document().history(editor.index()), &QUndoStack::indexChanged, this, &SheetActions::follow);
    connect(&editor.document(), &OpenDocument::curvesChanged, this, ifMine);
    connect(&editor.document(), &OpenDocument::viewChanged, this, ifMine);
    connect(&editor.document(), &OpenDocument::replaced, this, &SheetActions::follow);
    retranslateUi();
    follow();
}

void SheetActions::addNumber(const SheetNumber& number) {
    addSeparator();
    const auto addStep = [&](const char* name, const char* text, Qt::Key key, int by) {
        const auto stepped = [number, by](const SheetEditor& editor) {
            return number.value(*editor.activeCurve()) + by;
        };
        const auto run = [number, stepped](SheetEditor& editor) {
            editor.changeInBurst(number.with(*editor.activeCurve(), stepped(editor)), number.step);
        };
        const auto isPossible = [number, stepped](const SheetEditor& editor) {
            const SheetNumber::Range range = number.range(*editor.activeCurve());
            return range.low <= stepped(editor) && stepped(editor) <= range.high;
        };
        add({SheetAction::Group::curve, name, text, key, run, isPossible, {}});
    };
    addStep("raiseNumber", number.raiseText, Qt::Key_PageUp, 1);
    addStep("lowerNumber", number.lowerText, Qt::Key_PageDown, -1);
}

void SheetActions::add(SheetAction what) {
    auto* action = new QAction(this);
    action->setObjectName(QString::fromLatin1(what.name));
    action->setShortcut(what.shortcut);
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setCheckable(what.isChecked != nullptr);
    connect(action, &QAction::triggered, this, [this, run = what.run] {
        run(editor_);
        follow(); // what was switched may stand as it stood
    });
    canvas_.addAction(action);
    all_.append(action);
    entries_.push_back({action, std::move(what)});
}

void SheetActions::addSeparator() {
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    all_.append(separator);
}

QList<QAction*> SheetActions::of(std::initializer_list<SheetAction::Group> groups) const {
    QList<QAction*> found;
    for (const Entry& entry : entries_)
        if (std::ranges::find(groups, entry.what.group) != groups.end())
            found.append(entry.action);
    return found;
}

void SheetActions::follow() {
    const bool hasCurve = editor_.activeCurve() != nullptr;
    for (const Entry& entry : entries_) {
        entry.action->setEnabled(hasCurve && entry.what.isPossible(editor_));
        if (entry.what.isChecked)
            entry.action->setChecked(hasCurve && entry.what.isChecked(editor_));
    }
}

void SheetActions::retranslateUi() {
    for (const Entry& entry : entries_)
        entry.action->setText(QCoreApplication::translate("SheetActions", entry.what.text));
}

} // namespace kriva::ui
