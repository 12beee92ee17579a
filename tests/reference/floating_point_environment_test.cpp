// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/base/floating_point_environment.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <random>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/round.h"
#include "reference/oracle.h"
#include "reference/proofs/identities.h"
#include "reference/proofs/self_intersections.h"
#include "tests/reference/poses.h"

/// The oracle's answers do not depend on the environment a host has set up, and leave it as it was.
namespace pcm::reference {
namespace {

constexpr unsigned kFlushToZeroAndDenormalsAreZero = 0x8040;  // of MXCSR

struct Host {
  int rounding;
  unsigned set = 0;  ///< bits of MXCSR
};

class OracleOfHost : public testing::TestWithParam<Host> {
 protected:
  /// What `function` gives in the host's environment.
  template <class Function>
  static auto asked_by_host(const Function& function) {
    const int rounding = std::fegetround();
    std::fesetround(GetParam().rounding);
#if defined(__SSE2__)
    const unsigned control = _mm_getcsr();
    _mm_setcsr(control | GetParam().set);
    const unsigned entered = _mm_getcsr();
#endif
    auto result = function();
    EXPECT_EQ(std::fegetround(), GetParam().rounding);
#if defined(__SSE2__)
    EXPECT_EQ(_mm_getcsr(), entered);
    _mm_setcsr(control);
#endif
    std::fesetround(rounding);
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(Environments, OracleOfHost,
                         testing::Values(Host{FE_UPWARD}, Host{FE_DOWNWARD}, Host{FE_TOWARDZERO},
                                         Host{FE_TONEAREST, kFlushToZeroAndDenormalsAreZero}));

/// Of a size at which products of coordinates are denormal where `scale` is small.
struct Bodies {
  TriangleMesh E = generate::icosphere(1, 1);
  TriangleMesh F = degenerate::joined(generate::icosphere(0.7, 0), degenerate::spike());
  Pose pose;

  explicit Bodies(double scale) {
    std::mt19937_64 random(7);
    pose = random_pose(random, 0);
    pose.r = {0.3, 1.0 / 3, 0.9};
    for (TriangleMesh* const mesh : {&E, &F})
      for (Eigen::Vector3d& x : mesh->vertices) x *= scale;
    pose.r *= scale;
  }
};

TEST_P(OracleOfHost, AnswersAlike) {
  ContactLaw law;
  law.friction = 0.3;
  law.damping = 100;
  law.max_penetration = 0.1;
  Velocity velocity;
  velocity.v = {0.1, -0.7, 0.3};
  for (const double scale : {1.0, 0x1p-260}) {
    const Bodies bodies(scale);
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const auto answers = [&] {
        const Oracle oracle(bodies.E, bodies.F, law, Mode::both, scheme);
        Inquiry inquiry(oracle, bodies.pose, velocity);
        std::vector<Answer> both{inquiry.answer(Problem::rounded), inquiry.answer(Problem::exact)};
        both.push_back(oracle.answer(Problem::exact, bodies.pose, velocity));
        both.push_back(Inquiry(oracle, bodies.pose, velocity).facts(Problem::rounded, Mode::E));
        return both;
      };
      const std::vector<Answer> expected = answers();
      EXPECT_GT(expected[0].elements.size(), 10u);
      EXPECT_TRUE(asked_by_host(answers) == expected);
    }
  }
}

TEST_P(OracleOfHost, ProvesAlike) {
  const Bodies bodies(1);
  for (const Problem problem : {Problem::rounded, Problem::exact}) {
    const auto prove = [&] { return prove_identities(bodies.E, bodies.F, problem, bodies.pose); };
    const Identities expected = prove(), found = asked_by_host(prove);
    EXPECT_TRUE(found.vector_areas_cancel && found.fluxes_agree && found.limit_closes);
    EXPECT_GT(found.volume, 0);
    EXPECT_EQ(found.volume, expected.volume);
  }
}

TEST_P(OracleOfHost, FindsSelfIntersectionsAlike) {
  const Bodies bodies(0x1p-260);
  const auto find = [&] { return self_intersections(bodies.F); };
  const auto expected = find();
  EXPECT_EQ(asked_by_host(find), expected);
}

}  // namespace
}  // namespace pcm::reference
