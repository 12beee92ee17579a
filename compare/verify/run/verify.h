// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/verify/run/planned_poses.h"

/// The main job: engine against oracle over randomized poses of pairs and strata, or over recorded ones.
namespace pcm::compare {

/// What came of poses of one cell, whatever their order.
struct CellOutcome {
  std::int64_t without_scene = 0;  ///< which no scene was asked about (asks.h)
  Tally tally;

  void merge(const CellOutcome& other);
  nlohmann::ordered_json to_json() const;
  static CellOutcome from_json(const nlohmann::ordered_json& json);
};

/// The planned poses of a cell, with what came of those that are done.
struct Cell : PlannedCell, CellOutcome {};

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

/// No more cases than this are kept, the first ones in the order of cells and poses; the counts go on.
inline constexpr std::size_t kMostFindings = 300;

/// What came of some poses.
struct Outcomes {
  std::map<std::size_t, CellOutcome> cells;  ///< by their number
  std::vector<Finding> findings;             ///< in order, no more than are kept

  void merge(Outcomes&& other);
};

/// A run over a plan, in chunks of some poses each, which may be done in any order and on any machine.
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
  std::int64_t poses_in_all() const { return first_of_group_.back(); }
  /// Whether every pose of every cell is done.
  bool finished() const;
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
  Case as_case(const Finding& finding) const;

  /// Into how many chunks the run is cut.
  std::int64_t chunks() const { return chunks_; }
  /// Holds the poses of a chunk, which are spread over all cells. Whatever is thrown at a pose, while it is drawn too,
  /// is a disagreement of kind `failure` in each of its modes. `goes_on` is asked before each pose, with the number of
  /// poses done since; once it says no nothing is returned. From any thread, each with a workspace of its own.
  std::optional<Outcomes> hold_chunk(std::int64_t chunk, fast::Workspace& workspace,
                                     const std::function<bool(std::int64_t done)>& goes_on) const;
  /// What came of chunks, each of which must be added once.
  void add(Outcomes outcomes);

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
  /// Poses are numbered through: those of cells that differ in the mode alone begin with this number; in the end how
  /// many there are.
  std::vector<std::int64_t> first_of_group_;
  std::int64_t chunks_ = 1;
};

}  // namespace pcm::compare
