#include "core/document/limits.h"
#include "ui/exchange/points_table.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

std::optional<std::vector<Points>> readCurves(const QString& text) {
    const auto read = readPointsTable(text);
    const auto* curves = std::get_if<std::vector<Points>>(&read);
    return curves ? std::optional(*curves) : std::nullopt;
}
/// Those of a table of one curve.
std::optional<Points> pastedPoints(const QString& text) {
    const auto curves = readCurves(text);
    return curves && curves->size() == 1 ? std::optional(curves->front()) : std::nullopt;
}
QString refusal(const char* text) {
    const auto read = readPointsTable(QString::fromUtf8(text));
    const TableError* error = std::get_if<TableError>(&read);
    return error ? errorText(*error) : QStringLiteral("not refused");
}

TEST(PointsTable, takesEverySeparatorAndBothDecimalSigns) {
    const Points expected{{0.5, 1}, {-2, 0.25}};
    for (const char* text : {
             "0.5\t1\n-2\t0.25",
             "0,5\t1\n-2\t0,25",
             "0.5;1\n-2;0.25",
             "0,5 ; 1\n-2 ; 0,25",
             "0.5 1\n-2 0.25",
             "0,5 1\n-2   0,25",
             "0.5,1\n-2,0.25",
             "0.5, 1\n-2, 0.25",
             "\n  0.5\t1\t\r\n\r\n\xe2\x88\x92"
             "2\t2.5e-1\r\n",
         })
        EXPECT_EQ(pastedPoints(QString::fromUtf8(text)), expected) << text;
}

TEST(PointsTable, refusesWhatIsNoTableOfTwoNumbers) {
    for (const char* text : {
             "",
             " \n \n",
             "1",
             "1\n2",
             "1\t2\t3",
             "1;;2",
             "1\t2\n3\t",
             "1\tnan",
             "1\t1e999",
             "1,5,2,5",
             "1.234,5\t1",
             "1 000\t2",
             "{\"format\": 1}",
         })
        EXPECT_EQ(pastedPoints(QString::fromUtf8(text)), std::nullopt) << text;
}

TEST(PointsTable, passesOverALineThatNamesTheColumns) {
    for (const char* text : {"x\ty\n1\t2", "x,y\n1,2", "време;път\n1;2", "\nx y\n1 2"})
        EXPECT_EQ(pastedPoints(QString::fromUtf8(text)), (Points{{1, 2}})) << text;
    for (const char* text : {"x\ty", "x\ty\nx\ty\n1\t2", "x\t\n1\t2", "1\ty\n1\t2"})
        EXPECT_EQ(pastedPoints(QString::fromUtf8(text)), std::nullopt) << text;
}

TEST(PointsTable, readsTheCurvesThatKrivaWrites) {
    EXPECT_EQ(readCurves(QStringLiteral("curve,point,x,y\n0,0,0.5,1\n0,1,2,-3\n2,0,7,8\n")),
              (std::vector<Points>{{{0.5, 1}, {2, -3}}, {{7, 8}}}));
    EXPECT_EQ(readCurves(QStringLiteral("c;p;x;y\n0;0;0,5;1")), (std::vector<Points>{{{0.5, 1}}}));
    EXPECT_FALSE(readCurves(QStringLiteral("0;0;0.5;1"))) << "four of what?";
    EXPECT_FALSE(readCurves(QStringLiteral("c,p,x,y\n0,0,1,1\n1,2")));
}

TEST(PointsTable, refusesACommaBetweenNumbersWhereItIsADecimalSignElsewhere) {
    EXPECT_EQ(pastedPoints(QStringLiteral("0,5\t1\n3,4")), std::nullopt);
    EXPECT_EQ(pastedPoints(QStringLiteral("3,4\n0,5 1")), std::nullopt);
}

TEST(PointsTable, takesNumbersUpToTheLimitOfTheModel) {
    EXPECT_EQ(pastedPoints(QStringLiteral("1e9\t-1e9")), (Points{{limits::kNumber, -limits::kNumber}}));
    EXPECT_EQ(pastedPoints(QStringLiteral("1000000000.5\t0")), std::nullopt);
    EXPECT_EQ(pastedPoints(QStringLiteral("0\t-1000000000.5")), std::nullopt);
}

TEST(PointsTable, takesAsManyPointsAsASheetMayHave) {
    const QString line = QStringLiteral("1\t2\n");
    const auto most = static_cast<qsizetype>(limits::kPointsInSheet);
    const auto points = pastedPoints(line.repeated(most));
    ASSERT_TRUE(points);
    EXPECT_EQ(points->size(), limits::kPointsInSheet);
    EXPECT_EQ(pastedPoints(line.repeated(most + 1)), std::nullopt);
}

TEST(PointsTable, saysWhereItIsRefusedAndWhy) {
    EXPECT_EQ(refusal(" \n\n"), QStringLiteral("there are no points"));
    EXPECT_EQ(refusal("x\t1\n1\t2"), QString::fromUtf8("line 1: “x” is no number"));
    EXPECT_EQ(refusal("1\t2\n\n3\tfour"), QString::fromUtf8("line 3: “four” is no number"));
    EXPECT_EQ(refusal("1\t2\n3\t4\t5"), QStringLiteral("line 2: expected two numbers"));
    EXPECT_EQ(refusal("1,2\n3,4\n5"), QStringLiteral("line 3: expected two numbers"));
    EXPECT_EQ(refusal("1\t2\n2e9\t0"), QString::fromUtf8("line 2: “2e9” is not from -1000000000 to 1000000000"));
    EXPECT_EQ(refusal(QByteArray("1\t2\n").repeated(static_cast<qsizetype>(limits::kPointsInSheet) + 1).constData()),
              QStringLiteral("more than 1000000 points are too many"));
}

TEST(PointsTable, tellsOnlyTheBeginningOfALongCell) {
    const QString told = refusal(QByteArray("a").repeated(5000).constData());
    EXPECT_LT(told.size(), 80);
    EXPECT_TRUE(told.contains(QChar(u'…')));
}

TEST(PointsTable, comesBackBitForBit) {
    const Points points{{0.1, -1.0 / 3}, {1e-300, limits::kNumber}, {0, 12345.678}};
    EXPECT_EQ(pastedPoints(pointsTable(points)), points);
    EXPECT_EQ(pointsTable({{1, 2.5}, {-3, 0}}), QStringLiteral("1\t2.5\n-3\t0"));
}

} // namespace
} // namespace kriva::ui
