// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/surface/clearance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "fast/base/geometry.h"
#include "fast/surface/open_nodes.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Let m = 2^-30 of the greatest coordinate be how far coordinates may be moved, e = 2 m how far points, and h the
// face's least height. The face's normal and the inward normals of its sides then turn by less than 2 e / h each, being
// moved at both ends. What `Region` measures of a moved point x is a depth, n . (x - p), or a distance from a side's
// plane, that plus T times the depth: both change by less than 8 e + 16 e / h |x - p|, while 16 e / h is small.
constexpr double kPositionError = 16 * kClearanceTolerance;  ///< 8 e, relative to the greatest coordinate
constexpr double kGreatestTurn = 0x1p-8;                     ///< 16 e / h

/// T of both cones. What K is wider by than the cone, 1 / 32 of the depth, pays for planes that are moved and tilted.
constexpr std::array<double, 2> kTangent{0.81, 1.2};
static_assert(kConeCosine[0] * kConeCosine[0] * (1 + (kTangent[0] - 0x1p-5) * (kTangent[0] - 0x1p-5)) > 1);
static_assert(kConeCosine[1] * kConeCosine[1] * (1 + (kTangent[1] - 0x1p-5) * (kTangent[1] - 0x1p-5)) > 1);

/// A clearance that is great enough, relative to the greatest coordinate.
constexpr double kFar = 0.25;

/// A point as K sees it.
struct RegionPoint {
  double depth;                  ///< beneath the face
  double depth_error;            ///< how far that may be off
  std::array<double, 6> inside;  ///< of each of K's planes; negative outside
  double inside_room;
};

/// K of one face, on one side of it.
class Region {
 public:
  /// `down` is a unit vector along the face's normal or against it.
  Region(const std::array<Eigen::Vector3d, 3>& p, const Eigen::Vector3d& down, double tangent, double position_error,
         double turn)
      : p0_(p[0]), down_(down), down_absolute_(down.cwiseAbs()), position_error_(position_error), turn_(turn) {
    const Eigen::Vector3d N = (p[1] - p[0]).cross(p[2] - p[0]);
    std::array<Eigen::Vector3d, 3> inward;
    for (std::size_t k = 0; k < 3; ++k) inward[k] = unit(N.cross(p[(k + 1) % 3] - p[k]));
    for (std::size_t k = 0; k < 3; ++k) {
      axis_[k] = inward[k] + tangent * down;
      axis_[k + 3] = unit(inward[k] + inward[(k + 2) % 3]) + tangent * down;
      offset_[k] = axis_[k].dot(p[k] - p0_);
      offset_[k + 3] = axis_[k + 3].dot(p[k] - p0_);
    }
    for (std::size_t k = 0; k < axis_.size(); ++k) axis_absolute_[k] = axis_[k].cwiseAbs();
  }

  RegionPoint see(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d from_p0 = x - p0_;
    RegionPoint sight;
    sight.depth = down_.dot(from_p0);
    sight.depth_error = position_error_ + turn_ * from_p0.lpNorm<1>();
    sight.inside_room = sight.depth_error + std::abs(sight.depth) / 32;
    for (std::size_t k = 0; k < axis_.size(); ++k) sight.inside[k] = axis_[k].dot(from_p0) - offset_[k];
    return sight;
  }

  /// A lower bound of the depth of the box's points in K; infinite where it has none.
  double least_depth(const Box& box) const {
    const Eigen::Vector3d from_p0 = box.centre - p0_;
    const double depth_error = position_error_ + turn_ * (from_p0.lpNorm<1>() + box.half.lpNorm<1>());
    const double depth = down_.dot(from_p0), depth_range = down_absolute_.dot(box.half);
    if (depth + depth_range < -depth_error) return kInfinity;
    const double inside_room = depth_error + (std::abs(depth) + depth_range) / 32;
    for (std::size_t k = 0; k < axis_.size(); ++k) {
      if (axis_[k].dot(from_p0) - offset_[k] + axis_absolute_[k].dot(box.half) < -inside_room) return kInfinity;
    }
    return std::max(depth - depth_range - depth_error, 0.0);
  }

 private:
  Eigen::Vector3d p0_;
  Eigen::Vector3d down_, down_absolute_;
  double position_error_;
  double turn_;
  // Planes that hold all of K: through side k, that is corners k and k + 1, and number 3 + k through corner k, as
  // inward as both sides there.
  std::array<Eigen::Vector3d, 6> axis_;  ///< of unit length inward along the face, T downward
  std::array<double, 6> offset_;
  std::array<Eigen::Vector3d, 6> axis_absolute_;
};

/// Whether all of a face's corners but those that it shares lie outside of one plane through these, or above the face
/// of K, so that the face meets K in no more than what it shares. `planes` are those to be tried.
bool is_parted(const std::array<RegionPoint, 3>& corners, const std::array<bool, 3>& is_shared,
               std::initializer_list<std::size_t> planes) {
  const auto all_others = [&](const auto& test) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_shared[k] && !test(corners[k])) return false;
    }
    return true;
  };
  if (all_others([](const RegionPoint& x) { return x.depth < -x.depth_error; })) return true;
  return std::any_of(planes.begin(), planes.end(), [&](std::size_t plane) {
    return all_others([plane](const RegionPoint& x) { return x.inside[plane] < -x.inside_room; });
  });
}

/// A lower bound of the depth at which another face reaches into K; infinite where it does not.
double least_depth(const Region& region, const PreparedSurface& surface, const Triangle& triangle,
                   const Triangle& other) {
  std::array<RegionPoint, 3> corners;
  std::array<bool, 3> is_shared{};
  std::array<std::size_t, 3> shared{};
  std::size_t number = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = region.see(surface.vertex(other[k]));
    const auto found = std::find(triangle.begin(), triangle.end(), other[k]);
    is_shared[k] = found != triangle.end();
    if (is_shared[k]) shared[number++] = static_cast<std::size_t>(found - triangle.begin());
  }
  if (number == 0) {
    if (is_parted(corners, is_shared, {0, 1, 2, 3, 4, 5})) return kInfinity;
    double least = kInfinity;
    for (const RegionPoint& corner : corners) least = std::min(least, corner.depth - corner.depth_error);
    return std::max(least, 0.0);
  }
  bool parted = false;
  if (number == 1) {
    const std::size_t after = shared[0], before = (shared[0] + 2) % 3;
    parted = is_parted(corners, is_shared, {after, before, after + 3});
  } else if (number == 2) {
    parted = is_parted(corners, is_shared, {(shared[0] + 1) % 3 == shared[1] ? shared[0] : shared[1]});
  }
  return parted ? kInfinity : 0;
}

/// A lower bound of the depth at which another face reaches into K of `face`. Looks no further once it is known to be
/// less than `enough`, nor closely where it exceeds `far`.
double least_depth_in(const Region& region, const PreparedSurface& surface, Index face, double enough, double far) {
  const Triangle& triangle = surface.face(face);
  double nearest = kInfinity;
  OpenNodes<std::pair<double, Index>> open;
  open.push({0, 0});
  while (!open.empty() && nearest >= enough && nearest > 0) {
    const auto [depth, index] = open.pop();
    if (depth >= nearest) continue;
    const BoxNode& node = surface.tree.node(index);
    // A box that is small beside its depth, or far, stands for its faces.
    if (node.box.half.maxCoeff() < depth / 4 || depth > far) {
      nearest = std::min(nearest, depth);
    } else if (!node.leaf()) {
      std::pair<double, Index> children[2];
      for (Index k = 0; k < 2; ++k) {
        children[k] = {region.least_depth(surface.tree.node(node.child + k).box), node.child + k};
      }
      // The nearer one on top.
      if (children[0].first < children[1].first) std::swap(children[0], children[1]);
      for (const auto& child : children) {
        if (child.first < nearest) open.push(child);
      }
    } else if (node.face != face) {
      nearest = std::min(nearest, least_depth(region, surface, triangle, surface.face(node.face)));
    }
  }
  return nearest;
}

/// A float that is not greater.
float rounded_down(double x) {
  return static_cast<float>((1 - 0x1p-20) * x);
}

}  // namespace

Clearance find_clearance(const PreparedSurface& surface, Index face) {
  const double max_coordinate = surface.max_coordinates.maxCoeff();
  const double position_error = kPositionError * max_coordinate;
  const std::array<Eigen::Vector3d, 3> p = surface.points_of(face);
  const double longest = std::max({length(p[1] - p[0]), length(p[2] - p[1]), length(p[0] - p[2])});
  const Eigen::Vector3d N = (p[1] - p[0]).cross(p[2] - p[0]);
  const double turn = 2 * position_error * longest / length(N);
  if (!(turn < kGreatestTurn)) return {};
  const Eigen::Vector3d n = unit(N);
  const auto least_depth_of = [&](const Eigen::Vector3d& down, std::size_t cone, double enough) {
    return least_depth_in({p, down, kTangent[cone], position_error + turn * longest, turn}, surface, face, enough,
                          kFar * max_coordinate);
  };
  Clearance clearance;
  // What is clear of the wide cone is clear of the narrow one; where that is far, the difference hardly counts.
  double depth = least_depth_of(-n, 1, 0);
  clearance.beneath[1] = rounded_down(depth / max_coordinate);
  if (depth < kFar * max_coordinate) depth = least_depth_of(-n, 0, 0);
  clearance.beneath[0] = rounded_down(depth / max_coordinate);
  clearance.above[1] = least_depth_of(n, 1, kInfinity) == kInfinity;
  clearance.above[0] = clearance.above[1] || least_depth_of(n, 0, kInfinity) == kInfinity;
  return clearance;
}

}  // namespace pcm::fast
