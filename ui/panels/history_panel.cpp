#include "ui/panels/history_panel.h"

#include "ui/editing/sheet_editor.h"

#include <QEvent>
#include <QSignalBlocker>

namespace kriva::ui {

HistoryPanel::HistoryPanel(SheetEditor& editor, QWidget* parent)
    : QListWidget(parent)
    , editor_(editor) {
    setObjectName(QStringLiteral("history"));
    setFrameShape(QFrame::NoFrame);
    setUniformItemSizes(true);
    const QUndoStack& history = editor.document().history(editor.index());
    connect(&history, &QUndoStack::indexChanged, this, &HistoryPanel::showState);
    // Row 0 is the beginning, row i the state after step i.
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            editor_.document().goToStep(editor_.index(), row);
    });
    retranslateUi();
}

void HistoryPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QListWidget::changeEvent(event);
}

void HistoryPanel::retranslateUi() {
    setAccessibleName(tr("History"));
    showState();
}

void HistoryPanel::showState() {
    const QSignalBlocker blocker(this);
    const QUndoStack& history = editor_.document().history(editor_.index());
    const int rows = history.count() + 1;
    while (count() > rows)
        delete takeItem(count() - 1);
    while (count() < rows)
        addItem(QString());
    item(0)->setText(tr("Beginning"));
    for (int row = 1; row < rows; ++row) {
        item(row)->setText(resolvedStep(history.text(row - 1)));
        const bool isUndone = row > history.index();
        item(row)->setForeground(palette().brush(isUndone ? QPalette::Disabled : QPalette::Active, QPalette::Text));
    }
    setCurrentRow(history.index());
    scrollToItem(currentItem());
}

} // namespace kriva::ui
