#pragma once

#include <QMessageBox>
#include <QStringList>

namespace kriva::ui {

/// What a message box says: a title, a sentence, and further lines below it. All of it is shown letter by letter,
/// whatever stands in it: names of files and texts of documents need no care of their own.
struct Message {
    QString title;
    QString text;
    QStringList further;
};

/// The one box for messages and questions. It reads nothing as HTML, as QMessageBox does where a text looks like it,
/// and shows control and bidirectional characters as \uXXXX.
class MessageBox : public QMessageBox {
    Q_OBJECT
  public:
    MessageBox(Icon icon, const Message& message, StandardButtons buttons, QWidget* parent);
};

/// Says what went wrong, and waits until it is read.
void showError(const Message& message, QWidget* parent);

} // namespace kriva::ui
