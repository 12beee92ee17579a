// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/generator_support.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "meshes/generate/deterministic_trigonometry.h"
#include "pcm/bad_input.h"

namespace pcm::generate {

std::string shortest_decimal(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

namespace {

/// Twice the area of the face, squared; explicit sums, so that the order of operations is fixed.
double squared_double_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double ux = b.x() - a.x(), uy = b.y() - a.y(), uz = b.z() - a.z();
  const double vx = c.x() - a.x(), vy = c.y() - a.y(), vz = c.z() - a.z();
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  return nx * nx + ny * ny + nz * nz;
}

bool has_duplicates(std::vector<Eigen::Vector3d> vertices) {
  std::sort(vertices.begin(), vertices.end(), [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  });
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

/// The two triangles of the quadrilateral a b c d.
void add_quadrilateral(std::vector<Triangle>& faces, Index a, Index b, Index c, Index d) {
  faces.push_back({a, b, c});
  faces.push_back({a, c, d});
}

}  // namespace

void require_length(std::string_view parameter, double value) {
  if (value >= kMinLength && value <= kMaxLength) return;
  throw BadInput(std::string(parameter) + " is " + shortest_decimal(value) +
                 ": give a length in metres between 1e-50 and 1e50");
}

void require_between(std::string_view parameter, double value, double smallest, double largest) {
  if (value > smallest && value < largest) return;
  throw BadInput(std::string(parameter) + " is " + shortest_decimal(value) + ": give a number between " +
                 shortest_decimal(smallest) + " and " + shortest_decimal(largest) + ", both excluded");
}

void require_count(std::string_view parameter, Index value, Index smallest, Index largest) {
  if (value >= smallest && value <= largest) return;
  throw BadInput(std::string(parameter) + " is " + std::to_string(value) + ": give a count from " +
                 std::to_string(smallest) + " to " + std::to_string(largest));
}

TriangleMesh finished(std::string_view name, std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> faces) {
  const auto has_area = [&](const Triangle& face) {
    return squared_double_area(vertices[face[0]], vertices[face[1]], vertices[face[2]]) > 0;
  };
  if (has_duplicates(vertices) || !std::all_of(faces.begin(), faces.end(), has_area)) {
    throw BadInput(
        std::string(name) +
        ": the dimensions differ so much that vertices coincide in rounding; make the small ones larger, the "
        "large ones smaller or the subdivisions fewer");
  }
  return {std::move(vertices), std::move(faces), std::string(name)};
}

std::vector<Triangle> pole_to_pole_faces(Index rings, Index segments) {
  std::vector<Triangle> faces;
  faces.reserve(static_cast<std::size_t>(2) * rings * segments);
  const auto vertex = [segments](Index ring, Index k) { return 1 + ring * segments + k % segments; };
  const Index last_pole = 1 + rings * segments;
  for (Index k = 0; k < segments; ++k) faces.push_back({0, vertex(0, k + 1), vertex(0, k)});
  for (Index j = 0; j + 1 < rings; ++j) {
    for (Index k = 0; k < segments; ++k) {
      add_quadrilateral(faces, vertex(j, k), vertex(j, k + 1), vertex(j + 1, k + 1), vertex(j + 1, k));
    }
  }
  for (Index k = 0; k < segments; ++k) faces.push_back({vertex(rings - 1, k), vertex(rings - 1, k + 1), last_pole});
  return faces;
}

std::vector<Triangle> ring_faces(Index rings, Index segments) {
  std::vector<Triangle> faces;
  faces.reserve(static_cast<std::size_t>(2) * rings * segments);
  const auto vertex = [rings, segments](Index i, Index k) { return i % rings * segments + k % segments; };
  for (Index i = 0; i < rings; ++i) {
    for (Index k = 0; k < segments; ++k) {
      add_quadrilateral(faces, vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1), vertex(i + 1, k));
    }
  }
  return faces;
}

TriangleMesh surface_of_revolution(std::string_view name, const std::vector<ProfilePoint>& profile, Index segments) {
  const Index rings = static_cast<Index>(profile.size()) - 2;
  std::vector<CosineSine> directions;
  directions.reserve(segments);
  for (Index k = 0; k < segments; ++k) directions.push_back(cosine_sine_of_turn(k, segments));

  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(static_cast<std::size_t>(rings) * segments + 2);
  vertices.emplace_back(0.0, 0.0, profile.front().z);
  for (Index j = 1; j <= rings; ++j) {
    for (const auto& [cosine, sine] : directions) {
      vertices.emplace_back(profile[j].radius * cosine, profile[j].radius * sine, profile[j].z);
    }
  }
  vertices.emplace_back(0.0, 0.0, profile.back().z);
  return finished(name, std::move(vertices), pole_to_pole_faces(rings, segments));
}

}  // namespace pcm::generate
