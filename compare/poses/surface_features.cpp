// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/surface_features.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>

#include "compare/random/random.h"
#include "fast/base/number_vector.h"

namespace pcm::compare {
namespace {

const Eigen::Vector3d& corner(const TriangleMesh& mesh, Index face, std::size_t k) {
  return mesh.vertices[static_cast<std::size_t>(mesh.faces[static_cast<std::size_t>(face)][k])];
}

/// Along a face's vector area, which must not be 0, to some units in the last place; its greatest component is between
/// 2^-64 and 1.
Eigen::Vector3d exact_direction(const TriangleMesh& mesh, Index face) {
  const double* const p = corner(mesh, face, 0).data();
  const auto [x, y, z] = cross(fast::difference<Dyadic>(corner(mesh, face, 1).data(), p),
                               fast::difference<Dyadic>(corner(mesh, face, 2).data(), p));
  int top = std::numeric_limits<int>::min();
  for (const Dyadic* const component : {&x, &y, &z})
    if (component->sign() != 0) top = std::max(top, component->top());
  return {x.approximate(-top), y.approximate(-top), z.approximate(-top)};
}

/// Squared distance from x to the triangle, by the Voronoi regions of its corners and edges (Ericson 2005, 5.1.5).
double squared_distance_to_triangle(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                    const Eigen::Vector3d& c) {
  const auto squared_distance = [&x](const Eigen::Vector3d& y) {
    const Eigen::Vector3d d = x - y;
    return ordered_dot(d, d);
  };
  const Eigen::Vector3d ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const double d1 = ordered_dot(ab, ax), d2 = ordered_dot(ac, ax);
  if (d1 <= 0 && d2 <= 0) return squared_distance(a);
  const double d3 = ordered_dot(ab, bx), d4 = ordered_dot(ac, bx);
  if (d3 >= 0 && d4 <= d3) return squared_distance(b);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return squared_distance(a + ab * (d1 / (d1 - d3)));
  const double d5 = ordered_dot(ab, cx), d6 = ordered_dot(ac, cx);
  if (d6 >= 0 && d5 <= d6) return squared_distance(c);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return squared_distance(a + ac * (d2 / (d2 - d6)));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return squared_distance(b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))));
  const double sum = va + vb + vc;
  return squared_distance(a + ab * (vb / sum) + ac * (vc / sum));
}

/// Signed number of faces that a ray in the fixed oblique direction leaves through. A ray through an edge may be
/// miscounted; the candidate is then judged wrongly, so callers keep a margin of several candidates.
int winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& x) {
  const Eigen::Vector3d ray(0.57, 0.31, 0.76);
  int winding = 0;
  for (const Triangle& face : mesh.faces) {
    const Eigen::Vector3d a = mesh.vertices[static_cast<std::size_t>(face[0])] - x;
    const Eigen::Vector3d b = mesh.vertices[static_cast<std::size_t>(face[1])] - x;
    const Eigen::Vector3d c = mesh.vertices[static_cast<std::size_t>(face[2])] - x;
    const double ab = ordered_dot(ray, ordered_cross(a, b));
    const double bc = ordered_dot(ray, ordered_cross(b, c));
    const double ca = ordered_dot(ray, ordered_cross(c, a));
    const bool leaves = ab > 0 && bc > 0 && ca > 0;
    const bool enters = ab < 0 && bc < 0 && ca < 0;
    if (!leaves && !enters) continue;
    const double height = ordered_dot(a, ordered_cross(b, c));
    if (leaves && height > 0) ++winding;
    if (enters && height < 0) --winding;
  }
  return winding;
}

double distance_to_surface(const TriangleMesh& mesh, const Eigen::Vector3d& x) {
  double least = std::numeric_limits<double>::infinity();
  for (Index face = 0; face < static_cast<Index>(mesh.faces.size()); ++face)
    least = std::min(
        least, squared_distance_to_triangle(x, corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  return std::sqrt(least);
}

}  // namespace

SurfaceFeatures::SurfaceFeatures(const TriangleMesh& surface)
    : mesh(surface), vertex_normals(surface.vertices.size(), Eigen::Vector3d::Zero()) {
  std::map<std::array<Index, 2>, std::vector<Index>> faces_of_edge;
  std::vector<bool> used(mesh.vertices.size(), false);
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    const Triangle& face = mesh.faces[static_cast<std::size_t>(f)];
    const Eigen::Vector3d normal = face_normal(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face[k], b = face[(k + 1) % 3];
      faces_of_edge[{std::min(a, b), std::max(a, b)}].push_back(f);
      used[static_cast<std::size_t>(a)] = true;
      vertex_normals[static_cast<std::size_t>(a)] += normal;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double level = corner(mesh, f, 0)[axis];
      if (corner(mesh, f, 1)[axis] == level && corner(mesh, f, 2)[axis] == level)
        axis_faces.push_back({f, axis, normal[axis] > 0 ? 1 : -1});
    }
  }
  closed = true;
  for (auto& [ends, faces] : faces_of_edge) {
    closed = closed && faces.size() == 2;
    edges.push_back({ends, std::move(faces)});
  }
  for (Index v = 0; v < static_cast<Index>(mesh.vertices.size()); ++v)
    if (used[static_cast<std::size_t>(v)]) used_vertices.push_back(v);
  box_min = box_max = mesh.vertices[static_cast<std::size_t>(used_vertices.front())];
  for (const Index v : used_vertices) {
    box_min = box_min.cwiseMin(mesh.vertices[static_cast<std::size_t>(v)]);
    box_max = box_max.cwiseMax(mesh.vertices[static_cast<std::size_t>(v)]);
  }
  size = (box_max - box_min).maxCoeff();
}

Index SurfaceFeatures::support(const Eigen::Vector3d& direction) const {
  Index best = used_vertices.front();
  double greatest = ordered_dot(direction, mesh.vertices[static_cast<std::size_t>(best)]);
  for (const Index v : used_vertices) {
    const double height = ordered_dot(direction, mesh.vertices[static_cast<std::size_t>(v)]);
    if (height > greatest) {
      greatest = height;
      best = v;
    }
  }
  return best;
}

Eigen::Vector3d SurfaceFeatures::face_normal(Index face) const {
  const Eigen::Vector3d& p = corner(mesh, face, 0);
  const Eigen::Vector3d rounded = ordered_cross(corner(mesh, face, 1) - p, corner(mesh, face, 2) - p);
  return rounded.isZero(0) ? std::scalbn(1.0, -900) * exact_direction(mesh, face) : rounded;
}

const std::vector<Index>& SurfaceFeatures::faces_at(const std::array<Index, 2>& ends) const {
  const auto found = std::lower_bound(edges.begin(), edges.end(), ends,
                                      [](const FeatureEdge& edge, const auto& wanted) { return edge.ends < wanted; });
  assert(found != edges.end() && found->ends == ends);
  return found->faces;
}

InnerBall inner_ball(const SurfaceFeatures& features) {
  constexpr std::size_t kFaces = 12;  // spread evenly over the file order
  constexpr int kDepths = 5;          // size / 4, / 8, ... / 64 below the surface
  InnerBall best;
  if (!features.closed) return best;
  const std::size_t n = features.mesh.faces.size();
  for (std::size_t k = 0; k < std::min(kFaces, n); ++k) {
    const auto face = static_cast<Index>(k * n / std::min(kFaces, n));
    const Eigen::Vector3d normal = ordered_normalized(features.face_normal(face));
    const Eigen::Vector3d barycentre =
        (corner(features.mesh, face, 0) + corner(features.mesh, face, 1) + corner(features.mesh, face, 2)) / 3;
    for (int halving = 2; halving < 2 + kDepths; ++halving) {
      const Eigen::Vector3d x = barycentre - normal * std::ldexp(features.size, -halving);
      const double distance = distance_to_surface(features.mesh, x);
      if (distance > best.radius && winding_number(features.mesh, x) >= 1) best = {x, distance};
    }
  }
  return best;
}

double bounding_radius(const SurfaceFeatures& features) {
  const Eigen::Vector3d centre = (features.box_min + features.box_max) / 2;
  double greatest = 0;
  for (const Index v : features.used_vertices) {
    const Eigen::Vector3d d = features.mesh.vertices[static_cast<std::size_t>(v)] - centre;
    greatest = std::max(greatest, ordered_dot(d, d));
  }
  return std::sqrt(greatest);
}

double radius_about_origin(const TriangleMesh& mesh) {
  double greatest = 0;
  for (const Eigen::Vector3d& x : mesh.vertices) greatest = std::max(greatest, x.norm());
  return greatest;
}

}  // namespace pcm::compare
