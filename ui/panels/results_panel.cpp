#include "ui/panels/results_panel.h"

#include "ui/editing/results/sheet_relations.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>
#include <iterator>

namespace kriva::ui {

ResultsPanel::ResultsPanel(ShownSheet& sheet, const SheetRelations& relations, QWidget* parent)
    : QTreeView(parent)
    , results_(sheet)
    , relations_(relations)
    , pointedOut_(sheet) {
    setObjectName(QStringLiteral("results"));
    setFrameShape(QFrame::NoFrame);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setModel(&model_);
    header()->setStretchLastSection(true);
    header()->setResizeContentsPrecision(0); // as wide as what is seen needs: there may be very many rows
    connect(&results_, &CurveResults::changed, this, &ResultsPanel::showState);
    connect(&relations, &SheetRelations::changed, this, &ResultsPanel::showState);
    retranslateUi();
}

bool ResultsPanel::event(QEvent* event) {
    // Who copies here means these rows and not the points.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
        event->accept();
    return QTreeView::event(event);
}

void ResultsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QTreeView::changeEvent(event);
}

void ResultsPanel::retranslateUi() {
    setAccessibleName(tr("Results"));
    model_.retranslate();
    showColumns();
}

void ResultsPanel::showState() {
    if (model_.setResults(results_.results(), relations_.relations().results))
        showColumns();
    pointedOut_.follow(chosenPlaces());
}

Points ResultsPanel::chosenPlaces() const {
    Points places;
    for (const QModelIndex& row : selectionModel()->selectedRows())
        std::ranges::copy(model_.places(row.row()), std::back_inserter(places));
    return places;
}

void ResultsPanel::selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) {
    QTreeView::selectionChanged(selected, deselected);
    pointedOut_.choose(chosenPlaces());
}

void ResultsPanel::dataChanged(const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) {
    // Qt asks each changed row where it is, seen or not; here all are of one height and none is edited.
    constexpr int kFew = 1000;
    if (last.row() - first.row() < kFew)
        QTreeView::dataChanged(first, last, roles);
    else
        viewport()->update();
}

void ResultsPanel::setWatched(bool isWatched) {
    pointedOut_.choose(isWatched ? chosenPlaces() : Points());
}

void ResultsPanel::showColumns() {
    // A long name must not push the numbers out of sight.
    resizeColumnToContents(0);
    setColumnWidth(0, std::min(columnWidth(0), viewport()->width() * 11 / 20));
}

void ResultsPanel::resizeEvent(QResizeEvent* event) {
    QTreeView::resizeEvent(event);
    showColumns();
}

void ResultsPanel::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copy();
    else
        QTreeView::keyPressEvent(event);
}

void ResultsPanel::copy() const {
    QModelIndexList rows = selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end());
    QStringList lines;
    for (const QModelIndex& name : rows) {
        QString value = name.siblingAtColumn(1).data(Qt::ToolTipRole).toString();
        value.replace(u'\u2212', u'-'); // spreadsheets read no other minus
        lines.append(name.data().toString() + QLatin1Char('\t') + value);
    }
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace kriva::ui
