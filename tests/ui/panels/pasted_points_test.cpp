#include "core/document/limits.h"
#include "ui/panels/pasted_points.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

TEST(PastedPoints, takesEverySeparatorAndBothDecimalSigns) {
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

TEST(PastedPoints, refusesWhatIsNoTableOfTwoNumbers) {
    for (const char* text : {
             "",
             " \n \n",
             "1",
             "1\n2",
             "1\t2\t3",
             "1;;2",
             "x\ty\n1\t2",
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

TEST(PastedPoints, refusesACommaBetweenNumbersWhereItIsADecimalSignElsewhere) {
    EXPECT_EQ(pastedPoints(QStringLiteral("0,5\t1\n3,4")), std::nullopt);
    EXPECT_EQ(pastedPoints(QStringLiteral("3,4\n0,5 1")), std::nullopt);
}

TEST(PastedPoints, takesNumbersUpToTheLimitOfTheModel) {
    EXPECT_EQ(pastedPoints(QStringLiteral("1e9\t-1e9")), (Points{{limits::kNumber, -limits::kNumber}}));
    EXPECT_EQ(pastedPoints(QStringLiteral("1000000000.5\t0")), std::nullopt);
    EXPECT_EQ(pastedPoints(QStringLiteral("0\t-1000000000.5")), std::nullopt);
}

TEST(PastedPoints, takesAsManyPointsAsACurveMayHave) {
    const QString line = QStringLiteral("1\t2\n");
    const auto most = static_cast<qsizetype>(limits::kPointsInCurve);
    const auto points = pastedPoints(line.repeated(most));
    ASSERT_TRUE(points);
    EXPECT_EQ(points->size(), limits::kPointsInCurve);
    EXPECT_EQ(pastedPoints(line.repeated(most + 1)), std::nullopt);
}

} // namespace
} // namespace kriva::ui
