// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/savings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "compare/contact/contact_json.h"
#include "compare/poses/extreme_meshes.h"
#include "compare/poses/pairs.h"
#include "compare/poses/strata.h"
#include "fast/base/geometry.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"
#include "pcm/scene.h"
#include "reference/oracle.h"
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

/// A scene of the two bodies answers as `evaluate` does at the pose and in small steps from it.
void expect_the_same_of_a_scene(const fast::Pairing& pairing, const DrawnPose& drawn, fast::Workspace& one,
                                fast::Workspace& other) {
  if (fast::orthogonality_error(drawn.pose.A) > 1e-10) return;  // Such rotations a scene refuses.
  fast::Scene scene;
  scene.add_body(pairing.surface_E());
  scene.add_body(pairing.surface_F());
  scene.add_pairing(0, 1, pairing.law(), pairing.mode(), pairing.scheme());
  fast::BodyState E, F{drawn.pose, drawn.velocity};
  for (int step = 0; step < 4; ++step) {
    scene.move({E, F});
    fast::test::expect_same_answer(scene.evaluate(0, one), fast::evaluate(pairing, F.pose, F.velocity, {}, other));
    F.pose.r *= 1 + 1e-4;
  }
}

struct Bodies {
  TriangleMesh E, F;
};

/// The bodies as the stratum takes them: for nested made fit, none where they can't be; for extreme one extreme after
/// the other.
std::optional<NestedMeshes> meshes_for(Stratum stratum, const Bodies& bodies, std::size_t number) {
  if (stratum == Stratum::nested) return nested_meshes(bodies.E, bodies.F);
  if (stratum == Stratum::extreme) {
    auto [E, F] = extreme_meshes(bodies.E, bodies.F, number % kExtremes);
    return NestedMeshes{std::move(E), std::move(F), {}, Side::E};
  }
  return NestedMeshes{bodies.E, bodies.F, {}, Side::E};
}

class SavingsOverStrata : public testing::TestWithParam<Stratum> {};

TEST_P(SavingsOverStrata, EachSwitchedOffChangesNoBitOfAnyAnswer) {
  const std::array<Bodies, 4> pairs{{{generate::bubble(), generate::bubble()},
                                     {generate::pyramid(), generate::icosphere(0.5, 1)},
                                     {generate::gridded_box(1, 2), generate::gridded_box(1, 2)},
                                     {generate::torus(0.5, 0.25, 8, 6), generate::box({1, 1, 1})}}};
  const std::array<Wanted, 6> wanted = questions();
  fast::Workspace one, other;
  int touching = 0, looked_at = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    for (std::size_t pose = 0; pose < 12; ++pose) {
      const std::optional<NestedMeshes> bodies = meshes_for(GetParam(), pairs[p], 12 * p + pose);
      if (!bodies) continue;
      const FeaturePair features(*bodies);
      const fast::Surface E(bodies->E), F(bodies->F);
      const DrawnPose drawn =
          draw_pose(GetParam(), features, PoseRandom(31, static_cast<std::uint64_t>(GetParam()), p, pose));
      const ContactLaw law = verification_law(pose, bodies->E, bodies->F);
      const auto mode = static_cast<Mode>(pose % 3);
      const Scheme scheme = pose % 2 == 0 ? Scheme::barycentric : Scheme::clipped;
      const fast::Pairing pairing(E, F, law, mode, scheme);
      expect_the_same_of_a_scene(pairing, drawn, one, other);
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
  EXPECT_GT(looked_at, 1000);
  if (GetParam() != Stratum::separated && GetParam() != Stratum::nested) {
    EXPECT_GT(touching, 50);
  }
}

TEST_P(SavingsOverStrata, OracleLiftsFacesNearAndEverywhereWithTheSameBits) {
  const std::array<Bodies, 3> pairs{{{generate::pyramid(2, 1), generate::icosphere(0.5, 1)},
                                     {generate::box({1, 1, 1}), generate::gridded_box(1, 2)},
                                     {generate::rectangle(1, 1, 2, 2), generate::torus(0.5, 0.25, 6, 4)}}};
  std::size_t near_pairs = 0, all_pairs = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    for (std::size_t pose = 0; pose < 6; ++pose) {
      const std::optional<NestedMeshes> bodies = meshes_for(GetParam(), pairs[p], 6 * p + pose);
      if (!bodies) continue;
      const FeaturePair features(*bodies);
      const DrawnPose drawn =
          draw_pose(GetParam(), features, PoseRandom(33, static_cast<std::uint64_t>(GetParam()), p, pose));
      const ContactLaw law = verification_law(pose, bodies->E, bodies->F);
      const Scheme scheme = pose % 2 == 0 ? Scheme::barycentric : Scheme::clipped;
      using reference::CandidateRegion;
      const reference::Oracle near(bodies->E, bodies->F, law, Mode::both, scheme);
      const reference::Oracle everywhere(bodies->E, bodies->F, law, Mode::both, scheme, CandidateRegion::everywhere);
      reference::Inquiry one(near, drawn.pose, drawn.velocity), other(everywhere, drawn.pose, drawn.velocity);
      for (const reference::Problem problem : {reference::Problem::rounded, reference::Problem::exact}) {
        EXPECT_EQ(contact_json(one.answer(problem)).dump(), contact_json(other.answer(problem)).dump())
            << name(GetParam()) << ", pair " << p << ", pose " << pose;
        near_pairs += one.candidate_pairs(problem);
        all_pairs += other.candidate_pairs(problem);
      }
      EXPECT_EQ(other.candidate_pairs(reference::Problem::exact), bodies->E.faces.size() * bodies->F.faces.size());
    }
  }
  EXPECT_LT(2 * near_pairs, all_pairs);
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
  EXPECT_LT(work(force, nullptr).elements, work(force, &Savings::one_sided).elements);
  EXPECT_EQ(work(force, nullptr).velocities, 0);
  EXPECT_GT(work(force, &Savings::velocities).velocities, 10);
  EXPECT_EQ(work(touch, nullptr).elements, 0);
  EXPECT_GT(work(touch, &Savings::only_wanted).elements, 10);
}

}  // namespace
}  // namespace pcm::compare
