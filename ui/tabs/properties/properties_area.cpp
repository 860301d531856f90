#include "ui/tabs/properties/properties_area.h"

#include <QEvent>
#include <QScrollBar>

#include <algorithm>

namespace kriva::ui {
namespace {

constexpr int kLeastWidth = 300; // px: sliders that can be aimed at

} // namespace

PropertiesArea::PropertiesArea(QWidget* parent)
    : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus); // it scrolls to the field that has the focus
}

QSize PropertiesArea::sizeHint() const {
    return {minimumSizeHint().width(), widget() ? widget()->sizeHint().height() : 0};
}

QSize PropertiesArea::minimumSizeHint() const {
    const int content = widget() ? widget()->minimumSizeHint().width() : 0;
    return {std::max(kLeastWidth, content + verticalScrollBar()->sizeHint().width()), 0};
}

bool PropertiesArea::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

} // namespace kriva::ui
