// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/text_table.hpp"

#include <gtest/gtest.h>

namespace hitos {
namespace {

const TextTable kTable{{"name", "area (m^2)"}, {{"a|b, 50 %", "1.5"}, {"\"x\"\ny", kNoFigure}}};

TEST(TextTable, CsvQuotesWhatNeedsIt) {
    EXPECT_EQ(csv(kTable), "name,area (m^2)\n\"a|b, 50 %\",1.5\n\"\"\"x\"\" y\",\n");
}

TEST(TextTable, NothingIsAFormula) {
    EXPECT_EQ(csv_line({"=cmd()", "+1+1", "-x", "@a", "\tb"}), "'=cmd(),'+1+1,'-x,'@a,\"'\tb\"\n");
    EXPECT_EQ(csv_line({"a\tb", "c\x1b[1m"}), "\"a\tb\",\"c\x1b[1m\"\n");
    EXPECT_EQ(csv_line({"-1.5", "+2", "-inf", "a=b", "", "\n=1"}), "-1.5,+2,-inf,a=b,, =1\n");
}

TEST(TextTable, TransposedTwiceItIsItself) {
    const TextTable turned = transposed(kTable);
    EXPECT_EQ(turned.head, (std::vector<std::string>{"name", "a|b, 50 %", "\"x\"\ny"}));
    ASSERT_EQ(turned.rows.size(), 1U);
    EXPECT_EQ(turned.rows[0], (std::vector<std::string>{"area (m^2)", "1.5", kNoFigure}));
    EXPECT_EQ(transposed(turned).rows, kTable.rows);
    EXPECT_TRUE(transposed({}).head.empty());
}

TEST(TextTable, MarkdownEscapesPipes) {
    EXPECT_EQ(markdown({{"a"}, {{"b|c\\d"}}}), "| a |\n|---:|\n| b\\|c\\\\d |\n");
}

TEST(TextTable, LatexEscapesWhatTexReads) {
    EXPECT_EQ(latex({{"m^2", "%"}, {{"a_b & c", kNoFigure}, {"~\\{", "$#"}}}),
              "\\begin{tabular}{rr}\n\\hline\nm$^2$ & \\% \\\\\n\\hline\n"
              "a\\_b \\& c & -- \\\\\n\\~{}\\textbackslash{}\\{ & \\$\\# \\\\\n"
              "\\hline\n\\end{tabular}\n");
    const std::string cell = latex({{"h"}, {{"^\\input\n^^41"}}});
    EXPECT_NE(cell.find("\\^{}\\textbackslash{}input \\^{}$^4$1"), std::string::npos) << cell;
}

}  // namespace
}  // namespace hitos
