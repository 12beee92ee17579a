// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>

#include "fast/base/box_tree.h"
#include "fast/base/geometry.h"
#include "fast/prism/convex_polygon.h"
#include "fast/prism/sure_plane.h"
#include "pcm/triangle_mesh.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// A face with N to a few ulps of itself also where it is a needle: there the cross product of rounded differences
/// loses its digits, and with them the direction of the penetration lines, so it is computed exactly.
FaceGeometry face_with_sure_normal(const std::array<Eigen::Vector3d, 3>& points_Me);

/// The penetration lines of all points of a master face: a prism over the face, along -n (PCM section 6, clipped
/// scheme). Turns points into the face's coordinates. Scaling all lengths by 2^k changes no weight. For one thread, as
/// SurePlane is.
class MasterPrism {
 public:
  /// Only for faces of area > 0, their normals sure.
  explicit MasterPrism(const FaceGeometry& face);

  /// What the face sees of x. Each weight is taken from an end of the side where it is 0, so its error is a few ulps of
  /// the distance over the face's height. The depth is off by no more than kHeightError of itself, besides a few ulps
  /// and a factor that is the same for all depths below the face; it is 0 where x lies exactly in the face's plane, and
  /// only there. What is flush, or nearly so, is decided here.
  PrismPoint see(const Eigen::Vector3d& x_Me, WorkCounters& work) const;
  /// The same of a face's corners.
  std::array<PrismPoint, 3> see(const std::array<Eigen::Vector3d, 3>& points_Me, WorkCounters& work) const {
    return {see(points_Me[0], work), see(points_Me[1], work), see(points_Me[2], work)};
  }
  /// Whether the depths of a face's corners, not all 0, are so small that their ratios tell nothing.
  bool depths_underflow(const std::array<PrismPoint, 3>& corners) const {
    const double greatest =
        std::max({std::abs(corners[0][kDepth]), std::abs(corners[1][kDepth]), std::abs(corners[2][kDepth])});
    return greatest > 0 && greatest * std::min(1.0, 2 * face_.area) < kUnderflown;
  }
  /// Multiplies such depths by a power of two, >= 1, so that their ratios are sure. Its negative exponent is returned.
  int scale_depths(const std::array<Eigen::Vector3d, 3>& points_Me, std::array<PrismPoint, 3>& corners) const;
  /// The same weights alone.
  Eigen::Vector3d weights(const Eigen::Vector3d& x_Me) const { return products(x_Me).head<3>(); }

  /// How far lines through the corners of a face, seen by the prism at these, may be off from each other, where no
  /// |coordinate| exceeds `max_coordinate`. No distance from p0 is greater than 4 times that. What is common to all
  /// weights, a relative error of 2^-30, makes no sliver.
  Uncertainty uncertainty(const std::array<PrismPoint, 3>& corners, double max_coordinate) const {
    const double farthest = std::max({place_error(corners[0]), place_error(corners[1]), place_error(corners[2])});
    return uncertainty_of(std::min(farthest, greatest_place_error(max_coordinate)));
  }
  /// An upper bound of that for all faces at once.
  Uncertainty greatest_uncertainty(double max_coordinate) const {
    return uncertainty_of(greatest_place_error(max_coordinate));
  }

  /// The angle between the lines of the face, without any rounding, and those computed, at most; less than 2^-32.
  double tilt() const { return tilt_; }

  /// How far the weight that is 0 on side k of a point seen by the prism may be off, its own relative error of 2^-30
  /// aside: where the point is seen, over the height above that side.
  double weight_error(std::size_t side, const PrismPoint& point) const {
    return inward_length_[side] * place_error(point);
  }

  /// The face's own corner k, exactly.
  static PrismPoint corner(int k) {
    PrismPoint point = PrismPoint::Zero();
    point[k] = 1;
    return point;
  }

  const FaceGeometry& face() const { return face_; }
  const Eigen::Vector3d& p0_Me() const { return face_.points_Me[0]; }
  const Eigen::Vector3d& edge_s_Me() const { return edge_s_Me_; }  ///< p1 - p0
  const Eigen::Vector3d& edge_t_Me() const { return edge_t_Me_; }  ///< p2 - p0
  /// Gradient of the weight of p2, p0 and p1, that is inward from side 0, 1 and 2; side k joins corners k and k + 1.
  const Eigen::Vector3d& inward_Me(std::size_t side) const { return inward_Me_[side]; }
  double inward_length(std::size_t side) const { return inward_length_[side]; }

 private:
  static constexpr double kPlaceError = 16 * 0x1p-53;  ///< of a distance from p0: for its roundings and a cut's

  static double greatest_place_error(double max_coordinate) { return kPlaceError * (4 * max_coordinate); }
  Uncertainty uncertainty_of(double place_error) const {
    return {place_error * inward_length_[2], place_error * inward_length_[0]};
  }

  /// How far off a point may be seen, m. A turn of the lines by an angle moves a point by that times its depth, and no
  /// more but relative to itself. No corner is farther from the point than `distance` and its depth.
  double place_error(const PrismPoint& point) const {
    const double distance = (1 + std::abs(point[kS])) * length_s_ + (1 + std::abs(point[kT])) * length_t_;
    const double depth = std::abs(point[kDepth]);
    return 2 * tilt_ * depth + kPlaceError * (distance + depth);
  }

  /// The weights, and N . (x - p0), all four in one go.
  PrismPoint products(const Eigen::Vector3d& x_Me) const {
    const PrismPoint x = gradient_[0].cwiseProduct(PrismPoint::Constant(x_Me[0]) - origin_[0]);
    const PrismPoint y = gradient_[1].cwiseProduct(PrismPoint::Constant(x_Me[1]) - origin_[1]);
    const PrismPoint z = gradient_[2].cwiseProduct(PrismPoint::Constant(x_Me[2]) - origin_[2]);
    return (x + y) + z;
  }

  FaceGeometry face_;
  Eigen::Vector3d edge_s_Me_;
  Eigen::Vector3d edge_t_Me_;
  std::array<Eigen::Vector3d, 3> inward_Me_;  ///< 1 / m
  std::array<double, 3> inward_length_;       ///< of these, 1 / m
  // By component: what the three weights and the height are gradient . (x - origin) with.
  std::array<PrismPoint, 3> gradient_, origin_;
  double inverse_twice_area_;   ///< 1 / m^2
  double length_s_, length_t_;  ///< of the sides from p0, m
  double tilt_;
  mutable SurePlane plane_;
};

/// A master prism in the frame of a surface's tree: half spaces direction . x >= offset.
class TreePrism {
 public:
  /// In Me. Boxes grow by `box_error` before they are tested, m.
  TreePrism(const MasterPrism& prism, double box_error);
  /// In the frame whose points x are at A x + r in Me. No inverse of A is taken, so that it need not be orthogonal.
  TreePrism(const MasterPrism& prism, double box_error, const Eigen::Matrix3d& A, const Eigen::Vector3d& r_Me);

  /// False only where no point of the box, grown by the box error, lies in the prism at a depth from 0 to `deepest`.
  bool may_meet(const Box& box, double deepest) const {
    const double depth = down_.dot(box.centre) - top_;
    const double half_extent = down_.cwiseAbs().dot(box.half) + box_error_;
    if (depth + half_extent < 0 || depth - half_extent > deepest) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (inward_[k].dot(box.centre) + inward_[k].cwiseAbs().dot(box.half) + box_error_ < offset_[k]) return false;
    }
    return true;
  }

  const std::array<Eigen::Vector3d, 3>& inward() const { return inward_; }
  const std::array<double, 3>& offset() const { return offset_; }
  const Eigen::Vector3d& down() const { return down_; }
  double top() const { return top_; }
  double box_error() const { return box_error_; }

 private:
  std::array<Eigen::Vector3d, 3> inward_;  ///< of unit length in Me
  std::array<double, 3> offset_;           ///< m
  Eigen::Vector3d down_;                   ///< -n
  double top_;                             ///< m
  double box_error_;                       ///< m
};

/// The corners of a face as a master face sees them.
struct SeenCorners {
  std::array<PrismPoint, 3> points;
  std::array<int, 3> shared{-1, -1, -1};  ///< which of the master face's own corners each is, seen exactly, or -1

  std::array<bool, 3> is_shared() const { return {shared[0] >= 0, shared[1] >= 0, shared[2] >= 0}; }
};

/// A face of the slave, or another one of the master, as the penetration lines of a master face meet it.
struct ProjectedFace {
  std::int32_t number = 0;  ///< among all that the master face sees, for the lines of polygons' sides
  Index face;
  bool of_master;  ///< a face of the master
  bool leaves;     ///< the lines leave that face's body there, N . N_f < 0
  bool carries;    ///< may carry an element: a face of the slave that certainly is left there, over an area
  std::array<Index, 3> vertices;
  std::array<PrismPoint, 3> corners;  ///< of `vertices`, counterclockwise in (s, t); depths to a common factor
  ConvexPolygon seen;                 ///< the part over the master face at a depth >= 0, whatever lies before it
  double low_s, high_s, low_t, high_t;

  ProjectedFace() {}
};

/// Projects a face with the given vertices, seen by the prism at `corners`, whose depths are to be multiplied by
/// 2^depth_exponent. False where no line meets it: seen edgewise, beside the master face or above it.
bool project_face(const std::array<Index, 3>& vertices, const std::array<PrismPoint, 3>& corners, ProjectedFace& face,
                  int depth_exponent = 0);

}  // namespace pcm::fast
