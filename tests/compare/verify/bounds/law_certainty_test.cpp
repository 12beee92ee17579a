// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the law makes certain however the geometry is rounded: no damping where bodies part, no force where they would
// pull, the greatest penetration where it is exceeded. The engine's bounds say so, and not where it is not certain.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compare/random/random.h"
#include "meshes/generate/boxes.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

/// Some of what a depth of a tenth is off there, of itself.
constexpr double kStep = 0x1p-43;

/// A thousand edges from the origins of their frames, where vertices of F are rounded by 2^-43.
const Eigen::Vector3d kCentre(1024, 1024, 1024);

TriangleMesh far_cube() {
  TriangleMesh cube = generate::box({1, 1, 1});
  for (Eigen::Vector3d& x : cube.vertices) x += kCentre;
  return cube;
}

/// A cube of edge 1 sunk by a tenth into another one, a little turned about an axis of no special direction, so that
/// the normals of its faces are rounded; one element in the barycentric scheme.
class LawCertainty : public testing::TestWithParam<Scheme> {
 protected:
  LawCertainty() { place(0.9); }

  const fast::Contact& asked(const ContactLaw& law, const Velocity& velocity) {
    const fast::Pairing pairing{surface_, surface_, law, mode_, GetParam()};
    Wanted wanted;
    wanted.bound = true;
    return fast::evaluate(pairing, pose_, velocity, wanted, workspace_);
  }

  /// Of the force and its bound, the exact problem's.
  void expect_holds(const ContactLaw& law, const Velocity& velocity) {
    const fast::Contact& subj = asked(law, velocity);
    const reference::Answer truth =
        reference::Oracle(cube_, cube_, law, mode_, GetParam()).answer(reference::Problem::exact, pose_, velocity);
    ASSERT_TRUE(subj.bound);
    EXPECT_FALSE(subj.bound->flipped);
    for (int j = 0; j < 3; ++j) {
      EXPECT_LE(std::abs(subj.force_Me[j] - truth.force_Me[j]), subj.bound->force_Me[j]);
      EXPECT_LE(std::abs(subj.torque_Me[j] - truth.torque_Me[j]), subj.bound->torque_Me[j]);
    }
  }

  static ContactLaw damped(DampingMode mode) {
    ContactLaw law;
    law.stiffness = 1;
    law.damping = 0x1p30;
    law.damping_mode = mode;
    return law;
  }

  /// F's centre beside E's and so far above it; each turn has roundings of its own.
  void place(double height, int turn = 0) {
    pose_.A = ordered_rotation(1, 0.01 + 1e-6 * turn, 0.02, 0.03);
    pose_.r = kCentre + Eigen::Vector3d(0.4, 0.3, height) - pose_.A * kCentre;
  }

  const TriangleMesh cube_ = far_cube();
  const fast::Surface surface_{cube_};
  Mode mode_ = Mode::F;
  Pose pose_;
  const Velocity parting_{{0.01, 0.02, 1}, {0, 0, 0}}, approaching_{{0.01, 0.02, -1}, {0, 0, 0}};
  fast::Workspace workspace_;
};

TEST_P(LawCertainty, BodiesThatPartAreNotDampedInCompressionNorIsTheBound) {
  mode_ = Mode::E;  // whose walls the other body's do not approach
  ContactLaw law = damped(DampingMode::compression);
  const Eigen::Vector3d with = asked(law, parting_).bound->force_Me, towards = asked(law, approaching_).bound->force_Me;
  expect_holds(law, parting_);
  law.damping = 0;
  EXPECT_LE(with.norm(), 1.1 * asked(law, parting_).bound->force_Me.norm());
  EXPECT_GT(towards.norm(), 0x1p20 * with.norm());
}

TEST_P(LawCertainty, WherePartingIsARoundingAwayTheBoundCountsDamping) {
  ContactLaw law = damped(DampingMode::compression);
  law.damping = 0x1p60;
  const std::vector<fast::Element> elements = asked(law, {}).elements;
  ASSERT_FALSE(elements.empty());
  int parting = 0, approaching = 0;
  PoseRandom random(1, 0, 0, 0);
  for (const fast::Element& element : elements)
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d n = element.normal_Me, direction = random.direction();
      const Velocity along{direction - n * n.dot(direction), {0, 0, 0}};
      expect_holds(law, along);
      for (const fast::Element& e : asked(law, along).elements)
        if (e.master_face == element.master_face) ++(e.normal_velocity < 0 ? parting : approaching);
    }
  EXPECT_GT(parting, 0);
  EXPECT_GT(approaching, 0);
}

TEST_P(LawCertainty, BodiesThatWouldPullHaveNoForceAndNoBound) {
  mode_ = Mode::E;
  const ContactLaw law = damped(DampingMode::no_tension);
  EXPECT_EQ(asked(law, parting_).force_Me.norm(), 0);
  expect_holds(law, parting_);
  if (GetParam() == Scheme::clipped) return;  // slivers beside the elements may press
  EXPECT_LE(asked(law, parting_).bound->force_Me.norm(), 0x1p-1000);
  // As wide where the same speed pulls and may, and where it presses.
  const auto width = [&](DampingMode mode, const Velocity& velocity) {
    return asked(damped(mode), velocity).bound->force_Me.norm();
  };
  const double pressing = width(DampingMode::full, approaching_);
  EXPECT_GT(pressing, 0);
  EXPECT_NEAR(width(DampingMode::full, parting_), pressing, 0.01 * pressing);
  EXPECT_EQ(width(DampingMode::no_tension, approaching_), pressing);
}

TEST_P(LawCertainty, WherePullingIsARoundingAwayTheBoundKeepsIt) {
  // One element after the other, u its depth: of stiffness 1 and damping u / v an approach velocity of -v takes all of
  // F_n away.
  ContactLaw law = damped(DampingMode::no_tension);
  int pulling = 0, pressing = 0;
  for (int turn = 0; turn < (GetParam() == Scheme::clipped ? 2 : 40); ++turn) {
    place(0.9, turn);
    const std::vector<fast::Element> elements = asked(law, parting_).elements;
    ASSERT_FALSE(elements.empty());
    for (const fast::Element& element : elements) {
      if (element.normal_velocity >= 0) continue;
      const double limit = element.penetration / -element.normal_velocity;
      for (int k = -8; k <= 8; ++k) {
        law.damping = limit * (1 + k * kStep);
        expect_holds(law, parting_);
        for (const fast::Element& e : asked(law, parting_).elements)
          if (e.master_face == element.master_face && e.slave_face == element.slave_face)
            ++(e.normal_force > 0 ? pressing : pulling);
      }
    }
  }
  EXPECT_GT(pulling, 0);
  EXPECT_GT(pressing, 0);
}

TEST_P(LawCertainty, DepthsThatAreSurelyClampedAreKnown) {
  if (GetParam() == Scheme::clipped) return;  // it integrates depths up to the clamp's edge
  ContactLaw law;
  law.max_penetration = 0x1p-40;
  const fast::Contact& subj = asked(law, {});
  EXPECT_LE(subj.bound->force_Me.norm(), 0x1p-35 * subj.force_Me.norm());
  expect_holds(law, {});
}

TEST_P(LawCertainty, DepthsAtTheClampKeepTheirBound) {
  ContactLaw law;
  for (int turn = 0; turn < (GetParam() == Scheme::clipped ? 2 : 40); ++turn) {
    place(0.989, turn);  // less than a thousandth deep: what area is off matters little
    law.max_penetration = HUGE_VAL;
    const std::vector<fast::Element> elements = asked(law, {}).elements;
    ASSERT_FALSE(elements.empty());
    for (const fast::Element& element : elements) {
      for (int k = -8; k <= 8; ++k) {
        law.max_penetration = element.penetration * (1 + k * 0x1p-36);
        expect_holds(law, {});
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, LawCertainty, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::barycentric ? "barycentric" : "clipped";
                         });

}  // namespace
}  // namespace pcm::compare
