// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "fast/active/active_areas.h"
#include "fast/crossings/crossings.h"
#include "fast/crossings/tracked_pairs.h"
#include "fast/engine/force_by_scheme.h"
#include "fast/posed/motion.h"

namespace pcm::fast {

/// How steps that are short enough to be followed came among longer ones of late, and so whether more of them are to be
/// awaited: integrators go far and then iterate, or take difference quotients, about the place they have come to, or
/// come to each place but once. Decides what is looked for beforehand, and no bit.
class ShortSteps {
 public:
  /// `way`: of points of F, m.
  void note_short(double way) {
    count_ = std::min(count_ + 1, kSteady);
    longest_ = std::max(longest_, way);
  }
  void note_long() {
    counts_before_ = {std::exchange(count_, 0), counts_before_[0]};
    longest_before_ = std::exchange(longest_, 0);
  }

  /// After a short step.
  bool others_follow() const { return count_ > 1 || counts_before_[0] > 1; }
  /// Whether it is the fourth in a row, at least.
  bool are_steady() const { return count_ == kSteady; }
  /// After a long step: whether short ones follow, as they did after the last two; and how long the longest may be, m.
  bool awaited() const { return longest_before_ > 0 && counts_before_[1] > 0; }
  double longest_awaited() const { return longest_before_; }

 private:
  static constexpr int kSteady = 4;
  int count_ = 0;                           ///< since the last long step, up to kSteady
  std::array<int, 2> counts_before_{2, 0};  ///< between long steps before, the last ones first; at first others follow
  double longest_ = 0, longest_before_ = 0;
};

/// What is known of a pairing along a trajectory: which pairs of faces cross, for as long as F moves by little from
/// pose to pose, and what followed from it at the last one.
class Tracking {
 public:
  /// What is known at a pose before anything is looked for.
  enum class Known : std::uint8_t {
    nothing,
    crossing_pairs,  ///< the pairs that cross
    active_faces,    ///< the intersected and inner faces, those of the last pose, as well
  };

  Tracking(const PreparedSurface& E, const PreparedSurface& F);

  /// To be asked at every pose, in their order, once it is placed. `open` is scratch.
  Known move_to(const Pose& pose, PosedPair& posed, NodePairs& open) {
    known_ = know_at(pose, posed, open);
    return known_;
  }
  /// Of the last pose.
  Known known() const { return known_; }

  const TrackedPairs& pairs() const { return pairs_; }
  /// Keeps the intersected and inner faces of this pose.
  void keep_active_faces(const Crossings& crossings, const ActiveAreas& areas);
  /// Writes those kept; of crossings and areas nothing else is known.
  void restore_active_faces(Crossings& crossings, ActiveAreas& areas) const;
  LineMemories& lines() { return lines_; }

 private:
  struct KeptFaces {
    std::vector<Index> intersected, inner, pockets;
  };

  Known know_at(const Pose& pose, PosedPair& posed, NodePairs& open);
  void forget();
  /// For `ahead`, m; `way` is that of a step.
  void list_pairs(PosedPair& posed, double ahead, double way, NodePairs& open);
  void start_lines(double way);

  BoundingBall ball_F_;
  double usual_edge_;            ///< of the surface with the shorter ones, m
  std::size_t fewest_vertices_;  ///< of a component of either surface
  std::optional<Pose> last_;
  Known known_ = Known::nothing;
  ShortSteps short_steps_;
  // How far points have travelled since pairs were listed, at most, m:
  double travelled_ = 0;         ///< those of F
  double listed_travelled_ = 0;  ///< those of the faces listed alone
  TrackedPairs pairs_;
  LineMemories lines_;
  bool has_kept_ = false;
  std::array<KeptFaces, 2> kept_;
  bool nested_ = false, ambiguous_ = false;
};

}  // namespace pcm::fast
