// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/continuous_change.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "compare/poses/surface_features.h"
#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {
namespace {

/// Of a vertex at each of two poses: three products and three sums of at most |x_F| or |x_F| + |r| each, and as many
/// again for the depth (11) and the sums over the elements.
constexpr double kRoundings = 64 * kRoundoff;

}  // namespace

ContinuousChange::ContinuousChange(const fast::Pairing& pairing)
    : pairing_(pairing),
      c_l_(fast::SeriesStiffness(pairing.law()).c_l),
      weight_(pairing.mode() == Mode::both ? 0.5 : 1),
      radius_E_(radius_about_origin(pairing.surface_E().mesh())),
      radius_F_(radius_about_origin(pairing.surface_F().mesh())),
      lever_(radius_F_) {}

double ContinuousChange::change(const FaceLoad& before, const FaceLoad& after) const {
  return std::max((after.force_Me - before.force_Me).stableNorm(),
                  (after.torque_Me - before.torque_Me).stableNorm() / lever_);
}

double ContinuousChange::way(const Pose& a, const Pose& b) const {
  return (b.r - a.r).norm() + (b.A - a.A).norm() * radius_F_ + kRoundings * (radius_E_ + radius_F_ + a.r.norm());
}

ContinuousChange::Face ContinuousChange::face_Me(const Pose& pose, Side side, Index face) const {
  const TriangleMesh& mesh = (side == Side::E ? pairing_.surface_E() : pairing_.surface_F()).mesh();
  const Triangle& corners = mesh.faces[static_cast<std::size_t>(face)];
  std::array<Eigen::Vector3d, 3> x;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = mesh.vertices[static_cast<std::size_t>(corners[i])];
    if (side == Side::F) x[i] = pose.A * x[i] + pose.r;
  }
  const Eigen::Vector3d N = (x[1] - x[0]).cross(x[2] - x[0]);
  return {x[0], N.normalized(), N.norm() / 2, (x[1] - x[0]).norm() + (x[2] - x[1]).norm() + (x[0] - x[2]).norm()};
}

double ContinuousChange::operator()(const Pose& a, const Pose& b, const FaceLoad& before, const FaceLoad& after) const {
  const double d = way(a, b);
  const Side slave = opposite(before.master);
  const Face e = face_Me(a, before.master, before.face);
  double steepness = 0;  // sum of 1 / |n_e . n_f|
  for (const FaceLoad* load : {&before, &after})
    for (const Index f : load->slave_faces) steepness += 1 / std::abs(e.n.dot(face_Me(a, slave, f).n));
  double swept = e.area;
  if (pairing_.scheme() == Scheme::clipped) swept += e.perimeter * std::max(before.depth, after.depth);
  // F's normals turn with it, and the position C_k moves.
  const double turned = (b.A - a.A).norm() + kRoundings + d * (1 + steepness) / lever_;
  return weight_ * c_l_ * 3 * d * steepness * swept +
         turned * std::max(before.force_Me.stableNorm(), after.force_Me.stableNorm());
}

bool ContinuousChange::flush(const Pose& pose, Side master, Index master_face, Index slave_face) const {
  const Side slave = opposite(master);
  const Face e = face_Me(pose, master, master_face), f = face_Me(pose, slave, slave_face);
  const double size = radius_E_ + radius_F_ + pose.r.norm();
  // A tilt by t moves the plane by t times the size.
  return (e.n - f.n).norm() <= 0x1p-40 && std::abs(e.n.dot(f.point - e.point)) <= 0x1p-40 * size;
}

}  // namespace pcm::compare
