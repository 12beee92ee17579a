// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/boxes.h"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "meshes/generate/deterministic_trigonometry.h"
#include "meshes/generate/generator_support.h"
#include "pcm/bad_input.h"

namespace pcm::generate {
namespace {

using LatticePoint = std::array<Index, 3>;

/// Numbers lattice points in the order of their first use, so that patches share the vertices of their seams.
class LatticeSurface {
 public:
  Index vertex(const LatticePoint& point) {
    const auto [entry, is_new] = numbers_.try_emplace(point, static_cast<Index>(points_.size()));
    if (is_new) points_.push_back(point);
    return entry->second;
  }

  void add_triangle(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
    const Index i = vertex(a), j = vertex(b), k = vertex(c);
    faces_.push_back({i, j, k});
  }

  /// Grid of `count_u` by `count_v` cells from `origin` along the lattice steps u and v; its normal is u x v.
  void add_grid(const LatticePoint& origin, const LatticePoint& u, Index count_u, const LatticePoint& v,
                Index count_v) {
    const auto at = [&](Index i, Index j) {
      return LatticePoint{origin[0] + i * u[0] + j * v[0], origin[1] + i * u[1] + j * v[1],
                          origin[2] + i * u[2] + j * v[2]};
    };
    for (Index j = 0; j < count_v; ++j) {
      for (Index i = 0; i < count_u; ++i) {
        add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }

  const std::vector<LatticePoint>& points() const { return points_; }
  std::vector<Triangle> take_faces() { return std::move(faces_); }

 private:
  std::map<LatticePoint, Index> numbers_;
  std::vector<LatticePoint> points_;
  std::vector<Triangle> faces_;
};

/// Coordinate `i` of `count` equal steps from `from` to `to`, both met exactly.
double grid_coordinate(double from, double to, Index i, Index count) {
  return i == count ? to : from + (to - from) * (static_cast<double>(i) / static_cast<double>(count));
}

void require_extents(const Eigen::Vector3d& extents) {
  require_length("extent_x", extents.x());
  require_length("extent_y", extents.y());
  require_length("extent_z", extents.z());
}

void require_corners(const Eigen::Vector3d& min_corner, const Eigen::Vector3d& max_corner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::fabs(min_corner[axis]) <= kMaxLength) || !(std::fabs(max_corner[axis]) <= kMaxLength)) {
      throw BadInput("corner coordinate " + std::string(1, "xyz"[axis]) + " is not finite or beyond 1e50 m");
    }
  }
  require_extents(max_corner - min_corner);
}

}  // namespace

TriangleMesh gridded_box(const Eigen::Vector3d& min_corner, const Eigen::Vector3d& max_corner,
                         const std::array<Index, 3>& subdivisions) {
  require_corners(min_corner, max_corner);
  const auto [nx, ny, nz] = subdivisions;
  require_count("subdivisions_x", nx, 1);
  require_count("subdivisions_y", ny, 1);
  require_count("subdivisions_z", nz, 1);

  const LatticePoint x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  LatticeSurface surface;
  surface.add_grid({0, 0, 0}, y, ny, x, nx);   // bottom, normal -z
  surface.add_grid({0, 0, nz}, x, nx, y, ny);  // top, normal +z
  surface.add_grid({0, 0, 0}, x, nx, z, nz);   // normal -y
  surface.add_grid({0, ny, 0}, z, nz, x, nx);  // normal +y
  surface.add_grid({0, 0, 0}, z, nz, y, ny);   // normal -x
  surface.add_grid({nx, 0, 0}, y, ny, z, nz);  // normal +x

  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(surface.points().size());
  for (const LatticePoint& point : surface.points()) {
    vertices.emplace_back(grid_coordinate(min_corner.x(), max_corner.x(), point[0], nx),
                          grid_coordinate(min_corner.y(), max_corner.y(), point[1], ny),
                          grid_coordinate(min_corner.z(), max_corner.z(), point[2], nz));
  }
  return finished("gridded_box", std::move(vertices), surface.take_faces());
}

TriangleMesh gridded_box(const Eigen::Vector3d& extents, const std::array<Index, 3>& subdivisions) {
  require_extents(extents);
  return gridded_box(-extents / 2, extents / 2, subdivisions);
}

TriangleMesh gridded_box(double edge_length, Index subdivisions) {
  require_length("edge_length", edge_length);
  const Eigen::Vector3d corner = Eigen::Vector3d::Constant(edge_length / 2);
  return gridded_box(-corner, corner, {subdivisions, subdivisions, subdivisions});
}

TriangleMesh box(const Eigen::Vector3d& min_corner, const Eigen::Vector3d& max_corner) {
  TriangleMesh mesh = gridded_box(min_corner, max_corner, {1, 1, 1});
  mesh.name = "box";
  return mesh;
}

TriangleMesh box(const Eigen::Vector3d& extents) {
  require_extents(extents);
  return box(-extents / 2, extents / 2);
}

TriangleMesh plate(double extent_x, double extent_y, double thickness, Index subdivisions_x, Index subdivisions_y) {
  require_length("extent_x", extent_x);
  require_length("extent_y", extent_y);
  require_length("thickness", thickness);
  TriangleMesh mesh = gridded_box({-extent_x / 2, -extent_y / 2, -thickness}, {extent_x / 2, extent_y / 2, 0},
                                  {subdivisions_x, subdivisions_y, 1});
  mesh.name = "plate";
  return mesh;
}

TriangleMesh rectangle(double extent_x, double extent_y, Index subdivisions_x, Index subdivisions_y) {
  require_length("extent_x", extent_x);
  require_length("extent_y", extent_y);
  require_count("subdivisions_x", subdivisions_x, 1);
  require_count("subdivisions_y", subdivisions_y, 1);
  LatticeSurface surface;
  surface.add_grid({0, 0, 0}, {1, 0, 0}, subdivisions_x, {0, 1, 0}, subdivisions_y);
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(surface.points().size());
  for (const LatticePoint& point : surface.points()) {
    vertices.emplace_back(grid_coordinate(-extent_x / 2, extent_x / 2, point[0], subdivisions_x),
                          grid_coordinate(-extent_y / 2, extent_y / 2, point[1], subdivisions_y), 0.0);
  }
  return finished("rectangle", std::move(vertices), surface.take_faces());
}

TriangleMesh wedge(double tilt_degrees, double height, double width, Index subdivisions) {
  require_between("tilt_degrees", tilt_degrees, 0, 90);
  require_length("height", height);
  require_length("width", width);
  require_count("subdivisions", subdivisions, 1);
  const Index n = subdivisions;

  // Lattice point (i, j, k): i steps up the face that rises towards +x, j up the one towards -x, k along y; i + j <= n.
  LatticeSurface surface;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i + j < n; ++i) {
      surface.add_triangle({i, j, 0}, {i + 1, j, 0}, {i, j + 1, 0});  // the end towards -y
      surface.add_triangle({i, j, n}, {i, j + 1, n}, {i + 1, j, n});  // the end towards +y
      if (i + j + 1 == n) continue;
      surface.add_triangle({i + 1, j, 0}, {i + 1, j + 1, 0}, {i, j + 1, 0});
      surface.add_triangle({i + 1, j, n}, {i, j + 1, n}, {i + 1, j + 1, n});
    }
  }
  surface.add_grid({0, 0, 0}, {0, 0, 1}, n, {1, 0, 0}, n);   // the face rising towards +x
  surface.add_grid({0, 0, 0}, {0, 1, 0}, n, {0, 0, 1}, n);   // the face rising towards -x, tilted by tilt_degrees
  surface.add_grid({n, 0, 0}, {0, 0, 1}, n, {-1, 1, 0}, n);  // the top

  const auto [cosine, sine] = cosine_sine_of_degrees(tilt_degrees);
  const double towards_plus_x = height * sine / cosine;
  const double towards_minus_x = height * cosine / sine;
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(surface.points().size());
  for (const auto& [i, j, k] : surface.points()) {
    vertices.emplace_back(grid_coordinate(0, towards_plus_x, i, n) - grid_coordinate(0, towards_minus_x, j, n),
                          grid_coordinate(-width / 2, width / 2, k, n), grid_coordinate(0, height, i + j, n));
  }
  return finished("wedge", std::move(vertices), surface.take_faces());
}

}  // namespace pcm::generate
