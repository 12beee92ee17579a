// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/clipped/hiding_line.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

#include "fast/posed/posed_pair.h"
#include "fast/surface/prepared_surface.h"

namespace pcm::fast::hiding_line_test {
namespace {

using Eigen::Vector3d;

/// A master of legs 1 m in the plane z = 0, seen from above, over f 1/2 m below it. Every face has vertices of its own.
class HidingLine : public testing::Test {
 protected:
  MasterPrism prism{FaceGeometry({Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)})};
  std::array<TriangleMesh, 2> meshes;  ///< of the master, of the slave
  std::vector<ProjectedFace> faces;

  void SetUp() override {
    clear();
    add({Vector3d(-9, -9, -0.5), Vector3d(9, -9, -0.5), Vector3d(0, 9, -0.5)});
  }
  void clear() {
    meshes = {};
    faces.clear();
    add_to(meshes[0], {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)});
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
  /// On f, with what is seen to the left: below t = 1/4 from greater s to less.
  std::optional<PartOnLine> find(double from, double to, double t = 0.25) const {
    return find(PrismPoint(1 - from - t, from, t, 0.5), PrismPoint(1 - to - t, to, t, 0.5));
  }
  std::optional<PartOnLine> find(const PrismPoint& from, const PrismPoint& to) const {
    const PreparedSurface E = prepare_surface(meshes[0]), F = prepare_surface(meshes[1]);
    PosedPair posed;
    posed.place(E, F, {}, 0, false);
    return find_hiding_line({posed, Side::E, prism, faces, faces[0]}, from, to);
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
    add({Vector3d(0.125, 0.25, z), Vector3d(0.875, 0.25, z), Vector3d(0.5, 0.75, -0.25)});
    const auto found = find(0.75, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(number(*found), 1);
    EXPECT_LT(kind(*found), 3);
    SetUp();
    add({Vector3d(0.125, 0.25, z), Vector3d(0.875, 0.25, z), Vector3d(0.5, 0.75, -0.25)}, true);
    const auto of_own = find(0.75, 0);
    ASSERT_TRUE(of_own);
    EXPECT_LT(kind(*of_own), 3);
  }
}

// All of it is above f, and its depths less f's, as they are rounded, are 0 and -2^-54 m.
TEST_F(HidingLine, IsTheEdgeOfATiltedFaceThatLiesBeforeFByLessThanRoundings) {
  const std::array<Vector3d, 3> edge_first{Vector3d(0.125, 0.25, -0x1.14a2c8b30fe22p-1),
                                           Vector3d(0.875, 0.25, -0x1.704b421a3d79fp-2),
                                           Vector3d(0.5, 0.75, -0x1.999999999999ap-4)};
  for (const double lower : {0.0, 0x1p-50}) {
    SCOPED_TRACE(lower);
    clear();
    add({Vector3d(-9, -9, -0x1.102ad2d5ac3d0p-3), Vector3d(9, -9, 0x1.0cf6205b260dap+2),
         Vector3d(0, 9, -0x1.8474c9c478abbp+1)});
    std::array<Vector3d, 3> points = edge_first;
    for (std::size_t k = 0; k < 2; ++k) points[k].z() -= lower;
    points[2].z() -= lower == 0 ? 0 : 2;
    add(points);
    const auto found = find({0, 0.75, 0.25, 0x1.8f1fa4a6e3310p-2}, {0.75, 0, 0.25, 0x1.240cf9f962bdbp-1});
    EXPECT_EQ(found.has_value(), lower == 0);  // lower, and its corner with it, it lies behind f
    if (!found) continue;
    EXPECT_LT(kind(*found), 3);
    EXPECT_NEAR(found->from, 0, 1e-12);
    EXPECT_NEAR(found->to, 1 - 0.125 / 0.75, 1e-12);
  }
}

TEST_F(HidingLine, IsWhereAFacePassesThroughFOrTheMasterByOneUlp) {
  const std::array<double, 2> ends_beyond{-0.5 - 0x1p-53, 0x1p-1000};
  const std::array<int, 2> kinds{kCrossing, kAtDepth0};
  for (std::size_t k = 0; k < 2; ++k) {
    SCOPED_TRACE(k);
    SetUp();
    add({Vector3d(0.125, 0.25, ends_beyond[k]), Vector3d(0.875, 0.25, ends_beyond[k]), Vector3d(0.5, 0.75, -0.25)});
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
