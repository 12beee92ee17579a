// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "compare/motion/force_jumps.h"

namespace pcm::compare {

/// Sums along a path. The contact works on F, E being at rest: with force F and torque M on E about Mf, it does
/// W = - integral of F . dr + M . dphi.
struct PathWork {
  double work = 0;      ///< W, J, by the trapezoidal rule over all places looked at, so that jumps are resolved
  double error = 0;     ///< estimate of the rule's error: a third of the change when every other place is left out
  double greatest = 0;  ///< |W| at most: greatest |F| times length plus greatest |M| times turn, J
  double greatest_force = 0;   ///< |F|, N
  double greatest_torque = 0;  ///< |M|, N m
  PathPoint greatest_force_at;

  /// W / greatest; 0 where there is no force.
  double share() const { return greatest > 0 ? work / greatest : 0; }
};
PathWork path_work(const PosePath& path, const PathWalk& walk);

/// Force within a plane, over the steps of a path: with the plane's unit normal n, F_n = |F . n| and
/// F_t = |F - (F . n) n|.
struct TangentialForce {
  double greatest = 0;         ///< F_t, N
  double normal_there = 0;     ///< F_n, N
  PathPoint at;                ///< where
  double greatest_normal = 0;  ///< F_n anywhere, N

  /// Greatest F_t to greatest F_n; 0 where there is no force, infinite where there is no F_n.
  double share() const { return greatest > 0 ? greatest / greatest_normal : 0; }
};
TangentialForce tangential_force(const PathWalk& walk, const Eigen::Vector3d& normal_Me);

}  // namespace pcm::compare
