// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Plots over two logarithmic axes, side by side under one legend and over one caption, as an SVG picture.
namespace pcm::compare {

enum class Marker : std::uint8_t { circle, square, triangle, diamond };

struct CurveStyle {
  std::string colour;  ///< as SVG knows it
  Marker marker = Marker::circle;
  bool dashed = false;  ///< the line; its markers are hollow then
};

/// Points joined in their order. Curves of one name in several plots share an entry of the legend, and should share
/// their style.
struct PlotCurve {
  std::string name;
  CurveStyle style;
  std::vector<std::array<double, 2>> points;  ///< x and y, finite and positive
};

struct LogPlot {
  std::string title;
  std::string note;     ///< below the title, smaller: what the plot says, in a sentence
  std::string x_title;  ///< with its unit
  std::string y_title;
  std::vector<PlotCurve> curves;
};

struct Figure {
  std::string title;
  std::vector<LogPlot> plots;
  std::string caption;  ///< what is shown, for readers who know nothing else of it; wrapped
};

/// Axes end at powers of ten, which are labelled, every second or third where they are many. Asserts that there are
/// plots, that every plot has points and that all of them are positive.
std::string svg(const Figure& figure);

}  // namespace pcm::compare
