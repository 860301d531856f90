#include "ui/tabs/sheet_tab.h"

#include <QEvent>

namespace kriva::ui {

SheetTab::SheetTab(OpenDocument& document, QThreadPool& workers, SheetIndex sheet, const SheetUi& ui, QWidget* parent)
    : QMainWindow(parent)
    , editor_(document, workers, sheet)
    , input_(editor_, ui.explained)
    , content_(editor_, relations_, canvas())
    , ruled_(new RuledCanvas(&canvas(), this))
    , panels_(*this, editor_, relations_, ui)
    , actions_(editor_, ui, canvas()) {
    setWindowFlags(Qt::Widget); // a main window inside another: for its docks only
    setDockNestingEnabled(true);
    setCentralWidget(ruled_);

    connect(&input_, &SheetInput::explanationRequested, this,
            [this](const MarkPlace& mark) { panels_.explain(mark.at); });
    retranslateUi();
}

void SheetTab::setVisible(bool isVisible) {
    if (isVisible)
        panels_.make();
    QMainWindow::setVisible(isVisible);
}

void SheetTab::showEvent(QShowEvent* event) {
    panels_.layout().setTabShown(true);
    QMainWindow::showEvent(event);
}

void SheetTab::hideEvent(QHideEvent* event) {
    panels_.layout().setTabShown(false);
    QMainWindow::hideEvent(event);
}

void SheetTab::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QMainWindow::changeEvent(event);
}

void SheetTab::retranslateUi() {
    panels_.retranslateUi();
    actions_.retranslateUi();
    content_.retranslateUi();
}

} // namespace kriva::ui
