#include "ui/panels/point_delegate.h"

#include "core/curve/limits.h"
#include "ui/controls/number_field.h"
#include "ui/panels/points_model.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>

#include <cmath>
#include <limits>

namespace kriva::ui {
namespace {

/// A cell of a sheet's own column.
class CellField : public CheckedField {
  public:
    CellField(PointsModel& model, const QModelIndex& index, QWidget* parent)
        : CheckedField(parent)
        , model_(model)
        , index_(index) {
        follow();
    }
    void follow() {
        held_ = index_.data(Qt::EditRole).toString();
        followHeld();
    }

  protected:
    [[nodiscard]] bool accepts(const QString& text) const override { return model_.accepts(index_, text); }
    [[nodiscard]] QString refusal() const override { return model_.needed(index_); }
    [[nodiscard]] QString heldText() const override { return held_; }
    void apply(const QString& text) override { held_ = text; } // the delegate hands it on

  private:
    PointsModel& model_;
    QPersistentModelIndex index_;
    QString held_;
};

/// Whether the key means to leave the cell with what was typed.
bool applies(const QKeyEvent& key) {
    return key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter || key.key() == Qt::Key_Tab ||
           key.key() == Qt::Key_Backtab;
}

/// A table is not for one cell: it becomes points.
bool pastesTable(const QKeyEvent& key) {
    if (!key.matches(QKeySequence::Paste))
        return false;
    const QString text = QGuiApplication::clipboard()->text().trimmed();
    return text.contains(u'\n') || text.contains(u'\t');
}

} // namespace

PointDelegate::PointDelegate(PointsModel& model, QObject* parent)
    : QStyledItemDelegate(parent)
    , model_(model) {}

void PointDelegate::dropEditor() {
    if (editor_)
        Q_EMIT closeEditor(editor_, RevertModelCache);
}

QWidget* PointDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    CheckedField* field = nullptr;
    if (index.column() <= PointsModel::kY) {
        auto* coordinate = new NumberField(parent);
        coordinate->setRange({-limits::kNumber, limits::kNumber});
        field = coordinate;
    } else {
        field = new CellField(model_, index, parent);
    }
    field->setFrame(false);
    field->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
    editor_ = field;
    return field;
}

void PointDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const QVariant held = index.data(Qt::EditRole);
    if (auto* coordinate = qobject_cast<NumberField*>(editor))
        coordinate->setValue(held.isValid() ? held.toDouble() : std::numeric_limits<double>::quiet_NaN());
    else
        static_cast<CellField*>(editor)->follow();
}

void PointDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    auto* field = static_cast<CheckedField*>(editor);
    if (!field->commit())
        return;
    const QVariant held = index.data(Qt::EditRole);
    const auto* coordinate = qobject_cast<NumberField*>(editor);
    if (!coordinate) {
        if (held.toString() != field->text())
            model->setData(index, field->text(), Qt::EditRole);
    } else if (!std::isnan(coordinate->value()) && (!held.isValid() || held.toDouble() != coordinate->value())) {
        model->setData(index, coordinate->value(), Qt::EditRole);
    }
}

bool PointDelegate::eventFilter(QObject* editor, QEvent* event) {
    auto* field = qobject_cast<CheckedField*>(editor);
    if (field && event->type() == QEvent::KeyPress && applies(*static_cast<QKeyEvent*>(event)) &&
        !field->isAccepted()) {
        field->tellRefusal();
        return true;
    }
    if (field && event->type() == QEvent::ShortcutOverride && pastesTable(*static_cast<QKeyEvent*>(event))) {
        event->ignore();
        return true;
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

} // namespace kriva::ui
