// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/run/verification_plan.h"
#include "compare/verify/verdict/case_file.h"

namespace pcm::compare {

/// The poses of one pair and one stratum, asked in one scheme and one mode. The cells of a pair, stratum and scheme
/// are neighbours, in the plan's order of modes, and have the same poses; those of two schemes have no pose in common:
/// the second one's numbers go on where the first one's end.
struct PlannedCell {
  std::size_t pair = 0;
  Stratum stratum = Stratum::generic;
  Scheme scheme = Scheme::barycentric;
  Mode mode = Mode::both;
  std::int64_t first = 0;  ///< number of the first pose
  std::int64_t poses = 0;
};

/// What a plan asks: its poses, each drawn when it is wanted. They are spread evenly over the strata, and within a
/// stratum over its pairs by their shares: in degenerate and near-degenerate one pose in fifty falls to the general
/// pairs, the others to those made for them; in generic at least half of those in each scheme to pairs that are not
/// made to hurt, of which the measure is demanded.
class PlannedPoses {
 public:
  /// Prepares every pair, on all cores. Throws BadInput where a mesh is unfit, naming the pair, and where what the plan
  /// names gets no pose. `seam`, which must outlive this, hands on the engine's answers where a state depends on them.
  explicit PlannedPoses(VerificationPlan plan, const EngineSeam& seam = EngineSeam::none());

  const VerificationPlan& plan() const { return plan_; }
  /// In how many modes each pose is asked: in all of the plan's, but recorded poses each in its pairing's own.
  std::int64_t modes_per_pose() const { return modes_per_pose_; }
  const std::vector<PlannedCell>& cells() const { return cells_; }
  /// Strata of pairs that are not to be had, and what gets no pose because there are too few of them, in words.
  const std::vector<std::string>& omissions() const { return omissions_; }
  /// The plan's strata, schemes and pairs without a pose, in a few words, e.g. "generic; 54 of 59 pairs"; empty where
  /// all have one.
  const std::string& without_poses() const { return without_poses_; }

  /// Name of a pose in a scheme and mode, e.g. "bubble-bubble/generic/17/both" or, where the plan has both schemes,
  /// "bubble-bubble/generic/17/both/clipped". Pair, stratum and number alone tell the poses of a plan apart; the number
  /// of a recorded pose is its line. Here and below `pose` is a number from cell.first on.
  std::string pose_name(const PlannedCell& cell, std::int64_t pose) const;
  DrawnPose draw(const PlannedCell& cell, std::int64_t pose) const;
  /// The drawn pose with the law and the scheme it is answered with. Throws DrawFailure where the engine breaks down.
  HeldPairing::State asked(const PlannedCell& cell, std::int64_t pose) const;
  /// Where that pose is asked: pairs with variants have several.
  const HeldPairing& held_pairing(const PlannedCell& cell, std::int64_t pose) const;
  /// Where the state could not be drawn to its end: the one that the engine broke down at, in mode `both`.
  Case as_case(const PlannedCell& cell, std::int64_t pose) const;

 private:
  struct HeldPairings {
    std::vector<std::unique_ptr<HeldPairing>> usual;  ///< of the pair itself, then of its variants
    std::unique_ptr<HeldPairing> nested;
    std::vector<std::unique_ptr<HeldPairing>> extreme;
  };

  /// What can have poses, however few are asked for.
  struct Fit {
    std::set<std::size_t> pairs;
    std::set<Stratum> strata;
    std::int64_t cells = 0;  ///< in one mode
  };

  void prepare_pairings();
  bool takes_part(std::size_t pair, Stratum stratum) const;
  void add_drawn_cells();
  void add_recorded_cells();
  void say_what_gets_no_pose(const Fit& fit);
  /// None where poses are drawn.
  const RecordedState* recorded(const PlannedCell& cell, std::int64_t pose) const;
  /// The recorded states from which a scene is led to a recorded pose, in the order of time.
  std::vector<MovingPose> recorded_before(const PlannedCell& cell, std::int64_t pose) const;
  PoseRandom random_of(const PlannedCell& cell, std::int64_t pose, Purpose purpose) const;
  std::string origin(const PlannedCell& cell, std::int64_t pose) const;

  VerificationPlan plan_;
  std::int64_t modes_per_pose_;
  const EngineSeam* seam_;
  std::vector<HeldPairings> held_pairings_;
  std::vector<PlannedCell> cells_;
  std::vector<std::string> omissions_;
  std::string without_poses_;
};

}  // namespace pcm::compare
