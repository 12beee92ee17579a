// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/clipped/visible_parts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace pcm::fast::visible_parts_test {
namespace {

using Eigen::Vector3d;
using FacePoints = std::array<Vector3d, 3>;

constexpr double u = 0x1p-53;

/// A projected face together with its vertices in the order it has them.
struct Placed {
  ProjectedFace projected;
  FacePoints points_Me;
  const MasterPrism& prism;

  Placed(const MasterPrism& of_prism, Index face, const std::array<Index, 3>& vertices, const FacePoints& points)
      : prism(of_prism) {
    WorkCounters work;
    const std::array<PrismPoint, 3> corners{prism.see(points[0], work), prism.see(points[1], work),
                                            prism.see(points[2], work)};
    EXPECT_TRUE(project_face(vertices, corners, projected));
    projected.face = face;
    projected.of_master = false;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (projected.vertices[k] == vertices[i]) points_Me[k] = points[i];
      }
    }
  }
  PlacedFace face() const { return {projected, points_Me, prism, 1}; }
};

/// Area in (s, t) of what g leaves of f.
double area_left(const Placed& f, const Placed& g) {
  std::vector<ConvexPolygon> parts{f.projected.seen}, remaining;
  ClippingError clipping_error;
  WorkCounters work;
  subtract_hidden(f.face(), g.face(), parts, remaining, clipping_error, work);
  double area = 0;
  for (const ConvexPolygon& part : parts) area += 0.5 * twice_area(part);
  return area;
}

/// Twice the area of (0, a, b) in the plane.
double cross(const Vector3d& a, const Vector3d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// In the plane of z = 0, lengths in units of 2^-26.
Vector3d on_grid(const Vector3d& x) {
  return x.array().round();
}

// The master is a small triangle, the face before the slave's a long one that ends in two corners beside it and passes
// through the plane of the master along a line parallel to the master's longest side: so it hides what lies between its
// two long sides up to that line. Its far corner is `far` times as far away as the master is wide: places there are off
// by some 16 u of that.
TEST(SubtractHidden, LongFaceWithDepth0AlongALineThroughTheMasterHidesUpToThatLine) {
  const double unit = 0x1p-26;
  const Vector3d p1(61, 7, 0), p2(-11, 53, 0);
  const double doubled_area = cross(p1, p2);
  const MasterPrism prism(FaceGeometry({Vector3d(0, 0, 0), unit * p1, unit * p2}));
  const Placed f(prism, 0, {0, 1, 2},
                 {unit * Vector3d(-99, -99, -999), unit * Vector3d(0, 999, -999), unit * Vector3d(999, -99, -999)});
  for (const double far : {0x1p8, 0x1p14, 0x1p19}) {
    const std::array<Vector3d, 3> corners{on_grid(-far * p1 + 0.875 * far * p2), on_grid(1.25 * p1 - 0.75 * p2),
                                          on_grid(1.0625 * p1 + 0.015625 * p2)};
    const double level = 0.25;  // the depth is 0 where s + t = 1 - level
    std::array<double, 3> s, t;
    FacePoints points;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d& x = corners[k];
      s[k] = cross(x, p2) / doubled_area;
      t[k] = cross(p1, x) / doubled_area;
      points[k] = unit * Vector3d(x.x(), x.y(), -(cross(p2 - p1, x - p1) - level * doubled_area) / 64);
    }
    const double lower = (t[0] - t[1]) / (s[0] - s[1]), upper = (t[0] - t[2]) / (s[0] - s[2]);
    // What is hidden is the triangle s + t <= 1 - level but for one below the lower side at p0 and one beyond the
    // upper.
    const double most = 1 - level;
    const double t_lower = t[1] - lower * s[1], s_lower = -t_lower / lower;
    const double t_upper = t[2] - upper * s[2], s_upper = (most - t_upper) / (1 + upper);
    const double beyond = t_upper < most ? 0.5 * (most - t_upper) * s_upper : 0;
    const double hidden = 0.5 * most * most - 0.5 * s_lower * t_lower - beyond;
    for (std::size_t k = 0; k < 3; ++k) {
      const Placed g(prism, 1, {3, 4, 5}, {points[k], points[(k + 1) % 3], points[(k + 2) % 3]});
      EXPECT_NEAR(area_left(f, g), 0.5 - hidden, 32 * u * far) << far << " " << k;
    }
  }
}

// g hides all but a strip along one side of the master. Both are small, and so are roundings, however large the bodies.
TEST(SubtractHidden, NarrowStripOfASmallFaceIsSeenThoughTheBodiesAreLarge) {
  const double h = 0x1p-20;
  const MasterPrism prism(FaceGeometry({Vector3d(0, 0, 0), Vector3d(h, 0, 0), Vector3d(0, h, 0)}));
  const Placed f(prism, 0, {0, 1, 2},
                 {Vector3d(-h, -h, -2 * h), Vector3d(-h, 4 * h, -2 * h), Vector3d(4 * h, -h, -2 * h)});
  for (const double width : {0x1p-20, 0x1p-28, 0x1p-36}) {
    const Placed g(prism, 1, {3, 4, 5},
                   {Vector3d(width * h, -h, -h), Vector3d(width * h, 4 * h, -h), Vector3d(8 * h, -h, -h)});
    EXPECT_NEAR(area_left(f, g), width - 0.5 * width * width, 32 * u) << width;
  }
}

// Two corners of g lie 3 d above and d below f, the third one in it: the planes meet at three quarters of the side
// between them, whatever d is, though heights over f, d times its area, underflow.
TEST(SubtractHidden, FacesThatCrossByDenormalsHideEachOtherUpToTheLineOfTheirPlanes) {
  for (const double c : {1.0, 0x1p-8, 0x1p-100}) {
    const MasterPrism prism(FaceGeometry({c * Vector3d(-8, -8, 1), c * Vector3d(16, -8, 1), c * Vector3d(-8, 16, 1)}));
    const Placed f(prism, 0, {0, 1, 2}, {c * Vector3d(0, -1, 0), c * Vector3d(1, 0, -1), c * Vector3d(0, 1, 0)});
    const double whole = 0.5 * twice_area(f.projected.seen);
    for (const double d : {c * 0x1p-60, c * 0x1p-500, 0x1p-1040, std::numeric_limits<double>::denorm_min()}) {
      const Placed g(prism, 1, {3, 4, 5}, {Vector3d(0, -c, 3 * d), c * Vector3d(1, 0, -1), Vector3d(0, c, -d)});
      EXPECT_NEAR(area_left(f, g) / whole, 0.25, 1e-14) << c << " " << d;
      EXPECT_NEAR(area_left(g, f) / whole, 0.75, 1e-14) << c << " " << d;
    }
  }
}

/// Whether two faces overlap by the rule of find_overlaps, corner by corner.
bool overlap(const ProjectedFace& f, const ProjectedFace& g) {
  const auto apart = [](const ProjectedFace& a, const ProjectedFace& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      int beyond = 0;
      for (const PrismPoint& x : b.corners) beyond += cross_st(a.corners[k], a.corners[(k + 1) % 3], x) <= 0;
      if (beyond == 3) return true;
    }
    return false;
  };
  return f.low_s < g.high_s && g.low_s < f.high_s && f.low_t < g.high_t && g.low_t < f.high_t && !apart(f, g) &&
         !apart(g, f);
}

TEST(FindOverlaps, FindsWhatASearchOfAllPairsFindsInOrder) {
  std::mt19937_64 random(29);
  SCOPED_TRACE("seed 29");
  const auto coordinate = [&] { return static_cast<double>(random() % 17) / 8 - 0.5; };  // many are equal
  const MasterPrism prism(FaceGeometry({Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}));
  std::vector<FaceExtent> by_low_s;
  std::vector<Overlap> found;
  std::size_t overlaps = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<ProjectedFace> faces;
    for (int i = 0; i < 12; ++i) {
      std::array<PrismPoint, 3> corners;
      WorkCounters work;
      for (PrismPoint& corner : corners) corner = prism.see({coordinate(), coordinate(), -1}, work);
      ProjectedFace face;
      if (!project_face({0, 1, 2}, corners, face)) continue;
      face.carries = random() % 2 == 0;
      faces.push_back(face);
    }
    std::vector<Overlap> expected;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (std::size_t j = 0; j < faces.size(); ++j) {
        if (i != j && faces[i].carries && overlap(faces[i], faces[j])) expected.emplace_back(i, j);
      }
    }
    find_overlaps(faces, by_low_s, found);
    ASSERT_EQ(found, expected) << trial;
    overlaps += found.size();
  }
  EXPECT_GT(overlaps, 1000U);
}

}  // namespace
}  // namespace pcm::fast::visible_parts_test
