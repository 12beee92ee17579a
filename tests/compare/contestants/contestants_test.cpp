// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Engines of others, asked as `pcm judge --command` asks them. Where every engine must be right, away from
// coincidences, whatever one gets wrong is our mistake in asking it: a rotation transposed, bodies exchanged, a pair
// left out.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/judge/engines/asked_engine.h"
#include "compare/judge/judgement/judge.h"
#include "compare/judge/poses/poses_folder.h"
#include "compare/judge/poses/poses_writer.h"
#include "compare/judge/poses/write_poses.h"
#include "meshes/files/text_file.h"
#include "meshes/generate/boxes.h"
#include "tests/compare/small_pair.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

struct Expected {
  std::string engine;
  std::vector<Stratum> strata;  ///< in which it must be right
  std::vector<Fact> facts;      ///< all that it answers, but for forces
};

std::string program(const std::string& engine) {
  return std::string(PCM_CONTESTANTS_DIR) + "/" + engine;
}

bool is_built(const std::string& engine) {
  return std::filesystem::exists(program(engine));
}

/// Away from coincidences; their bodies are asked about at rest, with stiffness alone.
PosedQuestions asked_questions(const std::filesystem::path& folder, std::vector<Stratum> strata) {
  VerificationPlan plan;
  plan.poses = 24 * std::ssize(strata);
  plan.strata = std::move(strata);
  plan.schemes = {Scheme::barycentric};
  plan.modes = {Mode::E};
  plan.pairs = {small_pair()};
  write_poses(
      folder, PlannedPoses(std::move(plan)), PosedLaw::elastic, Notation::decimal, 2, [] { return false; },
      [](std::int64_t) {});
  return read_poses_folder(folder);
}

/// Intersection points are rounded.
Tolerances rounded_points() {
  Tolerances tolerances;
  tolerances.add("--absolute", {"area=1e-12", "volume=1e-12"}, &Tolerance::absolute);
  return tolerances;
}

class Contestants : public testing::TestWithParam<Expected> {};

TEST_P(Contestants, AreRightAwayFromCoincidences) {
  const auto& [engine, strata, facts] = GetParam();
  if (!is_built(engine)) GTEST_SKIP() << engine << " is not installed: its contestant was not built";
  const TemporaryFolder scratch;
  const PosedQuestions posed = asked_questions(scratch.path("poses"), strata);
  const Tolerances tolerances = rounded_points();
  const Judge judge(posed, tolerances, 0);
  AskedEngine asked("'" + program(engine) + "'", posed, scratch.path("poses"), Conversation::Seconds(60));
  for (std::size_t k = 0; k < posed.questions.size(); ++k) {
    const PosedQuestion& question = posed.questions[k];
    const Reply reply = asked.ask(k).value();
    ASSERT_FALSE(reply.breakdown) << question.id << ": " << reply.failure;
    std::vector<Fact> judged;
    for (const FactVerdict& fact : judge.judge(question, reply.answer).facts) {
      if (fact.fact >= Fact::force) continue;
      judged.push_back(fact.fact);
      EXPECT_EQ(fact.verdict, Verdict::right) << question.id << ": " << name(fact.fact) << ": " << fact.text;
    }
    EXPECT_EQ(judged, facts) << question.id;
  }
}

// Bullet makes contact points for faces that lie behind one another, and so for nested bodies; Simbody finds no contact
// there at all.
INSTANTIATE_TEST_SUITE_P(
    All, Contestants,
    testing::Values(Expected{"bullet", {Stratum::generic}, {Fact::touching}},
                    Expected{"cgal",
                             {Stratum::generic, Stratum::separated, Stratum::nested},
                             {Fact::touching, Fact::area, Fact::volume}},
                    Expected{"embree",
                             {Stratum::generic, Stratum::separated, Stratum::nested},
                             {Fact::touching, Fact::crossing_pairs}},
                    Expected{"fcl",
                             {Stratum::generic, Stratum::separated, Stratum::nested},
                             {Fact::touching, Fact::crossing_pairs}},
                    Expected{"ode", {Stratum::generic, Stratum::nested}, {Fact::touching}},
                    Expected{"simbody", {Stratum::generic, Stratum::separated}, {Fact::touching, Fact::active_faces}}),
    [](const testing::TestParamInfo<Expected>& test) { return test.param.engine; });

/// A cube of edge 0.5 m, its faces divided into so many cells along each edge, under one of edge 1, turned about the
/// vertical: 0.05 m deep on 0.25 m^2, 12500 N by the law of both.
Reply flat_contact(int cells) {
  const TemporaryFolder scratch;
  PosedSurfaces surfaces;
  PosedQuestion question;
  question.id = question.pair = question.stratum = "flat";
  question.E = surfaces.number_of(generate::gridded_box(0.5, cells));
  question.F = surfaces.number_of(generate::box({1, 1, 1}));
  question.pose.A = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  question.pose.r = {0.1, 0, 0.7};
  question.mode = Mode::E;
  PosesWriter writer(scratch.path("."), surfaces, 1, "a test");
  writer.add(dump_exactly(pose_json(question, surfaces.surfaces(), Notation::decimal)));
  writer.finish();
  const PosedQuestions posed = read_poses_folder(scratch.path("."));
  return AskedEngine("'" + program("simbody") + "'", posed, scratch.path("."), Conversation::Seconds(60))
      .ask(0)
      .value();
}

/// On faces that are as large as the sides of the cube no spring at a side is inside F, and Simbody's law is ours.
TEST(SimbodyContestant, HasTheForceOfAFlatContact) {
  if (!is_built("simbody")) GTEST_SKIP() << "Simbody is not installed: its contestant was not built";
  const Reply reply = flat_contact(1);
  ASSERT_FALSE(reply.breakdown) << reply.failure;
  ASSERT_TRUE(reply.answer.force_Me && reply.answer.torque_Me);
  // The force acts at E's origin, 0.1 m beside F's: (-0.1, 0, z) x (0, 0, -12500).
  EXPECT_LT((*reply.answer.force_Me - Eigen::Vector3d(0, 0, -12500)).norm(), 1e-6);
  EXPECT_LT((*reply.answer.torque_Me - Eigen::Vector3d(0, -1250, 0)).norm(), 1e-6);
}

/// Springs at the sides push too, for the nearest point of F is above them: with cells of just the depth h = 0.05, the
/// four uppermost rows add 4 * 0.5 m * h at a mean depth of h / 2, a fifth of 0.25 m^2 * h (docs/peers.md).
TEST(SimbodyContestant, AddsAFifthWhereSidesAreDivided) {
  if (!is_built("simbody")) GTEST_SKIP() << "Simbody is not installed: its contestant was not built";
  const Reply reply = flat_contact(10);
  ASSERT_FALSE(reply.breakdown) << reply.failure;
  ASSERT_TRUE(reply.answer.force_Me);
  EXPECT_LT((*reply.answer.force_Me - Eigen::Vector3d(0, 0, -1.2 * 12500)).norm(), 1e-6);
}

TEST(Contestant, WhatIsNoPoseEndsIt) {
  if (!is_built("cgal")) GTEST_SKIP() << "no contestant was built";
  Conversation conversation({program("cgal")}, "{\"format\":\"pcm poses 0\"}", Conversation::Seconds(60));
  const Conversation::Said said = conversation.ask("{}").value();
  EXPECT_EQ(said.breakdown, Breakdown::crash);
  EXPECT_NE(said.failure.find("status 2"), std::string::npos) << said.failure;
}

/// The script of `./run peers`, whole, with a pose of each pair in each stratum: every engine that is there is judged,
/// our own is right.
TEST(JudgeContestants, JudgesAllThatAreThere) {
  const TemporaryFolder scratch;
  const std::string script = std::string(PCM_SOURCE_DIR) + "/compare/contestants/judge_contestants.sh";
  const std::string out = scratch.path("peers");
  ASSERT_EQ(std::system(("sh '" + script + "' '" PCM_PROGRAMS_DIR "' '" + out + "' 48 > /dev/null").c_str()), 0);
  for (const std::string engine : {"bullet", "cgal", "embree", "fcl", "ode", "simbody"})
    EXPECT_EQ(std::filesystem::exists(out + "/" + engine + "/judgement.md"), is_built(engine)) << engine;
  const auto judged = nlohmann::json::parse(read_text_file(out + "/pcm/judgement.json"));
  EXPECT_EQ(judged.at("complete"), true);
  EXPECT_TRUE(judged.at("wrong_answers").empty());
  EXPECT_EQ(judged.at("strata").size(), 7U);  // and all
}

}  // namespace
}  // namespace pcm::compare
