// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/prism/master_prism.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/base/geometry.h"

namespace pcm::fast {

namespace {

/// A face is a needle where |N| is less than this part of the product of two sides. Each component of N is off by at
/// most 4 u of what its terms add up to, so |N| by 4 u of that product.
constexpr double kNeedle = 0x1p-16;

double product_of_sides(const std::array<Eigen::Vector3d, 3>& p) {
  return (p[1] - p[0]).lpNorm<1>() * (p[2] - p[0]).lpNorm<1>();
}

}  // namespace

FaceGeometry face_with_sure_normal(const std::array<Eigen::Vector3d, 3>& points_Me) {
  const FaceGeometry plain(points_Me);
  if (2 * plain.area >= kNeedle * product_of_sides(points_Me)) return plain;
  const double size = std::max((points_Me[1] - points_Me[0]).cwiseAbs().maxCoeff(),
                               (points_Me[2] - points_Me[0]).cwiseAbs().maxCoeff());
  return size > 0 ? FaceGeometry(points_Me, exact_normal(points_Me, size)) : plain;
}

MasterPrism::MasterPrism(const FaceGeometry& face)
    : face_(face),
      edge_s_Me_(face.points_Me[1] - face.points_Me[0]),
      edge_t_Me_(face.points_Me[2] - face.points_Me[0]),
      inverse_twice_area_(1 / (2 * face.area)),
      length_s_(length(edge_s_Me_)),
      length_t_(length(edge_t_Me_)),
      // 4 u for the roundings of n itself, twice all of it to be safe; a needle's normal is no worse than others'.
      tilt_(8 * 0x1p-53 * (1 + std::min(product_of_sides(face.points_Me) * inverse_twice_area_, 1 / kNeedle))),
      plane_(face.points_Me) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d side = face.points_Me[(k + 1) % 3] - face.points_Me[k];
    inward_Me_[k] = inverse_twice_area_ * face.n_Me.cross(side);
    inward_length_[k] = length(inward_Me_[k]);
  }
  const auto& p = face.points_Me;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    gradient_[k] = {inward_Me_[1][i], inward_Me_[2][i], inward_Me_[0][i], face.N_Me[i]};
    origin_[k] = {p[1][i], p[2][i], p[0][i], p[0][i]};
  }
}

PrismPoint MasterPrism::see(const Eigen::Vector3d& x_Me, WorkCounters& work) const {
  PrismPoint point = products(x_Me);
  const double height = point[kDepth];
  const double sure = plane_.sure_height(height, x_Me, work);
  // Stored as a whole: a number of it alone would have to reach memory before the point could be read.
  point = point.cwiseProduct(PrismPoint(1, 1, 1, -inverse_twice_area_));
  if (sure != height || point[kDepth] == 0) point[kDepth] = keeping_sign(-sure * inverse_twice_area_, -sure);
  return point;
}

int MasterPrism::scale_depths(const std::array<Eigen::Vector3d, 3>& points_Me,
                              std::array<PrismPoint, 3>& corners) const {
  const ScaledHeights heights = plane_.scaled_heights(points_Me);
  const int area_exponent = std::ilogb(inverse_twice_area_);
  const double mantissa = std::ldexp(inverse_twice_area_, -area_exponent);
  const int exponent = heights.exponent + area_exponent;
  // Far from underflow, and still next to nothing: how far off a point is seen does not grow with such a depth.
  const int scaled = std::max(exponent, -800);
  for (std::size_t k = 0; k < 3; ++k) corners[k][kDepth] = -std::ldexp(heights.value[k] * mantissa, scaled);
  return exponent - scaled;
}

TreePrism::TreePrism(const MasterPrism& prism, double box_error)
    : down_(-prism.face().n_Me), top_(down_.dot(prism.p0_Me())), box_error_(box_error) {
  for (std::size_t k = 0; k < 3; ++k) {
    inward_[k] = prism.inward_Me(k) / prism.inward_length(k);
    offset_[k] = inward_[k].dot(prism.face().points_Me[k]);
  }
}

TreePrism::TreePrism(const MasterPrism& prism, double box_error, const Eigen::Matrix3d& A, const Eigen::Vector3d& r_Me)
    : TreePrism(prism, box_error) {
  for (std::size_t k = 0; k < 3; ++k) {
    offset_[k] = inward_[k].dot(prism.face().points_Me[k] - r_Me);
    inward_[k] = A.transpose() * inward_[k];
  }
  top_ = down_.dot(prism.p0_Me() - r_Me);
  down_ = A.transpose() * down_;
}

bool project_face(const std::array<Index, 3>& vertices, const std::array<PrismPoint, 3>& corners, ProjectedFace& face,
                  int depth_exponent) {
  for (int weight = 0; weight < 3; ++weight) {
    if (!(std::max({corners[0][weight], corners[1][weight], corners[2][weight]}) > 0)) return false;
  }
  if (!(std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]}) >= 0)) return false;
  const double twice_area = cross_st(corners[0], corners[1], corners[2]);
  if (!(std::abs(twice_area) > 0)) return false;
  face.leaves = twice_area < 0;
  const std::array<std::size_t, 3> order{0, face.leaves ? 2U : 1U, face.leaves ? 1U : 2U};
  ConvexPolygon& seen = face.seen;
  seen.count = 3;
  seen.cuts = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    face.vertices[k] = vertices[order[k]];
    face.corners[k] = seen.points[k] = corners[order[k]];
    seen.lines[k] = line_of_face(face.number, static_cast<int>(k));
  }
  for (int coordinate = 0; coordinate <= kDepth; ++coordinate) {
    // A polygon of no corner beyond a side stays beyond none.
    if (std::min({corners[0][coordinate], corners[1][coordinate], corners[2][coordinate]}) >= 0) continue;
    keep_where_not_negative(seen, coordinate, coordinate == kDepth ? line_of_face(face.number, kAtDepth0) : kNoLine);
    if (seen.empty()) return false;
  }
  face.low_s = face.low_t = std::numeric_limits<double>::infinity();
  face.high_s = face.high_t = -face.low_s;
  for (int i = 0; i < seen.count; ++i) {
    if (seen[i][kDepth] < 0) seen[i][kDepth] = 0;
    // What lies beneath stays beneath.
    if (depth_exponent != 0 && seen[i][kDepth] > 0)
      seen[i][kDepth] =
          std::max(std::ldexp(seen[i][kDepth], depth_exponent), std::numeric_limits<double>::denorm_min());
    face.low_s = std::min(face.low_s, seen[i][kS]);
    face.high_s = std::max(face.high_s, seen[i][kS]);
    face.low_t = std::min(face.low_t, seen[i][kT]);
    face.high_t = std::max(face.high_t, seen[i][kT]);
  }
  return true;
}

}  // namespace pcm::fast
