// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "fast/force/law_parameters.h"
#include "pcm/bad_input.h"
#include "tests/fast/engine_support.h"

namespace pcm::fast {
namespace {

using namespace test;
using Eigen::Vector3d;
using generate::box;

/// A prism with its ridge along x through the origin, flanks at 45 degrees below it.
TriangleMesh roof() {
  TriangleMesh mesh;
  mesh.vertices = {{-2, 0, 0}, {2, 0, 0}, {-2, 1, -1}, {2, 1, -1}, {-2, -1, -1}, {2, -1, -1}};
  mesh.faces = {{0, 1, 3}, {0, 3, 2}, {0, 5, 1}, {0, 4, 5}, {2, 3, 5}, {2, 5, 4}, {0, 2, 4}, {1, 5, 3}};
  return mesh;
}

TEST(EngineRanges, PatchFarSmallerThanItsFacesKeepsTheDigitsItsPlaceAllows) {
  // Two roofs, ridge across ridge, sunk by h: a tetrahedron of volume 2/3 h^3 with flanks of sqrt(2) h^2 each. The
  // vertices of the turned roof are rounded to some 2^-52, which is 2^-52 / h of the patch.
  const Pose pose = turned(0.7, {0.1, 0.2, -0.3});
  TriangleMesh E = roof();
  for (Vector3d& x : E.vertices) x = pose.A * x + pose.r;
  Eigen::Matrix3d upside_down;
  upside_down << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  for (const double h : {0x1p-10, 0x1p-20, 0x1p-30}) {
    TriangleMesh F = roof();
    for (Vector3d& x : F.vertices) x = upside_down * x - Vector3d(0, 0, h);
    const Contact contact = answer(E, F, pose);
    const double tolerance = 64 * 0x1p-52 / h;
    EXPECT_NEAR(contact.E.area / (2 * std::sqrt(2.0) * h * h), 1, tolerance) << h;
    EXPECT_NEAR(contact.F.area / (2 * std::sqrt(2.0) * h * h), 1, tolerance) << h;
    EXPECT_NEAR(contact.volume / (2 * h * h * h / 3), 1, tolerance) << h;
  }
}

TEST(EngineRanges, SurfacesBeyondTheRangeOfVolumesAreRefused) {
  const TriangleMesh cube = box(Vector3d(1, 1, 1));
  for (const double size : {5e-324, 1e-200, 1e-100, 1e100, 1e160, 1e308}) {
    EXPECT_THROW(Surface(scaled(cube, size)), BadInput) << size;
  }
  for (const double size : {0x1p-299, 1e-80, 1e80, 0x1p299}) EXPECT_NO_THROW(Surface(scaled(cube, size))) << size;
  Pose pose;
  for (const double r : {1e100, 1e300, 1.7e308}) {
    pose.r[1] = -r;
    EXPECT_THROW(answer(cube, cube, pose), BadInput) << r;
  }
}

TEST(EngineRanges, AllLengthsTimes2ToThe290ScaleAreasAndVolume) {
  const TriangleMesh E = box(Vector3d(0, 0, 0), Vector3d(2, 2, 1)), F = box(Vector3d(0, 0, 0), Vector3d(1, 1, 3));
  Wanted geometry;
  geometry.force = geometry.elements = false;
  const Pose pose = turned(0.4, {0.3, 0.1, 0.6});
  const Contact plain = answer(E, F, pose, {}, Mode::E, {}, geometry);
  ASSERT_GT(plain.volume, 0);
  for (const int k : {-290, 290}) {
    const double s = std::ldexp(1.0, k);
    Pose far = pose;
    far.r *= s;
    const Contact contact = answer(scaled(E, s), scaled(F, s), far, {}, Mode::E, {}, geometry);
    EXPECT_EQ(contact.E.area, plain.E.area * s * s);
    EXPECT_EQ(contact.F.area, plain.F.area * s * s);
    EXPECT_EQ(contact.volume, plain.volume * s * s * s);
  }
}

TEST(EngineRanges, UnderflowOfATinyFacesHeightsChangesNoDecision) {
  // A line leaves a frustum through its cap, so small that its distance, a quotient of products of three lengths,
  // underflows. The plate is half as thick, so the master is left first.
  const auto frustum = [](double foot, double cap, double low, double high) {
    TriangleMesh mesh;
    for (const auto& [s, z] : {std::pair{foot, low}, std::pair{cap, high}}) {
      for (const Vector3d& x : {Vector3d(-s, -s, z), Vector3d(2 * s, -s, z), Vector3d(-s, 2 * s, z)}) {
        mesh.vertices.push_back(x);
      }
    }
    mesh.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
  };
  const double s = 0x1p-290;
  const TriangleMesh plate = frustum(s, s, 0, 0.5 * s);
  const Contact contact = answer(plate, frustum(1.5 * s, 0x1p-155 * s, -s, s));
  EXPECT_EQ(contact.element_count, 0);
  EXPECT_EQ(contact.too_deep, answer(plate, frustum(1.5 * s, 0x1p-10 * s, -s, s)).too_deep);
  EXPECT_EQ(contact.too_deep, 2);
}

TEST(EngineRanges, EveryLawScalesBitForBitWithAllLengthsTiesIncluded) {
  const TriangleMesh cube = box(Vector3d(0, 0, 0), Vector3d(2, 2, 2)),
                     upper = box(Vector3d(0, 0, 1), Vector3d(2, 2, 3));
  const TriangleMesh ball = generate::icosphere(0.7, 2);
  struct Pair {
    const TriangleMesh& E;
    const TriangleMesh& F;
    Pose pose;
  };
  const Pair pairs[] = {{cube, upper, {}}, {cube, ball, turned(0.8, {1.1, 0.9, 2.3})}, {cube, cube, {}}};
  for (const Pair& pair : pairs) {
    for (const DampingMode damping_mode : {DampingMode::no_tension, DampingMode::full, DampingMode::compression}) {
      for (const double c_F : {2e5, std::numeric_limits<double>::infinity()}) {
        ContactLaw law;
        law.layers = LayerStiffness{3e5, c_F};
        law.damping = 700;
        law.transition_depth = 0.3;
        law.friction = 0.4;
        law.slip_velocity = 0.1;
        law.max_penetration = 0.25;
        law.damping_mode = damping_mode;
        const Velocity velocity{{0.2, -0.1, 0.9}, {0.5, -0.2, 0.3}};
        for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
          const Contact plain = answer(pair.E, pair.F, pair.pose, law, mode, velocity);
          for (const int k : {-60, 60}) {
            const double s = std::ldexp(1.0, k);
            ContactLaw large = law;
            large.transition_depth *= s;
            large.slip_velocity *= s;
            large.max_penetration *= s;
            const Pose pose{pair.pose.A, pair.pose.r * s};
            const Contact contact =
                answer(scaled(pair.E, s), scaled(pair.F, s), pose, large, mode, Velocity{velocity.v * s, velocity.w});
            EXPECT_EQ(contact.touching, plain.touching);
            EXPECT_EQ(contact.force_Me, plain.force_Me * s * s * s);
            EXPECT_EQ(contact.torque_Me, plain.torque_Me * s * s * s * s);
            EXPECT_EQ(contact.E.area, plain.E.area * s * s);
            EXPECT_EQ(contact.F.vector_area_Me, plain.F.vector_area_Me * s * s);
            EXPECT_EQ(contact.volume, plain.volume * s * s * s);
            EXPECT_EQ(contact.penetration_exceeded, plain.penetration_exceeded);
            EXPECT_EQ(contact.statistics.mean_penetration, plain.statistics.mean_penetration * s);
            EXPECT_EQ(contact.statistics.centre_of_pressure_Me, plain.statistics.centre_of_pressure_Me * s);
          }
        }
      }
    }
  }
}

TEST(EngineRanges, ForceBeyondTheRangeOfDoublesIsRefusedAndTheWorkspaceStaysUsable) {
  const TriangleMesh plate = box(Vector3d(-1, -1, -1), Vector3d(1, 1, 0)), cube = box(Vector3d(0.5, 0.5, 0.5));
  const Surface E(scaled(plate, 0x1p290)), F(scaled(cube, 0x1p290)), small_E(plate), small_F(cube);
  Workspace workspace;
  EXPECT_THROW(evaluate(Pairing(E, F, {}, Mode::both), shifted(0, 0, 0x1p287), {}, {}, workspace), BadInput);
  const Contact& contact = evaluate(Pairing(small_E, small_F, {}, Mode::both), shifted(0, 0, 0.125), {}, {}, workspace);
  const Contact fresh = answer(plate, cube, shifted(0, 0, 0.125), {}, Mode::both);
  EXPECT_EQ(contact.force_Me, fresh.force_Me);
  EXPECT_EQ(contact.volume, fresh.volume);
}

TEST(EngineRanges, AWorkspaceMovedFromStartsAnew) {
  const TriangleMesh cube = box(Vector3d(1, 1, 1));
  const Pairing pairing{Surface(cube), Surface(cube)};
  Workspace first;
  const double volume = evaluate(pairing, shifted(0.5, 0.25, 0.125), {}, {}, first).volume;
  Workspace second = std::move(first);
  EXPECT_EQ(evaluate(pairing, shifted(0.5, 0.25, 0.125), {}, {}, second).volume, volume);
  // Using a workspace that was moved from is what this test is about.
  // NOLINTNEXTLINE(bugprone-use-after-move)
  EXPECT_EQ(evaluate(pairing, shifted(0.5, 0.25, 0.125), {}, {}, first).volume, volume);
}

TEST(EngineRanges, FeaturesWhoseSquaresUnderflowGiveFiniteAnswers) {
  const TriangleMesh cube = box(Vector3d(1, 1, 1));
  for (const double size : {1e-90, 1e-85, 1e-80}) {
    TriangleMesh sliver;
    sliver.vertices = {{0, 0, 0}, {0.5, 0, 0}, {0, size, 0}, {0, 0, size * 1e-60}};
    sliver.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (const Mode mode : {Mode::E, Mode::F}) {
      for (const Pose& pose : {shifted(0.1, 0.1, 0.1), shifted(0, 0, 0), turned(1, {-0.1, 0.5, 0})}) {
        const Contact contact = answer(cube, sliver, pose, {}, mode);
        EXPECT_TRUE(contact.force_Me.allFinite() && contact.torque_Me.allFinite());
        EXPECT_TRUE(std::isfinite(contact.E.area) && std::isfinite(contact.F.area) && std::isfinite(contact.volume));
        EXPECT_GE(contact.max_penetration, 0);
        for (const Element& element : contact.elements) {
          EXPECT_TRUE(element.position_Me.allFinite() && element.normal_Me.allFinite());
        }
      }
    }
  }
}

TEST(EngineRanges, ASmallBodyCrossesAFaceHoweverMuchLargerThatIs) {
  // Two large triangles on either side of F's origin; the pose has the barycentre of the first one in E's, exactly.
  constexpr double kLarge = 0x1p60;
  TriangleMesh F;
  for (const double side : {kLarge, -kLarge}) {
    const auto first = static_cast<Index>(F.vertices.size());
    for (const Vector3d& x : {Vector3d(1, 1, 4), Vector3d(1, 4, 1), Vector3d(4, 1, 1)}) F.vertices.push_back(side * x);
    F.faces.push_back({first, first + 1, first + 2});
  }
  Pose pose;
  const Vector3d first_row = Vector3d(3, 4, 5).normalized();
  const Vector3d third_row = first_row.cross(Vector3d(1, -2, 0.3)).normalized();
  pose.A.row(0) = first_row;
  pose.A.row(1) = third_row.cross(first_row);
  pose.A.row(2) = third_row;
  // Of 35 bits, so that products of whole numbers have no roundings.
  pose.A = pose.A.unaryExpr([](double x) { return std::ldexp(std::round(std::ldexp(x, 35)), -35); });
  pose.r = -(pose.A * (kLarge * Vector3d(2, 2, 2)));
  for (int exponent = -40; exponent > -300; exponent -= exponent > -60 || exponent < -80 ? 10 : 1) {
    TriangleMesh E;
    E.vertices = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    E.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const Contact contact = answer(scaled(E, std::ldexp(1.0, exponent)), F, pose);
    EXPECT_EQ(contact.polygons.size(), 1U) << exponent;
    EXPECT_EQ(contact.F.intersected.size(), 1U) << exponent;
  }
}

TEST(EngineRanges, ALineMeetsTheNearestOfTwoSheetsHoweverNarrowTheBarThatItLeaves) {
  for (int exponent = -60; exponent >= -290; exponent -= 10) {
    const double t = std::ldexp(1.0, exponent);
    TriangleMesh bar = box(Vector3d(2, 2, 1));
    for (Vector3d& x : bar.vertices) x.head<2>() *= t;
    for (const bool nearest_first : {true, false}) {
      TriangleMesh sheets;
      for (const double z : {nearest_first ? t : 2 * t, nearest_first ? 2 * t : t}) {
        const auto first = static_cast<Index>(sheets.vertices.size());
        for (const Vector3d& x : {Vector3d(-4 * t, -5 * t, z), Vector3d(6 * t, -5 * t, z), Vector3d(-4 * t, 7 * t, z)})
          sheets.vertices.push_back(x);
        sheets.faces.push_back({first, first + 1, first + 2});
      }
      const Contact contact = answer(bar, sheets, {}, stiffness(1), Mode::E);
      for (const Element& element : contact.elements) EXPECT_EQ(element.slave_face, nearest_first ? 0 : 1) << exponent;
      EXPECT_GT(contact.elements.size(), 0U) << exponent;
    }
  }
}

TEST(EngineRanges, ClippedElementsOfNearlyFlushNeedlesScaleUpToTheGreatestCoordinates) {
  TriangleMesh E, F;
  E.vertices = {{0, 0, 0},
                {0x1.d37b0e196e6f9p-38, 0x1.99aef1350bc4fp-38, 0},
                {-0x1.5c639ccf135bp-4, 1, 0x1.959df199d411ap-8},
                {0x1.6dbd3619bc50dp-2, 0x1.be7cfe981975fp-2, -0.5}};
  E.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  F.vertices = {{0x1.3c0251fd596dp+0, 0x1.be3a3c79683d6p-1, 0x1.b40598e4056bap-1},
                {-0x1.052921b99f83ap-1, -0x1.e8427bad7111bp-1, 0x1.478efe57145cfp-1},
                {-0x1.c66fcea3c01f5p-1, 0x1.238427ceb4ff3p-1, -0x1.11520eccab91ep+0},
                {0x1.3b7679ebbab68p+0, -0x1.45e53ef291693p+0, -0x1.826ed234fce7dp-1}};
  F.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const auto scaled_answer = [&](int exponent) {
    const double size = std::ldexp(1.0, exponent);
    return answer(scaled(E, size), scaled(F, size), {}, stiffness(std::ldexp(1.0, -exponent)), Mode::E, {}, {},
                  Scheme::clipped);
  };
  const Contact small = scaled_answer(0);
  ASSERT_EQ(small.elements.size(), 2U);
  for (int exponent = 280; exponent < 299; ++exponent) {
    const Contact large = scaled_answer(exponent);
    ASSERT_EQ(large.elements.size(), 2U) << exponent;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(large.elements[i].slave_face, small.elements[i].slave_face);
      EXPECT_EQ(std::ldexp(large.elements[i].penetration, -exponent), small.elements[i].penetration) << exponent;
    }
  }
}

TEST(EngineRanges, StiffestLayersShareThePenetrationEvenly) {
  ContactLaw law;
  law.layers = LayerStiffness{1.5e308, 1.5e308};
  const SeriesStiffness stiffness(law);
  EXPECT_EQ(stiffness.c_l, 0.75e308);
  EXPECT_EQ(stiffness.shift_from_E, 0.5);
  EXPECT_EQ(stiffness.shift_from_F, 0.5);
}

}  // namespace
}  // namespace pcm::fast
