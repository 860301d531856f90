#pragma once

#include "core/document/document.h"
#include "ui/document/serial.h"
#include "ui/document/step_label.h"

#include <QAbstractTableModel>

#include <array>
#include <functional>
#include <optional>

namespace kriva::ui {

class SheetEditor;

/// A column of the Points table that only some sheets have.
struct PointColumn {
    const char* title = ""; ///< marked with QT_TRANSLATE_NOOP("PointColumn", ...)
    std::function<QString(const Curve&, int point)> text;
    /// The curve with another text in the column; nothing where the text is refused.
    std::function<std::optional<Curve>(const Curve&, int point, const QString& text)> withText;
    /// Which texts the column takes, in the present language.
    std::function<QString(const Curve&, int point)> needed;
    StepLabel step; ///< what changing it is called
};

/// The points of the active curve: label, x, y and the sheet's own columns. The last row is empty: coordinates that are
/// set there add a point as soon as both are known; until then the row keeps the first.
class PointsModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    PointsModel(SheetEditor& editor, std::vector<PointColumn> columns, QObject* parent = nullptr);

    static constexpr int kX = 0;
    static constexpr int kY = 1;

    [[nodiscard]] int pointRows() const { return static_cast<int>(shown_.size()); }
    /// That of the point to come.
    [[nodiscard]] int newRow() const { return pointRows(); }
    /// The coordinate that it needs first.
    [[nodiscard]] int neededColumn() const { return draft_[kX] && !draft_[kY] ? kY : kX; }
    /// Forgets what the new row keeps.
    void clearDraft();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : pointRows() + 1;
    }
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Point pointAt(int row) const;
    /// Of columns of the sheet's own: whether the cell takes the text, and which it takes.
    [[nodiscard]] bool accepts(const QModelIndex& index, const QString& text) const;
    [[nodiscard]] QString needed(const QModelIndex& index) const;
    void retranslate();

  Q_SIGNALS:
    /// The new row became a point; the next one is behind it.
    void pointAdded();
    void otherCurveShown();

  private:
    void follow();
    void tellChanged(int first, int last);
    void addDraft();
    [[nodiscard]] QVariant draftData(int column, int role) const;
    [[nodiscard]] QVariant coordinateData(double number, int role) const;

    SheetEditor& editor_;
    std::vector<PointColumn> columns_;
    Points shown_; ///< what views know of
    std::array<std::optional<double>, 2> draft_;
    Serial serial_ = 0; ///< of the curve that is shown
    bool isAddingDraft_ = false;
};

} // namespace kriva::ui
