#include "core/bezier/evaluate.h"
#include "core/document/sheet_figure.h"
#include "core/sheets/combined/monotone_runs.h"
#include "core/sheets/spline/chain/spline_curve.h"
#include "tests/support/documents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace kriva {
namespace {

const std::filesystem::path kFolder = KRIVA_SOURCE_DIR "/resources/examples";

std::string textOf(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::filesystem::path> examples() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder))
        if (entry.path().extension() == ".kriva")
            files.push_back(entry.path());
    return files;
}

bool hasCompleteCurve(const Sheet& sheet) {
    return std::ranges::any_of(sheet.curves, [](const Curve& curve) { return !isIncomplete(curve); });
}

template <class C>
C firstCurve(const char* name) {
    const Document document = test::documentOf(textOf(kFolder / name));
    return std::get<C>(document.sheets[*sheetNamed(C::kSheet)].curves.at(0));
}

/// How often a chain of segments crosses itself, seen as a polyline with many corners.
int selfCrossings(const std::vector<Points>& segments) {
    Points line;
    for (const Points& segment : segments)
        for (int i = 0; i < 50; ++i)
            line.push_back(evaluate(segment, i / 50.0));
    line.push_back(segments.back().back());
    const auto side = [](Point a, Point b, Point p) { return cross(b - a, p - a) > 0; };
    int crossings = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (std::size_t j = i + 2; j + 1 < line.size(); ++j) {
            const Point a = line[i], b = line[i + 1], c = line[j], d = line[j + 1];
            const bool isClosing = i == 0 && j + 2 == line.size() && a == d;
            if (!isClosing && side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b))
                ++crossings;
        }
    return crossings;
}

TEST(Examples, areThere) {
    EXPECT_EQ(examples().size(), 10u);
}

TEST(Examples, areWrittenAsTheEditorWritesThem) {
    for (const auto& file : examples())
        EXPECT_EQ(writeDocument(test::documentOf(textOf(file))), textOf(file)) << file;
}

TEST(Examples, showACurveAndHaveAReport) {
    for (const auto& file : examples()) {
        const Document document = test::documentOf(textOf(file));
        EXPECT_TRUE(hasCompleteCurve(document.sheets[document.active])) << file;
        EXPECT_FALSE(figureOf(document.sheets[document.active], document.active).layers.empty()) << file;
        EXPECT_TRUE(std::holds_alternative<std::string>(reportJson(document, "example.kriva"))) << file;
    }
}

TEST(Examples, startWithSomethingInEveryTabAndNoCurveInSubdivision) {
    const Document document = test::documentOf(textOf(kFolder / "start.kriva"));
    for (const Sheet& sheet : document.sheets)
        EXPECT_TRUE(hasCompleteCurve(sheet));
    EXPECT_FALSE(document.sheets[*sheetNamed("subdivision")].view.layers.at("curve"));
}

TEST(Examples, crossThemselvesThreeTimesInAChainThatIsC1) {
    const std::vector<Points> segments = solveSpline(firstCurve<SplineCurve>("self-intersections.kriva")).segments;
    EXPECT_EQ(selfCrossings(segments), 3);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Points& next = segments[(i + 1) % segments.size()];
        EXPECT_LE(length(derivative(segments[i], 1) - derivative(next, 0)), 1e-12);
    }
}

TEST(Examples, runFiveTimesToAndFro) {
    EXPECT_EQ(monotoneRuns(firstCurve<CombinedCurve>("five-runs.kriva").points).size(), 5u);
}

TEST(Examples, interpolateAndApproximateTheSamePointsOfRungesFunction) {
    const Document document = test::documentOf(textOf(kFolder / "runge.kriva"));
    const std::vector<Curve>& curves = document.sheets[*sheetNamed("combined")].curves;
    ASSERT_EQ(curves.size(), 2u);
    const auto& interpolated = std::get<CombinedCurve>(curves[0]);
    EXPECT_EQ(interpolated.points, std::get<CombinedCurve>(curves[1]).points);
    ASSERT_EQ(interpolated.points.size(), 11u);
    for (const Point p : interpolated.points)
        EXPECT_DOUBLE_EQ(p.y, 1 / (1 + 25 * p.x * p.x));
}

} // namespace
} // namespace kriva
