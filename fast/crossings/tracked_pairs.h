// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "fast/crossings/pair_signs.h"
#include "fast/posed/motion.h"
#include "fast/posed/posed_pair.h"
#include "fast/search/candidates.h"

namespace pcm::fast {

/// The pairs of faces that may cross while F moves a little, each with its signs and how far points of F may have
/// travelled until these must be found again. Tells along a trajectory, exactly, which pairs cross, and costs little
/// where poses are a hair apart.
///
/// All is so at the pose asked for, in the rounded problem: what is not found again there can't be otherwise (WidePose,
/// pair_margin and fast/simd/pairs.h), ties least of all, which have no margin.
class TrackedPairs {
 public:
  /// What `update` can tell of what crosses, compared with the pose before.
  enum class Outcome : std::uint8_t {
    same,     ///< the same edges pass through the same faces, and no component has passed through the other surface
    unknown,  ///< maybe others
  };

  /// Nothing is tracked.
  void clear() { faces_.clear(), signs_.clear(), until_.clear(), listed_until_ = -1; }

  /// Lists all pairs that may cross at poses to which no point of F travels by more than `margin`, m.
  void list(PosedPair& posed, double margin, NodePairs& open);

  /// Whether the list holds at another pose. `travelled`: how far points of F have at most, on their way from where it
  /// was made, m.
  bool holds(double travelled) const { return travelled < listed_until_; }

  /// A ball about all faces of F that are in the list, in Mf.
  const BoundingBall& ball_of_listed() const { return ball_of_listed_; }

  /// At a pose where it holds: finds signs again where they may have changed. `travelled`: of points of the ball of
  /// listed faces alone, m. `fewest_vertices`: that a component of either surface has.
  Outcome update(PosedPair& posed, double travelled, std::size_t fewest_vertices);

  /// Calls `visit(face of E, face of F, PairSigns)` for each pair that crosses; corners that are no ends of edges that
  /// pass may be said to lie where they were when the pair was looked at last.
  template <class Visit>
  void for_each_crossing(const Visit& visit) const {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (signs_[i].passing != 0) visit(faces_[i].first, faces_[i].second, signs_[i]);
    }
  }

 private:
  /// Finds the signs of the expired pairs, and for how long they hold; whether all of them cross as they did.
  bool look_again(PosedPair& posed, double travelled);

  double listed_until_ = -1;
  BoundingBall ball_of_listed_;
  // By pair: its faces of E and F, and signs that hold until the ball's points have travelled so far, m.
  std::vector<std::pair<Index, Index>> faces_;
  std::vector<PairSigns> signs_;
  std::vector<double> until_;
  std::vector<Index> expired_;  ///< pairs that are looked at again
};

}  // namespace pcm::fast
