#include "ui/shell/plain_file_dialogs.h"

#include "ui/shell/language/plain_text.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QStyledItemDelegate>

namespace kriva::ui {
namespace {

class PlainNames : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;
    [[nodiscard]] QString displayText(const QVariant& value, const QLocale& locale) const override {
        return printable(QStyledItemDelegate::displayText(value, locale));
    }
};

void showPlainNames(QFileDialog& dialog) {
    for (auto* view : dialog.findChildren<QAbstractItemView*>())
        if (view->objectName() == QLatin1String("listView") || view->objectName() == QLatin1String("treeView"))
            view->setItemDelegate(new PlainNames(view));
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
