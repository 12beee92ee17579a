// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/depth.h"
#include "fast/penetration_predicates.h"
#include "fast/ray.h"
#include "fast/thickness.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The ray in the frame of a surface's tree. No point of the surfaces is farther from its origin than 8 times the
/// reach.
TreeRay in_tree_of(Side side, const Ray& ray, const Placement& placement, double radius) {
  return {placement.to_frame_of(side, ray.origin), placement.direction_in_frame_of(side, ray.direction),
          placement.slack(side) + 8 * placement.reach * ray.direction_error + radius};
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
template <bool kTraced>
FirstFace first_face_met(Workspace::Data& workspace, Side slave, const PenetrationLine& line, const Ray& ray,
                         LineTrace* trace) {
  PosedSurface& posed = workspace.side(slave).posed;
  const BoxTree& tree = posed.surface().tree;
  WorkCounters& work = workspace.contact.work;
  const TreeRay tree_ray = in_tree_of(slave, ray, workspace.placement, kTraced ? trace->radius : 0);
  auto& open = workspace.ray_nodes;
  open.clear();
  FirstFace first;
  if constexpr (kTraced) trace->slave_reach = kInfinity;
  const auto visit = [&](Index node) {
    ++work.box_tests;
    const double entry = tree_ray.entry(tree.node(node).box);
    if (entry <= first.no_farther_than && entry < kInfinity) {
      open.emplace_back(entry, node);
    } else if constexpr (kTraced) {
      trace->slave_reach = std::min(trace->slave_reach, entry);
    }
  };
  visit(0);
  while (!open.empty()) {
    const auto [entry, index] = open.back();
    open.pop_back();
    if (entry > first.no_farther_than) {
      if constexpr (kTraced) trace->slave_reach = std::min(trace->slave_reach, entry);
      continue;
    }
    const BoxNode& node = tree.node(index);
    if (!node.leaf()) {
      const std::size_t before = open.size();
      visit(node.child);
      visit(node.child + 1);
      // The nearer child is looked into first.
      if (open.size() == before + 2 && open[before].first < open[before + 1].first) {
        std::swap(open[before], open[before + 1]);
      }
      continue;
    }
    if constexpr (kTraced) trace->slave_faces.push_back(node.face);
    const FacePoints points = posed.face_Me(node.face, work);
    int direction = 0;
    if (!meets(line, points, direction, work)) continue;
    if (first.face >= 0) {
      const int order = compare_distance(line, points, first.points_Me, work);
      if (order > 0 || (order == 0 && node.face > first.face)) continue;
    }
    first = {node.face, direction, points, greatest_distance(ray, points, tree_ray.slack)};
  }
  return first;
}

/// Whether the line meets another face of the master strictly before `limit`.
template <bool kTraced>
bool leaves_master_before(Workspace::Data& workspace, Side master, Index face, const PenetrationLine& line,
                          const Ray& ray, const FirstFace& limit, LineTrace* trace) {
  PosedSurface& posed = workspace.side(master).posed;
  const BoxTree& tree = posed.surface().tree;
  WorkCounters& work = workspace.contact.work;
  const TreeRay tree_ray = in_tree_of(master, ray, workspace.placement, kTraced ? trace->radius : 0);
  std::vector<Index>& open = workspace.nodes;
  open.assign(1, 0);
  while (!open.empty()) {
    const BoxNode& node = tree.node(open.back());
    open.pop_back();
    ++work.box_tests;
    const double entry = tree_ray.entry(node.box);
    if (!(entry <= limit.no_farther_than && entry < kInfinity)) continue;
    if (!node.leaf()) {
      open.push_back(node.child);
      open.push_back(node.child + 1);
      continue;
    }
    if (node.face == face) continue;
    if constexpr (kTraced) trace->own_faces.push_back(node.face);
    const FacePoints points = posed.face_Me(node.face, work);
    int direction = 0;
    if (meets(line, points, direction, work) && compare_distance(line, points, limit.points_Me, work) < 0) return true;
  }
  return false;
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

template <bool kTraced>
Penetration follow_line(Workspace::Data& workspace, Side master, Index face, const FaceGeometry& geometry,
                        LineTrace* trace) {
  WorkCounters& work = workspace.contact.work;
  if constexpr (kTraced) {
    trace->clear();
  }
  const Ray ray(geometry, geometry.barycentre_Me());
  Penetration penetration;
  if (!(ray.direction_error < 1) && has_no_normal(geometry.points_Me)) return penetration;
  const PenetrationLine line(geometry.points_Me[0], geometry.points_Me[1], geometry.points_Me[2]);
  const FirstFace first = first_face_met<kTraced>(workspace, opposite(master), line, ray, trace);
  penetration.first_met = first.face;
  if (first.face < 0 || first.direction > 0) return penetration;
  if (!thicker_than(workspace, master, face, geometry, first.no_farther_than) &&
      leaves_master_before<kTraced>(workspace, master, face, line, ray, first, trace)) {
    penetration.outcome = Penetration::Outcome::too_deep;
    return penetration;
  }
  if constexpr (kTraced) trace->own_reach = first.no_farther_than;
  if (distance_sign(line, first.points_Me, work) == 0) return penetration;
  penetration.outcome = Penetration::Outcome::element;
  penetration.slave_face = first.face;
  penetration.depth = DepthBelow(geometry, first.points_Me).value();
  return penetration;
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
  return trace == nullptr ? follow_line<false>(workspace, master, face, geometry, nullptr)
                          : follow_line<true>(workspace, master, face, geometry, trace);
}

}  // namespace pcm::fast
