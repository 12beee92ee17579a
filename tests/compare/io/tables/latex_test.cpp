// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/latex.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "meshes/files/text_file.h"
#include "tests/compare/io/occurrences.h"
#include "tests/meshes/temporary_folder.h"

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

TEST(Latex, CutsATableThatIsWiderThanAPageIntoSeveralWithTheNamesInEach) {
  std::string heading = "| pair |", rule = "|---|", row = "| a |";
  for (int k = 0; k < 30; ++k) {
    heading += " column " + std::to_string(k) + " |";
    rule += "--:|";
    row += " " + std::to_string(k) + ".5 |";
  }
  const std::string latex = latex_tables(heading + "\n" + rule + "\n" + row + "\n");
  EXPECT_EQ(count(latex, "\\begin{longtable}{lr"), 4U) << latex;
  EXPECT_EQ(count(latex, "\npair & column"), 4U);
  EXPECT_EQ(count(latex, "\na & "), 4U);
  EXPECT_EQ(count(latex, ".5"), 30U);
  EXPECT_EQ(count(latex, "column"), 30U);
}

// Of two bytes each: 22 characters in each of four cells fit where 44 do not.
TEST(Latex, CutsTablesByTheirCharactersNotBytes) {
  const auto parts_of = [](const std::string& character) {
    std::string row = "| name |";
    for (int cell = 0; cell < 4; ++cell) {
      row += ' ';
      for (int k = 0; k < 22; ++k) row += character;
      row += " |";
    }
    const std::string latex = latex_tables("| a | b | c | d | e |\n|---|--:|--:|--:|--:|\n" + row + "\n");
    return count(latex, "begin{longtable}");
  };
  EXPECT_EQ(parts_of("\xc3\xa9"), 1U);
  EXPECT_EQ(parts_of("ee"), 2U);
}

TEST(Latex, FitsOnPages) {
  if (std::system("pdflatex --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "pdflatex (Debian: texlive-latex-recommended) is not installed";
  const TemporaryFolder scratch;
  std::string text;
  for (const int columns : {4, 9, 11, 12, 13, 14, 30}) {
    std::string heading = "| pair |", rule = "|---|", row = "| bumpy-bumpy_2 |";
    for (int k = 0; k < columns; ++k) {
      heading += " p99.9 |";
      rule += "--:|";
      row += " 1.2e-13 |";
    }
    text += "# " + std::to_string(columns) + " columns\n\n" + heading + "\n" + rule + "\n" + row + "\n\n";
  }
  scratch.write("tables.tex", latex_tables(text));
  scratch.write("report.tex",
                "\\documentclass{article}\\usepackage{booktabs,longtable}\n"
                "\\begin{document}\\input{tables}\\end{document}\n");
  const std::string command =
      "cd '" + scratch.path().string() + "' && pdflatex -interaction=batchmode report > /dev/null";
  ASSERT_EQ(std::system((command + " && " + command).c_str()), 0);
  EXPECT_EQ(count(read_text_file(scratch.path("report.log")), "Overfull"), 0U);
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
