// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/clipped/hiding_line.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "fast/posed/posed_pair.h"
#include "fast/surface/prepare_surface.h"
#include "tests/fast/exact_draw.h"

namespace pcm::fast::hiding_line_test {
namespace {

using Eigen::Vector3d;

/// A master of legs 1 m in the plane z = 0, seen from above, over f 1/2 m below it. Every face has vertices of its own.
class HidingLine : public testing::Test {
 protected:
  const std::array<Vector3d, 3> master{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)};
  MasterPrism prism{FaceGeometry(master)};
  std::array<TriangleMesh, 2> meshes;  ///< of the master, of the slave
  std::vector<ProjectedFace> faces;

  void SetUp() override {
    clear();
    add({Vector3d(-9, -9, -0.5), Vector3d(9, -9, -0.5), Vector3d(0, 9, -0.5)});
  }
  void clear() {
    meshes = {};
    faces.clear();
    add_to(meshes[0], master);
  }

  static Triangle add_to(TriangleMesh& mesh, const std::array<Vector3d, 3>& points) {
    const auto first = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
    mesh.faces.push_back({first, first + 1, first + 2});
    return mesh.faces.back();
  }
  void add(const std::array<Vector3d, 3>& points, bool of_master = false) {
    WorkCounters work;
    ProjectedFace face;
    ASSERT_TRUE(project_face(add_to(meshes[of_master ? 0 : 1], points),
                             {prism.see(points[0], work), prism.see(points[1], work), prism.see(points[2], work)},
                             face));
    face.number = static_cast<std::int32_t>(faces.size());
    face.face = face.number;
    face.of_master = of_master;
    faces.push_back(face);
  }
  /// From an edge at this height that lies on the way.
  void add_rising_from(double z, bool of_master = false) {
    add({Vector3d(0.125, 0.25, z), Vector3d(0.875, 0.25, z), Vector3d(0.5, 0.75, -0.25)}, of_master);
  }
  /// On f, with what is seen to the left: below t = 1/4 from greater s to less.
  std::optional<PartOnLine> find(double from, double to, double t = 0.25) const {
    return find(PrismPoint(1 - from - t, from, t, 0.5), PrismPoint(1 - to - t, to, t, 0.5));
  }
  std::optional<PartOnLine> find(const PrismPoint& from, const PrismPoint& to) const {
    const PreparedSurface E = prepare_surface(meshes[0]), F = prepare_surface(meshes[1]);
    PosedPair posed;
    posed.place(E, F, {}, 0, false);
    SeenBeyond beyond;
    return find_hiding_line({posed, Side::E, 0, prism, faces, {}, faces[0]}, from, to, beyond);
  }
  static int kind(const PartOnLine& part) { return (part.line - 1) % kLinesOfAFace; }
  static int number(const PartOnLine& part) { return (part.line - 1) / kLinesOfAFace; }
};

TEST_F(HidingLine, IsTheEdgeOfAFaceBeforeFAsFarAsThatReaches) {
  add({Vector3d(0.25, 0.25, -0.25), Vector3d(0.5, 0.25, -0.25), Vector3d(0.5, 0.5, -0.25)});
  const auto found = find(0.75, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(number(*found), 1);
  EXPECT_LT(kind(*found), 3);
  EXPECT_NEAR(found->from, 1.0 / 3, 1e-15);
  EXPECT_NEAR(found->to, 2.0 / 3, 1e-15);
}

TEST_F(HidingLine, IsNoneOfFacesOnTheOtherSideNorBeyondFNorAboveTheMaster) {
  add({Vector3d(0.25, 0.25, -0.25), Vector3d(0.5, 0.125, -0.25), Vector3d(0.5, 0.25, -0.25)});
  add({Vector3d(0.25, 0.25, -0.75), Vector3d(0.5, 0.25, -0.75), Vector3d(0.5, 0.5, -0.75)});
  EXPECT_FALSE(find(0.75, 0));
  EXPECT_FALSE(find(0.75, 0, 0.2500000001));
}

TEST_F(HidingLine, IsWhereAFacePassesThroughF) {
  // Of the master's own, 1/2 deep at y = 1/4 and less deep beyond; its sides count as far as they may be off.
  add({Vector3d(0.125, 0, -0.75), Vector3d(0.875, 0, -0.75), Vector3d(0.5, 0.5, -0.25)}, true);
  const auto found = find(0.75, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(number(*found), 1);
  EXPECT_EQ(kind(*found), kCrossing);
  EXPECT_NEAR(found->from, (0.75 - 0.6875) / 0.75, 1e-12);
  EXPECT_NEAR(found->to, (0.75 - 0.3125) / 0.75, 1e-12);
  EXPECT_FALSE(find(0, 0.75));  // what is seen on the other side is deeper than that
}

TEST_F(HidingLine, IsWhereAFacePassesThroughTheMaster) {
  add({Vector3d(0.125, 0, 0.25), Vector3d(0.875, 0, 0.25), Vector3d(0.5, 0.5, -0.25)});
  const auto found = find(0.75, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(kind(*found), kAtDepth0);
}

// Its plane meets f, or the master, where the edge is, but for what can't be told from roundings by places.
TEST_F(HidingLine, IsTheEdgeOfAFaceThatAllButReachesFOrTheMaster) {
  const std::array<double, 2> ends_before{-0.5 + 0x1p-50, -0x1p-50};
  for (const double z : ends_before) {
    SCOPED_TRACE(z);
    SetUp();
    add_rising_from(z);
    const auto found = find(0.75, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(number(*found), 1);
    EXPECT_LT(kind(*found), 3);
    SetUp();
    add_rising_from(z, true);
    const auto of_own = find(0.75, 0);
    ASSERT_TRUE(of_own);
    EXPECT_LT(kind(*of_own), 3);
  }
}

// The depths of a tilted face's edge, less f's, are a few roundings, before f or behind it, whatever they are found to
// be: all of the face lies on the edge's side.
TEST_F(HidingLine, IsTheEdgeOfAFaceOffATiltedFByUlpsWhereItLiesBeforeItExactly) {
  test::ExactDraw draw;
  int before = 0, behind = 0;
  for (int i = 0; i < 6000; ++i) {
    SCOPED_TRACE(i);
    const double at_0 = draw.between(-0.75, -0.5), per_x = draw.between(-0.25, 0.25), per_y = draw.between(-0.25, 0.25);
    const auto z = [&](double x, double y) { return at_0 + x * per_x + y * per_y; };
    const auto ulps = [&draw] { return std::floor(draw.between(-2, 3)); };
    const auto on_f = [&](double x, double y, double off) { return Vector3d(x, y, z(x, y) + off); };
    const std::array<Vector3d, 3> f{on_f(-9, -9, 0), on_f(9, -9, 0), on_f(0, 9, 0)};
    const double rise = draw.between(-1, 1) < 0 ? 0.1 : -0.1;
    const std::array<Vector3d, 3> h{on_f(0.125, 0.25, ulps() * 0x1p-53), on_f(0.875, 0.25, ulps() * 0x1p-53),
                                    on_f(0.5, 0.75, rise)};
    WorkCounters work;
    const double first = SurePlane(f).height(h[0], work) * rise, second = SurePlane(f).height(h[1], work) * rise;
    if (first < 0 || second < 0 || (first == 0 && second == 0))
      continue;  // it passes through f, or its edge lies in it
    clear();
    add(f);
    add(h);
    const auto found = find({0, 0.75, 0.25, -z(0.75, 0.25)}, {0.75, 0, 0.25, -z(0, 0.25)});
    if (rise < 0) {
      ++behind;
      EXPECT_FALSE(found);
      continue;
    }
    ++before;
    ASSERT_TRUE(found);
    EXPECT_LT(kind(*found), 3);
    EXPECT_NEAR(found->from, 0, 1e-12);
    EXPECT_NEAR(found->to, 1 - 0.125 / 0.75, 1e-12);
  }
  EXPECT_GT(before, 500);
  EXPECT_GT(behind, 500);
}

TEST_F(HidingLine, IsWhereAFacePassesThroughFOrTheMasterByOneUlp) {
  const std::array<double, 2> ends_beyond{-0.5 - 0x1p-53, 0x1p-1000};
  const std::array<int, 2> kinds{kCrossing, kAtDepth0};
  for (std::size_t k = 0; k < 2; ++k) {
    SCOPED_TRACE(k);
    SetUp();
    add_rising_from(ends_beyond[k]);
    const auto found = find(0.75, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(kind(*found), kinds[k]);
  }
}

TEST_F(HidingLine, IsTheEdgeOfFItself) {
  clear();
  add({Vector3d(-9, -9, -0.5), Vector3d(9, 0.25, -0.5), Vector3d(-9, 0.25, -0.5)});
  const auto found = find(0.75, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(number(*found), 0);
  EXPECT_NEAR(found->from, 0, 1e-15);
  EXPECT_NEAR(found->to, 1, 1e-15);
}

TEST_F(HidingLine, IsNoneOfAFaceInThePlaneOfF) {
  add({Vector3d(0.125, 0.25, -0.5), Vector3d(0.875, 0.25, -0.5 - 0x1p-53), Vector3d(0.5, 0.75, -0.5 + 0x1p-53)});
  const auto found = find(0.75, 0);
  EXPECT_TRUE(!found || kind(*found) < 3);
}

TEST_F(HidingLine, IsNoneOfAFaceSeenEdgewise) {
  // Also where no more than a corner lies over the master.
  add({Vector3d(0.5, 0.25, -0.25), Vector3d(2.5, -1.75 + 0x1p-51, 0.25), Vector3d(4.5, -3.75, -7)});
  add({Vector3d(0.125, 0.25, 0.25), Vector3d(0.5, 0.25 + 0x1p-52, -0.25), Vector3d(0.875, 0.25, 0.25)});
  EXPECT_FALSE(find(0.75, 0));
}

}  // namespace
}  // namespace pcm::fast::hiding_line_test
