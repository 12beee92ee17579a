// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/run_tables.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pcm::simulate {
namespace {

using compare::count_cell, compare::empty_cell;

/// In the notation that `format` names, as of printf.
compare::TableCell number(double x, std::string_view format) {
  return {fmt::format(fmt::runtime("{:" + std::string(format) + "}"), x), x};
}

/// A column of table 1 or 2 of the paper.
struct Published {
  std::string_view scene, integrator;
  double duration;  ///< s
  double mean_step_ms;
  int derivatives;
  std::string_view jacobians;
  double seconds, real_time_factor;
};

constexpr std::array kPublished = {Published{"bubbles", "LSODE (2003)", 3, 0.8, 6046, "-", 276, 92.1},
                                   Published{"bubbles", "DASSL (2003)", 3, 1.2, 7100, "88", 286, 95.3},
                                   Published{"pedestrian", "DOPRI5 (2003)", 1.5, 2.0, 4501, "-", 288, 192},
                                   Published{"pedestrian", "DASSL (2003)", 1.5, 0.8, 5020, "30", 336, 224}};

/// Beneath the table.
std::string cost_in_words(const KeptRun& run) {
  const Work& work = run.cost.work;
  std::string text;
  if (work.linear_derivatives > 0)
    text = fmt::format(
        "Jacobians by tangents of the pairings: their {} columns asked no engine and are not among the "
        "evaluations.\n\n",
        work.linear_derivatives);
  if (work.nonlinear_iterations > 0)
    text += fmt::format("Iterations for the implicit equations: {}.\n\n", work.nonlinear_iterations);
  const Failures& failures = work.failures;
  return text +
         fmt::format(
             "{} steps to t = {:g} s; rejected: {} for their error, {} by the nonlinear iteration, {} where bodies "
             "would be\nnested or too deep, {} not finite. Elements came or went in {:.0f} % of the steps; {} steps "
             "end "
             "with faces\nwithout a force (too deep). With everything that is recorded: {:.3g} s.\n",
             work.steps, run.checkpoint.t, failures.error_test, failures.nonlinear, failures.not_here,
             failures.not_finite,
             100.0 * static_cast<double>(run.cost.elements_changed) / static_cast<double>(work.steps),
             run.cost.too_deep, run.cost.seconds);
}

}  // namespace

NotedTable cost_table(const std::string& scene_name, const Scene& scene, const KeptRun& run) {
  NotedTable cost;
  cost.table.columns = {{"integrator", "integrator", false},
                        {"mean step, ms", "mean_step_ms"},
                        {"function evaluations", "evaluations"},
                        {"of them for Jacobians", "for_jacobians"},
                        {"law only", "law_only"},
                        {"Jacobians", "jacobians"},
                        {"processor time, s", "processor_s"},
                        {"real-time factor", "real_time_factor"}};
  std::vector<std::vector<compare::TableCell>>& rows = cost.table.rows;
  for (const Published& p : kPublished)
    if (p.scene == scene_name && !scene.initial_state && scene.duration == p.duration)
      rows.push_back({std::string(p.integrator), number(p.mean_step_ms, "g"), count_cell(p.derivatives), empty_cell(),
                      empty_cell(), std::string(p.jacobians), number(p.seconds, "g"), number(p.real_time_factor, "g")});
  const Work& work = run.cost.work;
  const std::string method(name(scene.integrator.method));
  if (work.steps == 0) {
    rows.emplace_back(cost.table.columns.size(), empty_cell()).front() = method;
    cost.notes = "No step was taken.\n";
    return cost;
  }
  const double simulated = run.checkpoint.t - scene.begin();
  const auto of_jacobians = [&](std::int64_t n) { return work.jacobians > 0 ? count_cell(n) : empty_cell(); };
  rows.push_back({method, number(1e3 * simulated / static_cast<double>(work.steps), ".2g"),
                  count_cell(work.derivatives + work.derivatives_for_jacobians),
                  of_jacobians(work.derivatives_for_jacobians), of_jacobians(run.cost.law_only),
                  of_jacobians(work.jacobians), number(run.cost.integration_seconds, ".3g"),
                  number(run.cost.integration_seconds / simulated, ".3g")});
  cost.notes = cost_in_words(run);
  return cost;
}

NotedTable energy_table(const KeptRun& run, const Energies& at_end) {
  const EnergyFlow& flow = run.checkpoint.flow;
  const double at_start = run.checkpoint.energy_at_start;
  const double remainder = at_end.total() + flow.lost() - at_start;
  NotedTable energies;
  energies.table.columns = {{"energy", "energy", false}, {"J", "joules"}};
  const auto add = [&](const char* what, double joules) {
    energies.table.rows.push_back({what, number(joules, ".6g")});
  };
  add("at the start", at_start);
  add("brought by prescribed motions", flow.motions);
  add("taken by damping of the contacts", flow.damping);
  add("taken by friction", flow.friction);
  add("taken by joints and bumpers", flow.joints);
  add("at the end: kinetic", at_end.kinetic);
  add("at the end: gravity's", at_end.gravity);
  add("at the end: elastic, of the contacts", at_end.elastic);
  add("at the end: bumpers'", at_end.bumpers);
  add("remainder", remainder);
  return energies;
}

}  // namespace pcm::simulate
