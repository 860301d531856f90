#include "tests/support/picture_trap.h"
#include "ui/base/message_box.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QLabel>

namespace kriva::ui {
namespace {

QStringList textsOf(const QMessageBox& box) {
    QStringList texts;
    for (const QLabel* label : box.findChildren<QLabel*>())
        if (!label->text().isEmpty())
            texts.append(label->text());
    return texts;
}

TEST(MessageBox, readsNoTextAsHtml) {
    const test::PictureTrap trap;
    const QString text = trap.html();
    MessageBox box(QMessageBox::Question, {text, text, {text, text}}, QMessageBox::Ok, nullptr);
    box.show();
    QApplication::processEvents();
    box.grab();
    for (const QLabel* label : box.findChildren<QLabel*>())
        EXPECT_TRUE(label->text().isEmpty() || label->textFormat() == Qt::PlainText) << label->text().toStdString();
    EXPECT_EQ(box.text(), text);
    EXPECT_EQ(box.informativeText(), text + u'\n' + text);
    EXPECT_EQ(textsOf(box).size(), 2);
    EXPECT_FALSE(trap.wasOpened());
}

TEST(MessageBox, theTrapOfThisTestIsSprungByABoxOfQt) {
    const test::PictureTrap trap;
    QMessageBox box(QMessageBox::Question, QString(), trap.html());
    box.show();
    box.grab();
    EXPECT_TRUE(trap.wasOpened());
}

TEST(MessageBox, escapesWhatTurnsLinesAround) {
    const MessageBox box(QMessageBox::Warning,
                         {QStringLiteral("a[*]"), QStringLiteral("gpj.\u202eexe\nforged"), {QStringLiteral("a\tb")}},
                         QMessageBox::Ok, nullptr);
    EXPECT_EQ(box.text(), QStringLiteral("gpj.\\u202eexe\\u000aforged"));
    EXPECT_EQ(box.informativeText(), QStringLiteral("a\\u0009b"));
    EXPECT_EQ(box.windowTitle(), QStringLiteral("a[*][*]"));
}

TEST(MessageBox, whatNoScreenHoldsIsCut) {
    const MessageBox box(QMessageBox::Warning, {{}, QString(100000, u'a'), {}}, QMessageBox::Ok, nullptr);
    EXPECT_EQ(box.text().size(), 5000);
    EXPECT_TRUE(box.text().endsWith(u'…'));
    EXPECT_EQ(box.informativeText(), QString());
}

} // namespace
} // namespace kriva::ui
