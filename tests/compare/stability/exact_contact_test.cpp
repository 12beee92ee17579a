// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/exact_contact.h"

#include <gtest/gtest.h>

#include "compare/stability/feature_pose.h"
#include "meshes/generate/boxes.h"
#include "reference/oracle.h"

namespace pcm::compare::stability {
namespace {

double of(const Figures& figures, Quantity quantity) {
  return figures[static_cast<std::size_t>(quantity)];
}

fast::Contact in_doubles(const reference::Answer& answer) {
  fast::Contact contact;
  contact.force_Me = answer.force_Me;
  contact.torque_Me = answer.torque_Me;
  contact.E.area = answer.E.area;
  contact.max_penetration = answer.max_penetration;
  return contact;
}

class ExactContactInSchemes : public testing::TestWithParam<Scheme> {};

/// The oracle rounds what is summed here: no number of it is farther off than half an ulp.
TEST_P(ExactContactInSchemes, IsWhatTheOracleRounds) {
  const SweptBodies bodies = bodies_at({Sweep::depth, -5});
  const ExactBodies exact(bodies.E, bodies.F);
  const reference::Oracle oracle(bodies.E, bodies.F, stability_law(), Mode::E, GetParam());
  for (std::uint64_t i = 0; i < 5; ++i)
    for (const reference::Problem problem : {reference::Problem::exact, reference::Problem::rounded}) {
      const Pose pose = draw_feature_pose(bodies, PoseRandom(3, 0, 0, i));
      ExactContact contact(exact, pose, GetParam(), problem);
      const reference::Answer answer = oracle.answer(problem, pose);
      ASSERT_GT(answer.force_scale, 0);
      const Figures sizes = contact.sizes(), off = differences(contact, in_doubles(answer));
      EXPECT_EQ(of(sizes, Quantity::force), answer.force_scale);
      EXPECT_EQ(of(sizes, Quantity::torque), answer.torque_scale);
      EXPECT_EQ(of(sizes, Quantity::area), answer.E.area);
      EXPECT_EQ(of(sizes, Quantity::penetration), answer.max_penetration);
      EXPECT_LE(of(off, Quantity::force), 0x1p-53 * 1.8 * answer.force_scale);
      EXPECT_LE(of(off, Quantity::torque), 0x1p-53 * 1.8 * answer.torque_scale);
      EXPECT_LE(of(off, Quantity::area), 0x1p-53 * answer.E.area);
      EXPECT_LE(of(off, Quantity::penetration), 0x1p-53 * answer.max_penetration);
      EXPECT_GT(of(off, Quantity::force), 0) << "a sum of roots is no double";
      EXPECT_EQ(contact.elements().size(), answer.elements.size());
    }
}

/// The box lies d deep in the plate, and once more 2^-80 deeper: no double of the answer tells them apart.
TEST_P(ExactContactInSchemes, TellsDifferencesFarBelowAnUlp) {
  const TriangleMesh plate = generate::box({-2, -3, -1}, {2, 3, 0});
  const auto box_from = [](double z) { return generate::box({-1, -1.5, z}, {1.25, 1.5, 1}); };
  constexpr double kDepth = 0x1p-3, kMore = 0x1p-80;
  Pose pose;
  pose.r.z() = -kDepth;
  const ExactBodies shallow(plate, box_from(0)), deep(plate, box_from(-kMore));
  ExactContact a(shallow, pose, GetParam()), b(deep, pose, GetParam());
  const Figures sizes = a.sizes(), off = differences(a, b);
  EXPECT_EQ(of(off, Quantity::penetration), kMore);
  EXPECT_EQ(of(off, Quantity::area), 0);
  // The force of either scheme is c_l A d.
  EXPECT_NEAR(of(off, Quantity::force) / of(sizes, Quantity::force), kMore / kDepth, 1e-15 * kMore / kDepth);
}

INSTANTIATE_TEST_SUITE_P(Schemes, ExactContactInSchemes, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::barycentric ? "barycentric" : "clipped";
                         });

TEST(ExactContact, ApartThereIsNoForceAndNothingIsOfAnySize) {
  const ExactBodies boxes(generate::box({1, 1, 1}), generate::box({1, 1, 1}));
  Pose pose;
  pose.r.x() = 5;
  ExactContact contact(boxes, pose, Scheme::clipped);
  EXPECT_FALSE(contact.carries_force());
  EXPECT_EQ(contact.sizes(), Figures{});
}

}  // namespace
}  // namespace pcm::compare::stability
