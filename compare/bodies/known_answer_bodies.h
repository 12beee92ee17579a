// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "pcm/engine.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// What the problems with a known answer share: orientations, placements and one-off evaluations.
namespace pcm::compare {

inline constexpr std::array kModes = {Mode::E, Mode::F, Mode::both};
inline constexpr std::array kSchemes = {Scheme::barycentric, Scheme::clipped};

/// How many fixed orientations there are: means are taken over all of them; where a row is exact but for rounding, a
/// few do.
inline constexpr int kOrientations = 20;

/// Fixed rotation number i, from a quaternion of small integers: a rational matrix, rounded. No two faces of the test
/// bodies become parallel by it.
Eigen::Matrix3d fixed_rotation(int i);

/// Fixed rotation number i about the z axis, from a Pythagorean pair.
Eigen::Matrix3d fixed_roll(int i);

/// Where body E stands seen from body F: x_F = R x_E + p.
struct Placement {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();

  Pose pose() const;  ///< of F seen from E
};

/// Force on E and torque on E about F's marker, resolved in F.
struct Load {
  Eigen::Vector3d force_F = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_F = Eigen::Vector3d::Zero();
};
Load load(const fast::Pairing& pairing, const Placement& placement, fast::Workspace& workspace);

/// Frictionless, undamped.
ContactLaw stiffness(double c_l);

/// The mesh with every vertex x replaced by R x, rounded.
TriangleMesh turned(TriangleMesh mesh, const Eigen::Matrix3d& R);

/// Root mean square of the edge lengths, each weighted by the area of its faces, m.
double mean_edge(const TriangleMesh& mesh);

/// How far a force that is exact but for rounding may be off, relative to it: a vertex rounded at the size S moves the
/// penetration u by a few units of roundoff times S, and each of the sums over vertices, polygons and elements that
/// follow adds a few more, all of the same condition S / u.
inline double rounding(double size_over_depth) {
  return 64 * 0x1p-53 * size_over_depth;
}

std::int64_t faces_of(const fast::Surface& E, const fast::Surface& F);

}  // namespace pcm::compare
