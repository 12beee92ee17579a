// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "fast/prism/convex_polygon.h"
#include "meshes/generate/parts.h"
#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"

/// max_penetration in the clipped scheme: elements integrate min(u, u_max) point by point (PCM section 6).
namespace pcm::fast::clipped_clamp_test {
namespace {

using namespace test;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ContactLaw clamped_at(double greatest) {
  ContactLaw law = stiffness(1);
  law.max_penetration = greatest;
  return law;
}

Contact clipped(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose, const ContactLaw& law,
                Mode mode = Mode::E, const Velocity& velocity = {}) {
  return answer(E, F, pose, law, mode, velocity, {}, Scheme::clipped);
}

double before(double x) {
  return std::nextafter(x, 0);
}
double after(double x) {
  return std::nextafter(x, kInfinity);
}

/// A prism over [0, 1] x [0, width] whose bottom runs from z = 0 at x = 0 to z = -1 at x = 1.
TriangleMesh sloping_body(double width) {
  TriangleMesh mesh;
  for (const double y : {0.0, width}) {
    mesh.vertices.insert(mesh.vertices.end(), {{0, y, 0}, {1, y, -1}, {1, y, 1}, {0, y, 1}});
  }
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {5, 4, 7}, {5, 7, 6}, {1, 5, 6}, {1, 6, 2},
                {4, 0, 3}, {4, 3, 7}, {3, 2, 6}, {3, 6, 7}, {4, 5, 1}, {4, 1, 0}};
  return mesh;
}

void expect_near(const Vector3d& a, const Vector3d& b, double tolerance) {
  EXPECT_LT((a - b).norm(), tolerance) << a.transpose() << "\n" << b.transpose();
}

TEST(ClippedClamp, NothingIsLostOfAPolygonWhoseCornersLieOnBothSidesOfTheClampByRoundings) {
  const double u = 0x1p-53;
  ConvexPolygon hexagon;
  const double s[] = {0.25, 0.5, 0.75, 0.75, 0.5, 0.25}, t[] = {0, 0, 0.25, 0.5, 0.75, 0.5};
  for (int k = 0; k < 6; ++k) hexagon.add({0, s[k], t[k], k % 2 == 0 ? 1 - 2 * u : 1});
  Moments whole, clamped;
  whole.add(hexagon);
  clamped.add_clamped(hexagon, 1 - u);
  EXPECT_NEAR(clamped.area, whole.area, 4 * u);
  EXPECT_NEAR(clamped.depth, whole.area, 4 * u);
  EXPECT_NEAR(clamped.s_depth, whole.s_depth, 4 * u);
  EXPECT_NEAR(clamped.t_depth, whole.t_depth, 4 * u);
}

TEST(ClippedClamp, PartAtTheClampExactlyCountsOnceThoughAnotherLiesAnUlpDeeper) {
  const double u = 0x1p-53;
  ConvexPolygon square;
  for (const auto& [s, t, depth] : {std::array{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 1.0, 1.0}, {0.0, 1.0, 1 + 2 * u}})
    square.add({0, s, t, depth});
  Moments clamped;
  clamped.add_clamped(square, 1);
  EXPECT_NEAR(clamped.area, 1, 4 * u);
  EXPECT_NEAR(clamped.depth, 1, 4 * u);
  EXPECT_NEAR(clamped.s_depth, 0.5, 4 * u);
  EXPECT_NEAR(clamped.t_depth, 0.5, 4 * u);
}

TEST(ClippedClamp, FlatDepthIsClampedFromTheFirstUlpOn) {
  const TriangleMesh plate = generate::plate(2, 2, 2);
  const TriangleMesh box = generate::box(Vector3d(-0.25, -0.25, -0.25), Vector3d(0.25, 0.25, 1));
  for (const double greatest : {0.125, before(0.25), 0.25, after(0.25), 0.5, kInfinity}) {
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      const Contact contact = clipped(plate, box, {}, clamped_at(greatest), mode);
      EXPECT_EQ(contact.max_penetration, 0.25);
      EXPECT_EQ(contact.penetration_exceeded, greatest < 0.25);
      EXPECT_NEAR(contact.force_Me.z() / (-0.25 * std::min(greatest, 0.25)), 1, 0x1p-51);
      expect_near(contact.torque_Me, {0, 0, 0}, 1e-16);
      EXPECT_NEAR(contact.statistics.patch_area, mode == Mode::both ? 0.5 : 0.25, 1e-16);
      for (const Element& element : contact.elements) {
        EXPECT_LE(element.penetration, greatest);
        EXPECT_NEAR(element.penetration / std::min(greatest, 0.25), 1, 0x1p-51);
      }
    }
  }
}

TEST(ClippedClamp, LinearDepthIsIntegratedUpToTheClampAndTheClampBeyond) {
  // u = x over [0, 1] x [0, 1/2]. With m = u_max: integral of min(x, m) = m - m^2 / 2, of x min(x, m) = m / 2 - m^3
  // / 6.
  const TriangleMesh plate = generate::plate(4, 4, 4), body = sloping_body(0.5);
  for (const double m : {0.5, 0.25, 0.75, 0x1p-20, 1.0}) {
    const double volume = 0.5 * (m - m * m / 2), first_moment = 0.5 * (m / 2 - m * m * m / 6);
    const Vector3d force(0, 0, -volume), torque(-volume / 4, first_moment, 0);
    for (const Mode mode : {Mode::E, Mode::F}) {
      // The plate is the master.
      const bool on_E = mode == Mode::E;
      const Contact contact =
          on_E ? clipped(plate, body, {}, clamped_at(m), mode) : clipped(body, plate, {}, clamped_at(m), mode);
      const double sign = on_E ? 1 : -1;
      expect_near(contact.force_Me, sign * force, 1e-15 * volume);
      expect_near(contact.torque_Me, sign * torque, 1e-15 * volume);
      EXPECT_EQ(contact.max_penetration, 1);
      EXPECT_EQ(contact.penetration_exceeded, m < 1);
      EXPECT_NEAR(contact.statistics.patch_area, 0.5, 1e-15);
    }
  }
}

TEST(ClippedClamp, FootIsTheCentroidOfTheClampedDepth) {
  // One slave face whose depth falls from 1 at x = 0 to 0 at x = 1, over a triangle that ends in a point there, so that
  // its width is 2 (1 - x). With u_max = 1/2, by parts: volume = integral of 2 (1 - x) min(1 - x, 1/2) = 1/12 + 3/8;
  // first moment = integral of x times that = 5/96 + 1/12.
  TriangleMesh body;
  body.vertices = {{0, -1, -1}, {0, 1, -1}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}, {1, 0, 1}};
  body.faces = {{0, 1, 2}, {4, 3, 5}, {1, 0, 4}, {4, 0, 3}, {2, 1, 5}, {5, 1, 4}, {0, 2, 3}, {3, 2, 5}};
  const TriangleMesh plate = translated(generate::plate(16, 16, 4), {3, 0.5, 0});
  // The plate's diagonal does not pass beneath the body.
  const Contact contact = clipped(plate, body, {}, clamped_at(0.5));
  double volume = 0, moment = 0;
  for (const Element& element : contact.elements) {
    volume += element.area * element.penetration;
    moment += element.area * element.penetration * element.position_Me.x();
  }
  EXPECT_NEAR(volume, 1.0 / 12 + 3.0 / 8, 1e-14);
  EXPECT_NEAR(moment, 5.0 / 96 + 1.0 / 12, 1e-14);
  EXPECT_NEAR(contact.torque_Me.y(), moment, 1e-14);
}

TEST(ClippedClamp, CornerAtTheClampIsFlaggedByTheUlpAndLosesNoMore) {
  const TriangleMesh plate = generate::plate(4, 4, 4), body = sloping_body(0.5);
  const Contact unclamped = clipped(plate, body, {}, stiffness(1));
  for (const double m : {before(1), 1.0, after(1)}) {
    const Contact contact = clipped(plate, body, {}, clamped_at(m));
    EXPECT_EQ(contact.penetration_exceeded, m < 1);
    expect_near(contact.force_Me, unclamped.force_Me, 1e-16);
    expect_near(contact.torque_Me, unclamped.torque_Me, 1e-16);
    if (m < 1) continue;
    expect_same_answer(contact, unclamped);
  }
}

TEST(ClippedClamp, OnAPlateTakesAwayWhatTheBodyLiftedByItWouldFeel) {
  // (u - u_max, where that is positive) is the depth of a convex body that was lifted by u_max.
  const TriangleMesh plate = generate::plate(8, 8, 3, 3, 3);
  const Eigen::Matrix3d corner_down =
      Eigen::Quaterniond::FromTwoVectors(Vector3d(1.1, 1, 0.9), Vector3d(0, 0, 1)).toRotationMatrix();
  const Eigen::Matrix3d apex_down = Eigen::AngleAxisd(3, Vector3d::UnitX()).toRotationMatrix();
  const std::pair<TriangleMesh, Eigen::Matrix3d> bodies[] = {
      {generate::icosphere(1, 2), turned(0.8, Eigen::Vector3d::Zero()).A},
      {generate::box(Vector3d(1, 0.8, 1.2)), corner_down},
      {generate::cone(0.7, 1.5, 24), apex_down}};
  for (const auto& [body, A] : bodies) {
    for (const double angle : {0.4, 1.3, 2.9}) {
      Pose pose;
      pose.A = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix() * A;
      pose.r = {0.21, -0.34, 0};
      double lowest = kInfinity;
      for (const Vector3d& x : body.vertices) lowest = std::min(lowest, (pose.A * x).z());
      pose.r.z() = -lowest - 0.3;
      const Contact whole = clipped(plate, body, pose, stiffness(1));
      for (const double m : {0.01, 0.07, 0.15, 0.29}) {
        Pose lifted = pose;
        lifted.r.z() += m;
        const Contact contact = clipped(plate, body, pose, clamped_at(m));
        const Contact excess = clipped(plate, body, lifted, stiffness(1));
        expect_near(contact.force_Me, whole.force_Me - excess.force_Me, 1e-14 * whole.force_Me.norm());
        expect_near(contact.torque_Me, whole.torque_Me - excess.torque_Me, 1e-14 * whole.force_Me.norm());
        EXPECT_EQ(contact.max_penetration, whole.max_penetration);
        EXPECT_TRUE(contact.penetration_exceeded);
      }
    }
  }
}

TEST(ClippedClamp, SplittingTheMasterInItsPlaneChangesNoElasticForce) {
  const TriangleMesh sphere = generate::icosphere(1, 3);
  const TriangleMesh coarse = generate::plate(4, 4, 1), fine = generate::plate(4, 4, 1, 32, 32);
  const Pose pose = turned(0.4, {0.1, 0.2, -0.8});
  for (const Mode mode : {Mode::E, Mode::F}) {
    for (const double m : {0.19, 0.1, 0.03, 1e-4}) {
      const Contact whole = clipped(sphere, coarse, pose, clamped_at(m), mode);
      const Contact split = clipped(sphere, fine, pose, clamped_at(m), mode);
      EXPECT_TRUE(whole.penetration_exceeded);
      expect_near(split.force_Me, whole.force_Me, 1e-14 * whole.force_Me.norm());
      expect_near(split.torque_Me, whole.torque_Me, 1e-14 * whole.force_Me.norm());
    }
  }
}

TEST(ClippedClamp, ElasticForceIsContinuousAndGrowsWithTheClamp) {
  // The force over the stiffness grows by no more than the clamped area times what the clamp grows by.
  const TriangleMesh torus = generate::torus(1, 0.3, 24, 12), plate = generate::plate(8, 8, 4);
  const TriangleMesh box = generate::box(Vector3d(1, 1, 1));
  // The box's bottom, flat but for roundings.
  Pose flat;
  flat.A = Eigen::AngleAxisd(0.7, Vector3d::UnitZ()).toRotationMatrix();
  flat.r = {0.1, 0.2, 0.4};
  const std::pair<const TriangleMesh*, Pose> cases[] = {{&torus, turned(0.5, {0.1, 0.07, 0.2})}, {&box, flat}};
  for (const auto& [body, pose] : cases) {
    const Contact whole = clipped(plate, *body, pose, stiffness(1));
    ASSERT_GT(whole.max_penetration, 0.05);
    const double area = whole.statistics.patch_area;
    std::vector<double> clamps;
    for (const double at : {0.01, 0.05, whole.max_penetration}) {
      clamps.push_back(at);
      for (double step = at / 8; step > 0x1p-54; step /= 8) {
        clamps.push_back(at - step);
        clamps.push_back(at + step);
      }
    }
    std::sort(clamps.begin(), clamps.end());
    double last = 0, least = 0;
    for (const double m : clamps) {
      const double force = -clipped(plate, *body, pose, clamped_at(m)).force_Me.z();
      ASSERT_GE(force, last - 1e-15);
      ASSERT_LE(force, last + area * (m - least) + 1e-15);
      last = force;
      least = m;
    }
    EXPECT_NEAR(last, -whole.force_Me.z(), 1e-15);
  }
}

TEST(ClippedClamp, ScalingAllLengthsByAPowerOfTwoChangesNoBitButTheExponent) {
  const TriangleMesh E = generate::icosphere(1, 2), F = generate::torus(1, 0.3, 16, 8);
  const Pose pose = turned(0.5, {0.4, 0.3, 0.9});
  const Contact plain = clipped(E, F, pose, clamped_at(0.05), Mode::both);
  EXPECT_TRUE(plain.penetration_exceeded);
  for (const int k : {-40, -7, 30}) {
    const double s = std::ldexp(1.0, k);
    Pose larger = pose;
    larger.r *= s;
    const Contact scaled_answer = clipped(scaled(E, s), scaled(F, s), larger, clamped_at(0.05 * s), Mode::both);
    EXPECT_TRUE(same(scaled_answer.force_Me, plain.force_Me * (s * s * s)));
    EXPECT_TRUE(same(scaled_answer.torque_Me, plain.torque_Me * (s * s * s * s)));
    ASSERT_EQ(scaled_answer.elements.size(), plain.elements.size());
    for (std::size_t i = 0; i < plain.elements.size(); ++i) {
      EXPECT_TRUE(same(scaled_answer.elements[i].penetration, plain.elements[i].penetration * s));
      EXPECT_TRUE(same(scaled_answer.elements[i].position_Me, plain.elements[i].position_Me * s));
    }
  }
}

TEST(ClippedClamp, DampingFadesWithTheClampedMean) {
  // Depth 1/4 over an area of 1/4, clamped to 1/8, which is half the transition depth.
  const TriangleMesh plate = generate::plate(2, 2, 2);
  const TriangleMesh box = generate::box(Vector3d(-0.25, -0.25, -0.25), Vector3d(0.25, 0.25, 1));
  ContactLaw law = clamped_at(0.125);
  law.damping = 1;
  law.transition_depth = 0.25;
  Velocity velocity;
  velocity.v = {0, 0, -1};
  EXPECT_NEAR(clipped(plate, box, {}, law, Mode::E, velocity).force_Me.z(), -(0.25 * 0.125 + 0.25 * 0.5), 1e-16);
}

}  // namespace
}  // namespace pcm::fast::clipped_clamp_test
