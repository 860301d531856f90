#pragma once

#include "core/document/document.h"
#include "ui/document/step_label.h"

#include <QAbstractTableModel>

#include <functional>

namespace kriva::ui {

class SheetEditor;

/// A column of the Points table that only some sheets have.
struct PointColumn {
    const char* title = ""; ///< marked with QT_TRANSLATE_NOOP("PointColumn", ...)
    std::function<QString(const Curve&, int point)> text;
    /// The curve with another text in the column; nothing where the text is refused or the cell cannot be edited.
    std::function<std::optional<Curve>(const Curve&, int point, const QString& text)> withText;
    StepLabel step; ///< what changing it is called
};

/// The points of the active curve: label, x, y and the sheet's own columns.
class PointsModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    PointsModel(SheetEditor& editor, std::vector<PointColumn> columns, QObject* parent = nullptr);

    static constexpr int kX = 0;
    static constexpr int kY = 1;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : static_cast<int>(shown_.size());
    }
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Point pointAt(int row) const;
    void retranslate();

  private:
    void follow();
    void tellChanged(int first, int last);

    SheetEditor& editor_;
    std::vector<PointColumn> columns_;
    Points shown_; ///< what views know of
};

} // namespace kriva::ui
