// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/round.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "meshes/generate/deterministic_trigonometry.h"
#include "meshes/generate/generator_support.h"

namespace pcm::generate {
namespace {

/// The point scaled to length 1; written out, so that the order of operations is fixed.
Eigen::Vector3d on_unit_sphere(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

/// Splits every face in four; the new vertices lie on the unit sphere, one for each edge, in order of first use.
void refine_on_unit_sphere(std::vector<Eigen::Vector3d>& vertices, std::vector<Triangle>& faces) {
  std::map<std::array<Index, 2>, Index> middle_of_edge;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, is_new] =
        middle_of_edge.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<Index>(vertices.size()));
    if (is_new) {
      const Eigen::Vector3d p = vertices[a], q = vertices[b];
      vertices.push_back(on_unit_sphere(p.x() + q.x(), p.y() + q.y(), p.z() + q.z()));
    }
    return entry->second;
  };
  std::vector<Triangle> refined;
  refined.reserve(4 * faces.size());
  for (const auto& [a, b, c] : faces) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    refined.push_back({a, ab, ca});
    refined.push_back({ab, b, bc});
    refined.push_back({ca, bc, c});
    refined.push_back({ab, bc, ca});
  }
  faces = std::move(refined);
}

}  // namespace

TriangleMesh icosphere(double radius, Index level) {
  require_length("radius", radius);
  require_count("level", level, 0, 10);

  // The icosahedron's vertices are the cyclic permutations of (0, +-1, +-golden ratio).
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::vector<Eigen::Vector3d> vertices{
      on_unit_sphere(-1, golden, 0),  on_unit_sphere(1, golden, 0),   on_unit_sphere(-1, -golden, 0),
      on_unit_sphere(1, -golden, 0),  on_unit_sphere(0, -1, golden),  on_unit_sphere(0, 1, golden),
      on_unit_sphere(0, -1, -golden), on_unit_sphere(0, 1, -golden),  on_unit_sphere(golden, 0, -1),
      on_unit_sphere(golden, 0, 1),   on_unit_sphere(-golden, 0, -1), on_unit_sphere(-golden, 0, 1)};
  std::vector<Triangle> faces{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (Index i = 0; i < level; ++i) refine_on_unit_sphere(vertices, faces);
  for (Eigen::Vector3d& vertex : vertices) vertex *= radius;
  return finished("icosphere", std::move(vertices), std::move(faces));
}

TriangleMesh uv_sphere(double radius, Index segments, Index bands) {
  require_length("radius", radius);
  require_count("segments", segments, 3);
  require_count("bands", bands, 2);
  std::vector<ProfilePoint> profile;
  for (Index j = 0; j <= bands; ++j) {
    const auto [cosine, sine] = cosine_sine_of_turn(j, std::int64_t{2} * bands);
    profile.push_back({radius * sine, 0.0 - radius * cosine});
  }
  return surface_of_revolution("uv_sphere", profile, segments);
}

TriangleMesh cylinder(double radius, double length, Index segments, Index bands, Index cap_rings) {
  require_length("radius", radius);
  require_length("length", length);
  require_count("segments", segments, 3);
  require_count("bands", bands, 1);
  require_count("cap_rings", cap_rings, 1);
  std::vector<ProfilePoint> profile;
  for (Index i = 0; i < cap_rings; ++i) profile.push_back({radius * (static_cast<double>(i) / cap_rings), -length / 2});
  for (Index i = 0; i < bands; ++i)
    profile.push_back({radius, -length / 2 + length * (static_cast<double>(i) / bands)});
  for (Index i = cap_rings; i >= 0; --i) profile.push_back({radius * (static_cast<double>(i) / cap_rings), length / 2});
  return surface_of_revolution("cylinder", profile, segments);
}

TriangleMesh cone(double radius, double height, Index segments, Index bands, Index cap_rings) {
  require_length("radius", radius);
  require_length("height", height);
  require_count("segments", segments, 3);
  require_count("bands", bands, 1);
  require_count("cap_rings", cap_rings, 1);
  std::vector<ProfilePoint> profile;
  for (Index i = 0; i < cap_rings; ++i) profile.push_back({radius * (static_cast<double>(i) / cap_rings), 0});
  for (Index i = 0; i <= bands; ++i) {
    profile.push_back({radius * (static_cast<double>(bands - i) / bands), height * (static_cast<double>(i) / bands)});
  }
  return surface_of_revolution("cone", profile, segments);
}

TriangleMesh tube(double inner_radius, double outer_radius, double length, Index segments, Index bands) {
  require_length("inner_radius", inner_radius);
  require_length("outer_radius", outer_radius);
  require_between("inner_radius", inner_radius, 0, outer_radius);
  require_length("length", length);
  require_count("segments", segments, 3);
  require_count("bands", bands, 1);
  // Up the outside, across the upper end and down the bore: with the body on the left.
  std::vector<ProfilePoint> profile;
  const auto height = [&](Index i) { return length * (static_cast<double>(i) / bands) - length / 2; };
  for (Index i = 0; i <= bands; ++i) profile.push_back({outer_radius, height(i)});
  for (Index i = bands; i >= 0; --i) profile.push_back({inner_radius, height(i)});
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(profile.size() * static_cast<std::size_t>(segments));
  for (const ProfilePoint& point : profile) {
    for (Index k = 0; k < segments; ++k) {
      const auto [cosine, sine] = cosine_sine_of_turn(k, segments);
      vertices.emplace_back(point.radius * cosine, point.radius * sine, point.z);
    }
  }
  return finished("tube", std::move(vertices), ring_faces(static_cast<Index>(profile.size()), segments));
}

TriangleMesh torus(double ring_radius, double tube_radius, Index segments, Index tube_segments) {
  require_length("ring_radius", ring_radius);
  require_length("tube_radius", tube_radius);
  require_between("tube_radius", tube_radius, 0, ring_radius);
  require_count("segments", segments, 3);
  require_count("tube_segments", tube_segments, 3);
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(static_cast<std::size_t>(segments) * tube_segments);
  for (Index i = 0; i < tube_segments; ++i) {
    const auto [cosine_tube, sine_tube] = cosine_sine_of_turn(i, tube_segments);
    const double distance = ring_radius + tube_radius * cosine_tube;
    for (Index k = 0; k < segments; ++k) {
      const auto [cosine, sine] = cosine_sine_of_turn(k, segments);
      vertices.emplace_back(distance * cosine, distance * sine, tube_radius * sine_tube);
    }
  }
  return finished("torus", std::move(vertices), ring_faces(tube_segments, segments));
}

}  // namespace pcm::generate
