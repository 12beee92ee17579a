// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/savings.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "compare/pairs.h"
#include "compare/strata.h"
#include "fast/engine.h"
#include "meshes/generate_boxes.h"
#include "meshes/generate_bubbles.h"
#include "meshes/generate_round.h"
#include "tests/fast/same_answer.h"

namespace pcm::compare {
namespace {

using fast::Savings;

struct Switch {
  const char* name;
  bool Savings::*saving;
};

constexpr std::array<Switch, 6> kSwitches{{{"first_crossing", &Savings::first_crossing},
                                           {"lazy_vertices", &Savings::lazy_vertices},
                                           {"one_sided", &Savings::one_sided},
                                           {"velocities", &Savings::velocities},
                                           {"only_wanted", &Savings::only_wanted},
                                           {"filters", &Savings::filters}}};

std::array<Wanted, 6> questions() {
  std::array<Wanted, 6> wanted;
  wanted[1] = {false, false, false, false, false, false};  // touch
  wanted[2] = {false, false, true, false, false, false};   // force
  wanted[3] = {true, false, false, false, false, false};   // polygons
  wanted[4] = {false, false, false, false, false, true};   // statistics
  wanted[5] = {false, true, false, false, true, false};    // areas and bound
  return wanted;
}

class SavingsOverStrata : public testing::TestWithParam<Stratum> {};

TEST_P(SavingsOverStrata, EachSwitchedOffChangesNoBitOfAnyAnswer) {
  struct Bodies {
    TriangleMesh E, F;
  };
  const std::array<Bodies, 4> pairs{{{generate::bubble(), generate::bubble()},
                                     {generate::pyramid(), generate::icosphere(0.5, 1)},
                                     {generate::gridded_box(1, 2), generate::gridded_box(1, 2)},
                                     {generate::torus(0.5, 0.25, 8, 6), generate::box({1, 1, 1})}}};
  const std::array<Wanted, 6> wanted = questions();
  fast::Workspace one, other;
  int touching = 0, looked_at = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    Bodies bodies = pairs[p];
    FeaturePair features(bodies.E, bodies.F);
    if (GetParam() == Stratum::nested) {
      std::optional<NestedMeshes> nested = nested_meshes(bodies.E, bodies.F);
      if (!nested) continue;
      bodies = {nested->E, nested->F};
      features = FeaturePair(bodies.E, bodies.F);
      features.ball = nested->ball;
      features.host = nested->host;
    }
    const fast::Surface E(bodies.E), F(bodies.F);
    for (std::size_t pose = 0; pose < 24; ++pose) {
      const DrawnPose drawn =
          draw_pose(GetParam(), features, PoseRandom(31, static_cast<std::uint64_t>(GetParam()), p, pose));
      const ContactLaw law = verification_law(pose, bodies.E, bodies.F);
      const auto mode = static_cast<Mode>(pose % 3);
      const Scheme scheme = pose % 2 == 0 ? Scheme::barycentric : Scheme::clipped;
      const fast::Pairing pairing(E, F, law, mode, scheme);
      for (std::size_t w = 0; w < wanted.size(); ++w) {
        const fast::Contact& all_on = fast::evaluate(pairing, drawn.pose, drawn.velocity, wanted[w], one);
        touching += all_on.touching;
        for (std::size_t k = 0; k <= kSwitches.size(); ++k) {
          SCOPED_TRACE(std::string(name(GetParam())) + ", pair " + std::to_string(p) + ", pose " +
                       std::to_string(pose) + ", question " + std::to_string(w) + ", without " +
                       (k < kSwitches.size() ? kSwitches[k].name : "any"));
          Savings savings = k < kSwitches.size() ? Savings{} : Savings::none();
          if (k < kSwitches.size()) savings.*kSwitches[k].saving = false;
          fast::test::expect_same_answer(
              all_on, fast::evaluate(pairing, drawn.pose, drawn.velocity, wanted[w], other, savings));
          ++looked_at;
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(looked_at, 2000);
  if (GetParam() != Stratum::separated && GetParam() != Stratum::nested) {
    EXPECT_GT(touching, 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Strata, SavingsOverStrata, testing::ValuesIn(kStrata),
                         [](const testing::TestParamInfo<Stratum>& stratum) {
                           std::string word(name(stratum.param));
                           std::replace(word.begin(), word.end(), '-', '_');
                           return word;
                         });

TEST(SavingsCounters, TellTheWorkThatEachSaves) {
  const fast::Surface bubble(generate::bubble());
  Pose pose;
  pose.r = {0.05, 0.1, 0.12};
  fast::Workspace workspace;
  const fast::Pairing pairing(bubble, bubble);
  const auto work = [&](const Wanted& wanted, bool Savings::*off) {
    Savings savings;
    if (off != nullptr) savings.*off = false;
    return fast::evaluate(pairing, pose, {}, wanted, workspace, savings).work;
  };
  const Wanted touch{false, false, false, false, false, false}, force{false, false, true, false, false, false};
  EXPECT_LT(2 * work(touch, nullptr).candidate_pairs, work(touch, &Savings::first_crossing).candidate_pairs);
  EXPECT_LT(2 * work(force, nullptr).vertices_transformed, work(force, &Savings::lazy_vertices).vertices_transformed);
  EXPECT_LT(2 * work(force, nullptr).exact_predicates + 100, work(force, &Savings::filters).exact_predicates);
  EXPECT_LT(work(force, nullptr).predicates, work(force, &Savings::one_sided).predicates);
}

}  // namespace
}  // namespace pcm::compare
