// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compare/hard_poses/search_report.h"
#include "compare/io/names.h"
#include "compare/verify/run/held_again.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

SearchPlan plan_of_cubes(std::int64_t climbs) {
  SearchPlan plan;
  plan.climbs = climbs;
  plan.seed = 3;
  plan.pairs = searched_pairs();
  std::erase_if(plan.pairs, [](const SurfacePair& pair) { return pair.name != "cube-cube"; });
  return plan;
}

SearchReport searched(const SearchPlan& plan, KeptValues& kept, int jobs = 2,
                      const EngineSeam& seam = EngineSeam::none()) {
  return search(
      plan, jobs, kept, [] { return false; }, [](std::int64_t) {}, seam);
}

SearchReport searched(const SearchPlan& plan, int jobs = 2, const EngineSeam& seam = EngineSeam::none()) {
  KeptValues nothing;
  return searched(plan, nothing, jobs, seam);
}

void expect_same(const SearchReport& a, const SearchReport& b) {
  ASSERT_EQ(a.climbs.size(), b.climbs.size());
  for (std::size_t k = 0; k < a.climbs.size(); ++k) {
    EXPECT_EQ(a.climbs[k].name, b.climbs[k].name);
    EXPECT_EQ(a.climbs[k].begun_at, b.climbs[k].begun_at);
    EXPECT_EQ(a.climbs[k].reached, b.climbs[k].reached);
    EXPECT_EQ(format_case(a.climbs[k].hardest, {}, {}), format_case(b.climbs[k].hardest, {}, {}));
  }
}

TEST(Search, ClimbsToEveryGoalInBothSchemesTheSameOnAnyNumberOfThreads) {
  const SearchPlan plan = plan_of_cubes(0);
  const SearchReport report = searched(plan);
  EXPECT_EQ(report.climbs.size(), 10U);
  EXPECT_TRUE(report.finished());
  EXPECT_EQ(report.disagreeing(), 0);
  std::set<std::pair<Goal, Scheme>> kinds;
  for (const Climbed& climbed : report.climbs) {
    kinds.insert({climbed.goal, climbed.hardest.scheme});
    EXPECT_GE(climbed.reached, climbed.begun_at) << climbed.name;
    EXPECT_TRUE(held_again(climbed.hardest).disagreements.empty()) << climbed.name;
  }
  EXPECT_EQ(kinds.size(), 10U);
  expect_same(report, searched(plan, 1));
  EXPECT_EQ(search_verdict(report), "verified: 10 climbs, 0 disagreements");
}

TEST(Search, GoesOnWhereItWasStoppedAndClimbsNothingTwice) {
  const TemporaryFolder scratch;
  const SearchPlan plan = plan_of_cubes(5);
  const nlohmann::ordered_json identity{{"format", "test"}};
  {
    KeptValues kept(scratch.path("kept"), identity);
    int asked = 0;
    const SearchReport report = search(
        plan, 1, kept, [&] { return asked++ >= 2; }, [](std::int64_t) {});
    EXPECT_EQ(report.climbs.size(), 2U);
    EXPECT_FALSE(report.finished());
    EXPECT_EQ(search_verdict(report), "unfinished: 2 climbs, 0 disagreements of 5");
  }
  KeptValues kept(scratch.path("kept"), identity);
  EXPECT_EQ(kept.size(), 2U);
  expect_same(searched(plan, kept), searched(plan));
  EXPECT_EQ(kept.size(), 5U);
}

TEST(Search, AKeptClimbThatIsDamagedIsRefused) {
  const TemporaryFolder scratch;
  const nlohmann::ordered_json identity{{"format", "test"}};
  for (const char* damaged :
       {"5", "{}", R"({"name":"a","from":"b","begun_at":"0x0p+0","reached":"0x0p+0","hardest":"?"})"}) {
    write_text_file(scratch.path("kept"), identity.dump() + "\n[\"seed 3, climb 0\"," + damaged + "]\n");
    KeptValues kept(scratch.path("kept"), identity);
    EXPECT_THROW(searched(plan_of_cubes(1), kept), BadInput) << damaged;
  }
}

TEST(Search, BeginsAtCasesWhereItIsGivenAny) {
  SearchPlan plan = plan_of_cubes(10);
  const SearchReport first = searched(plan);
  SearchPlan further;
  for (const Climbed& climbed : first.climbs)
    if (climbed.goal == Goal::error_over_bound) further.cases.push_back(climbed.hardest);
  ASSERT_EQ(further.cases.size(), 2U);
  const SearchReport report = searched(further);
  EXPECT_EQ(report.climbs.size(), 10U);
  fast::Workspace workspace;
  for (const Climbed& climbed : report.climbs) {
    const std::size_t number = climbed.name.find("/case 1/") != std::string::npos ? 0 : 1;
    const Case& begun = further.cases[number];
    const HardState hard = hard_state(begun);
    EXPECT_EQ(climbed.begun_at, hardness(climbed.goal, *hard.held, hard.mode, hard.state, workspace)) << climbed.name;
    EXPECT_EQ(climbed.hardest.scheme, begun.scheme);
    EXPECT_TRUE(climbed.hardest.origin.ends_with(", from " + begun.origin)) << climbed.hardest.origin;
  }
}

/// An engine whose greatest penetration is too small by a millionth where E is the master.
class Shallower : public EngineSeam {
 public:
  const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                const Ask& ask, fast::Workspace& workspace) const override {
    altered_ = EngineSeam::evaluate(pairing, pose, velocity, ask, workspace);
    if (pairing.mode() == Mode::E) altered_.max_penetration *= 1 - 1e-6;
    return altered_;
  }

 private:
  static thread_local fast::Contact altered_;
};
thread_local fast::Contact Shallower::altered_;

TEST(Search, AnEngineThatIsWrongInOneModeWhereAClimbEndsIsToldOfAndTheCaseShowsIt) {
  const SearchReport report = searched(plan_of_cubes(10), 2, Shallower());
  EXPECT_GT(report.disagreeing(), 0);
  for (const Climbed& climbed : report.climbs) {
    if (climbed.hardest.disagreements.empty()) continue;
    EXPECT_EQ(climbed.hardest.mode, Mode::E);
    EXPECT_EQ(in_words(held_again(climbed.hardest, Shallower()).disagreements), climbed.hardest.disagreements);
  }
  EXPECT_TRUE(search_verdict(report).starts_with("NOT verified: 10 climbs, ")) << search_verdict(report);
  EXPECT_NE(search_summary(report).find("penetration: "), std::string::npos) << search_summary(report);
}

TEST(SearchReport, TellsOfTheHardestFirst) {
  SearchReport report;
  report.planned = 3;
  for (const double reached : {1.0, 3.0, 2.0}) {
    Climbed& climbed = report.climbs.emplace_back();
    climbed.name = "work/barycentric/cube-cube/" + std::to_string(static_cast<int>(reached));
    climbed.goal = Goal::work;
    climbed.begun_at = reached / 2;
    climbed.reached = reached;
  }
  const std::vector<const Climbed*> hardest = hardest_climbs(report, 2);
  ASSERT_EQ(hardest.size(), 2U);
  EXPECT_EQ(hardest[0]->reached, 3);
  EXPECT_EQ(hardest[1]->reached, 2);
  const Table table = search_table(report);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0][2].value, 3);
  EXPECT_EQ(table.rows[0][3].value, 1);
  EXPECT_EQ(table.rows[0][5].value, 2);
  EXPECT_EQ(table.rows[0][6].value, 3);
  for (const std::string& text : {search_summary(report), search_markdown(report, hardest)})
    EXPECT_NE(text.find("work"), std::string::npos);
}

}  // namespace
}  // namespace pcm::compare
