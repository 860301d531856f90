#include "tests/support/visible_texts.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTabBar>

namespace kriva::test {
namespace {

class Collector {
  public:
    void add(const QObject& where, const char* what, const QString& text) {
        if (!text.trimmed().isEmpty())
            texts.append(QStringLiteral("%1 %2 %3: %4")
                             .arg(QLatin1String(where.metaObject()->className()), where.objectName(),
                                  QLatin1String(what), text));
    }
    void addModel(const QAbstractItemView& view) {
        const QAbstractItemModel* model = view.model();
        if (!model || qobject_cast<const QHeaderView*>(&view))
            return;
        for (int row = 0; row < model->rowCount(); ++row)
            for (int column = 0; column < model->columnCount(); ++column)
                for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
                    add(view, "cell", model->index(row, column).data(role).toString());
        for (int column = 0; column < model->columnCount(); ++column)
            add(view, "header", model->headerData(column, Qt::Horizontal).toString());
    }
    void addAction(const QAction& action) {
        add(action, "text", action.text());
        add(action, "tooltip", action.toolTip());
        if (action.menu())
            for (const QAction* inner : action.menu()->actions())
                addAction(*inner);
    }
    void addWidget(const QWidget& widget) {
        add(widget, "title", widget.windowTitle());
        add(widget, "tooltip", widget.toolTip());
        add(widget, "name", widget.accessibleName());
        add(widget, "description", widget.accessibleDescription());
        if (const auto* label = qobject_cast<const QLabel*>(&widget))
            add(widget, "label", label->text());
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
            add(widget, "button", button->text());
        if (const auto* field = qobject_cast<const QLineEdit*>(&widget))
            add(widget, "field", field->text());
        if (const auto* box = qobject_cast<const QComboBox*>(&widget))
            for (int i = 0; i < box->count(); ++i)
                add(widget, "entry", box->itemText(i));
        if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
            for (int i = 0; i < tabs->count(); ++i)
                add(widget, "tab", tabs->tabText(i));
        if (const auto* menu = qobject_cast<const QMenu*>(&widget))
            add(widget, "menu", menu->title());
        if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget))
            addModel(*view);
        for (const QAction* action : widget.actions())
            addAction(*action);
    }

    QStringList texts;
};

} // namespace

QStringList visibleTexts(QWidget& widget) {
    Collector collector;
    collector.addWidget(widget);
    for (const QWidget* child : widget.findChildren<QWidget*>())
        collector.addWidget(*child);
    // A menu that is too wide for the bar shows its entries in a second place; once is enough.
    collector.texts.removeDuplicates();
    return collector.texts;
}

} // namespace kriva::test
