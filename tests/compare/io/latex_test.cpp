// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/latex.h"

#include <gtest/gtest.h>

namespace pcm::compare {
namespace {

TEST(Latex, EscapesWhatItWouldTakeForCommands) {
  EXPECT_EQ(latex_escaped("a_b & 5 % of {x^2} ~ $1 #2 c\\d"),
            "a\\_b \\& 5 \\% of \\{x\\textasciicircum{}2\\} \\textasciitilde{} \\$1 \\#2 c\\textbackslash{}d");
  EXPECT_EQ(latex_escaped("1 < 2 > 0 | x"), "1 \\textless{} 2 \\textgreater{} 0 \\textbar{} x");
}

TEST(Latex, TakesTheTablesOfMarkdownWithTheHeadingsAboveThem) {
  const std::string latex = latex_tables(
      "# Title\n\nWords | that are no table.\n\n## Errors of 5 %\n\n"
      "| pair | S/p |\n|:--|--:|\n| **all** | `a_b` |\n| [bolt](x.md#y) | 1e-9 \\| 2 |\n| short |\n\nmore words\n");
  EXPECT_EQ(latex,
            "% For a document with \\usepackage{booktabs,longtable}.\n"
            "\n% Errors of 5 %\n{\\footnotesize\n\\begin{longtable}{lr}\n\\toprule\npair & S/p \\\\\n\\midrule\n"
            "\\endhead\n\\textbf{all} & \\texttt{a\\_b} \\\\\nbolt & 1e-9 \\textbar{} 2 \\\\\nshort &  \\\\\n"
            "\\bottomrule\n\\end{longtable}}\n");
}

TEST(Latex, OfTextWithoutTablesIsItsFirstLineAlone) {
  EXPECT_EQ(latex_tables("# Title\n\n|\n\n| a row | without a rule |\n"),
            "% For a document with \\usepackage{booktabs,longtable}.\n");
  EXPECT_EQ(latex_tables(""), "% For a document with \\usepackage{booktabs,longtable}.\n");
}

TEST(Latex, TakesATableAtTheEndWithoutALineFeed) {
  EXPECT_NE(latex_tables("| a |\n|---|\n| 1 |").find("a \\\\\n\\midrule\n\\endhead\n1 \\\\\n\\bottomrule"),
            std::string::npos);
}

}  // namespace
}  // namespace pcm::compare
