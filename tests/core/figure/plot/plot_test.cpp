#include "core/bezier/evaluate.h"
#include "core/figure/plot/bernstein_plot.h"
#include "core/figure/plot/plot_figure.h"
#include "core/figure/ticks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

const Layer* find(const Figure& figure, std::string_view name) {
    for (const Layer& layer : figure.layers)
        if (layer.name == name)
            return &layer;
    return nullptr;
}

Figure figureOfOne(const Plot& plot, PlotSize size = {}) {
    return plotFigure({&plot, 1}, size);
}

TEST(Ticks, stepByOneTwoFive) {
    EXPECT_EQ(roundStep(0.011), 0.02);
    EXPECT_EQ(roundStep(0.2), 0.2);
    EXPECT_EQ(roundStep(3), 5);
    EXPECT_EQ(roundStep(51), 100);
    EXPECT_EQ(decimalsOf(0.05), 2);
    EXPECT_EQ(decimalsOf(20), 0);
    EXPECT_EQ(multiples(5, -6, 11), (std::vector<double>{-5, 0, 5, 10}));
}

TEST(BernsteinPlot, hasTheWeightsAtT) {
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const Plot plot = bernsteinPlot(4, t);
        const std::vector<double> weights = bernstein(4, t);
        ASSERT_EQ(plot.lines.size(), 5U);
        for (std::size_t i = 0; i < weights.size(); ++i)
            EXPECT_NEAR(valueAt(plot.lines[i], t).value(), weights[i], 1e-15) << i;
    }
    EXPECT_FALSE(valueAt(bernsteinPlot(4, 0.5).lines[0], 1.5));
}

/// The heights of the entries, from the top.
std::vector<double> legendOf(int degree, double height) {
    std::vector<double> heights;
    const Figure figure = figureOfOne(bernsteinPlot(degree, 0.5), {90, height});
    for (const Label& label : find(figure, "plot-legend")->labels)
        heights.push_back(label.at.y);
    return heights;
}

TEST(PlotFigure, keepsItsLegendInsideAndLegible) {
    constexpr double kLetters = 3.2; // millimetres: the height of a line of 9 points
    for (const int degree : {2, 4, 15})
        for (const double height : {20.0, 27.0, 60.0}) {
            const std::vector<double> entries = legendOf(degree, height);
            ASSERT_FALSE(entries.empty());
            EXPECT_LE(entries.front() + kLetters / 2, height);
            EXPECT_GE(entries.back() - kLetters / 2, -0.1);
            for (std::size_t i = 1; i < entries.size(); ++i)
                EXPECT_GE(entries[i - 1] - entries[i], kLetters);
        }
    EXPECT_EQ(legendOf(4, 20).size(), 5U) << "closer together";
    EXPECT_LT(legendOf(15, 20).size(), 16U) << "no room for all";
}

TEST(PlotFigure, drawsLinesExactlyInsideTheFrame) {
    const Plot plot = bernsteinPlot(3, 0.5);
    const PlotSize size;
    const Box frame = plotFrame(plot, size);
    const Figure figure = figureOfOne(plot, size);
    const Layer& lines = *find(figure, "plot-lines");
    ASSERT_EQ(lines.strokes.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
        for (const double t : {0.0, 0.3, 0.8}) {
            const Point drawn = evaluate(lines.strokes[i].path.points, t);
            const Point meant = onPlot(plot, frame, {t, bernstein(3, t)[i]});
            EXPECT_NEAR(drawn.x, meant.x, 1e-12);
            EXPECT_NEAR(drawn.y, meant.y, 1e-12);
        }
    const Box box = boxOf(Figure{{lines}});
    EXPECT_GE(box.xmin, frame.xmin);
    EXPECT_LE(box.xmax, frame.xmax + 1e-9);
    EXPECT_GE(box.ymin, frame.ymin - 1e-9);
    EXPECT_LE(box.ymax, frame.ymax + 1e-9);
}

TEST(PlotFigure, cutsOffWhatIsBesideThePartOnView) {
    Plot plot = bernsteinPlot(3, 0.5);
    plot.x.low = 0.4;
    plot.x.high = 0.6;
    plot = withYFitted(plot);
    EXPECT_GT(plot.y.low, 0);
    EXPECT_LT(plot.y.high, 0.5);
    const Box frame = plotFrame(plot, {});
    const Figure figure = figureOfOne(plot);
    for (const Stroke& stroke : find(figure, "plot-lines")->strokes) {
        EXPECT_NEAR(stroke.path.points.front().x, frame.xmin, 1e-9);
        EXPECT_NEAR(stroke.path.points.back().x, frame.xmax, 1e-9);
    }
}

TEST(PlotFigure, marksWhatThePlotIsAbout) {
    const Plot plot = bernsteinPlot(2, 0.25);
    const Figure figure = figureOfOne(plot);
    const Box frame = plotFrame(plot, {});
    ASSERT_TRUE(find(figure, "plot-at"));
    const Points& marks = find(figure, "plot-at")->marks.front().at;
    ASSERT_EQ(marks.size(), 3U);
    EXPECT_NEAR(marks[1].y, onPlot(plot, frame, {0.25, 0.375}).y, 1e-12);
    EXPECT_NEAR(inPlot(plot, frame, marks[1]).x, 0.25, 1e-12);
}

TEST(PlotFigure, numbersLogarithmicAxesByPowersOfTen) {
    Plot plot{Caption::gap, {.isLogarithmic = true, .variable = "N"}, {.isLogarithmic = true}, {}};
    const Points gaps{{3, 0.5}, {100, 1e-6}};
    plot.lines.push_back({polyline(gaps)});
    plot = withAxesFitted(plot);
    EXPECT_EQ(plot.x.low, 1);
    EXPECT_EQ(plot.x.high, 100);
    EXPECT_NEAR(plot.y.low, 1e-6, 1e-20);
    EXPECT_EQ(plot.y.high, 1);
    const Figure figure = figureOfOne(plot);
    std::vector<double> numbers;
    std::vector<std::string> powers;
    for (const Label& label : find(figure, "plot-numbers")->labels)
        if (label.number)
            numbers.push_back(label.number->value);
        else
            powers.push_back(label.text);
    EXPECT_THAT(numbers, ::testing::IsSupersetOf({1.0, 10.0, 100.0}));
    EXPECT_THAT(powers, ::testing::Contains("10⁻⁶"));
}

TEST(PlotFigure, hasFurtherNumbersOnAPartOfALogarithmicAxis) {
    const auto numbersOf = [](double low, double high) {
        Plot plot{Caption::gap, {.low = low, .high = high, .isLogarithmic = true}, {}, {}};
        std::vector<double> numbers;
        const Figure figure = figureOfOne(plot);
        for (const Label& label : find(figure, "plot-numbers")->labels)
            if (label.number && label.side == LabelSide::below)
                numbers.push_back(label.number->value);
        return numbers;
    };
    EXPECT_THAT(numbersOf(3, 60), ::testing::ElementsAre(5, 10, 20, 50));
    EXPECT_THAT(numbersOf(1, 1e5), ::testing::ElementsAre(1, 10, 100, 1000));
    const std::vector<double> part = numbersOf(20, 30);
    EXPECT_GE(part.size(), 3U);
    EXPECT_THAT(part, ::testing::Each(::testing::AllOf(::testing::Ge(20), ::testing::Le(30))));
}

TEST(PlotFigure, putsPlotsOneAboveTheOther) {
    const std::vector<Plot> plots{bernsteinPlot(2, 0.5), bernsteinPlot(3, 0.5)};
    const PlotSize size{100, 60};
    const Figure figure = plotFigure(plots, size);
    const Page page = plotPage(2, size, 0);
    EXPECT_EQ(page.height, 120);
    const Layer& lines = *find(figure, "plot-lines");
    ASSERT_EQ(lines.strokes.size(), 7U);
    EXPECT_GT(lines.strokes[0].path.points[0].y, 60); // the first one at the top
    EXPECT_LT(lines.strokes[3].path.points[0].y, 60);
    EXPECT_EQ(std::ranges::count(figure.layers, std::string_view("plot-grid"), &Layer::name), 1);
}

TEST(PlotFigure, keepsCirclesRoundWhereItIsToScale) {
    Plot plot{Caption::hodograph, {}, {}, {}};
    plot.isToScale = true;
    const Points wide{{0, 0}, {30, 1}};
    plot.lines.push_back({polyline(wide)});
    plot = withAxesFitted(plot);
    const Box frame = plotFrame(plot, {});
    const Vector x = onPlot(plot, frame, {1, 0}) - onPlot(plot, frame, {0, 0});
    const Vector y = onPlot(plot, frame, {0, 1}) - onPlot(plot, frame, {0, 0});
    EXPECT_NEAR(x.x, y.y, 1e-12);
}

RC_GTEST_PROP(PlotProperty, marksStandOnTheirLines, (const std::vector<std::int8_t>& small)) {
    RC_PRE(small.size() >= 2 && small.size() < 12);
    std::vector<double> coefficients(small.begin(), small.end());
    Plot plot{Caption::none, {.low = -1, .high = 3}, {}, {{graphPath(coefficients, -1, 3)}}};
    plot = withYFitted(plot);
    const double x = *rc::gen::inRange(-100, 301) / 100.0;
    const std::optional<double> y = valueAt(plot.lines.front(), x);
    RC_ASSERT(y.has_value());
    RC_ASSERT(*y >= plot.y.low && *y <= plot.y.high);
}

} // namespace
} // namespace kriva
