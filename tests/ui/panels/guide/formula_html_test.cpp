#include "ui/panels/guide/formula_html.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

std::string html(const char* page) {
    return withFormulas(QString::fromUtf8(page)).toStdString();
}

TEST(FormulaHtml, leavesTheRestOfThePageAsItIs) {
    EXPECT_EQ(html("<p>Nothing to <b>do</b> &amp; more</p>\n"), "<p>Nothing to <b>do</b> &amp; more</p>\n");
}

TEST(FormulaHtml, setsVariablesInItalicsAndLowersAndRaises) {
    EXPECT_EQ(html("a $b_i$ c"), "a <span class=\"math\"><i>b</i><sub><i>i</i></sub></span> c");
    EXPECT_EQ(html("$t^{n-1}$"), "<span class=\"math\"><i>t</i><sup><i>n</i>−1</sup></span>");
    EXPECT_EQ(html("$B'(0)$"), "<span class=\"math\"><i>B</i>′(0)</span>");
    EXPECT_EQ(html("$\\max x$"), "<span class=\"math\">max <i>x</i></span>");
    EXPECT_EQ(html("$a &lt; b$"), "<span class=\"math\"><i>a</i> &lt; <i>b</i></span>");
}

TEST(FormulaHtml, writesFractionsOfALineWithASlash) {
    EXPECT_EQ(html("$\\frac{1|2}$"), "<span class=\"math\">1/2</span>");
    EXPECT_EQ(html("$\\sum{i|n} i$"), "<span class=\"math\">Σ <i>i</i></span>");
    EXPECT_EQ(html("$\\int{0|1}$"), "<span class=\"math\">∫</span>");
}

TEST(FormulaHtml, pilesUpFractionsAndSumsOnALineOfTheirOwn) {
    const std::string fraction = html("$$\\frac{a|2}$$");
    EXPECT_NE(fraction.find("<td align=\"center\" class=\"frac-0\"><i>a</i></td>"), std::string::npos) << fraction;
    EXPECT_NE(fraction.find("<td align=\"center\" class=\"frac-1\">2</td>"), std::string::npos) << fraction;
    const std::string sum = html("$$\\sum{i|}$$");
    EXPECT_EQ(sum.find("sum-0"), std::string::npos) << sum;
    EXPECT_NE(sum.find("class=\"sum-1\">Σ"), std::string::npos) << sum;
    EXPECT_NE(sum.find("class=\"sum-2\"><i>i</i>"), std::string::npos) << sum;
}

TEST(FormulaHtml, letsALongFormulaGoOnInTheNextLineWhereNothingIsPiledUp) {
    EXPECT_EQ(html("$$a = b$$"), "<p class=\"formula\" align=\"center\"><i>a</i> = <i>b</i></p>");
    EXPECT_EQ(html("$$\\min x$$"), "<p class=\"formula\" align=\"center\">min <i>x</i></p>");
    EXPECT_NE(html("$$a = \\frac{1|2}$$").find("<i>a</i>&nbsp;=&nbsp;</td><td>"), std::string::npos);
}

TEST(FormulaHtml, keepsTheCoordinatesOfAPointTogether) {
    EXPECT_EQ(html("(7/2, 3/2), (0, 1)"), "(7/2,&nbsp;3/2), (0,&nbsp;1)");
}

TEST(FormulaHtml, takesAFormulaThatBreaksOff) {
    EXPECT_EQ(html("$a_$"), "<span class=\"math\"><i>a</i></span>");
    EXPECT_EQ(html("$a_{i$"), "<span class=\"math\"><i>a</i><sub><i>i</i></sub></span>");
    EXPECT_EQ(html("$\\frac{$"), "<span class=\"math\">/</span>");
    EXPECT_EQ(html("one $ sign"), "one $ sign");
}

} // namespace
} // namespace kriva::ui
