#include "ui/base/language/plain_text.h"

#include <gtest/gtest.h>
#include <QTextDocument>

namespace kriva::ui {
namespace {

TEST(Printable, keepsLettersAndEscapesWhatMovesTheCursor) {
    EXPECT_EQ(printable(QStringLiteral("крива č 🙂")), QStringLiteral("крива č 🙂"));
    EXPECT_EQ(printable(QStringLiteral("a\tb\u0085\u2028\u2067")), QStringLiteral("a\\u0009b\\u0085\\u2028\\u2067"));
    EXPECT_EQ(printable(QStringLiteral("gpj.\u202eexe")), QStringLiteral("gpj.\\u202eexe"));
}

TEST(Printable, halvesOfCharactersAreEscaped) {
    const QChar first(0xd83d);
    const QChar second(0xde42);
    EXPECT_EQ(printable(QString(first) + u'a'), QStringLiteral("\\ud83da"));
    EXPECT_EQ(printable(QString(second) + first), QStringLiteral("\\ude42\\ud83d"));
    EXPECT_EQ(printable(QString(first) + second), QString(first) + second);
}

TEST(ToolTipOf, isHtmlThatShowsTheTextLetterByLetter) {
    for (const QString& text : {QStringLiteral("<b>a</b>"), QStringLiteral("a &amp; b"), QStringLiteral("\"a\" 'b'"),
                                QStringLiteral("plain"), QStringLiteral("<img src=/nowhere>")}) {
        const QString tip = toolTipOf(text);
        EXPECT_TRUE(Qt::mightBeRichText(tip));
        QTextDocument shown;
        shown.setHtml(tip);
        EXPECT_EQ(shown.toPlainText(), text);
    }
    EXPECT_EQ(toolTipOf({}), QString());
}

TEST(WindowTitleOf, keepsWhatQtWouldReplaceByTheSignOfAModifiedDocument) {
    EXPECT_EQ(windowTitleOf(QStringLiteral("a[*].kriva")), QStringLiteral("a[*][*].kriva"));
}

TEST(ActionTextOf, keepsWhatQtWouldTakeForAMnemonic) {
    EXPECT_EQ(actionTextOf(QStringLiteral("a & b\n.kriva")), QStringLiteral("a && b\\u000a.kriva"));
}

} // namespace
} // namespace kriva::ui
