#pragma once

#include "ui/canvas/canvas_client.h"
#include "ui/document/open_document.h"
#include "ui/sheets/hint.h"

namespace kriva::ui {

/// Edits one sheet of the open document, and keeps the view state that belongs to it and is neither saved nor undone:
/// the selection, and the stage that a player shows. A tab's canvas and panels all work on this one object.
class SheetEditor : public QObject {
    Q_OBJECT
  public:
    SheetEditor(OpenDocument& document, SheetIndex sheet, QObject* parent = nullptr);

    [[nodiscard]] OpenDocument& document() const { return document_; }
    [[nodiscard]] const Sheet& sheet() const { return document_.sheet(index_); }
    [[nodiscard]] SheetIndex index() const { return index_; }
    [[nodiscard]] Serial activeSerial() const { return document_.activeCurve(index_); }
    /// Null in an empty sheet.
    [[nodiscard]] const Curve* activeCurve() const { return document_.find(index_, activeSerial()); }

    /// The curve as it is on view: a player's stage, else the document's value.
    [[nodiscard]] const Curve* shown(Serial serial) const;
    /// Shows another value in place of the active curve's without changing the document; nothing shows the document's.
    void setStage(std::optional<Curve> stage);
    /// The whole document with the stage in place of the active curve: what an export draws.
    [[nodiscard]] Document documentOnView() const;
    [[nodiscard]] bool hasStage() const { return stage_.has_value(); }

    [[nodiscard]] const Selection& selection() const { return selection_; }
    void select(Selection selection);
    void selectAll();
    void selectNone();
    void invertSelection();
    /// Indices of the selected points of the active curve, ascending.
    [[nodiscard]] std::vector<int> selectedPoints() const;
    [[nodiscard]] std::vector<GripId> selectedGrips(Serial serial) const;

    // Points.
    void addPoint(Point at);
    /// At the end of the active curve, in one step.
    void addPoints(std::span<const Point> points);
    /// The same as a gesture that goes on, with the last of the points selected; false where they are refused.
    bool beginAdding(std::span<const Point> points);
    /// One point more near a place of the curve, which keeps its shape.
    void insertPoint(Serial serial, Point near);
    void removePoints(Serial serial, const std::vector<int>& indices, Removal removal);
    void removeSelected(Removal removal);
    void removeLastPoint();
    /// A point of the active curve, placed by typing.
    void placePoint(int index, Point at);
    void nudge(Vector by);

    // The active curve. `label` is marked with QT_TRANSLATE_NOOP("Step", ...).
    void change(Curve value, const StepLabel& label);
    /// As change, but steps of the same kind that follow each other closely become one.
    void changeInBurst(Curve value, const StepLabel& label);
    void reverse();

    // Curves.
    void newCurve();
    void duplicateCurve(Serial serial);
    void deleteCurve(Serial serial);
    void renameCurve(Serial serial, const QString& name);
    void colorCurve(Serial serial, Color color);
    void moveCurve(Serial serial, int index);
    void activateNextCurve();
    /// Deletes all curves in one step.
    void clear();

  Q_SIGNALS:
    void selectionChanged();
    /// What is on view for this curve changed: its value, or the stage in its place.
    void shownCurveChanged(kriva::ui::Serial serial);
    /// Something worth telling in the status row happened.
    void hint(const kriva::ui::Hint& hint);

  private:
    [[nodiscard]] Selection allPoints() const;
    void dropLostSelection();
    void applyMap(Serial serial, const IndexMap& map);
    void tellRemoval(const Curve& before, const Curve& after, std::optional<double> deviation);

    OpenDocument& document_;
    SheetIndex index_;
    Selection selection_;
    std::optional<Curve> stage_;
    Serial stagedSerial_ = 0; ///< in whose place the stage stands
};

} // namespace kriva::ui
