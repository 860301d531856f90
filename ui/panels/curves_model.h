#pragma once

#include "core/figure/style/style.h"
#include "ui/document/serial.h"

#include <QAbstractListModel>

#include <vector>

namespace kriva::ui {

class SheetEditor;

/// The curves of a sheet: a row shows name, colour and, as its check mark, whether the curve is shown.
class CurvesModel : public QAbstractListModel {
    Q_OBJECT
  public:
    explicit CurvesModel(SheetEditor& editor, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Serial serialAt(int row) const;
    /// Unnamed curves are called by number in the present language.
    void retranslate();

  private:
    /// What a row shows of its curve.
    struct Row {
        std::string name;
        CurveStyle style;
        CurveView view;
        friend bool operator==(const Row&, const Row&) = default;
    };
    [[nodiscard]] Row rowOf(int row) const;
    void reset();
    void follow(Serial serial);

    SheetEditor& editor_;
    std::vector<Row> shown_; ///< what views know of
};

} // namespace kriva::ui
