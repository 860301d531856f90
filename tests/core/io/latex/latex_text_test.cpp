#include "core/io/latex/latex_text.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

TEST(LatexText, escapesWhatTexTakesForACommand) {
    EXPECT_EQ(latexText(R"(50 % & #1_{a}^b~c\d $)"),
              R"(50 \% \& \#1\_\{a\}\textasciicircum{}b\textasciitilde{}c\textbackslash{}d \$)");
}

TEST(LatexText, setsSignsOfFormulas) {
    EXPECT_EQ(latexText("×3 < 10⁻²"), R"($\times$3 $<$ 10$^{-}$$^{2}$)");
    EXPECT_EQ(latexFormula("−δ"), R"(-\delta)");
}

TEST(LatexText, keepsLettersAndNoControls) {
    EXPECT_EQ(latexText("Крива čšž"), "Крива čšž");
    EXPECT_EQ(latexText("a\nb\x01"
                        "c\xff"),
              "a b c ");
}

TEST(LatexText, knowsCyrillic) {
    EXPECT_TRUE(hasCyrillic("kриva"));
    EXPECT_FALSE(hasCyrillic("čšž δ"));
}

} // namespace
} // namespace kriva
