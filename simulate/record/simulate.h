// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "simulate/record/run_folder.h"

namespace pcm::simulate {

/// What the caller is told while it runs.
struct Progress {
  double t = 0, duration = 0;   ///< s
  double step = 0;              ///< the last one, s
  double real_time_factor = 0;  ///< processor time of the steps over simulated time
};

/// Runs a scene to its end, or to a stop, in its folder; goes on where an earlier call stopped or was killed. What is
/// thrown leaves everything up to the last checkpoint usable: IntegrationFailure where the integrator gives up,
/// BadInput for whatever the caller can mend.
class RecordedRun {
 public:
  /// `notice` gets a line on an earlier run in the folder where there is something to say.
  RecordedRun(const Scene& scene, const std::string& scene_text, const std::filesystem::path& folder,
              std::string& notice);

  /// True at the end of the scene, false where `stop` said so, at the checkpoint reached last.
  bool run(const std::function<bool()>& stop, const std::function<void(const Progress&)>& progress);

  const KeptRun& kept() const { return kept_; }
  /// At the last checkpoint.
  Observation observe();
  Simulation& simulation() { return simulation_; }

 private:
  void add_outputs(const SimulatedStep& step);
  void keep();

  Scene scene_;
  Simulation simulation_;
  RunFolder folder_;
  KeptRun kept_;
  RunCost cost_before_;  ///< of earlier calls
  std::int64_t changed_ = 0, too_deep_ = 0;
  double seconds_at_start_ = 0;
};

}  // namespace pcm::simulate
