// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/engine/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fast/base/geometry.h"
#include "fast/prism/ray.h"

namespace pcm::fast {

namespace {

/// Pairs of boxes that are split before the search settles for what it has.
constexpr int kMostSplits = 512;

/// Boxes of inner nodes farther apart than this many times their half widths are not split further: the true distance
/// is at most 1 + 2 sqrt(3) / kFarApart times their gap. Faces, told apart by their planes, are not split at all.
constexpr double kFarApart = 4;

/// A lower bound of the distance between two boxes: in the axes of either frame the gaps along them are the legs of a
/// distance.
double gap_between(const Placement& placement, const Box& box_E, const Box& box_F) {
  const Eigen::Vector3d t_Me = placement.A * box_F.centre + placement.r_Me - box_E.centre;
  const Eigen::Vector3d t_Mf = placement.A.transpose() * t_Me;
  const Eigen::Vector3d gaps_Me =
      (t_Me.cwiseAbs() - box_E.half - placement.A_absolute * box_F.half).array() - placement.position_error_E;
  const Eigen::Vector3d gaps_Mf =
      (t_Mf.cwiseAbs() - box_F.half - placement.A_absolute.transpose() * box_E.half).array() -
      placement.position_error_F;
  return kShorter * std::max(gaps_Me.cwiseMax(0).norm(), gaps_Mf.cwiseMax(0).norm());
}

/// A box in Me, its axes those of either frame: half axes as columns.
struct BoxInMe {
  Eigen::Vector3d centre, half;
  const Eigen::Matrix3d* axes;  ///< nullptr where they are those of Me
};

/// How far a box lies above the plane of a face at least, or below it, m; 0 where the plane runs through it.
/// `position_error`: how far positions may be off.
double gap_to_plane(const FaceGeometry& face, const BoxInMe& box, double position_error) {
  const Eigen::Vector3d n_box = box.axes != nullptr ? Eigen::Vector3d(box.axes->transpose() * face.n_Me) : face.n_Me;
  const Eigen::Vector3d d = box.centre - face.points_Me[0];
  const double tilt = normal_error(face) * (d.cwiseAbs().sum() + 2 * box.half.sum());
  const double gap = std::abs(face.n_Me.dot(d)) - n_box.cwiseAbs().dot(box.half) - tilt - position_error;
  // Written so that a normal that is not known gives 0.
  return gap > 0 ? kShorter * gap : 0;
}

std::array<Eigen::Vector3d, 3> face_in_Me(const PreparedSurface& surface, const Placement& placement, Side side,
                                          Index face) {
  std::array<Eigen::Vector3d, 3> points;
  for (std::size_t k = 0; k < 3; ++k) points[k] = placement.from_frame_of(side, surface.vertex(surface.face(face)[k]));
  return points;
}

/// By how much splitting a node may still raise a gap, in half widths; faces are told apart by their planes.
double size_of(const BoxNode& node) {
  return node.leaf() ? 0 : node.box.half.maxCoeff();
}

}  // namespace

double distance_lower_bound(const PreparedSurface& surface_E, const PreparedSurface& surface_F,
                            const Placement& placement, BoxPairs& open, WorkCounters& work) {
  const BoxTree& tree_E = surface_E.tree;
  const BoxTree& tree_F = surface_F.tree;
  const auto farther = [](const BoxPair& a, const BoxPair& b) { return a.gap > b.gap; };
  const auto enter = [&](Index i, Index j) {
    ++work.box_tests;
    const BoxNode& E = tree_E.node(i);
    const BoxNode& F = tree_F.node(j);
    double gap = gap_between(placement, E.box, F.box);
    // A large face next to a small body is told apart by its plane, not by its box.
    const double position_error = 4 * placement.position_error_E;
    if (E.leaf()) {
      const BoxInMe box{placement.from_frame_of(Side::F, F.box.centre), F.box.half, &placement.A};
      gap = std::max(
          gap, gap_to_plane(FaceGeometry(face_in_Me(surface_E, placement, Side::E, E.face)), box, position_error));
    }
    if (F.leaf()) {
      const BoxInMe box{E.box.centre, E.box.half, nullptr};
      gap = std::max(
          gap, gap_to_plane(FaceGeometry(face_in_Me(surface_F, placement, Side::F, F.face)), box, position_error));
    }
    open.push_back({i, j, gap});
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
    const double size_E = size_of(E), size_F = size_of(F);
    if ((E.leaf() && F.leaf()) || splits == kMostSplits || nearest.gap > kFarApart * (size_E + size_F))
      return nearest.gap;
    if (size_E > size_F) {
      enter(E.child, nearest.node_F);
      enter(E.child + 1, nearest.node_F);
    } else {
      enter(nearest.node_E, F.child);
      enter(nearest.node_E, F.child + 1);
    }
  }
}

SeparationCertificate::SeparationCertificate(const Pose& pose, double gap) : pose_(pose), gap_(kShorter * gap) {}

bool SeparationCertificate::holds(const Pose& pose, const BoundingBall& ball_F) const {
  if (!(gap_ > 0)) return false;
  // Written so that what is no number certifies nothing.
  return greatest_travel(pose_, pose, ball_F) < gap_;
}

}  // namespace pcm::fast
