#include "ui/base/language/qt_texts.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QTabBar>

namespace kriva::ui {
namespace {

/// A button that Qt calls by `object` inside widgets of one kind, and its texts in Qt's own catalogue of that kind.
struct QtButton {
    const char* object;
    QString (*translate)(const char* source, const char* comment, int count);
    const char* name;
    const char* description; ///< empty where Qt gives none
};

constexpr QtButton kButtons[] = {
    {"qt_dockwidget_closebutton", &QDockWidget::tr, "Close", "Closes the dock widget"},
    {"qt_dockwidget_floatbutton", &QDockWidget::tr, "Float", "Undocks and re-attaches the dock widget"},
    {"ScrollLeftButton", &QTabBar::tr, "Scroll Left", ""},
    {"ScrollRightButton", &QTabBar::tr, "Scroll Right", ""},
};

} // namespace

void renameQtButtons(QWidget& window) {
    for (const QtButton& known : kButtons) {
        for (auto* button : window.findChildren<QAbstractButton*>(QLatin1String(known.object))) {
            button->setAccessibleName(known.translate(known.name, nullptr, -1));
            if (*known.description)
                button->setAccessibleDescription(known.translate(known.description, nullptr, -1));
        }
    }
}

} // namespace kriva::ui
