#include "ui/panels/points_panel.h"

#include "core/document/limits.h"
#include "ui/panels/controls/number_field.h"
#include "ui/sheets/sheet_editor.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QStyledItemDelegate>

#include <algorithm>

namespace kriva::ui {
namespace {

/// Edits coordinates in the one number field, so that 0.5 and 0,5 mean the same here too.
class CoordinateDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
        auto* field = new NumberField(parent);
        field->setRange({-limits::kNumber, limits::kNumber});
        field->setFrame(false);
        return field;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        static_cast<NumberField*>(editor)->setValue(index.data(Qt::EditRole).toDouble());
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        auto* field = static_cast<NumberField*>(editor);
        if (field->commit() && field->value() != index.data(Qt::EditRole).toDouble())
            model->setData(index, field->value(), Qt::EditRole);
    }
};

} // namespace

PointsPanel::PointsPanel(SheetEditor& editor, const std::vector<PointColumn>& columns, QWidget* parent)
    : QTableView(parent)
    , editor_(editor)
    , model_(editor, columns) {
    setObjectName(QStringLiteral("points"));
    // Rows that go take their marks with them, which is no wish of a person. The view hears of it after this.
    connect(&model_, &PointsModel::rowsAboutToBeRemoved, this, [this] { isShowingSelection_ = true; });
    setModel(&model_);
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
    auto* coordinates = new CoordinateDelegate(this);
    setItemDelegateForColumn(PointsModel::kX, coordinates);
    setItemDelegateForColumn(PointsModel::kY, coordinates);
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &PointsPanel::takeSelection);
    connect(&editor, &SheetEditor::selectionChanged, this, &PointsPanel::showSelection);
    connect(&model_, &PointsModel::rowsRemoved, this, &PointsPanel::showSelection);
    const auto ifMine = [this](SheetIndex sheet) {
        if (sheet == editor_.index())
            showSelection();
    };
    connect(&editor.document(), &OpenDocument::curvesChanged, this, ifMine);
    connect(&editor.document(), &OpenDocument::viewChanged, this, ifMine);
    retranslateUi();
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

void PointsPanel::showSelection() {
    QItemSelection rows;
    const int last = model_.columnCount() - 1;
    for (const int point : editor_.selectedPoints())
        if (point < model_.rowCount())
            rows.select(model_.index(point, 0), model_.index(point, last));
    isShowingSelection_ = true; // the view must hear of it, but it is no wish of a person
    selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    isShowingSelection_ = false;
    if (!rows.isEmpty())
        scrollTo(rows.last().topLeft());
}

void PointsPanel::takeSelection() {
    if (isShowingSelection_)
        return;
    Selection chosen;
    for (const QModelIndex& row : selectionModel()->selectedRows())
        chosen.insert({editor_.activeSerial(), {GripKind::point, row.row()}});
    editor_.select(std::move(chosen));
}

void PointsPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)
        editor_.removeSelected(event->modifiers().testFlag(Qt::ControlModifier) ? Removal::plain : Removal::refitted);
    else
        QTableView::keyPressEvent(event);
}

} // namespace kriva::ui
