// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/recorded_run.h"

#include <chrono>

namespace pcm::simulate {
namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Work sum(const Work& a, const Work& b) {
  Work work = a;
  work.steps += b.steps;
  work.derivatives += b.derivatives;
  work.derivatives_for_jacobians += b.derivatives_for_jacobians;
  work.linear_derivatives += b.linear_derivatives;
  work.jacobians += b.jacobians;
  work.nonlinear_iterations += b.nonlinear_iterations;
  work.failures.error_test += b.failures.error_test;
  work.failures.nonlinear += b.failures.nonlinear;
  work.failures.not_here += b.failures.not_here;
  work.failures.not_finite += b.failures.not_finite;
  return work;
}

}  // namespace

RecordedRun::RecordedRun(const Scene& scene, const std::string& scene_text, const std::filesystem::path& folder,
                         std::string& notice)
    : scene_(scene), simulation_(scene), folder_(folder, scene_text, scene_), seconds_at_start_(wall_seconds()) {
  if (const std::optional<KeptRun> found = folder_.open(notice)) {
    kept_ = *found;
    cost_before_ = kept_.cost;
    t_found_ = kept_.checkpoint.t;
    simulation_.start(kept_.checkpoint);
  } else {
    simulation_.start();
    kept_.checkpoint = simulation_.checkpoint();
    t_found_ = kept_.checkpoint.t;
    folder_.begin(simulation_.model().columns());
    folder_.add_state(t_found_, kept_.checkpoint.y);
    folder_.keep(kept_);
  }
  outputs_ = multiples_until(t_found_, scene_.output.interval, scene_.duration);
}

bool RecordedRun::run(const std::function<bool()>& stop, const std::function<void(const Progress&)>& progress) {
  while (!kept_.finished) {
    const SimulatedStep step = next_step();
    changed_ += step.entered + step.left > 0;
    too_deep_ += step.too_deep > 0;
    folder_.add_step(step);
    add_outputs();
    if (progress)
      progress({simulation_.t(), scene_.duration, step.step.size,
                simulation_.integration_seconds() / (simulation_.t() - t_found_)});
    if (!simulation_.at_checkpoint()) continue;
    keep();
    if (!kept_.finished && stop && stop()) return false;
  }
  return true;
}

SimulatedStep RecordedRun::next_step() {
  try {
    return simulation_.step();
  } catch (const IntegrationFailure&) {
    folder_.flush();
    account();
    throw;
  }
}

// Within the last step, or at its end.
void RecordedRun::add_outputs() {
  for (;; ++outputs_) {
    const double t = multiple_or_end(outputs_ + 1, scene_.output.interval, scene_.duration);
    if (t > simulation_.t()) return;
    folder_.add_state(t, simulation_.state_at(t));
  }
}

void RecordedRun::account() {
  kept_.checkpoint = simulation_.checkpoint();
  kept_.cost.work = sum(cost_before_.work, simulation_.work());
  kept_.cost.law_only = cost_before_.law_only + simulation_.law_only();
  kept_.cost.elements_changed = cost_before_.elements_changed + changed_;
  kept_.cost.too_deep = cost_before_.too_deep + too_deep_;
  kept_.cost.integration_seconds = cost_before_.integration_seconds + simulation_.integration_seconds();
  kept_.cost.seconds = cost_before_.seconds + wall_seconds() - seconds_at_start_;
  kept_.finished = simulation_.finished();
}

void RecordedRun::keep() {
  account();
  folder_.keep(kept_);
}

Observation RecordedRun::observe() {
  return simulation_.model().observe(kept_.checkpoint.t, kept_.checkpoint.y);
}

}  // namespace pcm::simulate
