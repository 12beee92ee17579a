// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/tangent_verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "compare/poses/rounded_vertices.h"
#include "compare/verify/bounds/tangent_bounds.h"
#include "compare/verify/routes/held_pairing.h"
#include "tests/compare/small_pair.h"

namespace pcm::compare {
namespace {

constexpr std::uint64_t kSeed = 31;

/// A law with everything in it, but no threshold that elements are just at.
ContactLaw law_of_all() {
  ContactLaw law;
  law.layers = LayerStiffness{3e6, 1e6};
  law.damping = 300;
  law.transition_depth = 0.01;
  law.friction = 0.3;
  law.slip_velocity = 0.5;
  return law;
}

/// Poses of two small bodies that move, the engine's tangent there and the oracle's.
template <class Visit>
void for_each_tangent(Scheme scheme, Stratum stratum, Mode mode, int count, const Visit& visit) {
  const SurfacePair pair = small_pair();
  const ContactLaw law = law_of_all();
  const Velocity velocity{{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}};
  const HeldPairing held(pair.E, pair.F, law, mode, scheme);
  fast::Workspace workspace;
  Wanted wanted;
  wanted.tangent = true;
  int found = 0;
  for (std::uint64_t i = 0; found < count; ++i) {
    ASSERT_LT(i, 10000U);
    const Pose pose = draw_pose(stratum, held.features(), PoseRandom(kSeed, 2, 0, i)).pose;
    const fast::Contact& subj = fast::evaluate(held.engine(), pose, velocity, wanted, workspace);
    if (subj.element_count == 0) continue;
    ++found;
    reference::Inquiry inquiry(held.oracle(), pose, velocity, {}, law, scheme);
    visit(held.question(pose, velocity), subj, inquiry.answer(reference::Problem::rounded, mode),
          inquiry.tangent(reference::Problem::rounded, mode));
  }
}

bool is_flagged(const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                const reference::Tangent& truth) {
  Checks checks;
  check_tangent(subj, truth, allowed_errors(question, subj.elements, answer, truth), checks);
  return !checks.disagreements().empty();
}

class TangentVerdict : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, TangentVerdict, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::clipped ? "clipped" : "barycentric";
                         });

TEST_P(TangentVerdict, PassesTheEnginesAndFlagsEveryBlockThatIsOff) {
  // Parts of faces are off by their outlines, faces by nothing.
  const double off = GetParam() == Scheme::clipped ? 1e-6 : 1e-9;
  int blocks = 0, flagged = 0;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both})
    for_each_tangent(GetParam(), Stratum::generic, mode, 60,
                     [&](const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                         const reference::Tangent& truth) {
                       EXPECT_FALSE(is_flagged(question, subj, answer, truth));
                       const bool shallow = !(coordinate_scale(question.E.mesh, question.F.mesh, question.pose) <
                                              1e3 * mean_thickness(answer));
                       if (shallow) return;
                       for (int row = 0; row < 6; row += 3)
                         for (int column = 0; column < 12; column += 3) {
                           fast::Contact altered = subj;
                           const auto block = altered.tangent->block<3, 3>(row, column);
                           if (block.isZero(0)) continue;
                           altered.tangent->block<3, 3>(row, column) = (1 + off) * block;
                           ++blocks;
                           flagged += is_flagged(question, altered, answer, truth);
                         }
                     });
  EXPECT_GT(blocks, 400);
  EXPECT_GE(flagged, 0.97 * blocks) << "of " << blocks;
}

TEST_P(TangentVerdict, PassesTheEnginesAtKinks) {
  for (const Stratum stratum : {Stratum::degenerate, Stratum::near_degenerate, Stratum::adversarial})
    for (const Mode mode : {Mode::E, Mode::F, Mode::both})
      for_each_tangent(GetParam(), stratum, mode, 12,
                       [&](const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                           const reference::Tangent& truth) {
                         EXPECT_FALSE(is_flagged(question, subj, answer, truth)) << name(stratum);
                       });
}

TEST_P(TangentVerdict, FlagsOneThatIsMissingOrNoNumber) {
  for_each_tangent(GetParam(), Stratum::generic, Mode::both, 5,
                   [&](const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                       const reference::Tangent& truth) {
                     fast::Contact altered = subj;
                     (*altered.tangent)(5, 11) = std::nan("");
                     EXPECT_TRUE(is_flagged(question, altered, answer, truth));
                     altered.tangent.reset();
                     EXPECT_TRUE(is_flagged(question, altered, answer, truth));
                   });
}

TEST_P(TangentVerdict, BoundsHangOnRoundingsAlone) {
  const double widest = GetParam() == Scheme::clipped ? 1e-3 : 1e-6;
  for_each_tangent(GetParam(), Stratum::generic, Mode::both, 40,
                   [&](const Question& question, const fast::Contact&, const reference::Answer& answer,
                       const reference::Tangent& truth) {
                     const fast::Tangent bounds = tangent_bounds(question, answer, truth.elements);
                     EXPECT_GT(bounds.maxCoeff(), 0);
                     EXPECT_LT(bounds.leftCols(6).norm(), widest * truth.slope.leftCols(6).norm());
                   });
}

TEST(ClippedTangentVerdict, MayBeRefusedWhereWhatIsAllowedReachesBeyondAllDoubles) {
  constexpr double kMost = std::numeric_limits<double>::max();
  reference::Tangent truth;
  fast::Tangent allowed = fast::Tangent::Constant(1);
  EXPECT_FALSE(may_overflow(truth, allowed));
  truth.slope(3, 9) = -kMost;
  EXPECT_FALSE(may_overflow(truth, allowed));
  allowed(3, 9) = kMost / 2;
  EXPECT_TRUE(may_overflow(truth, allowed));
  truth.slope(3, 9) = 0;
  EXPECT_FALSE(may_overflow(truth, allowed));
  allowed(5, 11) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(may_overflow(truth, allowed));
}

}  // namespace
}  // namespace pcm::compare
