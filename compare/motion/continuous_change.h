// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/motion/path_force.h"
#include "fast/force/law_parameters.h"

namespace pcm::compare {

/// How much the force of a master face may change between two near poses of a pairing if it is continuous there;
/// derived with `walk` in force_jumps.h. Also whether two faces lie flush.
class ContinuousChange {
 public:
  explicit ContinuousChange(const fast::Pairing& pairing);

  /// How much a face's load changed, N: |dF|, or |dM| over the greatest lever there can be where that is more.
  double change(const FaceLoad& before, const FaceLoad& after) const;

  /// Upper bound of that for continuous motion from pose a to pose b, N.
  double operator()(const Pose& a, const Pose& b, const FaceLoad& before, const FaceLoad& after) const;

  /// Whether the slave face has the master face's normal and lies in its plane, but for roundings.
  bool flush(const Pose& pose, Side master, Index master_face, Index slave_face) const;

 private:
  struct Face {
    Eigen::Vector3d point, n;  ///< in Me
    double area = 0, perimeter = 0;
  };
  Face face_Me(const Pose& pose, Side side, Index face) const;
  /// Upper bound of the way of a point of F between the poses as the engine rounds them, m.
  double way(const Pose& a, const Pose& b) const;

  const fast::Pairing& pairing_;
  double c_l_;
  double weight_;  ///< of a master's force in the total
  double radius_E_, radius_F_;
  double lever_;  ///< of an element about Mf, m: C_k lies within E and within F
};

}  // namespace pcm::compare
