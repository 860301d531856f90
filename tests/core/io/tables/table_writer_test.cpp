#include "core/io/tables/table_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace kriva {
namespace {

/// A language with a decimal comma and a minus of formulas.
TextSource comma() {
    return {[](Caption caption) {
                return caption == Caption::length ? std::string("Länge, L") : std::string("Wort & \"so\"");
            },
            [](double value, int decimals) {
                char text[64];
                std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value));
                std::string number = text;
                std::replace(number.begin(), number.end(), '.', ',');
                return (value < 0 ? "\u2212" : "") + number;
            },
            "de"};
}

const Table kTable{
    Caption::methods,
    {{Caption::none, "i", ""}, {Caption::length}, {Caption::none, "b", "2"}},
    {{{0}, {-0.1}, {Point{3.5, 1.5}}}, {{1}, {1e-7, true}, {}}, {{2}, {IndexRange{2, 11}}, {Caption::curve}}}};

TEST(TableWriter, writesDelimitedTextThatSpreadsheetsRead) {
    EXPECT_EQ(writeDelimited(kTable, comma()), "i,\"Länge, L\",b2 x,b2 y\n"
                                               "0,-0.1,3.5,1.5\n"
                                               "1,1e-07,,\n"
                                               "2,2–11,\"Wort & \"\"so\"\"\",\n");
}

TEST(TableWriter, writesLatexInTheLanguage) {
    EXPECT_EQ(writeLatex(kTable, comma()), "\\begin{tabular}{rrl}\n"
                                           "\\hline\n"
                                           "$i$ & Länge, L & $b_{2}$ \\\\\n"
                                           "\\hline\n"
                                           "$0$ & $-0{,}1$ & $(3{,}5;\\ 1{,}5)$ \\\\\n"
                                           "$1$ & $\\mathbf{1 \\cdot 10^{-7}}$ &  \\\\\n"
                                           "$2$ & 2–11 & Wort \\& \"so\" \\\\\n"
                                           "\\hline\n"
                                           "\\end{tabular}\n");
}

TEST(TableWriter, marksTheLeastOfAColumn) {
    Table table{Caption::methods, {{Caption::length}}, {{{2.0}}, {{1.0}}, {{}}, {{1.0}}}};
    markLeast(table, 0);
    EXPECT_FALSE(table.rows[0][0].isBest);
    EXPECT_TRUE(table.rows[1][0].isBest);
    EXPECT_FALSE(table.rows[2][0].isBest);
    EXPECT_TRUE(table.rows[3][0].isBest);
}

} // namespace
} // namespace kriva
