// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "compare/verify/run/planned_poses.h"

/// The main job: engine against oracle over randomized poses of pairs and strata, or over recorded ones.
namespace pcm::compare {

/// The planned poses of a cell, with what came of them.
struct Cell : PlannedCell {
  std::int64_t without_scene = 0;  ///< of those done, which no scene was asked about (call_routes.h)
  Tally tally;
};

/// What cells of one name have together: where they are of several modes, a pose counts once for each.
struct NamedTally {
  std::string name;
  Tally tally;
};

struct StratumTally {
  Stratum stratum = Stratum::generic;
  Scheme scheme = Scheme::barycentric;
  Mode mode = Mode::both;
  Tally tally;
};

/// A pose with a disagreement in a mode, kept for its case file.
struct Finding {
  std::size_t cell = 0;
  std::int64_t pose = 0;
  std::vector<Disagreement> disagreements;
};

/// No more cases than this are kept; the counts go on.
inline constexpr std::size_t kMostFindings = 300;

/// A run over a plan, batch by batch.
class Verification {
 public:
  /// As PlannedPoses. `seam`, which must outlive the run, hands on the engine's answers.
  explicit Verification(VerificationPlan plan, const EngineSeam& seam = EngineSeam::none());

  const PlannedPoses& poses() const { return poses_; }
  const VerificationPlan& plan() const { return poses_.plan(); }
  const std::vector<Cell>& cells() const { return cells_; }
  const std::vector<Finding>& findings() const { return findings_; }
  /// Each pose once, in however many modes.
  std::int64_t poses_done() const;
  std::int64_t batches() const { return batches_; }
  std::int64_t batches_done() const { return batches_done_; }
  bool finished() const { return batches_done_ == batches_; }
  Tally total() const;
  /// The cells of each pair together, in the plan's order; without pairs that have no cell.
  std::vector<NamedTally> by_pair() const;
  /// The cells of each stratum together, in the order of Stratum; without strata that have no cell.
  std::vector<NamedTally> by_stratum() const;
  /// The cells of each mode together, in the plan's order.
  std::vector<NamedTally> by_mode() const;
  /// The cells of each scheme together, in the plan's order.
  std::vector<NamedTally> by_scheme() const;
  /// The cells of each stratum, scheme and mode together, in this order.
  std::vector<StratumTally> by_stratum_scheme_and_mode() const;
  Case as_case(const Finding& finding) const { return poses_.as_case(cells_[finding.cell], finding.pose); }

  /// Runs what is left of the next batch on `jobs` threads. Whatever is thrown at a pose, while it is drawn too, is a
  /// disagreement of kind `failure` in each of its modes. `stop` is asked before each pose: once it says yes, the
  /// poses at hand are finished and added, and the batch is left for the next call. `progress` gets the number of poses
  /// done so far.
  void run_batch(int jobs, const std::function<bool()>& stop, const std::function<void(std::int64_t)>& progress);

  /// The whole state, to continue from: no pose done is lost. `restore` throws BadInput where the state is of another
  /// plan, or of another program's run.
  nlohmann::ordered_json state() const;
  void restore(const nlohmann::ordered_json& state);

 private:
  /// The outcomes of a pose, one a mode.
  struct Held {
    std::vector<PoseOutcome> outcomes;
    bool in_scene = false;
  };

  Held hold(const Cell& cell, std::int64_t pose, fast::Workspace& workspace) const;

  PlannedPoses poses_;
  const EngineSeam* seam_;
  std::vector<Cell> cells_;
  std::vector<Finding> findings_;
  std::int64_t batches_ = 1;
  std::int64_t batches_done_ = 0;
  std::set<std::size_t> done_of_batch_;  ///< which poses of the next batch are done already
};

}  // namespace pcm::compare
