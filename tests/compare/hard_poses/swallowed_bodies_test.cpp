// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies so far from an origin that doubles do not hold their shape: in their own frame they are refused by a stated
// rule, and where it is the position that swallows them, engine and oracle answer alike what is left.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "compare/random/random.h"
#include "compare/verify/routes/held_pairing.h"
#include "meshes/generate/boxes.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"

namespace pcm::compare {
namespace {

TriangleMesh moved_by(TriangleMesh mesh, double way) {
  for (Eigen::Vector3d& x : mesh.vertices) x += Eigen::Vector3d::Constant(way);
  return mesh;
}

TEST(SwallowedBodies, From2To53SizesFromTheOriginOfItsFrameABoxIsRefusedAndNotBefore) {
  for (int k = 20; k <= 52; ++k)
    EXPECT_NO_THROW(require_fit(moved_by(generate::box({1, 1, 1}), std::ldexp(1, k)))) << k;
  for (int k = 53; k <= 56; ++k) try {
      require_fit(moved_by(generate::box({1, 1, 1}), std::ldexp(1, k)));
      ADD_FAILURE() << k;
    } catch (const BadInput& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("12 faces of zero area"), std::string::npos) << refusal.what();
    }
}

/// A body of size 1 at a side of one 2^(k + 2) times as large, whose middle is 2^(k + 1) away.
class SwallowedByThePosition : public testing::TestWithParam<int> {};

TEST_P(SwallowedByThePosition, EngineAndOracleAnswerAlikeWhatRoundingLeaves) {
  const double far = std::ldexp(1, GetParam() + 1);
  const TriangleMesh large = generate::box({2 * far, 2 * far, 2 * far}), cube = generate::box({1, 1, 1}),
                     wedge = generate::wedge(30, 1, 1, 2);
  int touching = 0;
  for (const TriangleMesh& small : {cube, wedge})
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const HeldPairing held(large, small, {}, HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, scheme);
      fast::Workspace workspace;
      PoseRandom random(1, 0, 0, 0);
      for (int i = 0; i < 8; ++i) {
        Pose pose;
        if (i > 0) pose.A = random.rotation();
        pose.r = {far - random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        for (const PoseOutcome& outcome : held.hold(pose, {{1, 2, 3}, {0, 0, 1}}, workspace)) {
          touching += outcome.touching ? 1 : 0;
          for (const Disagreement& d : outcome.disagreements) ADD_FAILURE() << name(d.kind) << ": " << d.text;
        }
      }
    }
  EXPECT_EQ(touching > 0, GetParam() <= 52);  // then all vertices of the small body lie in that side
}

INSTANTIATE_TEST_SUITE_P(Offsets, SwallowedByThePosition, testing::Values(20, 40, 44, 52, 53, 56));

}  // namespace
}  // namespace pcm::compare
