// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fast/geometry.h"
#include "fast/ray.h"

namespace pcm::fast {

namespace {

/// Pairs of boxes that are split before the search settles for what it has.
constexpr int kMostSplits = 128;

/// Boxes farther apart than this many times their half widths are not split further: the true distance is at most
/// 1 + 2 sqrt(3) / kFarApart times their gap.
constexpr double kFarApart = 4;

/// Covers the roundings of a norm, and that a rotation's columns are unit vectors to 1e-9 only.
constexpr double kShorter = 1 - 0x1p-28;
constexpr double kLonger = 1 + 0x1p-28;

/// A lower bound of the distance between two boxes: in the axes of either frame the gaps along them are the legs of a
/// distance.
double gap_between(const Placement& placement, const Box& box_E, const Box& box_F) {
  const Eigen::Vector3d t_Me = placement.A * box_F.centre + placement.r_Me - box_E.centre;
  const Eigen::Vector3d t_Mf = placement.A.transpose() * t_Me;
  const Eigen::Vector3d gaps_Me =
      (t_Me.cwiseAbs() - box_E.half - placement.A_absolute * box_F.half).array() - placement.slack_E;
  const Eigen::Vector3d gaps_Mf =
      (t_Mf.cwiseAbs() - box_F.half - placement.A_absolute.transpose() * box_E.half).array() - placement.slack_F;
  return kShorter * std::max(gaps_Me.cwiseMax(0).norm(), gaps_Mf.cwiseMax(0).norm());
}

/// How far three points lie above the plane of a face at least, or below it, m; 0 where it runs between them. `slack`:
/// how far the points may be off.
double gap_to_plane(const FaceGeometry& face, const std::array<Eigen::Vector3d, 3>& points, double slack) {
  const double tilt = normal_error(face);
  double least = std::numeric_limits<double>::infinity(), greatest = -least, reach = 0;
  for (const Eigen::Vector3d& x : points) {
    const Eigen::Vector3d d = x - face.points_Me[0];
    const double height = face.n_Me.dot(d);
    least = std::min(least, height);
    greatest = std::max(greatest, height);
    reach = std::max(reach, d.cwiseAbs().sum());
  }
  const double gap = std::max(least, -greatest) - tilt * reach - slack;
  // Written so that a normal that is not known gives 0.
  return gap > 0 ? kShorter * gap : 0;
}

/// A lower bound of the distance between two faces: one plane or the other keeps them apart.
double gap_between_faces(const Surface::Data& surface_E, const Surface::Data& surface_F, const Placement& placement,
                         Index face_E, Index face_F) {
  std::array<Eigen::Vector3d, 3> e, f;
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = surface_E.vertex(surface_E.face(face_E)[k]);
    f[k] = placement.from_frame_of(Side::F, surface_F.vertex(surface_F.face(face_F)[k]));
  }
  return std::max(gap_to_plane(FaceGeometry(e), f, 2 * placement.slack_E),
                  gap_to_plane(FaceGeometry(f), e, 2 * placement.slack_E));
}

double size_of(const Box& box) {
  return box.half.maxCoeff();
}

/// A norm that bounds |r| and |A x| for x in the ball.
double reach_of(const Pose& pose, const BoundingBall& ball) {
  return pose.r.cwiseAbs().sum() + 2 * (ball.centre.cwiseAbs().sum() + ball.radius);
}

}  // namespace

BoundingBall::BoundingBall(const Surface::Data& surface)
    : centre(surface.tree.root().box.centre), radius(kLonger * surface.tree.root().box.half.norm()) {
  // Half widths are rounded to nearest, beside the last bit of the greatest coordinate.
  radius += 4 * 0x1p-53 * surface.reach.sum();
}

double distance_lower_bound(const Surface::Data& surface_E, const Surface::Data& surface_F, const Placement& placement,
                            BoxPairs& open, WorkCounters& work) {
  const BoxTree& tree_E = surface_E.tree;
  const BoxTree& tree_F = surface_F.tree;
  const auto farther = [](const BoxPair& a, const BoxPair& b) { return a.gap > b.gap; };
  const auto enter = [&](Index i, Index j) {
    ++work.box_tests;
    open.push_back({i, j, gap_between(placement, tree_E.node(i).box, tree_F.node(j).box), false});
    std::push_heap(open.begin(), open.end(), farther);
  };
  open.clear();
  enter(0, 0);
  for (int splits = 0;; ++splits) {
    // All points lie in the pairs of boxes that are left, and none of those is nearer.
    std::pop_heap(open.begin(), open.end(), farther);
    const BoxPair nearest = open.back();
    open.pop_back();
    const BoxNode& E = tree_E.node(nearest.node_E);
    const BoxNode& F = tree_F.node(nearest.node_F);
    const double size_E = size_of(E.box), size_F = size_of(F.box);
    if (nearest.final || splits == kMostSplits || nearest.gap > kFarApart * (size_E + size_F)) return nearest.gap;
    if (E.leaf() && F.leaf()) {
      const double gap = gap_between_faces(surface_E, surface_F, placement, E.face, F.face);
      open.push_back({nearest.node_E, nearest.node_F, std::max(nearest.gap, gap), true});
      std::push_heap(open.begin(), open.end(), farther);
    } else if (F.leaf() || (!E.leaf() && size_E > size_F)) {
      enter(E.child, nearest.node_F);
      enter(E.child + 1, nearest.node_F);
    } else {
      enter(nearest.node_E, F.child);
      enter(nearest.node_E, F.child + 1);
    }
  }
}

SeparationCertificate::SeparationCertificate(const Pose& pose, const BoundingBall& ball_F, double gap)
    : pose_(pose), gap_(kShorter * gap - kPlacementSlack * reach_of(pose, ball_F)) {}

bool SeparationCertificate::holds(const Pose& pose, const BoundingBall& ball_F) const {
  if (!(gap_ > 0)) return false;
  const Eigen::Matrix3d turn = pose.A - pose_.A;
  const double way = (turn * ball_F.centre + (pose.r - pose_.r)).norm() + turn.norm() * ball_F.radius;
  // Written so that what is no number certifies nothing.
  return kLonger * way + kPlacementSlack * reach_of(pose, ball_F) < gap_;
}

}  // namespace pcm::fast
