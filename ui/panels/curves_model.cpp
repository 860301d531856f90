#include "ui/panels/curves_model.h"

#include "core/figure/role_style.h"
#include "ui/editing/sheet/curve_name.h"
#include "ui/editing/sheet_editor.h"

#include <QColor>

#include <utility>

namespace kriva::ui {
namespace {

QColor colorOf(const Curve& curve) {
    const Color color = styleOf(curve).color.value_or(styleOf(Role::curve, 0, Theme::light).color);
    return {color.red, color.green, color.blue};
}

} // namespace

CurvesModel::CurvesModel(SheetEditor& editor, QObject* parent)
    : QAbstractListModel(parent)
    , editor_(editor) {
    connect(&editor.document(), &OpenDocument::replaced, this, &CurvesModel::reset);
    connect(&editor.document(), &OpenDocument::curvesChanged, this, [this](SheetIndex sheet) {
        if (sheet == editor_.index())
            reset();
    });
    connect(&editor.document(), &OpenDocument::curveChanged, this, [this](SheetIndex sheet, Serial serial) {
        if (sheet == editor_.index())
            follow(serial);
    });
    reset();
}

CurvesModel::Row CurvesModel::rowOf(int row) const {
    const Curve& curve = editor_.sheet().curves[static_cast<std::size_t>(row)];
    return {nameOf(curve), styleOf(curve), viewOf(curve)};
}

void CurvesModel::reset() {
    beginResetModel();
    shown_.clear();
    for (int row = 0; row < rowCount(); ++row)
        shown_.push_back(rowOf(row));
    endResetModel();
}

void CurvesModel::follow(Serial serial) {
    const std::optional<int> row = editor_.document().indexOf(editor_.index(), serial);
    if (!row || *row >= std::ssize(shown_))
        return;
    Row now = rowOf(*row);
    if (std::exchange(shown_[static_cast<std::size_t>(*row)], now) != now)
        Q_EMIT dataChanged(index(*row), index(*row));
}

int CurvesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(editor_.sheet().curves.size());
}

Serial CurvesModel::serialAt(int row) const {
    return editor_.document().serials(editor_.index())[static_cast<std::size_t>(row)];
}

QVariant CurvesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const Curve& curve = editor_.sheet().curves[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return curveName(curve, index.row());
    case Qt::EditRole:
        return QString::fromStdString(nameOf(curve));
    case Qt::DecorationRole:
        return colorOf(curve);
    case Qt::CheckStateRole:
        return viewOf(curve).isShown ? Qt::Checked : Qt::Unchecked;
    default:
        return {};
    }
}

bool CurvesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid())
        return false;
    const Serial serial = serialAt(index.row());
    if (role == Qt::EditRole)
        editor_.renameCurve(serial, value.toString());
    else if (role == Qt::CheckStateRole)
        editor_.document().setCurveShown(editor_.index(), serial, value.toInt() == Qt::Checked);
    else
        return false;
    return true;
}

Qt::ItemFlags CurvesModel::flags(const QModelIndex& index) const {
    return QAbstractListModel::flags(index) | Qt::ItemIsEditable | Qt::ItemIsUserCheckable;
}

void CurvesModel::retranslate() {
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

} // namespace kriva::ui
