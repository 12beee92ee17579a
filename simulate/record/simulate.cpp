// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/simulate.h"

#include <chrono>
#include <cmath>

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
    : scene_(scene), simulation_(scene), folder_(folder, scene_text, scene_) {
  if (const std::optional<KeptRun> found = folder_.open(notice)) {
    kept_ = *found;
    simulation_.start(kept_.checkpoint);
    return;
  }
  simulation_.start();
  kept_.checkpoint = simulation_.checkpoint();
  folder_.begin(simulation_.model().size());
  folder_.add_state(0, kept_.checkpoint.y);
  folder_.keep(kept_);
}

bool RecordedRun::run(const std::function<bool()>& stop, const std::function<void(const Progress&)>& progress) {
  cost_before_ = kept_.cost;
  seconds_at_start_ = wall_seconds();
  while (!kept_.finished) {
    const SimulatedStep step = simulation_.step();
    changed_ += step.entered + step.left > 0;
    too_deep_ += step.too_deep > 0;
    folder_.add_step(step);
    add_outputs(step);
    if (progress) {
      const double simulated = simulation_.t() - kept_.checkpoint.t + 1e-300;
      progress({simulation_.t(), scene_.duration, step.step.size,
                simulation_.integration_seconds() / std::max(simulated, simulation_.t())});
    }
    if (!simulation_.at_checkpoint()) continue;
    keep();
    if (!kept_.finished && stop && stop()) return false;
  }
  return true;
}

// Output number n is due at n times the interval, once: in the step at whose end or before it is.
void RecordedRun::add_outputs(const SimulatedStep& step) {
  const double interval = scene_.output.interval;
  const double end = simulation_.t(), begin = end - step.step.size;
  for (double n = std::floor(begin / interval) + 1; n * interval <= end; ++n)
    folder_.add_state(n * interval, simulation_.state_at(n * interval));
}

void RecordedRun::keep() {
  kept_.checkpoint = simulation_.checkpoint();
  kept_.cost.work = sum(cost_before_.work, simulation_.work());
  kept_.cost.elements_changed = cost_before_.elements_changed + changed_;
  kept_.cost.too_deep = cost_before_.too_deep + too_deep_;
  kept_.cost.integration_seconds = cost_before_.integration_seconds + simulation_.integration_seconds();
  kept_.cost.seconds = cost_before_.seconds + wall_seconds() - seconds_at_start_;
  kept_.finished = simulation_.finished();
  folder_.keep(kept_);
}

Observation RecordedRun::observe() {
  return simulation_.model().observe(kept_.checkpoint.t, kept_.checkpoint.y);
}

}  // namespace pcm::simulate
