// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fast/posed/motion.h"
#include "fast/posed/placement.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// Two nodes of box trees and how far apart their boxes are at least, m.
struct BoxPair {
  Index node_E = 0;
  Index node_F = 0;
  double gap = 0;
};
/// The heap of the search for the distance; kept between searches.
using BoxPairs = std::vector<BoxPair>;

/// A lower bound of the distance between the two surfaces, m, for all positions of F's vertices within their rounding;
/// 0 where boxes of two faces touch and reach through each other's planes. The nearest pair of boxes is split again and
/// again, until it is a pair of faces, its boxes are small beside their gap, or 512 have been split: some ten
/// microseconds, fifty at most.
double distance_lower_bound(const PreparedSurface& surface_E, const PreparedSurface& surface_F,
                            const Placement& placement, BoxPairs& open, WorkCounters& work);

/// Tells that two surfaces found apart are apart still, however they have moved in between: a rigorous lower bound on
/// the distance is spent by a bound on the relative motion.
///
/// Where no point of F has moved by as much as that distance (greatest_travel), none reaches E on the straight way from
/// its old place to its new one, so the surfaces don't cross, and no winding number changes: what was not nested is not
/// nested.
class SeparationCertificate {
 public:
  /// Certifies nothing.
  SeparationCertificate() = default;
  /// `gap`: a lower bound of the distance at `pose`, m.
  SeparationCertificate(const Pose& pose, double gap);

  /// Whether the surfaces are surely apart at `pose`. About 20 ns.
  bool holds(const Pose& pose, const BoundingBall& ball_F) const;

 private:
  Pose pose_;
  double gap_ = 0;  ///< m
};

}  // namespace pcm::fast
