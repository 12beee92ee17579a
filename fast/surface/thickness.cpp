// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/surface/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fast/predicates/penetration_predicates.h"
#include "fast/prism/master_prism.h"
#include "fast/surface/open_nodes.h"
#include "fast/surface/own_sights.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Steeper than this the distance to a face's plane follows the line's error by at most a factor of 2^8.
constexpr double kSteep = 0x1p-8;

/// A lower bound of the distance at which a line within `tolerance` of the ray meets f; infinite where none does.
///
/// With u = 2^-53 and 1-norms: on which side of an edge e the ray passes, seen from its corner a, is told by
/// d . (a x e), not by a x b with both ends, whose roundings are of no use beside a short edge far away. a and e are
/// off by u |a| and u |e|, the product by 7 u |a| |e| in all, so by 13 u |a| times the edge's length; 16 u |a| pays for
/// d's length, too. The plane's distance t = n . a / (n . d) with each component of n off by epsilon is off by epsilon
/// (|a| + 2 |t|) / |n . d|, where t does not exceed the farthest corner's |a|.
double least_distance(const Ray& ray, const FaceGeometry& f, double tolerance) {
  std::array<Eigen::Vector3d, 3> from_origin;
  std::array<double, 3> along, away;
  for (std::size_t k = 0; k < 3; ++k) {
    from_origin[k] = f.points_Me[k] - ray.origin;
    along[k] = ray.direction.dot(from_origin[k]);
    away[k] = from_origin[k].lpNorm<1>();
  }
  if (*std::max_element(along.begin(), along.end()) < -tolerance) return kInfinity;
  // Seen along the line, the origin lies within the tolerance of the face only where it is no farther than that on the
  // wrong side of any edge; a face seen edgewise may have either winding.
  bool as_seen = true, as_seen_reversed = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d edge = f.points_Me[(k + 1) % 3] - f.points_Me[k];
    const double side = ray.direction.dot(from_origin[k].cross(edge));
    const double allowed = (tolerance + 16 * 0x1p-53 * away[k]) * length(edge) + 0x1p-1060;
    as_seen = as_seen && side >= -allowed;
    as_seen_reversed = as_seen_reversed && side <= allowed;
  }
  if (!(as_seen || as_seen_reversed)) return kInfinity;
  const double cosine = ray.direction.dot(f.n_Me);
  const double plane_error = 3 * normal_error(f) * *std::max_element(away.begin(), away.end());
  if (std::abs(cosine) < kSteep || !(plane_error < tolerance)) {
    return *std::min_element(along.begin(), along.end()) - tolerance;
  }
  const double distance = f.n_Me.dot(from_origin[0]) / cosine;
  // A quarter for the line, a quarter for the plane.
  const double error = 4 / kSteep * tolerance;
  return distance < -error ? kInfinity : distance - error;
}

/// How deep beneath the master face any part of f begins that the prism, wider by `tolerance` on all sides, has in it.
double least_depth(const MasterPrism& prism, const std::array<PrismPoint, 3>& corners, double tolerance) {
  ConvexPolygon part;
  for (PrismPoint corner : corners) {
    corner[0] += tolerance * prism.inward_length(1);
    corner[1] += tolerance * prism.inward_length(2);
    corner[2] += tolerance * prism.inward_length(0);
    corner[kDepth] += tolerance;
    part.add(corner);
  }
  for (int coordinate = 0; coordinate <= kDepth; ++coordinate) keep_where_not_negative(part, coordinate);
  double least = kInfinity;
  for (int i = 0; i < part.count; ++i) least = std::min(least, part[i][kDepth]);
  return least - 2 * tolerance;
}

/// Another face as a master face sees it.
struct SeenFace : SeenCorners {
  const Triangle& vertices;

  SeenFace(OwnSights& sights, const PreparedSurface& surface, Index face, WorkCounters& work)
      : SeenCorners(sights.corners(surface, face, work)), vertices(surface.face(face)) {}

  bool is_neighbour() const { return shared[0] >= 0 || shared[1] >= 0 || shared[2] >= 0; }

  /// Whether the face lies above the master's plane or touches it from there, exactly.
  bool lies_above() const {
    const std::array<double, 3> depths{points[0][kDepth], points[1][kDepth], points[2][kDepth]};
    return std::max({depths[0], depths[1], depths[2]}) <= 0 && std::min({depths[0], depths[1], depths[2]}) < 0;
  }
  /// Whether it does so however its vertices and the master's are rounded, heights changing by less than `tolerance`:
  /// the corners that both share stay in the master's plane, all others are well above.
  bool surely_lies_above(double tolerance) const {
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (shared[k] >= 0) continue;
      if (!(points[k][kDepth] < -tolerance)) return false;
      any = true;
    }
    return any;
  }

  /// Whether one of the prism's sides has all of the face on its far side or in it, exactly. Rounded, the face then
  /// reaches into the prism no farther than vertices are moved.
  bool lies_beside(const MasterPrism& prism, const PreparedSurface& surface, WorkCounters& work) const {
    for (std::size_t weight = 0; weight < 3; ++weight) {
      const std::size_t side = (weight + 1) % 3;
      const auto may_lie_beyond = [&](std::size_t k) {
        return shared[k] >= 0 ? shared[k] != static_cast<int>(weight)
                              : points[k][static_cast<Index>(weight)] <= prism.weight_error(side, points[k]);
      };
      const auto lies_beyond = [&](std::size_t k) {
        return shared[k] >= 0 || side_of_prism(prism.face().points_Me, side, surface.vertex(vertices[k]), work) <= 0;
      };
      if (may_lie_beyond(0) && may_lie_beyond(1) && may_lie_beyond(2) && lies_beyond(0) && lies_beyond(1) &&
          lies_beyond(2)) {
        return true;
      }
    }
    return false;
  }
};

/// Whether all faces at a corner of the master face, whose prism it is, surely face its way, and go round that corner
/// no more than once. Then they lie side by side as the master sees them.
bool is_spread_out(const MasterPrism& prism, const PreparedSurface& surface, Index corner, double tolerance) {
  const double off_s = tolerance * prism.inward_length(2), off_t = tolerance * prism.inward_length(0);
  double angle = 0;
  for (const Index face : surface.vertex_faces[corner]) {
    const Triangle& t = surface.face(face);
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), corner) - t.begin());
    const Eigen::Vector3d from = prism.weights(surface.vertex(t[k]));
    const Eigen::Vector3d a = prism.weights(surface.vertex(t[(k + 1) % 3])) - from;
    const Eigen::Vector3d b = prism.weights(surface.vertex(t[(k + 2) % 3])) - from;
    const double winding = a[kS] * b[kT] - a[kT] * b[kS];
    const double turn =
        4 * (off_s * (std::abs(a[kT]) + std::abs(b[kT]) + 2 * off_t) + off_t * (std::abs(a[kS]) + std::abs(b[kS])));
    if (!(winding > turn)) return false;
    angle += std::atan2(winding, a[kS] * b[kS] + a[kT] * b[kT]);
  }
  // A closed fan goes round once, 2 pi, or at least twice; an open one may go round once and a little more.
  const bool closed = surface.vertex_edges[corner].size() == surface.vertex_faces[corner].size();
  return angle < (closed ? 7 : 5);
}

/// Whether all other faces at a corner of the master face lie beside it: on the far side of one of its sides each, but
/// for the vertices on that side.
bool all_lie_beside(const MasterPrism& prism, OwnSights& sights, const PreparedSurface& surface, Index master_face,
                    Index corner, double tolerance, WorkCounters& work) {
  for (const Index face : surface.vertex_faces[corner]) {
    if (face == master_face) continue;
    const SeenFace seen(sights, surface, face, work);
    std::array<bool, 3> beside{true, true, true};  // By weight; each is 0 on a side.
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t weight = 0; weight < 3; ++weight) {
        const double error = tolerance * prism.inward_length((weight + 1) % 3);
        const double w = seen.points[k][static_cast<Index>(weight)];
        beside[weight] = beside[weight] && (seen.shared[k] >= 0 ? w == 0 : w < -error);
      }
    }
    if (!(beside[0] || beside[1] || beside[2])) return false;
  }
  return true;
}

/// Whether the face goes round a corner that it shares with the master beside it.
bool is_beside_at_corners(const MasterPrism& prism, const PreparedSurface& surface, const SeenFace& seen,
                          double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (seen.shared[k] >= 0 && is_spread_out(prism, surface, seen.vertices[k], tolerance)) return true;
  }
  return false;
}

}  // namespace

double lower_bound_of_thickness(const PreparedSurface& surface, Index face) {
  const double tolerance = kThicknessTolerance * surface.max_coordinates.maxCoeff();
  const FaceGeometry geometry(surface.points_of(face));
  const Ray ray(geometry, geometry.barycentre_Me());
  if (!(8 * surface.max_coordinates.maxCoeff() * ray.direction_error < tolerance)) return 0;
  const TreeRay tree_ray(ray.origin, ray.direction, 2 * tolerance);
  double nearest = kInfinity;
  OpenNodes<Index> open;
  open.push(0);
  while (!open.empty() && nearest > 0) {
    const BoxNode& node = surface.tree.node(open.pop());
    const double entry = tree_ray.entry(node.box);
    if (entry == kInfinity || entry - 2 * tolerance > nearest) continue;
    if (!node.leaf()) {
      open.push(node.child);
      open.push(node.child + 1);
    } else if (node.face != face) {
      nearest = std::min(nearest, least_distance(ray, FaceGeometry(surface.points_of(node.face)), tolerance));
    }
  }
  return std::max(nearest, 0.0);
}

ThicknessEverywhere lower_bounds_of_thickness_everywhere(const PreparedSurface& surface, Index face) {
  const double tolerance = 2 * kThicknessTolerance * surface.max_coordinates.maxCoeff();
  const Triangle& master = surface.face(face);
  const FaceGeometry geometry(surface.points_of(face));
  if (!thickness_holds(surface, 0, geometry)) return {};
  const MasterPrism prism(geometry);
  OwnSights sights(prism, master);
  WorkCounters work;
  const TreePrism tree_prism(prism, 2 * tolerance);
  double nearest = kInfinity, nearest_within = kInfinity, nearest_rounded = kInfinity;
  OpenNodes<Index> open;
  open.push(0);
  // Once nearest_within is 0, so are all three bounds.
  while (!open.empty() && nearest_within > 0) {
    const BoxNode& node = surface.tree.node(open.pop());
    if (!tree_prism.may_meet(node.box, nearest_within)) continue;
    if (!node.leaf()) {
      open.push(node.child);
      open.push(node.child + 1);
      continue;
    }
    if (node.face == face) continue;
    const SeenFace seen(sights, surface, node.face, work);
    // A neighbour that is within the prism begins at the face: what it cuts short is not known.
    const bool neighbour = seen.is_neighbour();
    const double least = neighbour ? 0 : least_depth(prism, seen.points, tolerance);
    if (!neighbour) nearest = std::min(nearest, least);
    // Only where something is near is it asked whether it is within the prism.
    const bool above = seen.lies_above();
    if (!(least < (above ? nearest_rounded : nearest_within))) continue;
    if (above && seen.surely_lies_above(tolerance)) continue;
    if (seen.lies_beside(prism, surface, work)) continue;
    if (is_beside_at_corners(prism, surface, seen, tolerance)) continue;
    nearest_rounded = std::min(nearest_rounded, least);
    if (!above) nearest_within = std::min(nearest_within, least);
  }
  ThicknessEverywhere bounds;
  bounds.tolerant = std::max(std::min(nearest, nearest_within), 0.0);
  bounds.exact = std::max(nearest_within, 0.0);
  bounds.rounded = std::max(std::min(nearest_within, nearest_rounded), 0.0);
  bounds.clear_of_neighbours = std::all_of(master.begin(), master.end(), [&](Index corner) {
    return is_spread_out(prism, surface, corner, tolerance) ||
           all_lie_beside(prism, sights, surface, face, corner, tolerance, work);
  });
  return bounds;
}

}  // namespace pcm::fast
