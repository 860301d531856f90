#include "core/sheets/combined/combined.h"
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/spline/chain/spline_curve.h"
#include "core/sheets/subdivision/subdivision.h"
#include "ui/base/examples.h"
#include "ui/base/language/language.h"
#include "ui/panels/guide/formula_html.h"
#include "ui/panels/guide/guide_figure.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <set>

namespace kriva::ui {
namespace {

QString page(Language language, SheetIndex sheet) {
    const std::string_view name = sheetName(sheet);
    QFile file(QStringLiteral(":/guide/%1/%2.html")
                   .arg(languageCode(language), QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()))));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList found(const QString& text, const char* pattern) {
    QStringList all;
    for (auto matches = QRegularExpression(QString::fromUtf8(pattern)).globalMatch(text); matches.hasNext();)
        all.append(matches.next().captured(1));
    return all;
}

constexpr const char* kPair = "(\\([−/\\d]+,\\s[−/\\d]+\\))";

QStringList sorted(QStringList list) {
    for (QString& one : list)
        one = one.simplified(); // a line may end in it
    list.sort();
    return list;
}

QStringList formulasOfLines(QString text) {
    text.remove(QRegularExpression(QStringLiteral("\\$\\$[^$]+\\$\\$")));
    return sorted(found(text, "\\$([^$]+)\\$"));
}

Document figureDocument(const char* name) {
    return exampleDocument(QStringLiteral(":/guide/figures/%1.kriva").arg(QLatin1String(name)));
}

template <class C>
const C& curveOf(const Document& document) {
    return std::get<C>(document.sheets[document.active].curves.front());
}

class GuidePages : public testing::TestWithParam<std::tuple<Language, SheetIndex>> {
  protected:
    const QString text = page(std::get<0>(GetParam()), std::get<1>(GetParam()));
    const QString english = page(Language::English, std::get<1>(GetParam()));
};

TEST_P(GuidePages, tellWhatTheTabShowsHowToUseItAndItsMathematics) {
    EXPECT_EQ(found(text, "<(h1)>").size(), 1);
    EXPECT_GE(found(text, "<(h2)>").size(), 6);
    EXPECT_GE(found(text, "(figure):").size(), 3);
    EXPECT_GE(found(text, "\\$\\$(.+)\\$\\$").size(), 6);
    EXPECT_GT(text.size(), 3500);
}

TEST_P(GuidePages, sayTheSameInEveryLanguage) {
    for (const char* pattern : {"<(h\\d|ul|li|p|td|b)\\b", "src=\"([^\"]+)\"", "\\$\\$([^$]+)\\$\\$"})
        EXPECT_EQ(found(text, pattern), found(english, pattern)) << pattern;
    // Words stand in another order now and then, and with them what they speak of.
    EXPECT_EQ(formulasOfLines(text), formulasOfLines(english));
    EXPECT_EQ(sorted(found(text, kPair)), sorted(found(english, kPair)));
}

TEST_P(GuidePages, nameThingsAsTheProgramDoes) {
    struct Name {
        const char* context;
        const char* source;
    };
    static const std::array<std::vector<Name>, kSheetCount> names{{
        {{"Properties", "Degree"}, {"kriva::ui::Player", "Keep this stage"}, {"Menus", "A cubic raised 97 times"}},
        {{"Properties", "Parameter t"},
         {"Properties", "Levels"},
         {"Properties", "Runs over"},
         {"PointColumn", "Multiplicity"},
         {"kriva::ui::SubdivisionProperties", "Show the curve"},
         {"kriva::ui::SubdivisionProperties", "Show the blossom"},
         {"kriva::ui::Player", "Keep this stage"},
         {"Actions", "Delete &last point"},
         {"Actions", "&Clear the canvas"},
         {"Caption", "Curves of degree n − 1"},
         {"Menus", "De Casteljau at t = 1/2"}},
        {{"Menus", "A chain with three self-intersections"}},
        {{"Properties", "Basis"},
         {"kriva::ui::CombinedProperties", "Back to automatic"},
         {"Menus", "A curve with five monotone runs"},
         {"Menus", "Use these &points in"}},
    }};
    const LanguageSwitch language(std::get<0>(GetParam()));
    const QString words = text.simplified(); // a line may end in a name
    for (const Name& name : names[std::get<1>(GetParam())]) {
        const QString shown =
            QCoreApplication::translate(name.context, name.source).remove(QLatin1Char('&')).simplified();
        EXPECT_TRUE(words.contains(shown)) << shown.toStdString();
    }
    EXPECT_TRUE(words.contains(QCoreApplication::translate("Menus", "Exa&mples").remove(QLatin1Char('&'))));
}

TEST_P(GuidePages, leaveNoFormulaUnread) {
    const QString html = withFormulas(text);
    for (const char sign : {'$', '\\', '_', '^', '{', '~'})
        EXPECT_FALSE(html.contains(QLatin1Char(sign))) << sign;
}

TEST_P(GuidePages, leadNowhereElse) {
    EXPECT_FALSE(text.contains(QLatin1String("href")));
    EXPECT_FALSE(text.contains(QLatin1String("://")));
    EXPECT_FALSE(text.contains(QRegularExpression(QStringLiteral("#[0-9a-f]{3,6}|color"))))
        << "colours are the theme's";
}

TEST_P(GuidePages, haveEveryPicture) {
    for (const QString& name : found(text, "figure:([^\"]+)\"")) {
        for (const Theme theme : {Theme::light, Theme::dark}) {
            const QImage picture = guideFigure(name, {320, 2, theme});
            ASSERT_FALSE(picture.isNull()) << name.toStdString();
            EXPECT_EQ(picture.width(), 640);
            EXPECT_GT(picture.height(), 100);
            EXPECT_LE(picture.height(), 512);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(InEvery, GuidePages,
                         testing::Combine(testing::ValuesIn(kLanguages), testing::Range<SheetIndex>(0, kSheetCount)),
                         [](const auto& one) {
                             return languageCode(std::get<0>(one.param)).toStdString() +
                                    std::string(sheetName(std::get<1>(one.param)));
                         });

TEST(GuideFigures, areAllUsed) {
    std::set<QString> used;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        for (const QString& name : found(page(Language::English, sheet), "figure:([^\"]+)\""))
            used.insert(name + QStringLiteral(".kriva"));
    const QStringList files = QDir(QStringLiteral(":/guide/figures")).entryList();
    EXPECT_EQ(used, std::set<QString>(files.begin(), files.end()));
}

TEST(GuideFigures, areNothingWhereThereIsNoDocument) {
    EXPECT_TRUE(guideFigure(QStringLiteral("nothing"), {320, 1, Theme::light}).isNull());
}

TEST(GuideFigures, areInTheColoursOfTheTheme) {
    const QString name = QStringLiteral("de-casteljau");
    EXPECT_NE(guideFigure(name, {320, 1, Theme::light}), guideFigure(name, {320, 1, Theme::dark}));
    EXPECT_EQ(guideFigure(name, {320, 1, Theme::light}), guideFigure(name, {320, 1, Theme::light}));
}

// The numbers that the pages state, as core works them out from the documents of their pictures.

TEST(GuideNumbers, ofDegreeElevation) {
    const auto once = elevate(curveOf<ElevationCurve>(figureDocument("elevation-once")));
    EXPECT_EQ(once.polygon, (Points{{0, 0}, {3, 6}, {8, 8}, {13, 6}, {16, 0}}));
    EXPECT_DOUBLE_EQ(once.gap, 2);
    const auto often = elevate(curveOf<ElevationCurve>(figureDocument("elevation-97")));
    EXPECT_EQ(often.polygon.size(), 101);
    EXPECT_NEAR(often.gap, 2.0 / 33, 1e-14);
    ElevationCurve curve = curveOf<ElevationCurve>(figureDocument("elevation-once"));
    for (const int degree : {4, 6, 10, 50, 64}) {
        curve.times = degree - 3;
        EXPECT_NEAR(elevate(curve).gap, 6.0 / (degree - 1), 1e-14) << degree;
    }
}

TEST(GuideNumbers, ofDeCasteljausScheme) {
    const Subdivision result = subdivide(curveOf<SubdivisionCurve>(figureDocument("de-casteljau")));
    EXPECT_EQ(result.triangle[1], (Points{{0, 1}, {4, 2}, {6, 1}}));
    EXPECT_EQ(result.triangle[2], (Points{{2, 1.5}, {5, 1.5}}));
    EXPECT_EQ(result.triangle[3], (Points{{3.5, 1.5}}));
    EXPECT_EQ(result.halves.left, (Points{{0, 0}, {0, 1}, {2, 1.5}, {3.5, 1.5}}));
    EXPECT_EQ(result.halves.right, (Points{{3.5, 1.5}, {5, 1.5}, {6, 1}, {4, 0}}));
}

TEST(GuideNumbers, ofTheChain) {
    const auto chain = solveSpline(curveOf<SplineCurve>(figureDocument("chain")));
    EXPECT_EQ(chain.segments[0], (Points{{0, 0}, {2, 2}, {4, 4}, {6, 6}}));
    EXPECT_EQ(chain.segments[1], (Points{{6, 6}, {8, 8}, {10, 4}, {12, 0}}));
    EXPECT_EQ(chain.segments[2], (Points{{12, 0}, {14, -4}, {16, 1}, {18, 6}}));
}

TEST(GuideNumbers, ofTheQuadraticJoin) {
    const auto curve = combine(curveOf<CombinedCurve>(figureDocument("join")));
    ASSERT_EQ(curve.joins.size(), 1);
    EXPECT_EQ(curve.joins[0].points, (Points{{4, 4}, {5, 6}, {3, 8}}));
}

} // namespace
} // namespace kriva::ui
