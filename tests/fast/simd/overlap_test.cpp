// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/simd/overlap_sets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "fast/base/geometry.h"
#include "fast/posed/transform.h"
#include "fast/predicates/penetration_predicates.h"
#include "fast/prism/ray.h"
#include "fast/search/candidates.h"
#include "fast/search/line_search.h"
#include "meshes/generate/parts.h"
#include "tests/fast/engine_support.h"

/// Tests of many boxes, planes or faces at once against exact decisions taken one by one: what they rule out must be
/// ruled out, what they call sure must be so.
namespace pcm::fast::overlap_test {
namespace {

using namespace generate;
using namespace test;
using FacePair = std::pair<Index, Index>;

struct Situation {
  std::string name;
  TriangleMesh E, F;
  Pose pose;
};

std::string name_of(const testing::TestParamInfo<Situation>& info) {
  return info.param.name;
}
void PrintTo(const Situation& situation, std::ostream* out) {
  *out << situation.name;
}

/// A flat needle of a box, so that planes and edges are known badly.
TriangleMesh needle() {
  return gridded_box(Eigen::Vector3d(1, 0x1p-12, 0x1p-12), {3, 1, 1});
}

std::vector<Situation> situations() {
  std::vector<Situation> list;
  const auto add = [&list](const char* name, TriangleMesh E, TriangleMesh F, const Pose& pose) {
    list.push_back({name, std::move(E), std::move(F), pose});
  };
  const TriangleMesh ball = icosphere(0.5, 2), gear = spur_gear(8, 0.1, 0.25, 2, 1), cube = gridded_box(1, 3);
  add("Balls", ball, ball, turned(0.3, {0.6, 0.3, 0.4}));
  add("GearInBall", gear, ball, turned(1.1, {0.2, 0.1, -0.1}));
  add("IdenticalGears", gear, gear, Pose{});
  add("AlignedCubes", cube, cube, shifted(0.5, 0.25, 0.75));
  add("CubesThatShareAPlane", cube, cube, shifted(1, 0.25, 0));
  add("LatticeShift", cube, gridded_box(1, 2), shifted(0x1p-40, 0.5, 0.5));
  add("NeedleInBall", needle(), ball, turned(0.7, {0.4, 0, 0.2}));
  add("BallOnNeedle", ball, needle(), turned(2.0, {0.3, 0.2, 0.1}));
  Pose far = turned(0.3, {1e6 + 0.6, -2e6, 3e5});
  far.r += far.A * Eigen::Vector3d(1e6, 0, 0);
  add("FarFromBothOrigins", translated(ball, {1e6, -2e6, 3e5}), translated(ball, {-1e6, 0, 0}), far);
  add("MuchSmallerBody", ball, scaled(ball, 0x1p-14), turned(0.4, ball.vertices[7]));
  Pose tiny_E = turned(0.4, Eigen::Vector3d::Zero());
  tiny_E.r = -tiny_E.A * ball.vertices[7];
  add("MuchLargerBody", scaled(ball, 0x1p-30), ball, tiny_E);
  add("GreatUnits", scaled(ball, 0x1p200), scaled(gear, 0x1p200),
      turned(0.9, Eigen::Vector3d(0.3, 0.2, 0.4) * 0x1p200));
  add("SmallUnits", scaled(ball, 0x1p-200), scaled(gear, 0x1p-200),
      turned(0.9, Eigen::Vector3d(0.3, 0.2, 0.4) * 0x1p-200));
  return list;
}

class WideTestsOn : public testing::TestWithParam<Situation> {
 protected:
  WideTestsOn() : E(GetParam().E), F(GetParam().F), placement(E.data(), F.data(), GetParam().pose) {
    posed[0].place_E(E.data());
    posed[1].place_F(F.data(), GetParam().pose, GetParam().E.vertices.size(), false);
  }

  const PreparedSurface& surface(std::size_t side) const { return side == 0 ? E.data() : F.data(); }
  bool edge_passes(std::size_t side, Index face, Index other_face) {
    const auto e = posed[side].face_points(face, work), f = posed[1 - side].face_points(other_face, work);
    for (std::size_t k = 0; k < 3; ++k) {
      if (passes(e[k], e[(k + 1) % 3], f)) return true;
    }
    return false;
  }
  bool passes(const RankedPoint& a, const RankedPoint& b, const std::array<RankedPoint, 3>& f) {
    if (orientation(f[0], f[1], f[2], a, work) == orientation(f[0], f[1], f[2], b, work)) return false;
    const int turn = orientation(a, b, f[0], f[1], work);
    return turn == orientation(a, b, f[1], f[2], work) && turn == orientation(a, b, f[2], f[0], work);
  }
  /// Of the edges at the corner that lies on its own side: bit 0 that from it, bit 1 that to it.
  unsigned edges_that_pass(std::size_t side, Index face, Index other_face, unsigned above) {
    const auto e = posed[side].face_points(face, work), f = posed[1 - side].face_points(other_face, work);
    const std::size_t lone = above == 1 || above == 6 ? 0 : above == 2 || above == 5 ? 1 : 2;
    return (passes(e[lone], e[(lone + 1) % 3], f) ? 1U : 0U) | (passes(e[(lone + 2) % 3], e[lone], f) ? 2U : 0U);
  }

  Surface E, F;
  Placement placement;
  std::array<PosedSurface, 2> posed;
  WorkCounters work;
};

TEST_P(WideTestsOn, CandidatesHoldEveryCrossingPairOnce) {
  NodePairs open;
  std::set<FacePair> candidates;
  int surely_passing = 0;
  const auto expect_sides = [&](std::size_t side, Index face, Index plane, unsigned above) {
    const auto x = posed[side].face_points(face, work), p = posed[1 - side].face_points(plane, work);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(orientation(p[0], p[1], p[2], x[k], work) > 0, (above >> k & 1U) != 0);
  };
  for_each_candidate(E.data(), F.data(), placement, open, work, [&](Index e, Index f, const SureSigns& sure) {
    EXPECT_TRUE(candidates.emplace(e, f).second) << e << ' ' << f;
    if (sure.of_E()) expect_sides(0, e, f, sure.above_of_E());
    if (sure.of_F()) expect_sides(1, f, e, sure.above_of_F());
    if (sure.of_passing()) {
      ++surely_passing;
      EXPECT_EQ(edges_that_pass(0, e, f, sure.above_of_E()), sure.passing() & 3U);
      EXPECT_EQ(edges_that_pass(1, f, e, sure.above_of_F()), sure.passing() >> 2);
    }
    return true;
  });
  const auto faces_E = static_cast<Index>(GetParam().E.faces.size()),
             faces_F = static_cast<Index>(GetParam().F.faces.size());
  int crossing = 0;
  for (Index e = 0; e < faces_E; ++e) {
    for (Index f = 0; f < faces_F; ++f) {
      if (!edge_passes(0, e, f) && !edge_passes(1, f, e)) continue;
      ++crossing;
      EXPECT_TRUE(candidates.count({e, f}) != 0) << e << ' ' << f;
    }
  }
  EXPECT_GT(crossing, 0);
  RecordProperty("surely_passing", surely_passing);
  EXPECT_LT(candidates.size(), static_cast<std::size_t>(faces_E) * static_cast<std::size_t>(faces_F) / 2);
}

TEST_P(WideTestsOn, LinesMeetWhatIsSureAndMissWhatIsNotPossible) {
  int surely = 0, passed = 0;
  for (std::size_t slave = 0; slave < 2; ++slave) {
    const Side side = slave == 0 ? Side::E : Side::F;
    const WideTree& tree = surface(slave).wide_tree;
    for (std::size_t m = 0; m < surface(1 - slave).mesh.faces.size(); ++m) {
      const FaceGeometry geometry(posed[1 - slave].face_Me(static_cast<Index>(m), work));
      const Ray ray(geometry, geometry.barycentre_Me());
      const PenetrationLine line(geometry.points_Me[0], geometry.points_Me[1], geometry.points_Me[2]);
      const WideRay wide(tree, placement.to_frame_of(side, ray.origin),
                         placement.direction_in_frame_of(side, ray.direction),
                         placement.position_error(side) + 8 * placement.max_coordinate * ray.direction_error);
      std::set<Index> visited;
      LineNodes open;
      const double limit = std::numeric_limits<double>::infinity();
      search_along(tree, wide, limit, fastest_wide_tests(), open, work, [&](Index f, Passage passage) {
        EXPECT_TRUE(visited.insert(f).second);
        if (passage == Passage::unknown) return;
        ++surely;
        const FacePoints points = posed[slave].face_Me(f, work);
        EXPECT_EQ(facing(line, points, work), passage == Passage::leaving ? -1 : 1);
        EXPECT_TRUE(passes_through(line, points, work));
      });
      for (std::size_t f = 0; f < surface(slave).mesh.faces.size(); ++f) {
        const FacePoints points = posed[slave].face_Me(static_cast<Index>(f), work);
        if (facing(line, points, work) == 0 || !passes_through(line, points, work)) continue;
        if (distance_sign(line, points, work) < 0) continue;
        ++passed;
        EXPECT_TRUE(visited.count(static_cast<Index>(f)) != 0) << m << ' ' << f;
      }
    }
  }
  EXPECT_GT(passed, 0);
  RecordProperty("sure", surely);
}

TEST_P(WideTestsOn, PrismsMeetEveryBoxThatDoublePrecisionFinds) {
  int met = 0;
  for (std::size_t slave = 0; slave < 2; ++slave) {
    const WideTree& tree = surface(slave).wide_tree;
    for (std::size_t m = 0; m < surface(1 - slave).mesh.faces.size(); m += 7) {
      const FaceGeometry geometry(posed[1 - slave].face_Me(static_cast<Index>(m), work));
      if (!(geometry.area > 0)) continue;
      const MasterPrism prism(geometry);
      const double box_error = 4 * placement.position_error(slave == 0 ? Side::E : Side::F);
      const TreePrism tree_prism =
          slave == 0 ? TreePrism(prism, box_error) : TreePrism(prism, box_error, placement.A, placement.r_Me);
      const double infinity = std::numeric_limits<double>::infinity();
      for (const double deepest : {infinity, 0.1 * surface(slave).max_coordinates.maxCoeff()}) {
        const WidePrism wide(tree, tree_prism, deepest);
        for (Index i = 0; i < tree.nodes(); ++i) {
          const WideNode& node = tree.node(i);
          if (!node.bottom()) continue;
          const std::uint32_t lanes = fastest_wide_tests().boxes_in_prism(node, wide);
          EXPECT_EQ(lanes, all_wide_tests()[0]->boxes_in_prism(node, wide));
          for (std::size_t lane = 0; lane < static_cast<std::size_t>(node.count); ++lane) {
            if (!tree_prism.may_meet(box_of_faces(surface(slave).mesh, &node.child[lane], 1), deepest)) continue;
            ++met;
            EXPECT_TRUE((lanes >> lane & 1U) != 0) << m << ' ' << node.child[lane];
          }
        }
      }
    }
  }
  EXPECT_GT(met, 0);
}

TEST_P(WideTestsOn, WideInstructionsGiveTheBitsOfPortableOnes) {
  const auto [portable, wide] = all_wide_tests();
  if (wide == nullptr) GTEST_SKIP() << "this processor or build has no wide instructions";
  const WideTree &tree_E = E.data().wide_tree, &tree_F = F.data().wide_tree;
  const WidePose pose(tree_E, tree_F, placement);
  const WideRay ray(tree_E, placement.r_Me, Eigen::Vector3d(0.48, -0.6, 0.64), placement.position_error_E);
  for (Index i = 0; i < tree_E.nodes(); ++i) {
    const WideNode& e = tree_E.node(i);
    Lanes entry, wide_entry;
    const std::uint32_t lanes = portable->boxes_met(e, ray, entry);
    EXPECT_EQ(lanes, wide->boxes_met(e, ray, wide_entry));
    EXPECT_EQ(entry.value, wide_entry.value);
    if (e.bottom()) {
      const FacesMet a = portable->faces_met(tree_E.group(e.group), ray),
                     b = wide->faces_met(tree_E.group(e.group), ray);
      EXPECT_EQ(a.possible, b.possible);
      EXPECT_EQ(a.leaving, b.leaving);
      EXPECT_EQ(a.entering, b.entering);
    }
    for (Index j = 0; j < tree_F.nodes(); ++j) {
      const WideNode& f = tree_F.node(j);
      EXPECT_EQ(portable->boxes(e, f, pose), wide->boxes(e, f, pose));
      EXPECT_EQ(portable->children_of_E(e, f, pose), wide->children_of_E(e, f, pose));
      EXPECT_EQ(portable->children_of_F(e, f, pose), wide->children_of_F(e, f, pose));
      if (!e.bottom() || !f.bottom()) continue;
      const FacePairs a = portable->faces(e, tree_E.group(e.group), f, tree_F.group(f.group), pose),
                      b = wide->faces(e, tree_E.group(e.group), f, tree_F.group(f.group), pose);
      EXPECT_EQ(a.possible, b.possible);
      for (LanePairs possible = a.possible; possible != 0; possible &= possible - 1) {
        const auto pair = static_cast<std::size_t>(std::countr_zero(possible));
        EXPECT_EQ(a.bits[pair], b.bits[pair]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Situations, WideTestsOn, testing::ValuesIn(situations()), name_of);

/// What WidePose, WideRay and WidePrism derive of single precision, in roundings of it: what boxes, planes and edges
/// may be off by at the worst, which bodies drawn by chance come nowhere near.
TEST_P(WideTestsOn, MarginsAreAtLeastWhatIsDerived) {
  const WideTree &tree_E = E.data().wide_tree, &tree_F = F.data().wide_tree;
  const WidePose pose(tree_E, tree_F, placement);
  const double radii = tree_E.radius() + tree_F.unit() / tree_E.unit() * tree_F.radius(), rounding = 0x1p-24 * radii;
  EXPECT_GE(pose.box_error_E, 34 * rounding);
  EXPECT_GE(pose.box_error_F, 34 * rounding);
  EXPECT_GE(pose.plane_error, 100 * rounding);
  EXPECT_GE(pose.edge_error, (16 + 8 * 3.5 / 3) * rounding);
  const double margin = 0x1p-4 * radii, most_of_it = 0.999 * margin;
  const WidePose moved(tree_E, tree_F, placement, margin * tree_E.unit());
  EXPECT_GE(moved.box_error_E - pose.box_error_E, most_of_it);
  EXPECT_GE(moved.box_error_F - pose.box_error_F, most_of_it);
  EXPECT_GE(moved.plane_error - pose.plane_error, most_of_it);
  if (std::isfinite(pose.edge_error)) {
    EXPECT_GE(moved.edge_error - pose.edge_error, 2 * most_of_it);
  }

  const Eigen::Vector3d from_tree(3, -2, 1);
  const WideRay ray(tree_E, tree_E.origin() + tree_E.unit() * from_tree, Eigen::Vector3d::UnitX(), 0);
  EXPECT_GE(ray.box_error, 24 * 0x1p-24 * (tree_E.radius() + from_tree.lpNorm<1>()));
}

TEST(WideTree, HoldsEveryFaceOnceInBoxesAroundIt) {
  for (const Index level : {0, 1, 2, 3}) {
    const TriangleMesh mesh = translated(icosphere(0.3, level), {5, -7, 11});
    const Surface surface(mesh);
    const WideTree& tree = surface.data().wide_tree;
    std::set<Index> faces;
    for (Index i = 0; i < tree.nodes(); ++i) {
      const WideNode& node = tree.node(i);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if ((node.used() >> lane & 1U) == 0 || !node.bottom()) continue;
        EXPECT_TRUE(faces.insert(node.child[lane]).second);
        for (const Index v : mesh.faces[static_cast<std::size_t>(node.child[lane])]) {
          const Eigen::Vector3d x = (mesh.vertices[static_cast<std::size_t>(v)] - tree.origin()) / tree.unit();
          for (std::size_t k = 0; k < 3; ++k) {
            const double off = std::abs(x[static_cast<Eigen::Index>(k)] - node.centre[k].value[lane]);
            EXPECT_LE(off, node.half[k].value[lane] + 0x1p-45);
            const double own_off = std::abs(x[static_cast<Eigen::Index>(k)] - node.own_centre[k]);
            EXPECT_LE(own_off, node.own_half[k] + 0x1p-45);
          }
        }
      }
    }
    EXPECT_EQ(faces.size(), mesh.faces.size());
  }
}

TEST(WideTree, FaceThatItsCoordinatesCollapseHasNoPlane) {
  // The needle's tip is a triangle too small for differences from the hull's centre.
  TriangleMesh mesh;
  mesh.vertices = {{0x1p-80, 0, 0}, {0, 0x1p-80, 0}, {0, 0, 0x1p-80}, {3, 1, 1}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Surface surface(mesh);
  const FaceGroup& group = surface.data().wide_tree.group(0);
  for (const Lanes& component : group.normal) {
    for (const float value : component.value) EXPECT_EQ(value, 0);
  }
}

}  // namespace
}  // namespace pcm::fast::overlap_test
