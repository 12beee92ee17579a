// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/run_tables.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace pcm::simulate {
namespace {

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

}  // namespace

std::string cost_table(const std::string& scene_name, const Scene& scene, const KeptRun& run) {
  std::string text =
      "| integrator | mean step | function evaluations | of them for Jacobians | law only | Jacobians | "
      "processor time | real-time factor |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const Published& p : kPublished)
    if (p.scene == scene_name && !scene.initial_state && scene.duration == p.duration)
      text += fmt::format("| {} | {} ms | {} | | | {} | {:g} s | {:g} |\n", p.integrator, p.mean_step_ms, p.derivatives,
                          p.jacobians, p.seconds, p.real_time_factor);
  const Work& work = run.cost.work;
  const double t = run.checkpoint.t, simulated = t - scene.begin();
  const bool implicit = work.jacobians > 0;
  if (work.steps == 0)
    return text + fmt::format("| {} | no step was taken | | | | | | |\n", name(scene.integrator.method));
  text +=
      fmt::format("| {} | {:.2g} ms | {} | {} | {} | {} | {:.3g} s | {:.3g} |\n", name(scene.integrator.method),
                  1e3 * simulated / static_cast<double>(work.steps), work.derivatives + work.derivatives_for_jacobians,
                  implicit ? std::to_string(work.derivatives_for_jacobians) : "",
                  implicit ? std::to_string(run.cost.law_only) : "", implicit ? std::to_string(work.jacobians) : "-",
                  run.cost.integration_seconds, run.cost.integration_seconds / simulated);
  if (work.linear_derivatives > 0) {
    text += fmt::format(
        "\nJacobians by tangents of the pairings: their {} columns asked no engine and are not among the "
        "evaluations.\n",
        work.linear_derivatives);
  }
  const Failures& failures = work.failures;
  text += fmt::format(
      "\n{} steps to t = {:g} s; rejected: {} for their error, {} by the nonlinear iteration, {} where bodies would be "
      "nested or too deep, {} not finite. Elements came or went in {:.0f} % of the steps; {} steps end with faces "
      "without a force (too deep). With everything that is recorded: {:.3g} s.\n",
      work.steps, t, failures.error_test, failures.nonlinear, failures.not_here, failures.not_finite,
      100.0 * static_cast<double>(run.cost.elements_changed) / static_cast<double>(work.steps), run.cost.too_deep,
      run.cost.seconds);
  return text;
}

std::string energy_table(const KeptRun& run, const Energies& at_end) {
  const EnergyFlow& flow = run.checkpoint.flow;
  const double at_start = run.checkpoint.energy_at_start;
  const double remainder = at_end.total() + flow.lost() - at_start;
  return fmt::format(
      "| energy | J |\n|---|---|\n| at the start | {:.6g} |\n| brought by prescribed motions | {:.6g} |\n| taken by "
      "damping of the contacts | {:.6g} |\n| taken by friction | {:.6g} |\n| taken by joints and bumpers | {:.6g} |\n| "
      "at the end: kinetic | {:.6g} |\n| at the end: gravity's | {:.6g} |\n| at the end: elastic, of the contacts | "
      "{:.6g} |\n| at the end: bumpers' | {:.6g} |\n| remainder | {:.6g} |\n",
      at_start, flow.motions, flow.damping, flow.friction, flow.joints, at_end.kinetic, at_end.gravity, at_end.elastic,
      at_end.bumpers, remainder);
}

}  // namespace pcm::simulate
