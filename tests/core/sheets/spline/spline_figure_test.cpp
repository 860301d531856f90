#include "core/document/sheet_figure.h"
#include "core/sheets/spline/spline.h"
#include "tests/core/sheets/spline/spline_values.h"
#include "tests/support/sheet_curves.h"

namespace kriva {
namespace {

using test::curveThrough;
using Rule = SplineCurve::Rule;

const Layer* find(const Figure& figure, std::string_view name) {
    const auto found = std::ranges::find(figure.layers, name, &Layer::name);
    return found == figure.layers.end() ? nullptr : &*found;
}

Points marksOf(const Figure& figure) {
    Points all;
    for (const Layer& layer : figure.layers)
        for (const Marks& marks : layer.marks)
            all.insert(all.end(), marks.at.begin(), marks.at.end());
    return all;
}

RC_GTEST_PROP(SplineFigure, marksEverythingThatCanBeDragged, ()) {
    const SplineCurve curve = test::anySpline();
    const Points marks = marksOf(figureOf(curve, {}));
    for (const Grip& grip : grips(curve))
        RC_ASSERT(std::ranges::find(marks, grip.at) != marks.end());
}

RC_GTEST_PROP(SplineFigure, drawsItsLayersInTheOrderOfTheTable, ()) {
    const SplineCurve curve = test::anySpline();
    const auto table = layersOf(curve);
    auto next = table.begin();
    for (const Layer& layer : figureOf(curve, {}).layers) {
        next = std::ranges::find(next, table.end(), layer.name, &LayerInfo::name);
        RC_ASSERT(next != table.end());
    }
}

TEST(SplineFigure, drawsTheChainAsOneExactPath) {
    const SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}}, true, 5);
    const Figure figure = figureOf(curve, {});
    const Path& path = find(figure, "curve")->strokes.at(0).path;
    EXPECT_EQ(path, chain(solveSpline(curve).segments, true));
    EXPECT_EQ(path.degrees, (std::vector{5, 5, 5}));
}

TEST(SplineFigure, namesKnotsHandlesAndSegments) {
    const Figure figure = figureOf(curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}}), {});
    std::string names;
    for (const Label& label : find(figure, "labels")->labels)
        names += label.text + label.subscript + " ";
    EXPECT_EQ(names, "K0 K1 K2 P0 P1 P2 P3 c0 c1 ");
    EXPECT_EQ(find(figure, "labels")->labels[4].at, (Point{2, 2})); // P1 before the second knot
}

TEST(SplineFigure, showsTheKnotsOfACurveStillBeingDrawn) {
    const Figure figure = figureOf(curveThrough(Rule::mirror, {{1, 2}}), {});
    EXPECT_EQ(find(figure, "knots")->marks.at(0).at, (Points{{1, 2}}));
    EXPECT_FALSE(find(figure, "curve"));
    EXPECT_TRUE(figureOf(SplineCurve{}, {}).layers.size() <= layersOf(SplineCurve{}).size());
}

TEST(SplineFigure, leavesOutLabelsThatWouldCoverEachOther) {
    EXPECT_TRUE(find(figureOf(curveThrough(Rule::mirror, Points(1000, {1, 2})), {}), "labels"));
    EXPECT_FALSE(find(figureOf(curveThrough(Rule::mirror, Points(1001, {1, 2})), {}), "labels"));
}

TEST(SplineFigure, derivedLayersAreOffAtFirst) {
    const SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}});
    SheetView view;
    for (const char* name : {"curvature-comb", "all-rules", "inflections", "continuity"}) {
        EXPECT_FALSE(find(figureOf(curve, {0, true, &view}), name)) << name;
        view.layers[name] = true;
        EXPECT_TRUE(find(figureOf(curve, {0, true, &view}), name)) << name;
        EXPECT_FALSE(find(figureOf(curve, {0, false, &view}), name)) << name;
    }
}

TEST(SplineFigure, crossingsAreNotLookedForWhereTheirLayerIsOff) {
    Sheet sheet;
    sheet.curves = test::curves({curveThrough(Rule::mirror, {{0, 0}, {6, 0}, {3, 3}, {3, -3}})});
    EXPECT_TRUE(find(figureOf(sheet, test::kSpline), "crossings"));
    sheet.view.layers["crossings"] = false;
    EXPECT_EQ(figureOf(sheet, test::kSpline), figureOfCurves(sheet, 2));
}

} // namespace
} // namespace kriva
