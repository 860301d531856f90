#include "core/io/json/document_json.h"
#include "tests/core/sheets/spline/spline_values.h"
#include "tests/support/sheet_curves.h"

namespace kriva {
namespace {

using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

std::string documentWith(std::string_view curve) {
    return std::string(R"({"format":"kriva","version":1,"sheets":{"spline":{"curves":[)").append(curve).append("]}}}");
}

SplineCurve curveOf(std::string_view curve) {
    const auto read = readDocument(documentWith(curve));
    const Document* document = std::get_if<Document>(&read);
    EXPECT_TRUE(document) << curve;
    return document ? std::get<SplineCurve>(document->sheets[*sheetNamed("spline")].curves[0]) : SplineCurve{};
}

FileError errorOf(std::string_view curve) {
    const auto read = readDocument(documentWith(curve));
    EXPECT_TRUE(std::holds_alternative<FileError>(read)) << curve;
    return std::holds_alternative<FileError>(read) ? std::get<FileError>(read) : FileError{};
}

std::string placeOf(std::string_view curve) {
    return errorOf(curve).place;
}

RC_GTEST_PROP(SplineJson, everyCurveReadsBack, ()) {
    SplineCurve curve = test::anySpline();
    curve.name = "крива";
    curve.style.width = 2.5;
    curve.view.isShown = false;
    Document document;
    document.sheets[*sheetNamed("spline")].curves = test::curves({curve});
    const auto read = readDocument(writeDocument(document));
    RC_ASSERT(std::holds_alternative<Document>(read));
    RC_ASSERT(std::get<Document>(read) == document);
}

TEST(SplineJson, readsEveryKey) {
    const SplineCurve curve = curveOf(R"({"name":"a","degree":4,"rule":"catmull-rom","closed":true,
        "startDerivative":[1,2],"endDerivative":[3,4],
        "knots":[{"at":[0,0]},{"at":[3,2],"join":"corner","in":[2,2],"out":[4,2]},{"at":[5,0]}],
        "inner":{"2":[[4.5,1]]},"style":{"width":2},"view":{"shown":false}})");
    SplineCurve expected = test::curveThrough(Rule::catmullRom, {{0, 0}, {3, 2}, {5, 0}}, true, 4);
    expected.name = "a";
    expected.startDerivative = Vector{1, 2};
    expected.endDerivative = Vector{3, 4};
    expected.knots[1] = test::heldKnot({3, 2}, Join::corner, Point{2, 2}, Point{4, 2});
    expected.inner[2] = {{4.5, 1}};
    expected.style.width = 2;
    expected.view.isShown = false;
    EXPECT_EQ(curve, expected);
}

TEST(SplineJson, everyKeyButAtIsOptional) {
    EXPECT_EQ(curveOf("{}"), SplineCurve());
    const FileError error = errorOf(R"({"knots":[{"join":"auto"}]})");
    EXPECT_EQ(error.problem, FileProblem::missingKey);
    EXPECT_EQ(error.place, "sheets.spline.curves[0].knots[0]");
}

TEST(SplineJson, refusesWhatIsOutOfRange) {
    for (const char* curve : {R"({"degree":1})", R"({"degree":6})", R"({"degree":2.5})"})
        EXPECT_EQ(placeOf(curve), "sheets.spline.curves[0].degree");
    EXPECT_EQ(placeOf(R"({"rule":"catmullRom"})"), "sheets.spline.curves[0].rule");
    EXPECT_EQ(placeOf(R"({"closed":1})"), "sheets.spline.curves[0].closed");
    EXPECT_EQ(placeOf(R"({"endDerivative":[1]})"), "sheets.spline.curves[0].endDerivative");
    EXPECT_EQ(placeOf(R"({"knots":[{"at":[0,0]},{"at":[1,1],"join":"cusp"}]})"),
              "sheets.spline.curves[0].knots[1].join");
    EXPECT_EQ(placeOf(R"({"knots":[{"at":[0,0],"on":[1,1]}]})"), "sheets.spline.curves[0].knots[0].on");
}

TEST(SplineJson, asksForTheHandlesThatSegmentsUse) {
    const auto curve = [](std::string_view rest, std::string_view first) {
        return std::string("{")
            .append(rest)
            .append(R"("knots":[{"at":[0,0],"join":"corner")")
            .append(first)
            .append(R"(},{"at":[1,1]},{"at":[2,0]}]})");
    };
    EXPECT_EQ(errorOf(curve("", R"(,"in":[1,1])")).problem, FileProblem::missingKey);
    EXPECT_EQ(placeOf(curve("", R"(,"in":[1,1])")), "sheets.spline.curves[0].knots[0]");
    EXPECT_EQ(curveOf(curve("", R"(,"out":[1,1])")).knots[0].out, (Point{1, 1}));
    EXPECT_EQ(placeOf(curve(R"("closed":true,)", R"(,"out":[1,1])")), "sheets.spline.curves[0].knots[0]");
    EXPECT_EQ(curveOf(curve(R"("degree":2,)", "")).knots[0].join, Join::corner);
}

TEST(SplineJson, asksForNoHandlesWhileACurveIsBeingDrawn) {
    EXPECT_EQ(curveOf(R"({"knots":[{"at":[0,0],"join":"smooth"}]})").knots[0].join, Join::smooth);
    EXPECT_EQ(curveOf(R"({"closed":true,"knots":[{"at":[0,0],"join":"smooth"},{"at":[1,1]}]})").knots.size(), 2u);
}

TEST(SplineJson, keepsHandlesOfAutomaticKnots) {
    EXPECT_EQ(curveOf(R"({"knots":[{"at":[0,0],"in":[1,1]}]})").knots[0].in, (Point{1, 1}));
}

TEST(SplineJson, checksInnerPointsAgainstDegreeAndSegments) {
    const auto curve = [](int degree, std::string_view inner) {
        return std::string(R"({"knots":[{"at":[0,0]},{"at":[1,1]},{"at":[2,0]}],"degree":)")
            .append(1, static_cast<char>('0' + degree))
            .append(R"(,"inner":{)")
            .append(inner)
            .append("}}");
    };
    EXPECT_EQ(curveOf(curve(4, R"("1":[[1,2]])")).inner.size(), 1u);
    EXPECT_EQ(errorOf(curve(4, R"("2":[[1,2]])")).problem, FileProblem::noSuchIndex);
    EXPECT_EQ(placeOf(curve(4, R"("2":[[1,2]])")), "sheets.spline.curves[0].inner.2");
    EXPECT_EQ(errorOf(curve(4, R"("01":[[1,2]])")).problem, FileProblem::noSuchIndex);
    EXPECT_EQ(errorOf(curve(5, R"("1":[[1,2]])")).problem, FileProblem::wrongCount);
    EXPECT_EQ(placeOf(curve(5, R"("1":[[1,2]])")), "sheets.spline.curves[0].inner.1");
    EXPECT_EQ(curveOf(curve(3, R"("7":[[1,2],[3,4],[5,6]])")).inner.size(), 1u);
    EXPECT_EQ(placeOf(curve(3, R"("1":[[1,2,3]])")), "sheets.spline.curves[0].inner.1[0]");
}

TEST(SplineJson, doesNotYetAskWhichSegmentsAnIncompleteCurveHas) {
    EXPECT_EQ(curveOf(R"({"degree":4,"knots":[{"at":[0,0]}],"inner":{"5":[[1,2]]}})").inner.size(), 1u);
}

} // namespace
} // namespace kriva
