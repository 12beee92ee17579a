// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/pictures/svg_plot.h"
#include "compare/io/pictures/svg.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/compare/io/occurrences.h"
#include "tests/compare/io/well_formed_xml.h"

namespace pcm::compare {
namespace {

using Points = std::vector<std::array<double, 2>>;

PlotCurve curve(const char* name, const Points& points, Marker marker = Marker::circle, bool dashed = false) {
  PlotCurve curve;
  curve.name = name;
  curve.style.colour = "#0072B2";
  curve.style.marker = marker;
  curve.style.dashed = dashed;
  curve.points = points;
  return curve;
}

Figure figure_of(const PlotCurve& first) {
  Figure figure;
  figure.title = "title & more";
  figure.caption = "caption \"in words\"";
  LogPlot& plot = figure.plots.emplace_back();
  plot.title = "plot";
  plot.note = "note";
  plot.x_title = "time, s";
  plot.y_title = "error < 1";
  plot.curves.push_back(first);
  return figure;
}

TEST(SvgPlot, PointsLieWhereTheirLogarithmsDo) {
  // One decade each way: two corners of the plot and its middle.
  const double root = std::sqrt(10.0);
  const std::string picture = svg(figure_of(curve("a", {{1, 1e-3}, {root, 1e-3 * root}, {10, 1e-2}})));
  const std::size_t frame = picture.rfind("<rect ", picture.find("fill=\"none\" stroke=\"#666666\""));
  double x = 0, y = 0, width = 0, height = 0;
  ASSERT_EQ(std::sscanf(picture.c_str() + frame, R"(<rect x="%lf" y="%lf" width="%lf" height="%lf")", &x, &y, &width,
                        &height),
            4);
  std::array<double, 6> p{};
  ASSERT_EQ(std::sscanf(picture.c_str() + picture.find("<polyline", frame),
                        R"(<polyline points="%lf,%lf %lf,%lf %lf,%lf")", &p[0], &p[1], &p[2], &p[3], &p[4], &p[5]),
            6);
  const std::array<double, 6> expected{x, y + height, x + width / 2, y + height / 2, x + width, y};
  for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(p[k], expected[k], 0.11) << k;
}

TEST(SvgPlot, IsWellFormedAndSaysEverything) {
  Figure figure = figure_of(curve("<a>", {{1, 1}, {2, 3}}, Marker::square));
  figure.plots[0].curves.push_back(curve("b", {{5, 7}}, Marker::triangle, true));
  figure.plots[0].curves.push_back(curve("c", {{5, 8}}, Marker::diamond));
  const std::string picture = svg(figure);
  EXPECT_EQ(fault_in_xml(picture), "") << picture;
  for (const char* words : {"title &amp; more", "time, s", "error &lt; 1", "caption &quot;in words&quot;", "&lt;a&gt;",
                            "stroke-dasharray", "note"})
    EXPECT_NE(picture.find(words), std::string::npos) << words;
}

TEST(SvgPlot, CurvesOfOneNameShareAnEntryOfTheLegend) {
  Figure figure = figure_of(curve("shared", {{1, 1}, {2, 3}}));
  const LogPlot again = figure.plots.front();
  figure.plots.push_back(again);
  EXPECT_EQ(count(svg(figure), ">shared<"), 1U);
}

TEST(SvgPlot, LabelsOfManyDecadesKeepTheirDistance) {
  // Fourteen decades have a label each, forty every second or so.
  EXPECT_EQ(count(svg(figure_of(curve("a", {{1, 1e-14}, {10, 1}}))), ">10<tspan"), 2U + 15U);
  EXPECT_EQ(count(svg(figure_of(curve("a", {{1, 1e-40}, {10, 1}}))), ">10<tspan"), 2U + 21U);
}

TEST(SvgPlot, WordsAreWrappedAtBlanksAndCountedAsCharacters) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrapped("one two  three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapped("incomprehensibilities so", 5), (Lines{"incomprehensibilities", "so"}));
  EXPECT_EQ(wrapped("m\u00b3 m\u00b3", 5), (Lines{"m\u00b3 m\u00b3"}));
  EXPECT_TRUE(wrapped("", 5).empty());
}

TEST(WellFormedXml, FaultsAreFound) {
  EXPECT_EQ(fault_in_xml("<?xml version=\"1.0\"?>\n<a><b c=\"d>e\"/>f &amp; g</a>\n"), "");
  for (const char* bad : {"<a>", "<a></b>", "<a/><a/>", "<a>&</a>", "<a", "words", "<a b=\"<\"/>"})
    EXPECT_NE(fault_in_xml(bad), "") << bad;
}

}  // namespace
}  // namespace pcm::compare
