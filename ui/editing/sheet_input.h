#pragma once

#include "ui/canvas/canvas_view.h"
#include "ui/editing/sheet_drag.h"

#include <memory>
#include <span>

namespace kriva::ui {

/// What mouse and keys on the canvas of a sheet do to its curves and its selection.
class SheetInput : public QObject, private CanvasInput {
    Q_OBJECT
  public:
    /// `explained` are the roles of marks that the tables tell about. The editor and they outlive this.
    SheetInput(SheetEditor& editor, std::span<const Role> explained);

    [[nodiscard]] CanvasView& canvas() { return *canvas_; }

    /// Whether points that are dragged or added snap.
    void setSnapping(bool isSnapping) { isSnapping_ = isSnapping; }
    /// Inserts a point where the context menu was asked for, if that was on a curve; else behind the selected point.
    void insertPointHere() { insertPoint(menuPlace_); }
    /// The context menu is gone.
    void endMenu() { menuPlace_.reset(); }

  Q_SIGNALS:
    /// A text for the status row about what lies under the pointer; empty where there is nothing to say.
    void hintChanged(const QString& hint);
    /// A context menu is asked for. What is under it is selected or active by now, so that the actions are about it.
    void menuRequested(QPoint globalPosition, const kriva::ui::Hit& under);
    /// A click on a mark that the tables tell about.
    void explanationRequested(const kriva::ui::MarkPlace& mark);

  private:
    void hover(const PointerEvent& now) override;
    void click(const PointerEvent& press) override;
    bool doubleClick(const PointerEvent& press) override;
    bool beginDrag(const PointerEvent& press) override;
    void drag(Vector by, const DragKeys& keys) override;
    void endDrag() override;
    void cancelDrag() override;
    void select(Selection selection) override;
    void nudge(Vector by) override { editor_.nudge(by); }
    void removeSelected(Removal removal) override { editor_.removeSelected(removal); }
    void insertPoint(std::optional<CurvePlace> place) override;

    void clickWithAlt(const PointerEvent& press);
    void clickWithAddTool(const PointerEvent& press);
    void clickWithEditTool(const PointerEvent& press);
    void requestMenu(const PointerEvent& press);
    /// Inserts into the curve under the pointer, else adds a point.
    void addPoint(const PointerEvent& press);
    /// To where a new point comes that is asked for at `at`.
    [[nodiscard]] Point snapped(Point at) const;
    [[nodiscard]] bool canExplain(const std::optional<MarkPlace>& mark) const;

    SheetEditor& editor_;
    std::span<const Role> explained_;
    SheetDrag drag_{editor_};
    bool isSnapping_ = false;
    std::optional<CurvePlace> menuPlace_; ///< of the context menu that is open
    std::unique_ptr<CanvasView> canvas_;  ///< the last, so that it is gone before the rest, which it talks to
};

} // namespace kriva::ui
