// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/rounded_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "compare/poses/rounded_vertices.h"
#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {
namespace {

using roundoff::u;

}  // namespace

RoundedFaces::RoundedFaces(const Question& question)
    : E_(question.E), F_(question.F), vertices_F_Me_(rounded_vertices(question.F.mesh, question.pose)) {
  for (const Eigen::Vector3d& x : E_.mesh.vertices)
    max_coordinate_ = std::max(max_coordinate_, x.cwiseAbs().maxCoeff());
  for (const Eigen::Vector3d& x : vertices_F_Me_) max_coordinate_ = std::max(max_coordinate_, x.cwiseAbs().maxCoeff());
  Eigen::Vector3d box_F = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : F_.mesh.vertices) box_F = box_F.cwiseMax(x.cwiseAbs());
  placed_max_coordinate_ =
      std::max(max_coordinate_, (question.pose.A.cwiseAbs() * box_F + question.pose.r.cwiseAbs()).maxCoeff());
  for (const Side side : {Side::E, Side::F}) {
    for (std::size_t i = 0; i < surface(side).mesh.faces.size(); ++i) {
      const Index face = static_cast<Index>(i);
      for (std::size_t k = 0; k < 3; ++k)
        longest_side_ = std::max(longest_side_, (corner(side, face, (k + 1) % 3) - corner(side, face, k)).stableNorm());
    }
  }
}

// N = d1 x d2 with d1, d2 two sides. A difference has the relative error u in each component, each product of two
// of them 3 u, each component of N so at most 4 u (|d1_i d2_j| + |d1_j d2_i|) to first order; the length of the vector
// of these sums is at most sqrt(2) |d1| |d2|. Hence |dN| <= 4 sqrt(2) u |d1| |d2| < 6 u L1 L2 with the two longest
// sides, whichever two the evaluation takes. The area |N| / 2 takes half of that and 3 roundings more; the unit normal
// |dN| / |N| twice (direction and length) and 4 roundings more. A height over the plane is N . (x - p) / |N|, or in
// proportion to it, in error by |dN| / |N| and 4 roundings of the distance |x - p|; none is greater than that.
RoundedFaces::Face RoundedFaces::face(Side side, Index index) const {
  const Eigen::Vector3d &p = corner(side, index, 0), &q = corner(side, index, 1), &s = corner(side, index, 2);
  Face face;
  std::array<double, 3> sides = {(q - p).stableNorm(), (s - q).stableNorm(), (p - s).stableNorm()};
  std::sort(sides.begin(), sides.end());
  const double N_error = 6 * u * sides[1] * sides[2];
  const Eigen::Vector3d N = (q - p).cross(s - p);
  const double length = N.stableNorm();
  face.area = length / 2;
  face.area_error = N_error / 2 + 3 * u * face.area;
  face.normal_error = length > N_error ? std::min(2.0, 2 * N_error / length + 4 * u) : 2;
  face.plane_error = no_more(N_error / length + 4 * u, 1);
  if (length > 0) face.normal_Me = N / length;
  face.longest = sides[2];
  face.farthest = std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), s.cwiseAbs().maxCoeff()});
  return face;
}

RoundedFaces::Corners RoundedFaces::corners_by_plane(Side side_a, Index a, Side side_b, Index b) const {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const auto point = [&](Side side, Index face, std::size_t k) {
    const Eigen::Vector3d& x = corner(side, face, k);
    return Point(x.x(), x.y(), x.z());
  };
  const Point p = point(side_a, a, 0), q = point(side_a, a, 1), s = point(side_a, a, 2);
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const CGAL::Orientation side = CGAL::orientation(p, q, s, point(side_b, b, k));
    ++(side == CGAL::POSITIVE ? corners.above : side == CGAL::NEGATIVE ? corners.below : corners.on);
  }
  return corners;
}

}  // namespace pcm::compare
