// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/fast/engine_support.h"

namespace pcm::fast {
namespace {

using namespace test;
using Eigen::Vector3d;
using generate::box;

const TriangleMesh kCube = box(Vector3d(0, 0, 0), Vector3d(2, 2, 2));

/// What must hold of every answer, whatever the pose.
void expect_sound(const Contact& contact) {
  EXPECT_TRUE(contact.force_Me.allFinite() && contact.torque_Me.allFinite());
  EXPECT_TRUE(std::isfinite(contact.E.area) && std::isfinite(contact.F.area) && std::isfinite(contact.volume));
  EXPECT_EQ(contact.touching, contact.work.crossing_pairs > 0);
  Index count = 0;
  for (const Polygon& polygon : contact.polygons) {
    EXPECT_EQ(polygon.first, count);
    EXPECT_GE(polygon.count, polygon.closed ? 3 : 2);
    count += polygon.count;
    for (Index i = polygon.first; i < count; ++i) {
      const Crossing& crossing = contact.crossings[static_cast<std::size_t>(i)];
      EXPECT_TRUE(crossing.position_Me.allFinite());
      EXPECT_LT(crossing.edge[0], crossing.edge[1]);
    }
  }
  EXPECT_EQ(static_cast<std::size_t>(count), contact.crossings.size());
  for (const ActiveArea* area : {&contact.E, &contact.F}) {
    EXPECT_TRUE(std::is_sorted(area->intersected.begin(), area->intersected.end()));
    EXPECT_TRUE(std::is_sorted(area->inner.begin(), area->inner.end()));
  }
}

TEST(Engine, SeparatedBoxesDoNotTouch) {
  const Contact contact = answer(kCube, kCube, shifted(0, 0, 2.5));
  EXPECT_FALSE(contact.touching);
  EXPECT_FALSE(contact.nested);
  EXPECT_EQ(contact.volume, 0);
  EXPECT_TRUE(contact.force_Me.isZero(0));
}

TEST(Engine, BoxCornerInBoxHasVolumeAndAreasOfTheOverlap) {
  const Contact contact = answer(kCube, kCube, shifted(1.5, 1.25, 1));
  expect_sound(contact);
  ASSERT_EQ(contact.polygons.size(), 1u);
  EXPECT_TRUE(contact.polygons[0].closed);
  EXPECT_EQ(contact.patches, 1);
  EXPECT_NEAR(contact.volume, 0.5 * 0.75 * 1, 1e-15);
  const double area = 0.5 * 0.75 + 0.75 * 1 + 1 * 0.5;
  EXPECT_NEAR(contact.E.area, area, 1e-15);
  EXPECT_NEAR(contact.F.area, area, 1e-15);
  EXPECT_LT((contact.E.vector_area_Me + contact.F.vector_area_Me).norm(), 1e-15);
  EXPECT_LT((contact.E.vector_area_Me - Vector3d(0.75, 0.5, 0.375)).norm(), 1e-15);
}

TEST(Engine, TurnedBoxesHaveTheSameVolumeFromBothSides) {
  const Pose pose = turned(0.7, {1.2, 0.6, 0.9});
  Pose inverse;
  inverse.A = pose.A.transpose();
  inverse.r = -pose.A.transpose() * pose.r;
  const Contact direct = answer(kCube, kCube, pose);
  const Contact exchanged = answer(kCube, kCube, inverse);
  expect_sound(direct);
  EXPECT_GT(direct.volume, 0.1);
  EXPECT_NEAR(direct.volume, exchanged.volume, 1e-14);
  EXPECT_NEAR(direct.E.area, exchanged.F.area, 1e-14);
  EXPECT_LT((direct.E.vector_area_Me + direct.F.vector_area_Me).norm(), 1e-14);
}

TEST(Engine, StackedBoxesTouchOrNotButNeverPush) {
  const TriangleMesh upper = box(Vector3d(0, 0, 2), Vector3d(2, 2, 4));
  const Contact below = answer(kCube, upper);
  const Contact above = answer(upper, kCube);
  for (const Contact& contact : {below, above}) {
    expect_sound(contact);
    EXPECT_NEAR(contact.volume, 0, 1e-15);
    EXPECT_TRUE(contact.force_Me.isZero(0));
  }
  // One body order sees the bodies overlap by the tie rule, the other sees them apart.
  EXPECT_NE(below.touching, above.touching);
}

TEST(Engine, FlushFlanksGiveTheSameForceInBothBodyOrders) {
  const TriangleMesh upper = box(Vector3d(0, 0, 1), Vector3d(2, 2, 3));
  const Contact contact = answer(kCube, upper);
  expect_sound(contact);
  EXPECT_EQ(contact.force_Me, Vector3d(0, 0, -4));
  const Contact exchanged = answer(upper, kCube);
  expect_sound(exchanged);
  EXPECT_EQ(exchanged.force_Me, Vector3d(0, 0, 4));
  EXPECT_NEAR(contact.volume, 4, 1e-14);
  EXPECT_NEAR(exchanged.volume, 4, 1e-14);
  const Contact by_F = answer(kCube, upper, {}, stiffness(1), Mode::F);
  EXPECT_EQ(by_F.force_Me, Vector3d(0, 0, -4));
}

TEST(Engine, BoxOnPlateIsPushedByStiffnessAreaAndPenetration) {
  // The box's bottom lies wholly under the plate's top: 0.05 deep, side walls contribute nothing.
  const TriangleMesh plate = generate::plate(4, 4, 1);
  const TriangleMesh small = box(Vector3d(0.5, 0.5, 0.5));
  const Contact contact = answer(small, plate, shifted(0, 0, -0.2), stiffness(100));
  expect_sound(contact);
  EXPECT_NEAR(contact.force_Me.z(), 100 * 0.25 * 0.05, 1e-14);
  EXPECT_NEAR(contact.force_Me.head<2>().norm(), 0, 1e-15);
  EXPECT_EQ(contact.element_count, 2);
  EXPECT_NEAR(contact.max_penetration, 0.05, 1e-16);
  EXPECT_NEAR(contact.volume, 0.25 * 0.05, 1e-15);
}

TEST(Engine, TorusOnPlateHasTwoPolygonsAndOnePatch) {
  const Contact contact = answer(generate::torus(1, 0.25, 40, 20), generate::plate(4, 4, 1), shifted(0.01, 0.02, -0.2));
  expect_sound(contact);
  ASSERT_EQ(contact.polygons.size(), 2u);
  EXPECT_EQ(contact.patches, 1);
  EXPECT_EQ(contact.polygons[0].patch, 0);
  EXPECT_EQ(contact.polygons[1].patch, 0);
}

TEST(Engine, TwoPinsUnderOnePlateAreTwoPatches) {
  TriangleMesh pins = box(Vector3d(-1.5, -0.25, -1), Vector3d(-1, 0.25, 0.125));
  pins = degenerate::joined(pins, box(Vector3d(1, -0.25, -1), Vector3d(1.5, 0.25, 0.125)));
  const Contact pressed = answer(generate::plate(4, 4, 0.25, 3, 3), pins, shifted(0, 0, -0.25));
  expect_sound(pressed);
  EXPECT_EQ(pressed.polygons.size(), 2u);
  EXPECT_EQ(pressed.patches, 2);
  EXPECT_NEAR(pressed.volume, 2 * 0.5 * 0.5 * 0.125, 1e-15);
}

TEST(Engine, SmallBoxInsideBigOneIsNestedAndPushesNothing) {
  const TriangleMesh big = box(Vector3d(10, 10, 10));
  const Contact contact = answer(big, kCube, turned(0.4, {0.5, 0.25, 0.125}));
  expect_sound(contact);
  EXPECT_FALSE(contact.touching);
  EXPECT_TRUE(contact.nested);
  EXPECT_EQ(contact.F.inner.size(), 12u);
  EXPECT_TRUE(contact.E.inner.empty());
  EXPECT_NEAR(contact.volume, 8, 1e-13);
  EXPECT_NEAR(contact.F.area, 24, 1e-13);
  EXPECT_TRUE(contact.force_Me.isZero(0));
  const Contact exchanged = answer(kCube, big);
  EXPECT_TRUE(exchanged.nested);
  EXPECT_EQ(exchanged.E.inner.size(), 12u);
  EXPECT_NEAR(exchanged.volume, 8, 1e-13);
}

TEST(Engine, BoxInCavityIsOutsideTheBody) {
  const TriangleMesh hollow =
      degenerate::joined(box(Vector3d(10, 10, 10)), degenerate::inverted(box(Vector3d(6, 6, 6))));
  const Contact inside = answer(hollow, kCube, shifted(-1, -1, -1));
  EXPECT_FALSE(inside.touching);
  EXPECT_FALSE(inside.nested);
  EXPECT_EQ(inside.volume, 0);
  // Halfway into the wall: 1 of its 2 m.
  const Contact at_wall = answer(hollow, kCube, shifted(2, -1, -1));
  expect_sound(at_wall);
  EXPECT_TRUE(at_wall.touching);
  EXPECT_NEAR(at_wall.volume, 4, 1e-13);
  EXPECT_NEAR(answer(hollow, kCube, shifted(2, -1, -1), stiffness(1), Mode::F).force_Me.x(), 4, 1e-13);
}

TEST(Engine, BubbleInOpenContainerIsPushedUp) {
  double of_bubble = 0;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const Contact contact =
        answer(generate::pyramid(), generate::bubble(), turned(0.3, {0.013, 0.02, 0.195}), stiffness(1.2e6), mode);
    expect_sound(contact);
    ASSERT_TRUE(contact.touching);
    EXPECT_FALSE(contact.has_volume);
    EXPECT_FALSE(contact.ambiguous);
    EXPECT_EQ(contact.undefined_areas, 0);
    EXPECT_GT(contact.F.inner.size(), 0u);
    EXPECT_GT(contact.F.area, 0);
    EXPECT_NEAR((contact.E.vector_area_Me + contact.F.vector_area_Me).norm() / contact.F.area, 0, 0.6);
    // The barycentres of the container's four faces lie far off, and mode both has the mean.
    if (mode == Mode::E) {
      EXPECT_EQ(contact.element_count, 0);
      EXPECT_EQ(contact.force_Me, Vector3d(0, 0, 0));
    } else if (mode == Mode::F) {
      of_bubble = contact.force_Me.z();
      EXPECT_LT(of_bubble, -200);
    } else {
      EXPECT_EQ(contact.force_Me.z(), of_bubble / 2);
    }
  }
}

TEST(Engine, IdenticalBodiesAtTheIdentityAreSound) {
  for (const TriangleMesh& mesh : {kCube, generate::bubble(), generate::icosphere(1, 2)}) {
    const Contact contact = answer(mesh, mesh);
    expect_sound(contact);
    EXPECT_TRUE(contact.force_Me.isZero(0));
    std::set<std::array<Index, 4>> crossings;
    for (const Crossing& c : contact.crossings) {
      crossings.insert({static_cast<Index>(c.edge_side), c.edge[0], c.edge[1], c.face});
    }
    EXPECT_EQ(crossings.size(), contact.crossings.size());
  }
}

TEST(Engine, PlateAsMasterFeelsTheSlavesImmersedVolume) {
  // Barycentric scheme on a fine grid: within discretisation.
  const TriangleMesh plate = generate::plate(2, 2, 1, 80, 80);
  const Contact contact = answer(plate, generate::icosphere(1, 3), turned(0.2, {0.01, 0.003, 0.8}), stiffness(10));
  expect_sound(contact);
  EXPECT_NEAR(contact.force_Me.z(), -10 * contact.volume, 10 * contact.volume * 0.01);
}

TEST(Engine, PenetrationDeeperThanTheMasterIsThickIsCounted) {
  // A thin sheet wholly inside a big box but for one side: its line leaves the sheet before the box.
  const TriangleMesh sheet = box(Vector3d(-3, -0.5, -0.0625), Vector3d(0.5, 0.5, 0.0625));
  const Contact contact = answer(sheet, box(Vector3d(4, 4, 4)));
  expect_sound(contact);
  EXPECT_GT(contact.too_deep, 0);
}

TEST(Engine, DeepPenetrationIsClampedAndFlagged) {
  ContactLaw law = stiffness(1);
  law.max_penetration = 0.5;
  const Contact contact = answer(kCube, box(Vector3d(0, 0, 1), Vector3d(2, 2, 3)), {}, law);
  EXPECT_TRUE(contact.penetration_exceeded);
  EXPECT_EQ(contact.max_penetration, 1);
  EXPECT_EQ(contact.force_Me, Vector3d(0, 0, -2));
}

TEST(Engine, FarFromTheOriginNothingBreaks) {
  for (const double distance : {1e3, 1e6, 1e9, 1e12, 1e15}) {
    const TriangleMesh far_cube = translated(kCube, Vector3d(distance, -distance, distance));
    Pose pose = turned(0.5, {0, 0, 0});
    pose.r = Vector3d(distance, -distance, distance) + Vector3d(1, 0.5, 0.75);
    const Contact contact = answer(far_cube, kCube, pose, stiffness(1), Mode::both);
    expect_sound(contact);
  }
}

TEST(Engine, SmallBodyRoundedToNothingOnABigOneIsSound) {
  const TriangleMesh big = box(Vector3d(2e12, 2e12, 2e12));
  for (const double size : {1e-12, 1e-5, 1e-4, 1e-3, 1e-2}) {
    for (const Mode mode : {Mode::E, Mode::F}) {
      expect_sound(answer(big, generate::icosphere(size, 1), turned(0.5, {1e12, 0.3e12, 0.1e12}), stiffness(1), mode));
    }
  }
}

}  // namespace
}  // namespace pcm::fast
