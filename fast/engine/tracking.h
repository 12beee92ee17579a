// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "fast/active/active_areas.h"
#include "fast/crossings/crossings.h"
#include "fast/crossings/tracked_pairs.h"
#include "fast/engine/force_by_scheme.h"
#include "fast/posed/motion.h"

namespace pcm::fast {

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
  Known move_to(const Pose& pose, PosedPair& posed, NodePairs& open);

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

  void list_pairs(PosedPair& posed, double margin, NodePairs& open);
  void start_lines(double way);

  BoundingBall ball_F_;
  double longest_step_;           ///< of points of F that is followed, m
  std::array<double, 2> spread_;  ///< how far lines of a master are from where they were, over what F has travelled
  std::size_t fewest_vertices_;   ///< of a component of either surface
  std::optional<Pose> last_;
  double longest_since_long_ = 0;  ///< way of points of F on a short step since the last long one, 0: there was none, m
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
