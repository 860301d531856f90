#include "ui/shell/plain_file_dialogs.h"

#include <QApplication>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>

namespace kriva::ui {

PlainFileDialogs::PlainFileDialogs(QObject* parent)
    : QObject(parent) {
    qApp->installEventFilter(this);
}

bool PlainFileDialogs::eventFilter(QObject* watched, QEvent* event) {
    // A box is polished when it is to be shown, before it is laid out: until then its text is not read.
    if (event->type() != QEvent::Polish)
        return false;
    const auto* box = qobject_cast<QMessageBox*>(watched);
    if (box && qobject_cast<QFileDialog*>(box->parentWidget()))
        for (QLabel* label : box->findChildren<QLabel*>())
            label->setTextFormat(Qt::PlainText);
    return false;
}

} // namespace kriva::ui
