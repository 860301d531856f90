#include "ui/panels/points_panel.h"

#include "ui/editing/sheet_editor.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

constexpr Qt::KeyboardModifiers kOfShortcuts = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;

[[nodiscard]] bool isTyped(const QKeyEvent& key) {
    const bool isText = !key.text().isEmpty() && key.text().front().isPrint() && !(key.modifiers() & kOfShortcuts);
    return isText || key.key() == Qt::Key_F2;
}

} // namespace

PointsPanel::PointsPanel(SheetEditor& editor, const std::vector<PointColumn>& columns, QWidget* parent)
    : QTableView(parent)
    , editor_(editor)
    , model_(editor, columns)
    , delegate_(new PointDelegate(model_, this)) {
    setObjectName(QStringLiteral("points"));
    // Rows that go take their marks with them, which is no wish of a person. The view hears of it after this.
    connect(&model_, &PointsModel::rowsAboutToBeRemoved, this, [this] { isShowingSelection_ = true; });
    setModel(&model_);
    setItemDelegate(delegate_);
    setFrameShape(QFrame::NoFrame);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setTabKeyNavigation(false);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setResizeContentsPrecision(0); // as wide as what is seen needs: there may be very many rows
    for (int column = PointsModel::kY + 1; column < model_.columnCount(); ++column)
        horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    connectModel();
    retranslateUi();
}

void PointsPanel::connectModel() {
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &PointsPanel::takeSelection);
    connect(&editor_, &SheetEditor::selectionChanged, this, &PointsPanel::showSelection);
    connect(&model_, &PointsModel::rowsRemoved, this, &PointsPanel::showSelection);
    connect(&model_, &PointsModel::pointAdded, this, [this] { hasAddedPoint_ = true; });
    connect(&model_, &PointsModel::otherCurveShown, delegate_, &PointDelegate::dropEditor);
    const auto ifMine = [this](SheetIndex sheet) {
        if (sheet == editor_.index())
            showSelection();
    };
    connect(&editor_.document(), &OpenDocument::curvesChanged, this, ifMine);
    connect(&editor_.document(), &OpenDocument::viewChanged, this, ifMine);
}

bool PointsPanel::event(QEvent* event) {
    // The table's own key for editing a cell, which is that of renaming a curve elsewhere.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F2)
        event->accept();
    return QTableView::event(event);
}

void PointsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QTableView::changeEvent(event);
}

void PointsPanel::retranslateUi() {
    setAccessibleName(tr("Points"));
    model_.retranslate();
}

/// Neighbours are one range: each range is looked at in every repaint.
void PointsPanel::showSelection() {
    const std::vector<int> points = editor_.selectedPoints();
    QItemSelection rows;
    for (auto first = points.begin(); first != points.end();) {
        const auto gap = std::adjacent_find(first, points.end(), [](int a, int b) { return b != a + 1; });
        const auto last = gap == points.end() ? points.end() - 1 : gap;
        const int bottom = std::min(*last, model_.pointRows() - 1);
        if (*first <= bottom)
            rows.append(QItemSelectionRange(model_.index(*first, 0), model_.index(bottom, model_.columnCount() - 1)));
        first = last + 1;
    }
    const bool wasShowing = std::exchange(isShowingSelection_, true); // the view must hear of it, but nobody wished it
    if (wasShowing || !isTakingSelection_)
        selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    isShowingSelection_ = false;
    if (rows.isEmpty() || isTakingSelection_)
        return;
    scrollTo(model_.index(rows.last().bottom(), 0));
    if (state() != EditingState && !selectionModel()->isSelected(currentIndex()))
        makeCurrent(rows.first().top(), std::max(0, currentIndex().column()));
}

Selection PointsPanel::markedPoints() const {
    std::vector<GripRef> marked;
    for (const QItemSelectionRange& range : selectionModel()->selection())
        for (int row = range.top(); row <= std::min(range.bottom(), model_.pointRows() - 1); ++row)
            marked.push_back({editor_.activeSerial(), {GripKind::point, row}});
    return Selection(std::move(marked));
}

void PointsPanel::takeSelection() {
    if (isShowingSelection_)
        return;
    isTakingSelection_ = true;
    editor_.select(markedPoints());
    isTakingSelection_ = false;
}

void PointsPanel::makeCurrent(int row, int column) {
    selectionModel()->setCurrentIndex(model_.index(row, column), QItemSelectionModel::NoUpdate);
}

void PointsPanel::aim() {
    const QModelIndex current = currentIndex();
    const bool isNew = current.row() == model_.newRow();
    const bool isMeant = isNew ? current.column() <= PointsModel::kY : selectionModel()->isSelected(current);
    if (!isMeant)
        makeNewRowCurrent();
}

void PointsPanel::removeRows(Qt::KeyboardModifiers modifiers) {
    if (currentIndex().row() == model_.newRow())
        model_.clearDraft();
    else
        editor_.removeSelected(modifiers.testFlag(Qt::ControlModifier) ? Removal::plain : Removal::refitted);
}

void PointsPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)
        return removeRows(event->modifiers());
    if (isTyped(*event))
        aim();
    QTableView::keyPressEvent(event);
}

void PointsPanel::inputMethodEvent(QInputMethodEvent* event) {
    if (!event->commitString().isEmpty() || !event->preeditString().isEmpty())
        aim();
    QTableView::inputMethodEvent(event);
}

void PointsPanel::mousePressEvent(QMouseEvent* event) {
    QTableView::mousePressEvent(event);
    if (!indexAt(event->position().toPoint()).isValid())
        makeNewRowCurrent(); // where what is typed next comes
}

void PointsPanel::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
    const bool hasAddedPoint = std::exchange(hasAddedPoint_, false);
    const QModelIndex current = currentIndex();
    if (hint == QAbstractItemDelegate::EditNextItem && current.row() == model_.newRow() &&
        current.column() == PointsModel::kY) {
        QTableView::closeEditor(editor, QAbstractItemDelegate::NoHint);
        makeCurrent(model_.newRow(), PointsModel::kX); // and not to the first row, which nobody chose
        edit(currentIndex());
        return;
    }
    QTableView::closeEditor(editor, hint);
    if (hint == QAbstractItemDelegate::SubmitModelCache && (hasAddedPoint || currentIndex().row() == model_.newRow()))
        makeNewRowCurrent(); // Enter goes on with what is missing, of this point or of the next one
}

} // namespace kriva::ui
