#include "ui/canvas/rulers/ruled_canvas.h"

#include "ui/canvas/canvas_view.h"

#include <QGridLayout>
#include <QMouseEvent>

namespace kriva::ui {

RuledCanvas::RuledCanvas(CanvasView* canvas, QWidget* parent)
    : QWidget(parent)
    , above_(new Ruler(Qt::Horizontal, this))
    , atLeft_(new Ruler(Qt::Vertical, this))
    , corner_(new QWidget(this)) {
    corner_->setBackgroundRole(QPalette::Base);
    corner_->setAutoFillBackground(true);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(corner_, 0, 0);
    layout->addWidget(above_, 0, 1);
    layout->addWidget(atLeft_, 1, 0);
    layout->addWidget(canvas, 1, 1);
    setFocusProxy(canvas);
    setRulersShown(false);
    for (Ruler* ruler : {above_, atLeft_}) {
        ruler->setMapping(canvas->mapping());
        connect(canvas, &CanvasView::mappingChanged, ruler, &Ruler::setMapping);
    }
    canvas->viewport()->installEventFilter(this);
}

void RuledCanvas::setRulersShown(bool areShown) {
    for (QWidget* widget : {static_cast<QWidget*>(above_), static_cast<QWidget*>(atLeft_), corner_})
        widget->setVisible(areShown);
}

bool RuledCanvas::eventFilter(QObject* watched, QEvent* event) {
    const auto show = [this](std::optional<QPointF> pointer) {
        for (Ruler* ruler : {above_, atLeft_})
            ruler->setPointer(pointer);
    };
    if (event->type() == QEvent::MouseMove)
        show(static_cast<QMouseEvent*>(event)->position());
    else if (event->type() == QEvent::Leave)
        show({});
    return QWidget::eventFilter(watched, event);
}

} // namespace kriva::ui
