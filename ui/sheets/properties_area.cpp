#include "ui/sheets/properties_area.h"

#include <QEvent>
#include <QScrollBar>

namespace kriva::ui {

PropertiesArea::PropertiesArea(QWidget* parent)
    : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QSize PropertiesArea::sizeHint() const {
    return {minimumSizeHint().width(), widget() ? widget()->sizeHint().height() : 0};
}

QSize PropertiesArea::minimumSizeHint() const {
    const int content = widget() ? widget()->minimumSizeHint().width() : 0;
    return {content + verticalScrollBar()->sizeHint().width(), 0};
}

bool PropertiesArea::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

} // namespace kriva::ui
