// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/prism/sure_plane.h"

#include <Eigen/Geometry>

#include "fast/base/geometry.h"

namespace pcm::fast {

namespace {

/// The terms of N = (p1 - p0) x (p2 - p0) taken absolutely.
Eigen::Vector3d magnitude_of_normal(const std::array<Eigen::Vector3d, 3>& p) {
  const Eigen::Vector3d a = (p[1] - p[0]).cwiseAbs(), b = (p[2] - p[0]).cwiseAbs();
  return cross_of_magnitudes(a, b).array() + kFilterUnderflow;
}

}  // namespace

SurePlane::SurePlane(const std::array<Eigen::Vector3d, 3>& p)
    : p_(p), N_((p[1] - p[0]).cross(p[2] - p[0])), N_magnitude_(magnitude_of_normal(p)) {}

const ExactPlane& SurePlane::exact() {
  if (!exact_) exact_.emplace(p_);
  return *exact_;
}

}  // namespace pcm::fast
