// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/bench/work_precision.h"
#include "compare/io/names.h"

namespace pcm::compare {
namespace {

constexpr std::array kErrors = {ErrorAgainst::smooth, ErrorAgainst::integral};

constexpr const char* kLegend =
    "Time: median over the orientations of the least of up to five evaluations of force and torque, one thread. "
    "Error:\n"
    "length of the difference of the forces over the length of the reference, root mean square over the same\n"
    "orientations. Against the smooth bodies: closed forms; bubbles: quadrature, good to 1e-5. Against the integral: "
    "the\n"
    "elastic foundation's over the same meshes; the clipped scheme computes it, and shows the certified bound on its\n"
    "rounding. The first body is the master. Equal volume: meshes that enclose what the smooth bodies do.\n";

constexpr const char* kLegendOfRatios =
    "Orders in edge length over the last three levels. Ratio: barycentric error over clipped error, on the same "
    "meshes\n"
    "(the finest of both) and at equal time (least and greatest over the times that both curves cover; against the\n"
    "integral: at least, for the clipped error is a bound). Against the smooth bodies both schemes are of second "
    "order\n"
    "and both pay for the meshes, so that the ratio at equal time does not grow with time.\n";

std::string_view words(ErrorAgainst reference) {
  return reference == ErrorAgainst::smooth ? "smooth bodies" : "integral over the meshes";
}

std::string_view meshes_of(bool equal_volume) {
  return equal_volume ? "equal volume" : "as meshed";
}

/// Errors and ratios of them range over many powers of ten.
TableCell scientific(double x) {
  return {fmt::format("{:.1e}", x), x};
}

std::string ratio_in_words(double ratio) {
  const double exponent = std::floor(std::log10(ratio));
  return ratio < 1e4 ? fmt::format("{:.2g}", ratio)
                     : fmt::format("{:.0f}e{:.0f}", ratio / std::pow(10, exponent), exponent);
}

TableCell ratio_cell(double ratio) {
  return {ratio_in_words(ratio), ratio};
}

TableCell order_cell(const WorkPrecisionCurve& curve, ErrorAgainst reference) {
  const std::optional<double> order = curve.order(reference);
  return order ? number_cell(*order, 3) : empty_cell();
}

/// Barycentric error over the clipped one on the finest meshes where both are.
std::optional<double> ratio_on_the_same_meshes(const WorkPrecisionResult& result, bool equal_volume,
                                               ErrorAgainst reference) {
  const WorkPrecisionCurve &barycentric = result.curve(Scheme::barycentric, equal_volume),
                           &clipped = result.curve(Scheme::clipped, equal_volume);
  const std::size_t both = std::min(barycentric.points.size(), clipped.points.size());
  if (both == 0) return {};
  return barycentric.points[both - 1].error(reference) / clipped.points[both - 1].error(reference);
}

std::string left_out(const std::vector<WorkPrecisionResult>& results) {
  std::string lines;
  for (const WorkPrecisionResult& result : results)
    for (const WorkPrecisionCurve& curve : result.curves)
      if (curve.stopped_by_ms)
        lines += fmt::format(
            "Left out, for an evaluation took {:.0f} ms: {}, {}, from the meshes next finer than those of {} faces "
            "on.\n",
            *curve.stopped_by_ms, result.title, curve.method.name, curve.points.back().faces);
  return lines;
}

/// "2 to 3 times", or nothing where no time is covered by both schemes.
std::string times_at_equal_time(const WorkPrecisionResult& result, bool equal_volume) {
  const std::optional<EqualTime> ratio =
      errors_at_equal_time(result.curve(Scheme::barycentric, equal_volume), result.curve(Scheme::clipped, equal_volume),
                           ErrorAgainst::smooth);
  if (!ratio) return "not comparable with";
  return fmt::format("{} to {} times", ratio_in_words(ratio->least), ratio_in_words(ratio->greatest));
}

std::string against_smooth_in_words(const WorkPrecisionResult& result) {
  return fmt::format(
      "At equal time the barycentric error is {} the clipped one (meshes of equal volume: {}): the meshes' own error "
      "counts in both schemes.",
      times_at_equal_time(result, false), times_at_equal_time(result, true));
}

std::string against_integral_in_words(const WorkPrecisionResult& result) {
  const std::optional<EqualTime> ratio = errors_at_equal_time(
      result.curve(Scheme::barycentric, false), result.curve(Scheme::clipped, false), ErrorAgainst::integral);
  std::string note = "The clipped scheme computes this integral: a certified bound on its rounding is shown.";
  if (ratio)
    note += fmt::format(" At equal time the barycentric error is at least {} times the clipped one.",
                        ratio_in_words(ratio->least));
  return note;
}

PlotCurve plotted(const WorkPrecisionCurve& curve, ErrorAgainst reference) {
  // Colours of Okabe and Ito, told apart by the colour-blind too.
  const auto style = [&]() -> CurveStyle {
    if (curve.method.engine == Engine::published_2003) return {"#009E73", Marker::triangle, false};
    if (curve.method.engine == Engine::published_2023) return {"#CC79A7", Marker::diamond, false};
    const bool clipped = curve.method.scheme == Scheme::clipped;
    return {clipped ? "#0072B2" : "#D55E00", clipped ? Marker::circle : Marker::square, curve.method.equal_volume};
  };
  PlotCurve plot{curve.method.name, style(), {}};
  for (const WorkPrecisionPoint& point : curve.points) plot.points.push_back({point.median_us, point.error(reference)});
  return plot;
}

LogPlot panel(const WorkPrecisionResult& result, ErrorAgainst reference) {
  const bool smooth = reference == ErrorAgainst::smooth;
  LogPlot plot;
  plot.title = smooth ? "Error against the smooth bodies" : "Error against the exact integral on the same mesh";
  plot.note = smooth ? against_smooth_in_words(result) : against_integral_in_words(result);
  plot.x_title = "time for one evaluation of force and torque, microseconds";
  plot.y_title = "relative error of the force (1 = 100 %)";
  for (const WorkPrecisionCurve& curve : result.curves)
    if (!curve.points.empty() && (smooth || !curve.method.equal_volume))
      plot.curves.push_back(plotted(curve, reference));
  return plot;
}

}  // namespace

Table work_precision_table(const std::vector<WorkPrecisionResult>& results) {
  Table table{{{"bodies, the master first", "bodies", false},
               {"method", "engine", false},
               {"scheme", "scheme", false},
               {"meshes", "meshes", false},
               {"faces", "faces"},
               {"edge m", "edge_m"},
               {"median us", "median_us"},
               {"against smooth", "error_against_smooth"},
               {"against integral", "error_against_integral"}},
              {}};
  for (const WorkPrecisionResult& result : results)
    for (const WorkPrecisionCurve& curve : result.curves)
      for (const WorkPrecisionPoint& point : curve.points)
        table.rows.push_back({result.title, std::string(name(curve.method.engine)),
                              std::string(name(curve.method.scheme)), std::string(meshes_of(curve.method.equal_volume)),
                              count_cell(point.faces), number_cell(point.edge, 2), number_cell(point.median_us, 3),
                              scientific(point.smooth_error), scientific(point.integral_error)});
  return table;
}

Table equal_time_table(const std::vector<WorkPrecisionResult>& results) {
  Table table{{{"bodies, the master first", "bodies", false},
               {"meshes", "meshes", false},
               {"error against", "against", false},
               {"order, barycentric", "order_barycentric"},
               {"order, clipped", "order_clipped"},
               {"ratio, same meshes", "ratio_same_meshes"},
               {"at equal time, least", "ratio_equal_time_least"},
               {"greatest", "ratio_equal_time_greatest"},
               {"from us", "from_us"},
               {"to us", "to_us"},
               {"at least 10", "at_least_10", false}},
              {}};
  for (const WorkPrecisionResult& result : results)
    for (const ErrorAgainst reference : kErrors)
      for (const bool equal_volume : {false, true}) {
        if (equal_volume && reference == ErrorAgainst::integral) continue;  // the same again
        const WorkPrecisionCurve &barycentric = result.curve(Scheme::barycentric, equal_volume),
                                 &clipped = result.curve(Scheme::clipped, equal_volume);
        const std::optional<double> same = ratio_on_the_same_meshes(result, equal_volume, reference);
        const std::optional<EqualTime> equal = errors_at_equal_time(barycentric, clipped, reference);
        table.rows.push_back({result.title, std::string(meshes_of(equal_volume)), std::string(words(reference)),
                              order_cell(barycentric, reference),
                              reference == ErrorAgainst::smooth ? order_cell(clipped, reference) : empty_cell(),
                              same ? ratio_cell(*same) : empty_cell(), equal ? ratio_cell(equal->least) : empty_cell(),
                              equal ? ratio_cell(equal->greatest) : empty_cell(),
                              equal ? number_cell(equal->from_us, 3) : empty_cell(),
                              equal ? number_cell(equal->to_us, 3) : empty_cell(),
                              !equal ? empty_cell() : TableCell(equal->least >= 10 ? "yes" : "no")});
      }
  return table;
}

std::string work_precision_picture(const std::string& id) {
  return "work_precision_" + id;
}

std::string work_precision_screen(const std::vector<WorkPrecisionResult>& results, const Machine& machine) {
  return fmt::format("{}\n{}\n{}{}\n{}\n{}", describe(machine), kLegend, on_screen(work_precision_table(results)),
                     left_out(results), kLegendOfRatios, on_screen(equal_time_table(results)));
}

std::string work_precision_markdown(const std::vector<WorkPrecisionResult>& results, const Machine& machine) {
  std::string page = fmt::format("# pcm bench work-precision\n\n{}\n\n{}\n", describe(machine), kLegend);
  for (const WorkPrecisionResult& result : results)
    page += fmt::format("- {}: {}; {} orientations. Reference: {}. Plot: {}.svg\n", result.title, result.problem,
                        result.orientations, result.reference, work_precision_picture(result.id));
  page += fmt::format("\n## Barycentric scheme against clipped scheme\n\n{}\n{}\n## All figures\n\n{}", kLegendOfRatios,
                      markdown(equal_time_table(results)), markdown(work_precision_table(results)));
  const std::string missing = left_out(results);
  return missing.empty() ? page : page + '\n' + missing;
}

Figure work_precision_figure(const WorkPrecisionResult& result, const Machine& machine) {
  std::string faces;
  for (const WorkPrecisionPoint& point : result.curve(Scheme::barycentric, false).points)
    faces += fmt::format("{}{}", faces.empty() ? "" : ", ", point.faces);
  Figure figure;
  figure.title = fmt::format("Contact force of two triangle meshes: error over run time, {}", result.title);
  for (const ErrorAgainst reference : kErrors) figure.plots.push_back(panel(result, reference));
  figure.caption = fmt::format(
      "Bodies: {}. Elastic foundation of stiffness K = 1 N/m\u00b3 without damping or friction; the first body carries "
      "the contact elements. Each marker is one resolution of the meshes, from left to right {} triangles in both "
      "bodies, each with half the edge length of the one before. Barycentric scheme: penetration sampled once a "
      "triangle; clipped scheme: integrated over it exactly. Error: length of the difference of the force vectors over "
      "the length of the reference, root mean square over {} fixed orientations. Left: reference is the smooth "
      "bodies' force, {}; the meshes' vertices lie on the smooth bodies, or (equal volume) the meshes are scaled to "
      "enclose the same volume. Right: reference is the integral of the elastic foundation over the same triangles. "
      "Time: median over the orientations of the least of up to five evaluations, one thread, on {} ({}). pcm: this "
      "project's engine. Methods are left out where an evaluation takes more than {:.0f} ms, except on the coarsest "
      "meshes.",
      result.problem, faces, result.orientations, result.reference, machine.processor, machine.compiler,
      kLongestEvaluation_ms);
  return figure;
}

}  // namespace pcm::compare
