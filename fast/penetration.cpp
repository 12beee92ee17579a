// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/depth.h"
#include "fast/line_search.h"
#include "fast/penetration_predicates.h"
#include "fast/ray.h"
#include "fast/thickness.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How far the line's points and a surface's may be from the computed ones, m. No point of the surfaces is farther from
/// the line's origin than 8 times the reach.
double line_slack(Side side, const Ray& ray, const Placement& placement) {
  return placement.slack(side) + 8 * placement.reach * ray.direction_error;
}

/// The line in the coordinates of a surface's tree.
WideRay in_tree_of(Side side, const WideTree& tree, const Ray& ray, const Placement& placement, double radius) {
  return {tree, placement.to_frame_of(side, ray.origin), placement.direction_in_frame_of(side, ray.direction),
          line_slack(side, ray, placement) + radius};
}

/// An upper bound of the distance at which the line meets f, given that it does: no farther than f's farthest vertex,
/// and near the quotient (11) where the angle is fair.
double greatest_distance(const Ray& ray, const FacePoints& f, double slack) {
  if (!(ray.direction_error < 1)) return kInfinity;
  const Eigen::Vector3d d0 = f[0] - ray.origin;
  const Eigen::Vector3d first_edge = f[1] - f[0], second_edge = f[2] - f[0];
  const double along0 = ray.direction.dot(d0);
  double greatest = std::max({along0, along0 + ray.direction.dot(first_edge), along0 + ray.direction.dot(second_edge)});
  const Eigen::Vector3d N = first_edge.cross(second_edge);
  // 1-norms: |a x b| <= |a| |b|. Roundings: 32 u covers the 12 of each quantity.
  const double size = first_edge.lpNorm<1>() * second_edge.lpNorm<1>();
  const double height_error = (slack + 32 * 0x1p-53 * d0.lpNorm<1>()) * size;
  const double slope = std::abs(ray.direction.dot(N));
  const double slope_error = (3 * ray.direction_error + 32 * 0x1p-53) * size;
  if (slope > 2 * slope_error && slope > kLeastProduct) {
    greatest = std::min(greatest, (std::abs(d0.dot(N)) + height_error) / (slope - slope_error));
  }
  // Where anything overflowed, nothing is known.
  return std::isfinite(greatest) ? std::max(greatest, 0.0) + slack : kInfinity;
}

/// The line meets f at q >= 0 (before the shift).
bool meets(const PenetrationLine& line, const FacePoints& f, int& face_direction, WorkCounters& work) {
  face_direction = facing(line, f, work);
  return face_direction != 0 && passes_through(line, f, work) && distance_sign(line, f, work) >= 0;
}

struct FirstFace {
  Index face = -1;
  int direction = 0;  ///< -1 where the line leaves the slave there, +1 where it enters
  FacePoints points_Me;
  double no_farther_than = kInfinity;
};

/// The first face of a surface that the line meets, by exact distance, then shift, then face index.
FirstFace first_face_met(Workspace::Data& workspace, Side slave, const PenetrationLine& line, const Ray& ray,
                         LineTrace* trace) {
  PosedSurface& posed = workspace.side(slave).posed;
  const WideTree& tree = posed.surface().wide_tree;
  WorkCounters& work = workspace.contact.work;
  const double slack = line_slack(slave, ray, workspace.placement);
  const WideRay wide_ray = in_tree_of(slave, tree, ray, workspace.placement, trace != nullptr ? trace->radius : 0);
  FirstFace first;
  const double reach = search_along(tree, wide_ray, first.no_farther_than, workspace.line_nodes, work, [&](Index face) {
    if (trace != nullptr) trace->slave_faces.push_back(face);
    const FacePoints points = posed.face_Me(face, work);
    int direction = 0;
    if (!meets(line, points, direction, work)) return;
    if (first.face >= 0) {
      const int order = compare_distance(line, points, first.points_Me, work);
      if (order > 0 || (order == 0 && face > first.face)) return;
    }
    first = {face, direction, points, greatest_distance(ray, points, slack)};
  });
  if (trace != nullptr) trace->slave_reach = reach;
  return first;
}

/// Whether the line meets another face of the master strictly before `limit`.
bool leaves_master_before(Workspace::Data& workspace, Side master, Index face, const PenetrationLine& line,
                          const Ray& ray, const FirstFace& limit, LineTrace* trace) {
  PosedSurface& posed = workspace.side(master).posed;
  const WideTree& tree = posed.surface().wide_tree;
  WorkCounters& work = workspace.contact.work;
  const WideRay wide_ray = in_tree_of(master, tree, ray, workspace.placement, trace != nullptr ? trace->radius : 0);
  bool leaves = false;
  double no_farther_than = limit.no_farther_than;
  search_along(tree, wide_ray, no_farther_than, workspace.line_nodes, work, [&](Index own) {
    if (own == face || leaves) return;
    if (trace != nullptr) trace->own_faces.push_back(own);
    const FacePoints points = posed.face_Me(own, work);
    int direction = 0;
    if (!meets(line, points, direction, work) || compare_distance(line, points, limit.points_Me, work) >= 0) return;
    leaves = true;
    no_farther_than = -1;  // The search is over.
  });
  return leaves;
}

/// Whether a face's vertices lie exactly on a line: N = 0 where the plane through them holds every point that differs
/// from one of them in a single coordinate.
bool has_no_normal(const FacePoints& p) {
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d x = p[0];
    x[k] = x[k] == 0 ? 1 : 0;
    if (exact_orientation(p[0].data(), p[1].data(), p[2].data(), x.data()) != 0) return false;
  }
  return true;
}

}  // namespace

bool thicker_than(const Workspace::Data& workspace, Side master, Index face, const FaceGeometry& geometry,
                  double distance) {
  const Surface::Data& surface = workspace.side(master).surface();
  return distance < surface.thickness[static_cast<std::size_t>(face)] &&
         thickness_holds(surface, workspace.placement.slack(master), geometry);
}

Penetration find_penetration(Workspace::Data& workspace, Side master, Index face, const FaceGeometry& geometry,
                             LineTrace* trace) {
  WorkCounters& work = workspace.contact.work;
  if (trace != nullptr) trace->clear();
  const Ray ray(geometry, geometry.barycentre_Me());
  Penetration penetration;
  if (!(ray.direction_error < 1) && has_no_normal(geometry.points_Me)) return penetration;
  const PenetrationLine line(geometry.points_Me[0], geometry.points_Me[1], geometry.points_Me[2]);
  const FirstFace first = first_face_met(workspace, opposite(master), line, ray, trace);
  penetration.first_met = first.face;
  if (first.face < 0 || first.direction > 0) return penetration;
  if (!thicker_than(workspace, master, face, geometry, first.no_farther_than) &&
      leaves_master_before(workspace, master, face, line, ray, first, trace)) {
    penetration.outcome = Penetration::Outcome::too_deep;
    return penetration;
  }
  if (trace != nullptr) trace->own_reach = first.no_farther_than;
  if (distance_sign(line, first.points_Me, work) == 0) return penetration;
  penetration.outcome = Penetration::Outcome::element;
  penetration.slave_face = first.face;
  penetration.depth = DepthBelow(geometry, first.points_Me).value();
  return penetration;
}

}  // namespace pcm::fast
