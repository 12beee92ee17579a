// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/pictures/svg_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compare/io/pictures/svg.h"

namespace pcm::compare {
namespace {

// Lengths in pixels.
constexpr double kPlotWidth = 390, kPlotHeight = 360;
constexpr double kLeft = 92, kGap = 108, kRight = 30;
constexpr double kExponentSize = 10;
constexpr double kLegendEntry = 310;
constexpr double kMarker = 4.5;  ///< half its width

constexpr const char* kGrey = "#666666";

std::string text(double x, double y, double size, std::string_view anchor, std::string_view words,
                 std::string_view more = "") {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" font-size="{:g}" text-anchor="{}"{}>{}</text>)"
                     "\n",
                     x, y, size, anchor, more, escaped(words));
}

std::string line(double x1, double y1, double x2, double y2, std::string_view colour, double width) {
  return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="{}" stroke-width="{:g}"/>)"
                     "\n",
                     x1, y1, x2, y2, colour, width);
}

std::string lines(const std::vector<std::string>& paragraph, double x, double y, std::string_view colour) {
  std::string picture;
  for (std::size_t i = 0; i < paragraph.size(); ++i)
    picture += text(x, y + kLine * static_cast<double>(i), kTextSize, "start", paragraph[i],
                    fmt::format(R"( fill="{}")", colour));
  return picture;
}

/// A logarithmic axis between powers of ten.
class LogAxis {
 public:
  LogAxis(const std::vector<PlotCurve>& curves, std::size_t coordinate, double begin, double end)
      : begin_(begin), end_(end) {
    double least = HUGE_VAL, greatest = 0;
    for (const PlotCurve& curve : curves)
      for (const auto& point : curve.points) {
        assert(std::isfinite(point[coordinate]) && point[coordinate] > 0);
        least = std::min(least, point[coordinate]);
        greatest = std::max(greatest, point[coordinate]);
      }
    assert(greatest > 0);
    low_ = static_cast<int>(std::floor(std::log10(least)));
    high_ = std::max(low_ + 1, static_cast<int>(std::ceil(std::log10(greatest))));
  }

  int low() const { return low_; }
  int high() const { return high_; }
  double decade() const { return std::abs(end_ - begin_) / (high_ - low_); }
  double at(double value) const { return begin_ + (end_ - begin_) * (std::log10(value) - low_) / (high_ - low_); }

  /// Labels keep `room` from each other.
  bool labelled(int power, double room) const {
    const int step = static_cast<int>(std::ceil(room / decade()));
    return (power - low_) % step == 0;
  }

 private:
  double begin_, end_;
  int low_ = 0, high_ = 1;
};

/// 10 to this power, an exponent as raised text.
std::string power_of_ten(double x, double y, std::string_view anchor, int power) {
  const std::string sign = power < 0 ? "\u2212" : "";
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" font-size="{:g}" text-anchor="{}">10<tspan dy="-5" )"
                     R"(font-size="{:g}">{}{}</tspan></text>)"
                     "\n",
                     x, y, kTextSize, anchor, kExponentSize, sign, std::abs(power));
}

/// Grid, ticks and labels; minor grid lines where decades have room for them.
std::string axes(const LogPlot& plot, const LogAxis& x, const LogAxis& y, double left, double top) {
  const double right = left + kPlotWidth, bottom = top + kPlotHeight;
  constexpr double kRoomForMinor = 40;
  const auto minor = [](const LogAxis& axis, const auto& draw) {
    if (axis.decade() < kRoomForMinor) return;
    for (int power = axis.low(); power < axis.high(); ++power)
      for (int digit = 2; digit <= 9; ++digit) draw(axis.at(digit * std::pow(10.0, power)));
  };
  std::string picture;
  minor(x, [&](double at) { picture += line(at, top, at, bottom, "#f0f0f0", 1); });
  minor(y, [&](double at) { picture += line(left, at, right, at, "#f0f0f0", 1); });
  for (int power = x.low(); power <= x.high(); ++power) {
    const double at = x.at(std::pow(10.0, power));
    picture += line(at, top, at, bottom + 5, "#cccccc", 1);
    if (x.labelled(power, 40)) picture += power_of_ten(at, bottom + 21, "middle", power);
  }
  for (int power = y.low(); power <= y.high(); ++power) {
    const double at = y.at(std::pow(10.0, power));
    picture += line(left - 5, at, right, at, "#cccccc", 1);
    if (y.labelled(power, 18)) picture += power_of_ten(left - 9, at + 5, "end", power);
  }
  picture += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:g}" height="{:g}" fill="none" stroke="{}"/>)"
                         "\n",
                         left, top, kPlotWidth, kPlotHeight, kGrey);
  picture += text(left + kPlotWidth / 2, bottom + 44, kTextSize, "middle", plot.x_title);
  const double title_x = left - 58, title_y = top + kPlotHeight / 2;
  return picture + text(title_x, title_y, kTextSize, "middle", plot.y_title,
                        fmt::format(R"xml( transform="rotate(-90 {:.1f} {:.1f})")xml", title_x, title_y));
}

std::string marker(const CurveStyle& style, double x, double y) {
  const std::string paint =
      fmt::format(R"(fill="{}" stroke="{}" stroke-width="1.8")", style.dashed ? "#ffffff" : style.colour, style.colour);
  const double r = kMarker;
  switch (style.marker) {
    case Marker::circle:
      return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:g}" {}/>)"
                         "\n",
                         x, y, r, paint);
    case Marker::square:
      return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:g}" height="{:g}" {}/>)"
                         "\n",
                         x - r, y - r, 2 * r, 2 * r, paint);
    case Marker::triangle:
      return fmt::format(R"(<path d="M{:.1f} {:.1f}l{:g} {:g}h{:g}z" {}/>)"
                         "\n",
                         x, y - 1.2 * r, 1.2 * r, 2.1 * r, -2.4 * r, paint);
    case Marker::diamond:
      return fmt::format(R"(<path d="M{0:.1f} {1:.1f}l{2:g} {2:g}l{3:g} {2:g}l{3:g} {3:g}z" {4}/>)"
                         "\n",
                         x, y - 1.35 * r, 1.35 * r, -1.35 * r, paint);
  }
  return {};
}

std::string stroke(const CurveStyle& style) {
  return fmt::format(R"(fill="none" stroke="{}" stroke-width="1.8"{})", style.colour,
                     style.dashed ? R"( stroke-dasharray="6 4")" : "");
}

std::string curve_on(const LogAxis& x, const LogAxis& y, const PlotCurve& curve) {
  std::string path, markers;
  for (const auto& [px, py] : curve.points) {
    path += fmt::format("{:.1f},{:.1f} ", x.at(px), y.at(py));
    markers += marker(curve.style, x.at(px), y.at(py));
  }
  if (!path.empty()) path.pop_back();
  return fmt::format(R"(<polyline points="{}" {}/>)"
                     "\n",
                     path, stroke(curve.style)) +
         markers;
}

std::vector<PlotCurve> legend_of(const std::vector<LogPlot>& plots) {
  std::vector<PlotCurve> entries;
  for (const LogPlot& plot : plots)
    for (const PlotCurve& curve : plot.curves)
      if (std::none_of(entries.begin(), entries.end(), [&](const PlotCurve& e) { return e.name == curve.name; }))
        entries.push_back({curve.name, curve.style, {}});
  return entries;
}

}  // namespace

std::string svg(const Figure& figure) {
  assert(!figure.plots.empty());
  const auto number = static_cast<double>(figure.plots.size());
  const double width = kLeft + number * kPlotWidth + (number - 1) * kGap + kRight;

  std::string picture = text(kMargin, 34, kTitleSize, "start", figure.title, R"( font-weight="bold")");
  double y = 62;
  const std::vector<PlotCurve> legend = legend_of(figure.plots);
  const std::size_t columns = std::max<std::size_t>(1, static_cast<std::size_t>((width - 2 * kMargin) / kLegendEntry));
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double x = kMargin + kLegendEntry * static_cast<double>(i % columns);
    if (i > 0 && i % columns == 0) y += 22;
    picture += fmt::format(R"(<polyline points="{:.1f},{:.1f} {:.1f},{:.1f}" {}/>)"
                           "\n",
                           x, y, x + 36, y, stroke(legend[i].style));
    picture += marker(legend[i].style, x + 18, y) + text(x + 44, y + 4.5, kTextSize, "start", legend[i].name);
  }

  y += 36;
  std::size_t note_lines = 0;
  for (const LogPlot& plot : figure.plots)
    note_lines = std::max(note_lines, wrapped(plot.note, characters_in(kPlotWidth + kLeft / 2)).size());
  const double top = y + kLine * static_cast<double>(note_lines) + 20;
  for (std::size_t p = 0; p < figure.plots.size(); ++p) {
    const LogPlot& plot = figure.plots[p];
    const double left = kLeft + (kPlotWidth + kGap) * static_cast<double>(p), words = left - kLeft / 2;
    picture += text(words, y, kHeadingSize, "start", plot.title, R"( font-weight="bold")");
    picture += lines(wrapped(plot.note, characters_in(kPlotWidth + kLeft / 2)), words, y + kLine + 1, kGrey);
    const LogAxis x_axis(plot.curves, 0, left, left + kPlotWidth);
    const LogAxis y_axis(plot.curves, 1, top + kPlotHeight, top);
    picture += axes(plot, x_axis, y_axis, left, top);
    for (const PlotCurve& curve : plot.curves) picture += curve_on(x_axis, y_axis, curve);
  }

  const std::vector<std::string> caption = wrapped(figure.caption, characters_in(width - 2 * kMargin));
  y = top + kPlotHeight + 44 + 30;
  picture += lines(caption, kMargin, y, kBlack);
  const double height = y + kLine * static_cast<double>(caption.size()) + kMargin / 2;
  return svg_document(width, height, figure.title, figure.caption, picture);
}

}  // namespace pcm::compare
