// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <iostream>
#include <vector>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "reference/combinatorics/combinatorics.h"
#include "reference/oracle.h"
#include "reference/proofs/identities.h"
#include "tests/reference/poses.h"
#include "tests/reference/problems.h"

namespace pcm::reference {
namespace {

Answer answer_of(const TriangleMesh& E, const TriangleMesh& F, Problem problem, const Pose& pose = {}) {
  return Oracle(E, F).answer(problem, pose);
}

void expect_identities(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose = {}) {
  for (const Problem problem : kProblems) {
    const Identities identities = prove_identities(E, F, problem, pose);
    EXPECT_TRUE(identities.applicable);
    EXPECT_TRUE(identities.vector_areas_cancel);
    EXPECT_TRUE(identities.fluxes_agree);
    EXPECT_TRUE(identities.limit_closes);
    EXPECT_EQ(identities.volume, answer_of(E, F, problem, pose).volume);
  }
}

/// Of areas at the identity, once they are changed.
template <class Change>
Identities identities_with(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Change& change) {
  const Surface E = make_surface(mesh_E), F = make_surface(mesh_F);
  const ExactPose pose(Problem::exact, E, F, {});
  InsideAreas areas = find_combinatorics(pose).inside_areas(pose);
  change(areas);
  return identities_of(areas, pose);
}

TEST(OracleAreas, IdentitiesNoticeAFaceThatIsMissingOrCountedTwice) {
  const TriangleMesh E = generate::box({0, 0, 0}, {2, 2, 2}), F = generate::box({1, 1, 1}, {3, 3, 3});
  const Identities lost = identities_with(E, F, [](InsideAreas& areas) { areas.E.pop_back(); });
  EXPECT_FALSE(lost.vector_areas_cancel || lost.fluxes_agree || lost.limit_closes);
  const Identities twice = identities_with(E, F, [](InsideAreas& areas) { areas.F[0].cells[0].winding = 2; });
  EXPECT_FALSE(twice.vector_areas_cancel || twice.fluxes_agree || twice.limit_closes);
}

TEST(OracleAreas, IdentitiesAreNoneWhereASurfaceIsOpen) {
  const TriangleMesh open = generate::rectangle(1, 1), closed = generate::box({-2, -2, -2}, {2, 2, 2});
  for (const Problem problem : kProblems) {
    EXPECT_FALSE(prove_identities(open, closed, problem, {}).applicable);
    EXPECT_FALSE(prove_identities(closed, open, problem, {}).applicable);
  }
}

TEST(OracleAreas, IdentitiesNoticeALimitOfOneSideAlone) {
  // E is moved into F, whose bottom lies in E's top: in z = 0, where no part adds to the volume.
  const TriangleMesh E = generate::box({0, 0, -2}, {2, 2, 0}), F = generate::box({0, 0, 0}, {2, 2, 2});
  for (const Side side : {Side::E, Side::F}) {
    const Identities identities = identities_with(E, F, [side](InsideAreas& areas) {
      ASSERT_FALSE(areas.overlaps.empty());
      (side == Side::E ? areas.overlaps[0].share_E : areas.overlaps[0].share_F) *= 2;
    });
    EXPECT_TRUE(identities.vector_areas_cancel);
    EXPECT_TRUE(identities.fluxes_agree);
    EXPECT_FALSE(identities.limit_closes);
  }
}

TEST(OracleAreas, BoxCornerInBox) {
  const TriangleMesh E = generate::box({0, 0, 0}, {2, 2, 2}), F = generate::box({1, 1, 1}, {3, 3, 3});
  for (const Problem problem : kProblems) {
    const Answer answer = answer_of(E, F, problem);
    EXPECT_EQ(answer.E.area, 3);
    EXPECT_EQ(answer.F.area, 3);
    EXPECT_EQ(answer.E.area_interval.open, 3);
    EXPECT_EQ(answer.E.area_interval.closed, 3);
    EXPECT_EQ(answer.E.vector_area_Me, Eigen::Vector3d(1, 1, 1));
    EXPECT_EQ(answer.F.vector_area_Me, Eigen::Vector3d(-1, -1, -1));
    EXPECT_EQ(answer.volume, 1);
  }
  expect_identities(E, F);
}

TEST(OracleAreas, StackedBoxesTouchWithAnIntervalOfAreas) {
  const TriangleMesh E = generate::box({0, 0, 0}, {2, 2, 2}), F = generate::box({0, 0, 2}, {2, 2, 4});
  for (const auto& [first, second] : {std::pair(E, F), std::pair(F, E)})
    for (const Problem problem : kProblems) {
      const Answer answer = answer_of(first, second, problem);
      for (const ActiveArea* area : {&answer.E, &answer.F}) {
        EXPECT_EQ(area->area, 0);
        EXPECT_EQ(area->area_interval.open, 0);
        EXPECT_EQ(area->area_interval.closed, 4);
        EXPECT_EQ(area->vector_area_Me, Eigen::Vector3d(0, 0, 0));
      }
      EXPECT_EQ(answer.volume, 0);
    }
  expect_identities(E, F);
}

TEST(OracleAreas, FlushFlanksCountInTheAreaOfE) {
  const TriangleMesh E = generate::box({0, 0, 0}, {2, 2, 2}), F = generate::box({0, 0, 1}, {2, 2, 3});
  for (const auto& [first, second] : {std::pair(E, F), std::pair(F, E)})
    for (const Problem problem : kProblems) {
      const Answer answer = answer_of(first, second, problem);
      EXPECT_EQ(answer.E.area, 12);
      EXPECT_EQ(answer.F.area, 4);
      EXPECT_EQ(answer.E.area_interval.open, 4);
      EXPECT_EQ(answer.E.area_interval.closed, 12);
      EXPECT_EQ(answer.F.area_interval.open, 4);
      EXPECT_EQ(answer.F.area_interval.closed, 12);
      EXPECT_EQ(answer.volume, 4);
    }
  expect_identities(E, F);
}

/// A cube of 2 m whose sides across an axis have needles in them, their height far below what enclosures at a distance
/// of some km tell.
TriangleMesh cube_with_needles_across(int axis) {
  TriangleMesh mesh = generate::box({-1, -1, -1}, {1, 1, 1});
  const std::vector<Triangle> sides = mesh.faces;
  mesh.faces.clear();
  for (const Triangle& t : sides) {
    const Eigen::Vector3d a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    if (a[axis] != b[axis] || a[axis] != c[axis]) {
      mesh.faces.push_back(t);
      continue;
    }
    const auto tip = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.5 * (a + b) + 0x1p-45 * (c - a));
    for (int k = 0; k < 3; ++k) mesh.faces.push_back({t[k], t[(k + 1) % 3], tip});
  }
  return mesh;
}

TEST(OracleAreas, NeedlesThatEnclosuresTakeForNothingCountWhicheverAxisTheyLieAcross) {
  const TriangleMesh hall = generate::box({0, 0, 0}, {8192, 8192, 8192});
  for (int axis = 0; axis < 3; ++axis) {
    Pose pose;
    pose.A = Eigen::AngleAxisd(0.7, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
    pose.r = {1234.5, 2345.25, 3456.125};
    expect_identities(hall, cube_with_needles_across(axis), pose);
    expect_identities(cube_with_needles_across(axis), hall, {pose.A.transpose(), -(pose.A.transpose() * pose.r)});
  }
}

TEST(OracleAreas, IdenticalBodiesHaveTheirOwnSurfaceAndVolume) {
  const TriangleMesh box = generate::gridded_box({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  for (const Problem problem : kProblems) {
    const Answer answer = answer_of(box, box, problem);
    EXPECT_EQ(answer.E.area, 6);
    EXPECT_EQ(answer.F.area, 0);
    EXPECT_EQ(answer.F.area_interval.closed, 6);
    EXPECT_EQ(answer.volume, 1);
  }
  expect_identities(box, box);
}

/// What the tie rule leaves inside: E is moved to +z, or +y where the faces stand upright, or +x where they are normal
/// to it.
TEST(OracleAreas, StackedBoxesPartOrPassAsTheTieRuleMovesE) {
  const TriangleMesh E = generate::box({0, 0, 0}, {2, 2, 2});
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-2.0, 2.0})
      for (const Problem problem : kProblems) {
        Pose pose;
        pose.r[axis] = side;
        const Answer answer = answer_of(E, E, problem, pose);
        const double overlap = side > 0 ? 4 : 0;  // F ahead of E: they pass; behind it: they part
        Eigen::Vector3d n_E = Eigen::Vector3d::Zero();
        n_E[axis] = side / 2;
        EXPECT_EQ(answer.E.limit_area, overlap);
        EXPECT_EQ(answer.F.limit_area, overlap);
        EXPECT_EQ(answer.E.limit_vector_area_Me, overlap * n_E);
        EXPECT_EQ(answer.F.limit_vector_area_Me, -overlap * n_E);
        EXPECT_EQ(answer.volume, 0);
      }
}

TEST(OracleAreas, FlushFlanksAreThoseOfTheBodyThatTheTieRuleMovesInward) {
  const TriangleMesh E = generate::box({0, 0, 0}, {2, 2, 2});
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (const Problem problem : kProblems) {
        Pose pose;
        pose.r[axis] = side;
        const Answer answer = answer_of(E, E, problem, pose);
        // Of four flush flanks, 2 each, E's two on the negative sides are inside F, and F's on the positive sides in E.
        Eigen::Vector3d flanks(-2, -2, -2), of_E = Eigen::Vector3d::Zero();
        flanks[axis] = 0;
        of_E[axis] = 4 * side;
        EXPECT_EQ(answer.E.limit_area, 4 + 4);
        EXPECT_EQ(answer.F.limit_area, 4 + 4);
        EXPECT_EQ(answer.E.limit_vector_area_Me, of_E + flanks);
        EXPECT_EQ(answer.F.limit_vector_area_Me, -(of_E + flanks));
      }
}

TEST(OracleAreas, IdenticalBodiesShareTheirSurfaceByTheTieRule) {
  const TriangleMesh box = generate::gridded_box({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  for (const Problem problem : kProblems) {
    const Answer answer = answer_of(box, box, problem);
    EXPECT_EQ(answer.E.limit_area, 3);
    EXPECT_EQ(answer.F.limit_area, 3);
    EXPECT_EQ(answer.E.limit_vector_area_Me, Eigen::Vector3d(-1, -1, -1));
    EXPECT_EQ(answer.F.limit_vector_area_Me, Eigen::Vector3d(1, 1, 1));
  }
}

/// The tie rule moves E to +z by much more than to +y, and there by much more than to +x. Moved so by numbers that are
/// small but not vanishing, the bodies have no coplanar faces, and their areas differ from the limit by no more than
/// the length of all edges times the move.
TEST(OracleAreas, TheTieRulesLimitIsThatOfMovesToZMoreThanYMoreThanX) {
  const Eigen::Vector3d move(0x1p-44, 0x1p-30, 0x1p-16);
  const TriangleMesh grid = generate::gridded_box(2.0, 2);
  TriangleMesh roof;  // one of its faces stands upright, one leans
  roof.vertices = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {0, 0, 1}};
  roof.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const TriangleMesh shapes[] = {grid, roof, degenerate::joined(roof, generate::box({2, -1, -1}, {3, 1, 1}))};
  std::mt19937_64 random(11);
  const auto step = [&random] { return static_cast<double>(random() % 5) / 2 - 1; };
  int told_apart = 0;
  for (int i = 0; i < 72; ++i) {
    const TriangleMesh &E = shapes[i % 3], &F = shapes[i / 3 % 3];
    Pose pose = shifted(step(), step(), step());
    if (random() % 2 == 0) pose.A << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    if (random() % 4 == 0) pose.r.setZero();
    Pose moved = pose;
    moved.r -= move;  // exact: 46 bits
    const Answer answer = answer_of(E, F, Problem::exact, pose), beside = answer_of(E, F, Problem::exact, moved);
    const double change = 100 * move.norm();  // m^2
    for (const Side side : {Side::E, Side::F}) {
      const ActiveArea &limit = side == Side::E ? answer.E : answer.F, &area = side == Side::E ? beside.E : beside.F;
      EXPECT_EQ(area.area_interval.open, area.area_interval.closed);
      EXPECT_NEAR(limit.limit_area, area.area, change);
      EXPECT_LE((limit.limit_vector_area_Me - area.vector_area_Me).norm(), change);
      told_apart += std::abs(limit.limit_area - limit.area) > 2 * change;
    }
    expect_identities(E, F, pose);
  }
  EXPECT_GE(told_apart, 24);
}

TEST(OracleAreas, GridUponShiftedGridIsExact) {
  const TriangleMesh E = generate::gridded_box({0, 0, 0}, {2, 2, 2}, {2, 2, 2});
  const TriangleMesh F = generate::gridded_box({0.5, 0.25, 0}, {2.5, 2.25, 2}, {3, 2, 4});
  const Answer answer = answer_of(E, F, Problem::exact);
  // E's parts: flank x = 2 inside F, flank y = 2, and the flush bottom and top of the common column.
  EXPECT_EQ(answer.E.area, 1.75 * 2 + 1.5 * 2 + 2 * 1.5 * 1.75);
  EXPECT_EQ(answer.F.area, 1.75 * 2 + 1.5 * 2);
  EXPECT_EQ(answer.volume, 1.5 * 1.75 * 2);
  expect_identities(E, F);
}

TEST(OracleAreas, NestedBodyHasItsWholeSurface) {
  const TriangleMesh E = generate::box({0, 0, 0}, {1, 1, 1}), F = generate::box({-1, -1, -1}, {2, 2, 2});
  const Answer answer = answer_of(E, F, Problem::exact);
  EXPECT_EQ(answer.E.area, 6);
  EXPECT_EQ(answer.F.area, 0);
  EXPECT_EQ(answer.volume, 1);
  expect_identities(E, F);
}

TEST(OracleAreas, RingPatch) {
  // A plate's hole lies over the middle of the box: the box's top inside the frame is a ring.
  const TriangleMesh frame =
      with_cavity(generate::box({-2, -2, -2}, {3, 3, 3}), generate::box({0.25, 0.25, -1}, {0.75, 0.75, 2}));
  const TriangleMesh box = generate::box({0, 0, 0}, {1, 1, 1});
  const Answer answer = answer_of(box, frame, Problem::rounded);
  EXPECT_EQ(answer.E.area, 6 - 2 * 0.25);
  EXPECT_EQ(answer.volume, 0.75);
  EXPECT_EQ(answer.polygons.size(), 2u);
  expect_identities(box, frame);
}

TEST(OracleAreas, SelfCrossingFreeRandomPosesProveTheIdentities) {
  const std::uint64_t seed = 20261121;
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const TriangleMesh shapes[] = {generate::gridded_box(1.0, 2), generate::icosphere(0.6, 1),
                                 generate::torus(0.5, 0.25, 8, 6), generate::cone(0.5, 1, 9)};
  int touching = 0;
  for (int i = 0; i < 24; ++i) {
    const TriangleMesh &E = shapes[random() % 4], &F = shapes[random() % 4];
    const Pose pose = random_pose(random, 0.7);
    expect_identities(E, F, pose);
    touching += Oracle(E, F).answer(Problem::rounded, pose).touching;
  }
  EXPECT_GE(touching, 12);
}

TEST(OracleAreas, DegenerateGridPosesProveTheIdentities) {
  // Moves by multiples of half a cell and turns by quarters: faces, edges and vertices fall upon one another.
  const TriangleMesh E = generate::gridded_box(2.0, 2), F = generate::gridded_box(2.0, 2);
  std::mt19937_64 random(7);
  for (int i = 0; i < 12; ++i) {
    Pose pose = shifted(static_cast<double>(random() % 5) / 2 - 1, static_cast<double>(random() % 5) / 2 - 1,
                        static_cast<double>(random() % 5) / 2 - 1);
    if (random() % 2 == 0) pose.A << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    expect_identities(E, F, pose);
    Eigen::Vector3d overlap;
    for (int j = 0; j < 3; ++j) overlap[j] = std::max(0.0, 2 - std::abs(pose.r[j]));
    EXPECT_EQ(answer_of(E, F, Problem::rounded, pose).volume, overlap.prod());
  }
}

TEST(OracleAreas, OpenContainerClipsTheBoxBelowItsFloor) {
  const TriangleMesh floor = generate::rectangle(10, 10);
  const TriangleMesh box = generate::box({-1, -1, -0.25}, {1, 1, 1});
  for (const Problem problem : kProblems) {
    const Answer answer = answer_of(box, floor, problem, shifted(0.125, 0.0625, 0));
    EXPECT_TRUE(answer.touching);
    EXPECT_FALSE(answer.volume.has_value());
    EXPECT_EQ(answer.E.area, 4 + 8 * 0.25);
    EXPECT_EQ(answer.F.area, 4);
  }
}

TEST(OracleAreas, BoxRestingOnOpenFloorHasAnInterval) {
  const TriangleMesh floor = generate::rectangle(10, 10);
  const TriangleMesh box = generate::box({-1, -1, 0}, {1, 1, 1});
  const Answer answer = answer_of(box, floor, Problem::exact);
  EXPECT_EQ(answer.E.area, 0);
  EXPECT_EQ(answer.E.area_interval.closed, 4);
  EXPECT_EQ(answer.F.area, 0);
  EXPECT_EQ(answer.F.area_interval.closed, 4);
}

/// The top of F is z = 1; each pose puts the open rectangle E flush on it, or turned over, in part over its edge.
TEST(OracleAreas, OpenRectangleFlushOnABoxWithACavityHasAnIntervalOfWholeFaces) {
  const TriangleMesh hollow =
      with_cavity(generate::box({-1, -1, -1}, {1, 1, 1}), generate::box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  const TriangleMesh rectangle = generate::rectangle(1, 1);
  Pose flush = shifted(0.125, 0.0625, -1), turned = shifted(0.125, 0.0625, 1), over_edge = shifted(1, 0, -1);
  turned.A = Eigen::Vector3d(1, -1, -1).asDiagonal();
  for (const Problem problem : kProblems)
    for (const Pose& pose : {flush, turned, over_edge}) {
      const Answer answer = answer_of(rectangle, hollow, problem, pose);
      const double overlap = pose.r[0] == 1 ? 0.5 : 1;
      EXPECT_EQ(answer.E.area_interval.open, 0);
      EXPECT_EQ(answer.E.area_interval.closed, overlap);
      // Two faces of F, 2 each, have a part in common with the rectangle; over the edge only one of them.
      EXPECT_EQ(answer.F.area_interval.open, 0);
      EXPECT_EQ(answer.F.area_interval.closed, pose.r[0] == 1 ? 2 : 4);
      // Moved off the common plane either way, as a tie rule might: within the intervals.
      for (const double height : {-0x1p-40, 0x1p-40}) {
        Pose moved = pose;
        moved.r[2] += height;
        const Answer beside = answer_of(rectangle, hollow, problem, moved);
        EXPECT_GE(beside.E.area, answer.E.area_interval.open);
        EXPECT_LE(beside.E.area, answer.E.area_interval.closed);
      }
    }
}

TEST(OracleAreas, BorderThatEndsInAFaceLeavesItsAreaUndefined) {
  const TriangleMesh rectangle = generate::rectangle(1, 1), box = generate::box({-4, -4, -4}, {0, 4, 4});
  for (const Problem problem : kProblems) {
    // The rectangle sticks through the box's wall x = 0: it bounds no part of that wall.
    const Answer answer = answer_of(rectangle, box, problem, shifted(0.125, 0.0625, 0.03125));
    EXPECT_TRUE(answer.touching);
    ASSERT_EQ(answer.polygons.size(), 1u);
    EXPECT_FALSE(answer.polygons[0].closed);
    EXPECT_GE(answer.undefined_areas, 1);
    EXPECT_EQ(answer.F.area, 0);
    EXPECT_EQ(answer.E.area, 0.625);
    EXPECT_FALSE(answer.volume.has_value());
    // It also crosses the wall's diagonal, whose ends label all other faces, each its own way.
    EXPECT_TRUE(answer.ambiguous);
  }
}

}  // namespace
}  // namespace pcm::reference
