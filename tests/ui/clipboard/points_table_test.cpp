#include "core/curve/limits.h"
#include "ui/clipboard/points_table.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

QString refusal(std::string_view text) {
    const auto read = readPointsTable(text);
    const TableError* error = std::get_if<TableError>(&read);
    return error ? errorText(*error) : QStringLiteral("not refused");
}

TEST(PointsTable, saysWhereATableIsRefusedAndWhy) {
    EXPECT_EQ(refusal(" \n\n"), QStringLiteral("there are no points"));
    EXPECT_EQ(refusal("x\t1\n1\t2"), QString::fromUtf8("line 1, column 1: “x” is no number"));
    EXPECT_EQ(refusal("1\t2\n\n3\tfour"), QString::fromUtf8("line 3, column 3: “four” is no number"));
    EXPECT_EQ(refusal("1\t2\n3\t4\t5"), QStringLiteral("line 2, column 5: expected two numbers"));
    EXPECT_EQ(refusal("1\t2\n2e9\t0"),
              QString::fromUtf8("line 2, column 1: “2e9” is not from -1000000000 to 1000000000"));
    EXPECT_EQ(refusal("1,5;2\n1.5;2"),
              QString::fromUtf8("line 2, column 1: “1.5” has another decimal sign than the numbers before it"));
    EXPECT_EQ(refusal(QByteArray("1\t2\n").repeated(static_cast<qsizetype>(limits::kPointsInCurve) + 1).toStdString()),
              QStringLiteral("line 100001, column 1: a curve takes at most 100000 points"));
}

TEST(PointsTable, tellsOnlyTheBeginningOfALongCell) {
    const QString told = refusal(std::string(5000, 'a'));
    EXPECT_LT(told.size(), 80);
    EXPECT_TRUE(told.contains(QChar(u'…')));
}

TEST(PointsTable, comesBackBitForBit) {
    const Points points{{0.1, -1.0 / 3}, {1e-300, limits::kNumber}, {0, 12345.678}};
    const auto read = readPointsTable(pointsTable(points).toStdString());
    EXPECT_EQ(std::get<std::vector<Points>>(read), std::vector<Points>{points});
    EXPECT_EQ(pointsTable({{1, 2.5}, {-3, 0}}), QStringLiteral("1\t2.5\n-3\t0"));
}

} // namespace
} // namespace kriva::ui
