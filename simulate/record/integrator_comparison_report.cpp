// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/integrator_comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "compare/io/pictures/svg_plot.h"

namespace pcm::simulate {
namespace {

/// Okabe and Ito's colours, which readers of all kinds of sight tell apart; dashed with tangents.
compare::CurveStyle style(std::size_t number, JacobianOf jacobian) {
  constexpr std::array kColours = {"#D55E00", "#0072B2", "#009E73", "#E69F00", "#CC79A7", "#56B4E9", "#000000"};
  constexpr std::array kMarkers = {compare::Marker::circle, compare::Marker::square, compare::Marker::triangle,
                                   compare::Marker::diamond};
  return {kColours.at(number % kColours.size()), kMarkers.at(number % kMarkers.size()),
          jacobian == JacobianOf::tangents};
}

/// One curve for each integrator and what its Jacobians are made of, through those trials that came to the end.
template <typename Point>
std::vector<compare::PlotCurve> curves(const std::vector<IntegratorTrial>& trials, const Point& point) {
  std::vector<compare::PlotCurve> all;
  std::size_t number = 0;
  const IntegratorTrial* last = nullptr;
  for (const IntegratorTrial& trial : trials) {
    if (last != nullptr && trial.integrator != last->integrator) ++number;
    if (last == nullptr || trial.name() != last->name())
      all.push_back({trial.name(), style(number, trial.jacobian), {}});
    last = &trial;
    if (!trial.gave_up) all.back().points.push_back(point(trial));
  }
  std::erase_if(all, [](const compare::PlotCurve& curve) { return curve.points.empty(); });
  return all;
}

std::vector<compare::TableCell> row(const IntegratorTrial& trial, const compare::TableCell& error) {
  using compare::count_cell;
  const Failures& failures = trial.work.failures;
  return {trial.name(),
          {fmt::format("{:g}", trial.slip_velocity), trial.slip_velocity},
          {fmt::format("{:g}", trial.tolerance), trial.tolerance},
          count_cell(trial.evaluations()),
          count_cell(trial.work.derivatives_for_jacobians),
          count_cell(trial.work.steps),
          count_cell(failures.error_test),
          count_cell(failures.nonlinear),
          trial.gave_up ? compare::TableCell("gave up") : error};
}

}  // namespace

NotedTable comparison_table(const IntegratorComparison& comparison) {
  NotedTable trials;
  trials.table.columns = {{"integrator", "integrator", false},
                          {"v_eps, m/s", "slip_velocity"},
                          {"tolerance", "tolerance"},
                          {"evaluations", "evaluations"},
                          {"of them for Jacobians", "for_jacobians"},
                          {"steps", "steps"},
                          {"too large an error", "error_test_failed"},
                          {"nonlinear iteration failed", "nonlinear_failed"},
                          {"error at the end", "error"}};
  for (const IntegratorTrial& trial : comparison.by_tolerance)
    trials.table.rows.push_back(row(trial, {fmt::format("{:.1e}", trial.error), trial.error}));
  for (const IntegratorTrial& trial : comparison.by_slip_velocity)
    trials.table.rows.push_back(row(trial, compare::empty_cell()));
  trials.notes = fmt::format(
      "Error: the greatest difference of a component of the state at the end, in m, rad, m/s or rad/s,\nfrom BDF at a "
      "tolerance of {:g}, from which ESDIRK at the same tolerance differs by {:.1e}.\n",
      comparison.reference_tolerance, comparison.reference_error);
  return trials;
}

std::string comparison_picture(const std::string& title, const IntegratorComparison& comparison) {
  compare::Figure figure;
  figure.title = title;
  figure.plots.push_back({"Error over evaluations", "Farther left and lower is better.",
                          "evaluations of the equations of motion", "error at the end, m, rad, m/s, rad/s",
                          curves(comparison.by_tolerance, [](const IntegratorTrial& trial) {
                            // Logarithmic axes know no zero.
                            return std::array{static_cast<double>(trial.evaluations()), std::max(trial.error, 1e-16)};
                          })});
  figure.plots.push_back({"Evaluations over the slip velocity", "The stiffness goes with 1 / v_eps.",
                          "slip velocity v_eps, m/s", "evaluations of the equations of motion",
                          curves(comparison.by_slip_velocity, [](const IntegratorTrial& trial) {
                            return std::array{trial.slip_velocity, static_cast<double>(trial.evaluations())};
                          })});
  figure.caption = fmt::format(
      "Evaluations for difference quotients and spectral radii are counted, tangents as one each; dashed: Jacobians of "
      "tangents in place of differences. Left: v_eps = {:g} m/s; each marker is one "
      "tolerance, relative and absolute alike, 1e-3, 1e-4, 1e-5, 1e-6; the error is the greatest difference of a "
      "component of the state at the end from that of BDF at {:g}, which ESDIRK's differs from by {:.0e}. Right: "
      "tolerances of v_eps / 10.",
      comparison.slip_velocity, comparison.reference_tolerance, comparison.reference_error);
  return svg(figure);
}

}  // namespace pcm::simulate
