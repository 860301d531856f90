#include "ui/base/message_box.h"

#include "ui/base/language/plain_text.h"

#include <QLabel>

namespace kriva::ui {
namespace {

/// What is longer makes a box that no screen holds. A path has at most 4,096 bytes.
constexpr qsizetype kLongestText = 5000;

QString shown(const QString& text) {
    return printable(text.size() > kLongestText ? text.first(kLongestText - 1) + QChar(u'…') : text);
}

} // namespace

MessageBox::MessageBox(Icon icon, const Message& message, StandardButtons buttons, QWidget* parent)
    : QMessageBox(icon, windowTitleOf(message.title), QString(), buttons, parent) {
    setTextFormat(Qt::PlainText); // before any text is set: a text in another format would already be read
    setText(shown(message.text));
    if (message.further.isEmpty())
        return;
    QStringList lines;
    for (const QString& line : message.further)
        lines.append(shown(line));
    setInformativeText(QStringLiteral(" ")); // makes its label, which has a format of its own
    for (QLabel* label : findChildren<QLabel*>())
        label->setTextFormat(Qt::PlainText);
    setInformativeText(lines.join(QLatin1Char('\n')));
}

void showError(const Message& message, QWidget* parent) {
    MessageBox(QMessageBox::Critical, message, QMessageBox::Ok, parent).exec();
}

} // namespace kriva::ui
