// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/svg_plot.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/compare/well_formed_xml.h"

namespace pcm::compare {
namespace {

Figure figure_of(const std::vector<PlotCurve>& curves) {
  return {"title & more", {{"plot", "note", "time, s", "error < 1", curves}}, "caption \"in words\""};
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(SvgPlot, PointsLieWhereTheirLogarithmsDo) {
  // One decade each way: the corners of the plot and its middle, where both are the square root of ten.
  const std::string picture =
      svg(figure_of({{"a", {"#0072B2"}, {{1, 1e-3}, {3.16227766016838, 3.16227766016838e-3}, {10, 1e-2}}}}));
  const std::size_t frame = picture.find("fill=\"none\" stroke=\"#666666\"");
  const std::size_t begin = picture.rfind("<rect ", frame);
  double x = 0, y = 0, width = 0, height = 0;
  ASSERT_EQ(std::sscanf(picture.c_str() + begin, R"(<rect x="%lf" y="%lf" width="%lf" height="%lf")", &x, &y, &width,
                        &height),
            4);
  double points[6] = {};
  const std::size_t curve = picture.find("<polyline", begin);
  ASSERT_EQ(std::sscanf(picture.c_str() + curve, R"(<polyline points="%lf,%lf %lf,%lf %lf,%lf")", &points[0],
                        &points[1], &points[2], &points[3], &points[4], &points[5]),
            6);
  EXPECT_NEAR(points[0], x, 0.11);
  EXPECT_NEAR(points[1], y + height, 0.11);
  EXPECT_NEAR(points[2], x + width / 2, 0.11);
  EXPECT_NEAR(points[3], y + height / 2, 0.11);
  EXPECT_NEAR(points[4], x + width, 0.11);
  EXPECT_NEAR(points[5], y, 0.11);
}

TEST(SvgPlot, IsWellFormedAndSaysEverything) {
  const std::string picture = svg(figure_of({{"<a>", {"red", Marker::square}, {{1, 1}, {2, 3}}},
                                             {"b", {"blue", Marker::triangle, true}, {{5, 7}}},
                                             {"c", {"green", Marker::diamond}, {{5, 8}}}}));
  EXPECT_EQ(fault_in_xml(picture), "") << picture;
  for (const char* words : {"title &amp; more", "time, s", "error &lt; 1", "caption &quot;in words&quot;", "&lt;a&gt;",
                            "stroke-dasharray", "note"})
    EXPECT_NE(picture.find(words), std::string::npos) << words;
}

TEST(SvgPlot, CurvesOfOneNameShareAnEntryOfTheLegend) {
  Figure figure = figure_of({{"shared", {"red"}, {{1, 1}, {2, 3}}}});
  figure.plots.push_back(figure.plots.front());
  EXPECT_EQ(count(svg(figure), ">shared<"), 1U);
}

TEST(SvgPlot, LabelsOfManyDecadesKeepTheirDistance) {
  // Fourteen decades have a label each, forty every second.
  EXPECT_EQ(count(svg(figure_of({{"a", {"red"}, {{1, 1e-14}, {10, 1}}}})), ">10<tspan"), 2U + 15U);
  EXPECT_EQ(count(svg(figure_of({{"a", {"red"}, {{1, 1e-40}, {10, 1}}}})), ">10<tspan"), 2U + 14U);
}

TEST(SvgPlot, WordsAreWrappedAtBlanksAndCountedAsCharacters) {
  EXPECT_EQ(wrapped("one two  three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("incomprehensibilities so", 5), (std::vector<std::string>{"incomprehensibilities", "so"}));
  EXPECT_EQ(wrapped("m\u00b3 m\u00b3", 5), (std::vector<std::string>{"m\u00b3 m\u00b3"}));
  EXPECT_TRUE(wrapped("", 5).empty());
}

TEST(WellFormedXml, FaultsAreFound) {
  EXPECT_EQ(fault_in_xml("<?xml version=\"1.0\"?>\n<a><b c=\"d>e\"/>f &amp; g</a>\n"), "");
  for (const char* bad : {"<a>", "<a></b>", "<a/><a/>", "<a>&</a>", "<a", "words", "<a b=\"<\"/>"})
    EXPECT_NE(fault_in_xml(bad), "") << bad;
}

}  // namespace
}  // namespace pcm::compare
