// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/degenerate/hard_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/generator_support.h"
#include "meshes/generate/round.h"

namespace pcm::degenerate {
namespace {

/// A nearly regular octagon of half-width 4, counterclockwise.
constexpr std::array<std::array<double, 2>, 8> kOctagon = {
    {{4, 0}, {3, 3}, {0, 4}, {-3, 3}, {-4, 0}, {-3, -3}, {0, -4}, {3, -3}}};

}  // namespace

TriangleMesh fan_tipped_spike(double tip) {
  TriangleMesh mesh;
  mesh.name = "fan-tipped spike";
  mesh.vertices.emplace_back(0, 0, -1 - tip);
  for (const auto& [x, y] : kOctagon) mesh.vertices.emplace_back(x / 4 * tip, y / 4 * tip, -1);
  for (const auto& [x, y] : kOctagon) mesh.vertices.emplace_back(x / 16, y / 16, 0);
  mesh.vertices.emplace_back(0, 0, 0);
  mesh.faces = generate::pole_to_pole_faces(2, static_cast<Index>(kOctagon.size()));
  return mesh;
}

TriangleMesh needle(double half_width) {
  const double w = half_width;
  TriangleMesh mesh;
  mesh.name = "needle";
  mesh.vertices = {{0, 0, -0.5}, {w, 0, 0}, {0, w, 0}, {-w, 0, 0}, {0, -w, 0}, {0, 0, 0.5}};
  mesh.faces = generate::pole_to_pole_faces(1, 4);
  return mesh;
}

TriangleMesh open_box(const Eigen::Vector3d& extents) {
  TriangleMesh mesh = generate::box(extents);
  const double top = extents.z() / 2;
  std::erase_if(mesh.faces, [&](const Triangle& face) {
    return std::all_of(face.begin(), face.end(), [&](Index v) { return mesh.vertices[v].z() == top; });
  });
  mesh.name = "open box";
  return mesh;
}

TriangleMesh folded_sheet(Index folds, double pitch, double height) {
  TriangleMesh mesh;
  mesh.name = "folded sheet";
  for (Index i = 0; i <= folds; ++i) {
    const double x = pitch * (i - 0.5 * folds), z = (i % 2 == 0 ? -0.5 : 0.5) * height;
    mesh.vertices.emplace_back(x, -0.5, z);
    mesh.vertices.emplace_back(x, 0.5, z);
  }
  for (Index i = 0; i < folds; ++i) {
    const Index a = 2 * i;
    mesh.faces.push_back({a, a + 2, a + 3});
    mesh.faces.push_back({a, a + 3, a + 1});
  }
  return mesh;
}

TriangleMesh without_face(TriangleMesh mesh, Index face) {
  mesh.faces.erase(mesh.faces.begin() + face);
  mesh.name += " without face " + std::to_string(face + 1);
  return mesh;
}

TriangleMesh hollow_cube(double cavity) {
  TriangleMesh mesh = joined(generate::box({1, 1, 1}), inverted(generate::box({cavity, cavity, cavity})));
  mesh.name = "hollow cube";
  return mesh;
}

TriangleMesh prism_over(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& centre, double height) {
  const auto n = static_cast<Index>(polygon.size());
  TriangleMesh mesh;
  mesh.name = "prism";
  for (const double z : {-height / 2, height / 2}) {
    for (const Eigen::Vector2d& p : polygon) mesh.vertices.emplace_back(p.x(), p.y(), z);
    mesh.vertices.emplace_back(centre.x(), centre.y(), z);
  }
  const Index top = n + 1;
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    mesh.faces.push_back({n, next, i});
    mesh.faces.push_back({top + n, top + i, top + next});
    mesh.faces.push_back({i, next, top + next});
    mesh.faces.push_back({i, top + next, top + i});
  }
  return mesh;
}

TriangleMesh pentagram() {
  TriangleMesh mesh = prism_over({{0.5, 0}, {-0.375, 0.25}, {0.125, -0.5}, {0.125, 0.5}, {-0.375, -0.25}}, {0, 0}, 0.5);
  mesh.name = "pentagram";
  return mesh;
}

TriangleMesh figure_of_eight() {
  TriangleMesh mesh = prism_over({{1, -1}, {1, 1}, {-0.25, -0.25}, {-0.25, 0.25}}, {0.25, 0}, 0.5);
  mesh.name = "figure of eight";
  return mesh;
}

TriangleMesh shrinking_cubes(Index count, int halvings) {
  TriangleMesh mesh;
  double low = 0;
  for (Index k = 0; k < count; ++k) {
    const double edge = std::ldexp(1, -halvings * k);
    if (k > 0) low += edge;
    mesh = joined(std::move(mesh), generate::box({low, 0, 0}, {low + edge, edge, edge}));
    low += edge;
  }
  mesh.name = "shrinking cubes";
  return mesh;
}

TriangleMesh plate_stack(Index count, double thickness, double gap) {
  constexpr std::array<std::array<double, 2>, 3> kTriangle = {{{-1, -0.75}, {1, -0.75}, {0, 1}}};
  TriangleMesh mesh;
  for (Index k = 0; k < count; ++k) {
    const bool upright = k % 2 == 0;
    const double middle = (k - 0.5 * (count - 1)) * (thickness + gap);
    TriangleMesh plate;
    for (const bool upper : {false, true}) {
      const double size = upper == upright ? 0.75 : 1, z = middle + (upper ? 0.5 : -0.5) * thickness;
      for (const auto& [x, y] : kTriangle) plate.vertices.emplace_back(size * x, size * y, z);
    }
    plate.faces = {{0, 2, 1}, {3, 4, 5}};
    for (Index i = 0; i < 3; ++i) {
      const Index next = (i + 1) % 3;
      plate.faces.push_back({i, next, 3 + next});
      plate.faces.push_back({i, 3 + next, 3 + i});
    }
    mesh = joined(std::move(mesh), plate);
  }
  mesh.name = "plate stack";
  return mesh;
}

TriangleMesh block_with_touching_keel(double rise) {
  TriangleMesh upper;
  upper.vertices = {{-0.5, 0, 0},     {0.5, 0, 0},       {-0.5, -0.5, rise}, {0.5, -0.5, rise},
                    {0.5, 0.5, rise}, {-0.5, 0.5, rise}, {0, 0, 1}};
  upper.faces = {{0, 1, 3}, {0, 3, 2}, {1, 0, 5}, {1, 5, 4}};
  constexpr std::array<Index, 6> kRim = {2, 3, 1, 4, 5, 0};
  for (std::size_t i = 0; i < kRim.size(); ++i) upper.faces.push_back({kRim[i], kRim[(i + 1) % kRim.size()], 6});
  TriangleMesh mesh = joined(generate::box({-2, -2, -1}, {2, 2, 0}), upper);
  mesh.name = "block with touching keel";
  return mesh;
}

TriangleMesh torus_chain(Index links, double ring_radius, double tube_radius, Index segments, Index tube_segments) {
  // Neighbours pass each other at 3/8 of the ring's radius from the centre of its hole.
  const double step = 1.375 * ring_radius;
  TriangleMesh chain;
  for (Index k = 0; k < links; ++k) {
    TriangleMesh link = generate::torus(ring_radius, tube_radius, segments, tube_segments);
    for (Eigen::Vector3d& x : link.vertices) {
      if (k % 2 == 1) x = {x.x(), -x.z(), x.y()};
      x.x() += step * k;
    }
    chain = joined(std::move(chain), link);
  }
  chain.name = "torus chain";
  return chain;
}

}  // namespace pcm::degenerate
