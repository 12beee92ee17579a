// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fast/ray.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Steeper than this the distance to a face's plane follows the line's error by at most a factor of 2^8.
constexpr double kSteep = 0x1p-8;

std::array<Eigen::Vector3d, 3> points_of(const Surface::Data& surface, Index face) {
  const Triangle& triangle = surface.face(face);
  return {surface.vertex(triangle[0]), surface.vertex(triangle[1]), surface.vertex(triangle[2])};
}

/// A lower bound of the distance at which a line within `tolerance` of the ray meets f; infinite where none does.
double least_distance(const Ray& ray, const FaceGeometry& f, double tolerance) {
  std::array<Eigen::Vector3d, 3> from_origin;
  std::array<double, 3> along;
  for (std::size_t k = 0; k < 3; ++k) {
    from_origin[k] = f.points_Me[k] - ray.origin;
    along[k] = ray.direction.dot(from_origin[k]);
  }
  if (*std::max_element(along.begin(), along.end()) < -tolerance) return kInfinity;
  // Seen along the line, the origin lies within the tolerance of the face only where it is no farther than that on the
  // wrong side of any edge; a face seen edgewise may have either winding.
  const double cosine = ray.direction.dot(f.n_Me);
  bool as_seen = true, as_seen_reversed = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double side = ray.direction.dot(from_origin[k].cross(from_origin[next]));
    const double allowed = tolerance * length(f.points_Me[next] - f.points_Me[k]);
    as_seen = as_seen && side >= -allowed;
    as_seen_reversed = as_seen_reversed && side <= allowed;
  }
  if (!(as_seen || as_seen_reversed)) return kInfinity;
  if (std::abs(cosine) < kSteep) return *std::min_element(along.begin(), along.end()) - tolerance;
  const double distance = f.n_Me.dot(from_origin[0]) / cosine;
  const double margin = 4 / kSteep * tolerance;
  return distance < -margin ? kInfinity : distance - margin;
}

}  // namespace

std::vector<double> lower_bounds_of_thickness(const Surface::Data& surface) {
  const double tolerance = kThicknessTolerance * surface.reach.maxCoeff();
  std::vector<double> bounds(surface.mesh.faces.size(), 0.0);
  std::vector<Index> open;
  for (Index face = 0; face < static_cast<Index>(bounds.size()); ++face) {
    const FaceGeometry geometry(points_of(surface, face));
    const Ray ray(geometry, geometry.barycentre_Me());
    if (!(8 * surface.reach.maxCoeff() * ray.direction_error < tolerance)) continue;
    const TreeRay tree_ray(ray.origin, ray.direction, 2 * tolerance);
    double nearest = kInfinity;
    open.assign(1, 0);
    while (!open.empty() && nearest > 0) {
      const BoxNode& node = surface.tree.node(open.back());
      open.pop_back();
      const double entry = tree_ray.entry(node.box);
      if (entry == kInfinity || entry - 2 * tolerance > nearest) continue;
      if (!node.leaf()) {
        open.push_back(node.child);
        open.push_back(node.child + 1);
      } else if (node.face != face) {
        nearest = std::min(nearest, least_distance(ray, FaceGeometry(points_of(surface, node.face)), tolerance));
      }
    }
    bounds[static_cast<std::size_t>(face)] = std::max(nearest, 0.0);
  }
  return bounds;
}

}  // namespace pcm::fast
