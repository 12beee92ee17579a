// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/dynamic_closed_forms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/bodies/polyhedral_foundation.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"

/// The expected values of the dynamic known answers, against numbers computed elsewhere and against each other.
namespace pcm::compare {
namespace {

TEST(DynamicClosedForms, RestitutionOfAFlatBounceHasTheTabulatedDigits) {
  const double table[][4] = {{0.1, .729248, .744079, .862600},
                             {0.2, .526621, .571740, .756135},
                             {0.3, .372326, .450975, .671547},
                             {0.5, .163034, .298436, .546293}};
  for (const auto& [z, full, no_tension, compression] : table) {
    EXPECT_NEAR(flat_restitution(z, DampingMode::full), full, 5e-7) << z;
    EXPECT_NEAR(flat_restitution(z, DampingMode::no_tension), no_tension, 5e-7) << z;
    EXPECT_NEAR(flat_restitution(z, DampingMode::compression), compression, 5e-7) << z;
  }
}

TEST(DynamicClosedForms, RestitutionInTheTransitionDepthHasTheTabulatedDigits) {
  const double table[][2] = {{.1, .937476}, {.3, .832870}, {1, .593624}, {3, .306897}};
  for (const auto& [a, e] : table) EXPECT_NEAR(faded_restitution(a), e, 5e-7) << a;
}

TEST(DynamicClosedForms, DropOfASphereHasTheTabulatedDigits) {
  const double k = std::numbers::pi * 1.17857e6 * 0.2;
  const Drop without = quadratic_drop(k, {2, 4.42945, 0});
  EXPECT_NEAR(without.depth, 42.996e-3, 5e-7);
  EXPECT_NEAR(without.contact_time, 27.2216e-3, 5e-8);
  EXPECT_NEAR(without.force, 1368.96, 5e-3);
  EXPECT_NEAR(without.depth, std::cbrt(3 * 2 * 4.42945 * 4.42945 / (2 * k)), 1e-16);
  EXPECT_NEAR(without.contact_time, 2 * 1.4021821 * without.depth / 4.42945, 1e-9);
  const Drop with = quadratic_drop(k, {2, 4.42945, 9.81});
  EXPECT_NEAR(with.depth, 43.612e-3, 5e-7);
  EXPECT_NEAR(with.contact_time, 27.339e-3, 5e-7);
  EXPECT_NEAR(with.force, 1408.48, 5e-3);
  EXPECT_NEAR(std::sqrt(2 * 9.81 / k), 5.1473e-3, 5e-8);
}

TEST(DynamicClosedForms, FrictionHasTheTabulatedDigits) {
  EXPECT_NEAR(creep_speed(0.2, 0.25), .5528, 5e-5);
  EXPECT_NEAR(stopping_distance(2, 0.3, 0, 9.81), 4 / (2 * 0.3 * 9.81), 1e-15);
  EXPECT_NEAR(stopping_distance(0.5, 0.3, 0.5, 9.81), 0.25 / (0.3 * 9.81) * std::log(2.0), 1e-15);
}

TEST(DynamicClosedForms, PolyhedralDropTendsToTheSpheres) {
  const double K = 1.17857e6, r = 0.2, k = std::numbers::pi * K * r;
  const Dropped body{2, 4.42945, 9.81};
  const Drop smooth = quadratic_drop(k, body);
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    double last = 1;
    for (const Index level : {3, 4, 5}) {
      const Drop drop = polyhedral_drop({generate::icosphere(r, level), K, scheme}, -r, 0, body);
      const double error = std::abs(drop.contact_time / smooth.contact_time - 1);
      EXPECT_LT(error, 0.4 * last) << level;
      EXPECT_LT(std::abs(drop.depth / smooth.depth - 1), 2 * error);
      last = error;
    }
  }
}

TEST(PolyhedralFoundation, WorkIsTheIntegralOfForce) {
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const PolyhedralFoundation foundation(generate::icosphere(1, 2), 3, scheme);
    const double low = -0.9, high = -0.4;
    const int n = 20000;
    double work = foundation.work(low);
    for (int i = 0; i < n; ++i) work += foundation.force(low + (high - low) * (i + 0.5) / n) * (high - low) / n;
    EXPECT_NEAR(foundation.work(high), work, 1e-8 * work);
  }
}

TEST(PolyhedralFoundation, BarycentricForceIsTheEngines) {
  const TriangleMesh sphere = generate::icosphere(1, 3);
  const PolyhedralFoundation foundation(sphere, 7, Scheme::barycentric);
  ContactLaw law;
  law.stiffness = 7;
  const fast::Pairing pairing(fast::Surface(generate::plate(6, 6, 2)), fast::Surface(sphere), law, Mode::F);
  fast::Workspace workspace;
  for (const double h : {0.03, 0.1, 0.3}) {
    Pose pose;
    pose.r = {0.1, 0.2, 1 - h};
    const double force = -fast::evaluate(pairing, pose, {}, {}, workspace).force_Me.z();
    EXPECT_NEAR(foundation.force(h - 1), force, 1e-14 * force / h);
  }
}

}  // namespace
}  // namespace pcm::compare
