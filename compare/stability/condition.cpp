// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/condition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::compare::stability {
namespace {

/// The next double away from zero.
double next(double x) {
  return std::nextafter(x, std::copysign(std::numeric_limits<double>::infinity(), x));
}

}  // namespace

std::vector<Pose> poses_an_ulp_away(const Pose& pose) {
  std::vector<Pose> poses;
  for (int i = 0; i < 3; ++i) {
    poses.push_back(pose);
    poses.back().r[i] = next(pose.r[i]);
    for (int j = 0; j < 3; ++j) {
      poses.push_back(pose);
      poses.back().A(i, j) = next(pose.A(i, j));
    }
  }
  return poses;
}

Figures movement_by_an_ulp(const ExactBodies& bodies, const Pose& pose, Scheme scheme, ExactContact& truth) {
  Figures greatest{};
  for (const Pose& moved : poses_an_ulp_away(pose)) {
    ExactContact there(bodies, moved, scheme);
    const Figures distance = differences(truth, there);
    for (std::size_t k = 0; k < greatest.size(); ++k) greatest[k] = std::max(greatest[k], distance[k]);
  }
  return greatest;
}

}  // namespace pcm::compare::stability
