#include "ui/canvas/clicks.h"

#include "core/document/document_drags.h"
#include "ui/canvas/canvas_view.h"

namespace kriva::ui {
namespace {

void clickWithAlt(const Press& press, CanvasClient& client) {
    if (press.with(Qt::ControlModifier)) {
        if (press.under.curve)
            client.insertPoint(*press.under.curve, press.at);
    } else if (press.under.grip) {
        client.removePoint(*press.under.grip);
    } else {
        client.addPoint(press.at);
    }
}

void clickWithAddTool(const Press& press, CanvasClient& client) {
    if (press.under.grip)
        client.addPointOn(*press.under.grip, press.at);
    else if (press.under.curve)
        client.insertPoint(*press.under.curve, press.at);
    else
        client.addPoint(press.at);
}

void clickWithEditTool(const Press& press, const Selection& selection, CanvasClient& client) {
    const bool isToggling = press.with(Qt::ShiftModifier);
    if (press.under.grip && press.with(Qt::ControlModifier) && isHandle(press.under.grip->id.kind)) {
        client.retractHandle(*press.under.grip);
    } else if (press.under.grip) {
        const Selection clicked{*press.under.grip};
        if (!isToggling)
            client.select(clicked);
        else
            client.select(selection.contains(*press.under.grip) ? without(selection, clicked)
                                                                : united(selection, clicked));
    } else {
        if (press.under.curve)
            client.activateCurve(*press.under.curve);
        else if (!isToggling && !selection.empty())
            client.select({});
        if (press.under.mark)
            client.explain(*press.under.mark);
    }
}

} // namespace

void click(const Press& press, CanvasView& view, CanvasClient& client) {
    if (press.button == Qt::RightButton)
        view.requestContextMenu(press.pixel);
    else if (press.with(Qt::AltModifier))
        clickWithAlt(press, client);
    else if (view.tool() == Tool::add)
        clickWithAddTool(press, client);
    else
        clickWithEditTool(press, view.selection(), client);
}

void doubleClick(const Press& press, CanvasClient& client) {
    if (press.under.curve)
        client.insertPoint(*press.under.curve, press.at);
    else
        client.addPoint(press.at);
}

} // namespace kriva::ui
