// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compare/poses/pairs.h"
#include "compare/verify/case_file.h"
#include "compare/verify/held_pairing.h"

/// The main job: engine against oracle over randomized poses of pairs and strata, or over recorded ones.
namespace pcm::compare {

struct RecordedState {
  Pose pose;
  Velocity velocity;
  std::int64_t line = 0;  ///< of the file that it is from; names the pose
};

/// What a pair is asked in place of drawn poses, with the pair's own law.
struct RecordedPoses {
  HeldPairing::Modes modes;  ///< every pose is answered in each; as many for every pair of a plan
  Scheme scheme = Scheme::barycentric;
  std::filesystem::path file;
  std::int64_t in_file = 0;  ///< how many poses the file has
  std::vector<RecordedState> states;
};

/// What a run is; the same plan gives the same tables, whatever the number of threads.
struct VerificationPlan {
  std::int64_t poses = 20160;
  std::uint64_t seed = 1;
  std::vector<Stratum> strata{kStrata.begin(), kStrata.end()};
  HeldPairing::Modes modes{Mode::both};  ///< every pose is answered in each
  /// With both, one pose in three is answered in the clipped scheme, the others in the barycentric one.
  std::vector<Scheme> schemes{Scheme::barycentric};
  std::vector<SurfacePair> pairs;
  /// Of each pair, or empty: then poses are drawn. `poses`, `strata`, `modes` and `schemes` say what is in them
  /// (read_trajectory), and no seed, no drawn law and no share of a pair has a part in the run.
  std::vector<RecordedPoses> recorded;
  /// Asked for by name: each of these must then get a pose. What else gets none is an omission.
  bool strata_named = false, schemes_named = false, pairs_named = false;
  std::string build;  ///< which program answers; by default the hash of the one that runs
};

/// The poses of one pair and one stratum, answered in one scheme and one mode. The cells of a pair, stratum and scheme
/// are neighbours, in the plan's order of modes, and have the same poses; those of two schemes have no pose in common:
/// the second one's numbers go on where the first one's end.
struct Cell {
  std::size_t pair = 0;
  Stratum stratum = Stratum::generic;
  Scheme scheme = Scheme::barycentric;
  Mode mode = Mode::both;
  std::int64_t first = 0;  ///< number of the first pose
  std::int64_t poses = 0;
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

/// A run over a plan, batch by batch. Poses are spread evenly over the strata, and within a stratum over its pairs by
/// their shares: in degenerate and near-degenerate one pose in fifty falls to the general pairs, the others to those
/// made for them.
class Verification {
 public:
  /// Prepares every pair, on all cores. Throws BadInput where a mesh is unfit, naming the pair, and where what the plan
  /// names gets no pose.
  /// `seam`, which must outlive the run, hands on the engine's answers.
  explicit Verification(VerificationPlan plan, const EngineSeam& seam = EngineSeam::none());
  ~Verification();

  const VerificationPlan& plan() const { return plan_; }
  /// In how many modes each pose is answered: in all of the plan's, but recorded poses each in its pairing's own.
  std::int64_t modes_per_pose() const { return modes_per_pose_; }
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
  /// Strata of pairs that are not to be had, and what gets no pose because there are too few of them, in words.
  const std::vector<std::string>& omissions() const { return omissions_; }
  /// The plan's strata, schemes and pairs without a pose, in a few words, e.g. "generic; 54 of 59 pairs"; empty where
  /// all have one.
  const std::string& without_poses() const { return without_poses_; }

  /// Name of a pose in a scheme and mode, e.g. "bubble-bubble/generic/17/both" or, where the plan has both schemes,
  /// "bubble-bubble/generic/17/both/clipped". Pair, stratum and number alone tell the poses of a plan apart; the number
  /// of a recorded pose is its line. Here and below `pose` is a number from cell.first on.
  std::string pose_name(const Cell& cell, std::int64_t pose) const;
  DrawnPose draw(const Cell& cell, std::int64_t pose) const;
  /// The drawn pose with the law and the scheme it is answered with. Throws DrawFailure where the engine breaks down.
  HeldPairing::State asked(const Cell& cell, std::int64_t pose) const;
  /// Where that pose is asked: pairs with variants have several.
  const HeldPairing& held_pairing(const Cell& cell, std::int64_t pose) const;
  /// Where the state could not be drawn to its end: the one that the engine broke down at, in mode `both`.
  Case as_case(const Finding& finding) const;

  /// Runs what is left of the next batch on `jobs` threads. Whatever is thrown at a pose, while it is drawn too, is a
  /// disagreement of kind `failure` in each of its modes. `stop` is asked before each pose: once it says yes, the
  /// poses at hand are finished and added, and the batch is left for the next call. `progress` gets the number of poses
  /// done so far.
  void run_batch(int jobs, const std::function<bool()>& stop, const std::function<void(std::int64_t)>& progress);

  /// The whole state, to continue from: no pose done is lost. `restore` throws BadInput where the state is of another
  /// plan, or of another program's run.
  nlohmann::ordered_json state() const;
  void restore(const nlohmann::ordered_json& state);
  /// Whether the state is of a run with the same arguments, whatever program and surfaces it ran with. An argument that
  /// it lacks, or that is unknown here, is another one.
  bool same_arguments(const nlohmann::ordered_json& state) const;
  /// What makes the state one of another run with the same arguments, e.g. "of another build of pcm"; empty where
  /// nothing does.
  std::string difference_from(const nlohmann::ordered_json& state) const;

 private:
  struct HeldPairings {
    std::vector<std::unique_ptr<HeldPairing>> usual;  ///< of the pair itself, then of its variants
    std::unique_ptr<HeldPairing> nested;
  };

  /// The outcomes of a pose, one a mode.
  struct Held {
    std::vector<PoseOutcome> outcomes;
    bool in_scene = false;
  };

  /// What can have poses, however few are asked for.
  struct Fit {
    std::set<std::size_t> pairs;
    std::set<Stratum> strata;
    std::int64_t cells = 0;  ///< in one mode
  };

  void prepare_pairings();
  void add_drawn_cells();
  void add_recorded_cells();
  void say_what_gets_no_pose(const Fit& fit);
  /// None where poses are drawn.
  const RecordedState* recorded(const Cell& cell, std::int64_t pose) const;
  std::string origin(const Cell& cell, std::int64_t pose) const;
  Held hold(const Cell& cell, std::int64_t pose, fast::Workspace& workspace) const;
  nlohmann::ordered_json identity() const;

  VerificationPlan plan_;
  std::int64_t modes_per_pose_;
  const EngineSeam* seam_;
  std::vector<HeldPairings> held_pairings_;
  std::vector<Cell> cells_;
  std::vector<Finding> findings_;
  std::vector<std::string> omissions_;
  std::string without_poses_;
  std::int64_t batches_ = 1;
  std::int64_t batches_done_ = 0;
  std::set<std::size_t> done_of_batch_;  ///< which poses of the next batch are done already
};

}  // namespace pcm::compare
