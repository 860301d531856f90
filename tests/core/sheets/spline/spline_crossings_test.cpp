#include "core/document/sheet_figure.h"
#include "core/sheets/spline/spline_crossings.h"
#include "tests/core/sheets/spline/spline_values.h"
#include "tests/support/sheet_curves.h"

#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::SizeIs;
using testing::UnorderedElementsAre;

SplineCurve line(Point from, Point to) {
    return test::curveThrough(SplineCurve::Rule::mirror, {from, to}, false);
}

Sheet sheetOf(std::vector<Curve> curves) {
    return {std::move(curves), {}};
}

const Curve kRising(line({0, 0}, {4, 4}));
const Curve kFalling(line({0, 4}, {4, 0}));
const Curve kUpright(line({1, -1}, {1, 9}));

Points marksOf(const Relations& relations) {
    return relations.figure.layers.at(0).marks.at(0).at;
}

TEST(SplineRelations, countAndMarkTheCrossingsOfTheSheet) {
    const Relations relations = relationsOf(sheetOf({kRising, kFalling, kUpright}), test::kSpline);
    ASSERT_THAT(relations.results, SizeIs(5));
    EXPECT_EQ(relations.results[0].caption, Caption::crossingCount);
    EXPECT_EQ(std::get<int>(*relations.results[0].value), 3);
    EXPECT_EQ(relations.results[1].caption, Caption::crossing);
    EXPECT_EQ(std::get<int>(*relations.results[4].value), 0);
    EXPECT_THAT(marksOf(relations), UnorderedElementsAre(Point{2, 2}, Point{1, 1}, Point{1, 3}));
}

TEST(SplineRelations, markOnlyCrossingsOfCurvesThatAreShown) {
    const Curve hidden = withView(kUpright, {false});
    const Relations relations = relationsOf(sheetOf({kRising, kFalling, hidden}), test::kSpline);
    EXPECT_EQ(std::get<int>(*relations.results[0].value), 3);
    EXPECT_THAT(marksOf(relations), UnorderedElementsAre(Point{2, 2}));
}

TEST(SplineRelations, areNoneWhereNothingIsDrawnYet) {
    EXPECT_TRUE(relationsOf(sheetOf({}), test::kSpline).results.empty());
    EXPECT_TRUE(relationsOf(sheetOf({Curve(ElevationCurve{})}), test::kElevation).results.empty());
}

TEST(SplineRelations, areDrawnInTheFigureOfTheSheetUnlessTheLayerIsOff) {
    Sheet sheet = sheetOf({kRising, kFalling});
    const auto hasMarks = [&] {
        const Figure figure = figureOf(sheet, test::kSpline);
        return std::ranges::any_of(figure.layers, [](const Layer& layer) { return layer.name == "crossings"; });
    };
    EXPECT_TRUE(hasMarks());
    sheet.view.layers = {{"crossings", false}};
    EXPECT_FALSE(hasMarks());
}

TEST(SplineRelations, thatTakeTooManyStepsAreRefusedByName) {
    const Sheet sheet = sheetOf({kRising, kFalling, kUpright});
    WorkBudget budget(100);
    const std::optional<Relations> relations = relationsOf(sheet, 2, budget);
    ASSERT_TRUE(relations) << "that it is too much is an answer";
    ASSERT_TRUE(relations->refusal);
    EXPECT_EQ(relations->refusal->problem, FileProblem::tooManyIntersections);
    EXPECT_EQ(relations->refusal->place, "sheets.spline.curves");
    ASSERT_THAT(relations->results, SizeIs(1));
    EXPECT_EQ(std::get<Caption>(*relations->results[0].value), Caption::tooManyToCount);
    EXPECT_TRUE(relations->figure.layers.empty());
}

TEST(SplineRelations, beyondTheirPassesAreRefusedWithTheLimit) {
    const SplineCurve rising = std::get<SplineCurve>(kRising), falling = std::get<SplineCurve>(kFalling);
    const std::vector<const SplineCurve*> curves{&rising, &falling};
    WorkBudget enough;
    EXPECT_TRUE(crossingsOf(curves, enough, 2));
    WorkBudget budget;
    EXPECT_FALSE(crossingsOf(curves, budget, 1));
    EXPECT_EQ(budget.end(), WorkEnd::tooMuchFound);
    const Relations relations = refusedRelations(WorkEnd::tooMuchFound);
    EXPECT_EQ(relations.refusal->problem, FileProblem::tooManyPasses);
    EXPECT_EQ(relations.refusal->numbers, std::vector<double>{1e6});
    EXPECT_EQ(std::get<MoreThan>(*relations.results[0].value), MoreThan{1'000'000});
}

TEST(SplineRelations, areNoneWhereSomebodyStopsThem) {
    std::stop_source stop;
    stop.request_stop();
    WorkBudget budget(WorkBudget::kUnlimited, stop.get_token());
    EXPECT_FALSE(relationsOf(sheetOf({kRising, kFalling}), 2, budget));
}

} // namespace
} // namespace kriva
