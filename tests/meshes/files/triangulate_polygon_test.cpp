// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/files/triangulate_polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "meshes/exact/exact_signs.h"

namespace pcm {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Triangles of a polygon in the plane z = 0.
std::vector<Triangle> triangulate(const Points& points) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Index> corners;
  for (const Eigen::Vector2d& p : points) {
    corners.push_back(static_cast<Index>(vertices.size()));
    vertices.emplace_back(p.x(), p.y(), 0);
  }
  std::vector<Triangle> faces;
  triangulate_polygon(vertices, corners, faces);
  return faces;
}

/// n - 2 triangles whose directed edges cancel in pairs but for the polygon's own: a triangulated disk.
void expect_triangulated_disk(std::size_t n, const std::vector<Triangle>& faces) {
  ASSERT_EQ(faces.size(), n - 2);
  std::map<std::pair<Index, Index>, int> uses;
  for (const Triangle& face : faces)
    for (std::size_t k = 0; k < 3; ++k) ++uses[{face[k], face[(k + 1) % 3]}];
  for (std::size_t i = 0; i < n; ++i) --uses[{static_cast<Index>(i), static_cast<Index>((i + 1) % n)}];
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    EXPECT_EQ(count, opposite == uses.end() ? 0 : opposite->second) << edge.first << ' ' << edge.second;
  }
}

/// A triangulation of a simple polygon without overlap: all triangles turn as the polygon does. (They cover it with
/// the right multiplicity because their edges cancel; none being flipped, the multiplicity is one.)
void expect_valid(const Points& points) {
  const std::vector<Triangle> faces = triangulate(points);
  expect_triangulated_disk(points.size(), faces);
  const int orientation = area_sign(points);
  ASSERT_NE(orientation, 0);
  for (const Triangle& f : faces) EXPECT_EQ(turn_sign(points[f[0]], points[f[1]], points[f[2]]), orientation);
}

/// The polygon from every first corner and in both orientations.
void expect_valid_however_listed(Points points) {
  for (int turn = 0; turn < 2; ++turn) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      expect_valid(points);
      std::rotate(points.begin(), points.begin() + 1, points.end());
    }
    std::reverse(points.begin(), points.end());
  }
}

TEST(TriangulatePolygon, ConvexPolygonIsFannedFromItsFirstCorner) {
  EXPECT_EQ(triangulate({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}}),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(triangulate({{0, 0}, {0, 2}, {2, 2}, {3, 1}, {2, 0}}),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(TriangulatePolygon, ArrowLShapeCombAndStarAreCutWithoutOverlap) {
  expect_valid_however_listed({{0, 0}, {2, 1}, {0, 2}, {1, 1}});
  expect_valid_however_listed({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  expect_valid_however_listed(
      {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  expect_valid_however_listed({{0, 3}, {-1, 1}, {-3, 0}, {-1, -1}, {0, -3}, {1, -1}, {3, 0}, {1, 1}});
}

TEST(TriangulatePolygon, SpiralIsCutWithoutOverlap) {
  Points outer;
  Points inner;
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.3 * i;
    outer.emplace_back((1 + angle) * std::cos(angle), (1 + angle) * std::sin(angle));
    inner.emplace_back((0.5 + angle) * std::cos(angle), (0.5 + angle) * std::sin(angle));
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  expect_valid(outer);
  std::rotate(outer.begin(), outer.begin() + 57, outer.end());
  expect_valid(outer);
}

TEST(TriangulatePolygon, SpiralOfThousandsOfCornersIsCutWithoutOverlap) {
  Points points;
  for (const double start : {1.0, 0.5}) {
    Points arm;
    for (int i = 0; i < 2000; ++i) {
      const double angle = 0.05 * i;
      arm.emplace_back((start + angle) * std::cos(angle), (start + angle) * std::sin(angle));
    }
    if (start < 1) std::reverse(arm.begin(), arm.end());
    points.insert(points.end(), arm.begin(), arm.end());
  }
  expect_valid(points);
}

TEST(TriangulatePolygon, CornersOnStraightLinesGiveNoZeroAreaTriangle) {
  expect_valid_however_listed({{0, 0}, {1, 0}, {2, 0}, {0, 2}});
  expect_valid_however_listed({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
  expect_valid_however_listed({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 3}});
  expect_valid_however_listed({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 2}, {2, 1}, {1, 1}, {0, 1}});
}

TEST(TriangulatePolygon, SlitToAHoleIsKept) {
  // A square with a square hole, reached by a slit walked both ways: corners 0 and 4, 5 and 9 coincide.
  const Points points{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}};
  const std::vector<Triangle> faces = triangulate(points);
  expect_triangulated_disk(points.size(), faces);
  double area = 0;
  for (const Triangle& f : faces) {
    const Eigen::Vector2d a = points[f[1]] - points[f[0]];
    const Eigen::Vector2d b = points[f[2]] - points[f[0]];
    EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0);
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  EXPECT_EQ(area, 8);
}

TEST(TriangulatePolygon, NearlyCollinearCornersAreDecidedExactly) {
  const double u = std::ldexp(1.0, -52);
  // The last corner lies one ulp inside or outside of the diagonal from (0.1, 0.1) to (0.3, 0.3).
  for (const double shift : {-2 * u, -u, u, 2 * u})
    expect_valid_however_listed({{0.1, 0.1}, {0.7, 0.2}, {0.3, 0.3}, {0.2 + shift / 4, 0.2}});
  expect_valid_however_listed({{0, 0}, {1e-300, 0}, {1e-300, 1e-300}, {1e-310, 1e-320}});
  expect_valid_however_listed({{-1e308, -1e308}, {1e308, -1e308}, {1e308, 1e308}, {0, -1e300}});
}

TEST(TriangulatePolygon, PolygonInAnyPlaneKeepsItsOrientation) {
  // An arrow in planes perpendicular to each axis and askew; the normals of its triangles agree with its own.
  const Points arrow{{0, 0}, {2, 1}, {0, 2}, {1, 1}};
  const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> frames{
      {{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}},  {{0, 1, 0}, {0, 0, 1}},
      {{0, 0, 1}, {1, 0, 0}}, {{1, 0, 2}, {0, 1, -1}}, {{3, 1, 0}, {-1, 2, 5}}};
  for (const auto& [u, v] : frames) {
    std::vector<Eigen::Vector3d> vertices;
    for (const Eigen::Vector2d& p : arrow) vertices.push_back(p.x() * u + p.y() * v);
    std::vector<Triangle> faces;
    triangulate_polygon(vertices, std::vector<Index>{0, 1, 2, 3}, faces);
    expect_triangulated_disk(4, faces);
    for (const Triangle& f : faces)
      EXPECT_GT((vertices[f[1]] - vertices[f[0]]).cross(vertices[f[2]] - vertices[f[0]]).dot(u.cross(v)), 0);
  }
}

TEST(TriangulatePolygon, PolygonsWithoutAreaOrWithCrossingsStillGiveAllTriangles) {
  for (const Points& points : std::vector<Points>{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}},
                                                  {{0, 0}, {0, 0}, {0, 0}, {0, 0}},
                                                  {{0, 0}, {1, 1}, {1, 0}, {0, 1}},
                                                  {{0, 0}, {3, 3}, {3, 0}, {0, 1}},
                                                  {{0, 1}, {0.6, -0.8}, {-1, 0.3}, {1, 0.3}, {-0.6, -0.8}},
                                                  {{0, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 1}}})
    expect_triangulated_disk(points.size(), triangulate(points));
}

TEST(TriangulatePolygon, RandomStarShapedPolygonsAreCutWithoutOverlap) {
  constexpr std::uint64_t kSeed = 31;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    // Random small integer points sorted by angle about the centre, one for each direction; collinear ones abound.
    std::map<std::pair<long, long>, Eigen::Vector2d> by_direction;
    const std::size_t count = 6 + random() % 20;
    for (std::size_t k = 0; k < count; ++k) {
      const long x = static_cast<long>(random() % 15) - 7;
      const long y = static_cast<long>(random() % 15) - 7;
      const long divisor = std::gcd(x, y);
      if (divisor != 0) by_direction[{x / divisor, y / divisor}] = {static_cast<double>(x), static_cast<double>(y)};
    }
    Points points;
    for (const auto& [direction, point] : by_direction) points.push_back(point);
    std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return std::atan2(a.y(), a.x()) < std::atan2(b.y(), b.x());
    });
    // Simple about the centre only where no gap is half a turn or more.
    bool surrounds = points.size() >= 4;
    for (std::size_t k = 0; surrounds && k < points.size(); ++k)
      surrounds = turn_sign({0, 0}, points[k], points[(k + 1) % points.size()]) > 0;
    if (!surrounds) continue;
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(random() % points.size()), points.end());
    if (random() % 2) std::reverse(points.begin(), points.end());
    expect_valid(points);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace pcm
