#include "ui/clipboard/clip.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

const QString kOwn = QString::fromLatin1(kFragmentFormat);
const QString kSvg = QStringLiteral("image/svg+xml");

SubdivisionCurve arch() {
    SubdivisionCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 0.5}};
    curve.multiplicity = {1, 2, 1};
    return curve;
}

QString refusalOf(const QMimeData& clip, SheetIndex sheet = 1) {
    const auto read = readClip(clip, sheet);
    const QString* refusal = std::get_if<QString>(&read);
    return refusal ? *refusal : QStringLiteral("not refused");
}

TEST(Clip, isAFragmentAFigureAndATable) {
    const auto clip = clipOf({Fragment::Content::curve, Curve(arch())}, 10);
    EXPECT_EQ(clip->text(), QStringLiteral("0\t0\n1\t2\n3\t0.5"));
    EXPECT_EQ(clip->data(kSvg).count("<path"), 1);
    EXPECT_TRUE(clip->data(kOwn).startsWith("{\"format\": \"kriva-fragment\""));
    const auto read = readClip(*clip, 1);
    EXPECT_EQ(std::get<Fragment>(read), (Fragment{Fragment::Content::curve, Curve(arch())}));
}

TEST(Clip, ofOnePointHasNoFigure) {
    const std::vector<int> second{1};
    const auto clip = clipOf(fragmentOf(Curve(arch()), second), 10);
    EXPECT_FALSE(clip->hasFormat(kSvg));
    EXPECT_EQ(clip->text(), QStringLiteral("1\t2"));
}

TEST(Clip, ofAnotherSheetGivesItsPoints) {
    const auto clip = clipOf({Fragment::Content::curve, Curve(arch())}, 10);
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        const auto fragment = std::get<Fragment>(readClip(*clip, sheet));
        EXPECT_EQ(fragment.curve.index(), sheet);
        EXPECT_EQ(pointCount(fragment.curve), 3u);
        EXPECT_EQ(pointAt(fragment.curve, 2), (Point{3, 0.5}));
    }
}

TEST(Clip, ofPathsGivesACurveForEach) {
    const auto curvesOf = [](const QMimeData& clip, SheetIndex sheet) {
        return std::get<std::vector<Curve>>(readClip(clip, sheet));
    };
    QMimeData text;
    text.setText(QStringLiteral(" M0 0C1 -2 3 -2 4 0m1 0h1"));
    const std::vector<Curve> curves = curvesOf(text, 2);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(segmentsOf(std::get<SplineCurve>(curves[0])).front(), (Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}}));
    EXPECT_EQ(std::get<ElevationCurve>(curvesOf(text, 0)[0]).points, (Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}}));
    // What other programs put there, and what Kriva puts there for them.
    QMimeData figure;
    figure.setData(kSvg, "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0L1 -1'/></svg>");
    EXPECT_EQ(pointCount(curvesOf(figure, 3)[0]), 2u);
    const auto own = clipOf({Fragment::Content::curve, Curve(arch())}, 10);
    QMimeData drawn;
    drawn.setData(kSvg, own->data(kSvg));
    EXPECT_EQ(curvesOf(drawn, 0).size(), 1u);
}

TEST(Clip, tellsWhyItIsRefused) {
    EXPECT_EQ(refusalOf({}), QStringLiteral("The clipboard: there are no points"));
    QMimeData clip;
    clip.setText(QStringLiteral("1\t2\nthree\t4"));
    EXPECT_EQ(refusalOf(clip), QString::fromUtf8("The clipboard: line 2, column 1: “three” is no number"));
    clip.setText(QStringLiteral("M0 0L1"));
    EXPECT_EQ(refusalOf(clip), QStringLiteral("The clipboard: line 1, column 7: this is no path data"));
    clip.setData(kOwn, R"({"format":"kriva-fragment","version":1,"content":"points","sheet":"combined",)"
                       R"("curve":{"points":[[0,0],[1,"2"]]}})");
    EXPECT_EQ(refusalOf(clip), QStringLiteral("The clipboard: its curve cannot be read: expected two finite numbers"));
}

} // namespace
} // namespace kriva::ui
