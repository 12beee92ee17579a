// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/element_law.h"

#include <gtest/gtest.h>

#include <limits>

#include "compare/poses/surface_features.h"
#include "meshes/generate/boxes.h"

namespace pcm::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(GreatestForce, IsThatOfFullDampingAndFriction) {
  ContactLaw law;
  law.stiffness = 8;
  law.damping = 2;
  law.friction = 0.5;
  law.transition_depth = 1;
  EXPECT_EQ(greatest_force(law, 4, 0.25, 3), 1.5 * 4 * (8 * 0.25 + 2 * 3));
}

/// An element at rest where bodies neither move nor are damped: what such factors of 0 do to errors without a bound.
class LawBounds : public testing::Test {
 protected:
  LawBounds() {
    truth_.area = 2;
    truth_.penetration = truth_.greatest_penetration = 0.5;
    truth_.normal_Me = {0, 0, 1};
    truth_.position_Me = {0.25, 0.5, 0};
    truth_.normal_force = 1;
    truth_.force_Me = {0, 0, 1};
    law_.stiffness = 1;
    law_.friction = 0.5;
  }

  ElementBounds bounds(const GeometryErrors& errors) const {
    return bounds_after_law({box_, box_, law_, Mode::E, Scheme::clipped, {}, velocity_}, truth_, errors);
  }

  static void expect_numbers(const ElementBounds& b) {
    for (const double bound : {b.area, b.penetration, b.depth, b.position, b.normal, b.normal_velocity,
                               b.tangential_velocity, b.normal_force, b.tangential_force, b.force, b.torque})
      EXPECT_GE(bound, 0);  // which NaN is not
  }

  TriangleMesh mesh_ = generate::box({1, 1, 1});
  SurfaceFeatures box_{mesh_};
  ContactLaw law_;
  Velocity velocity_;
  reference::Element truth_;
};

/// Of a torque next to the least double each of six products and sums may be off by half of that (`pcm verify`, seed
/// 2035, extreme pose 2880 of the shrinking cubes).
TEST_F(LawBounds, AllowForWhatATorqueLosesToUnderflow) {
  truth_.penetration = truth_.greatest_penetration = 0x1p-540;
  truth_.normal_force = truth_.area * truth_.penetration;
  truth_.force_Me = {0, 0, truth_.normal_force};
  truth_.position_Me = {0x1p-530, 0, 0};
  const double bound = bounds({}).torque;
  EXPECT_GE(bound, 3 * std::numeric_limits<double>::denorm_min());
  EXPECT_LT(bound, 0x1p-1050);
}

TEST_F(LawBounds, AreNumbersWhereAreaOrPenetrationHaveNone) {
  for (const double damping : {0.0, 10.0})
    for (const double w : {0.0, 2.0})
      for (const double transition : {0.0, 0.25, 1e300})
        for (const bool of_area : {false, true}) {
          law_.damping = damping;
          law_.transition_depth = transition;
          velocity_.w = {0, w, 0};
          GeometryErrors errors;
          (of_area ? errors.area : errors.penetration) = kInfinity;
          const ElementBounds b = bounds(errors);
          expect_numbers(b);
          EXPECT_EQ(b.normal_force, kInfinity);
          EXPECT_EQ(b.force, kInfinity);
          EXPECT_EQ(b.torque, kInfinity);
        }
}

}  // namespace
}  // namespace pcm::compare
