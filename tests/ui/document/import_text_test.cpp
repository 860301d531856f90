#include "core/curve/limits.h"
#include "ui/document/import_text.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

QString refusal(const QByteArray& text) {
    const auto read = readImport(text);
    const QString* refusal = std::get_if<QString>(&read);
    return refusal ? *refusal : QStringLiteral("not refused");
}

TEST(ImportText, saysWhereATableIsRefusedAndWhy) {
    EXPECT_EQ(refusal(" \n\n"), QStringLiteral("there are no points"));
    EXPECT_EQ(refusal("x\t1\n1\t2"), QString::fromUtf8("line 1, column 1: “x” is no number"));
    EXPECT_EQ(refusal("1\t2\n\n3\tfour"), QString::fromUtf8("line 3, column 3: “four” is no number"));
    EXPECT_EQ(refusal("1\t2\n3\t4\t5"), QStringLiteral("line 2, column 5: expected two numbers"));
    EXPECT_EQ(refusal("1\t2\n2e9\t0"),
              QString::fromUtf8("line 2, column 1: “2e9” is not from -1000000000 to 1000000000"));
    EXPECT_EQ(refusal("1,5;2\n1.5;2"),
              QString::fromUtf8("line 2, column 1: “1.5” has another decimal sign than the numbers before it"));
    EXPECT_EQ(refusal(QByteArray("1\t2\n").repeated(static_cast<qsizetype>(limits::kPointsInCurve) + 1)),
              QStringLiteral("line 100001, column 1: a curve takes at most 100000 points"));
}

TEST(ImportText, tellsOnlyTheBeginningOfALongCell) {
    const QString told = refusal(QByteArray(5000, 'a'));
    EXPECT_LT(told.size(), 80);
    EXPECT_TRUE(told.contains(QChar(u'…')));
}

} // namespace
} // namespace kriva::ui
