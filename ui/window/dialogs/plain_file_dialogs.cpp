#include "ui/window/dialogs/plain_file_dialogs.h"

#include "ui/base/language/plain_text.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCompleter>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QStyledItemDelegate>

namespace kriva::ui {
namespace {

class PlainNames : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;
    [[nodiscard]] QString displayText(const QVariant& value, const QLocale& locale) const override {
        // Qt has a separator of lines in place of a line's end, which would be another character of the name.
        const bool isText = value.userType() == QMetaType::QString;
        return printable(isText ? value.toString() : QStyledItemDelegate::displayText(value, locale));
    }
};

/// The names that complete what is typed. Their list has the current one marked as a field with the focus.
class PlainCompletions : public PlainNames {
  public:
    using PlainNames::PlainNames;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        PlainNames::initStyleOption(option, index);
        option->showDecorationSelected = true;
        const auto* view = qobject_cast<const QAbstractItemView*>(option->widget);
        if (view && view->currentIndex() == index)
            option->state |= QStyle::State_HasFocus;
    }
};

/// What is written in the field for a name stays as it is: the dialog takes the name from there.
void showPlainNames(QFileDialog& dialog) {
    for (auto* view : dialog.findChildren<QAbstractItemView*>())
        if (view->objectName() == QLatin1String("listView") || view->objectName() == QLatin1String("treeView"))
            view->setItemDelegate(new PlainNames(view));
    for (const auto* field : dialog.findChildren<QLineEdit*>())
        if (field->completer())
            field->completer()->popup()->setItemDelegate(new PlainCompletions(field->completer()->popup()));
}

} // namespace

PlainFileDialogs::PlainFileDialogs(QObject* parent)
    : QObject(parent) {
    qApp->installEventFilter(this);
}

bool PlainFileDialogs::eventFilter(QObject* watched, QEvent* event) {
    // A box is polished when it is to be shown, before it is laid out: until then its text is not read.
    if (event->type() != QEvent::Polish)
        return false;
    if (auto* dialog = qobject_cast<QFileDialog*>(watched))
        showPlainNames(*dialog);
    const auto* box = qobject_cast<QMessageBox*>(watched);
    if (box && qobject_cast<QFileDialog*>(box->parentWidget()))
        for (QLabel* label : box->findChildren<QLabel*>())
            label->setTextFormat(Qt::PlainText);
    return false;
}

} // namespace kriva::ui
