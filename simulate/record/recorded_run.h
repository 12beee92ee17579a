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
  double real_time_factor = 0;  ///< processor time of the steps over simulated time, since the folder was opened
};

/// Runs a scene to its end, or to a stop, in its folder; goes on where an earlier call stopped or was killed. What is
/// thrown leaves what was computed usable: IntegrationFailure where the integrator gives up (tables and `kept` then go
/// up to the last accepted step, the folder's checkpoint is an earlier one), BadInput for whatever the caller can mend.
class RecordedRun {
 public:
  /// `notice` gets a line on an earlier run in the folder where there is something to say.
  RecordedRun(const Scene& scene, const std::string& scene_text, const std::filesystem::path& folder,
              std::string& notice);

  /// May be called again. True at the end of the scene, false where `stop` said so, at the checkpoint reached last.
  bool run(const std::function<bool()>& stop, const std::function<void(const Progress&)>& progress);

  /// At the last checkpoint, or where the integrator gave up.
  const KeptRun& kept() const { return kept_; }
  /// There.
  Observation observe();
  Simulation& simulation() { return simulation_; }

 private:
  void add_outputs();
  SimulatedStep next_step();
  /// Where the run stands, to `kept_`.
  void account();
  void keep();

  Scene scene_;
  Simulation simulation_;
  RunFolder folder_;
  KeptRun kept_;
  RunCost cost_before_;       ///< of what was found in the folder
  double t_found_ = 0;        ///< where that ended, or where the scene starts, s
  std::int64_t outputs_ = 0;  ///< multiples of the interval that were passed
  std::int64_t changed_ = 0, too_deep_ = 0;
  double seconds_at_start_ = 0;
};

}  // namespace pcm::simulate
