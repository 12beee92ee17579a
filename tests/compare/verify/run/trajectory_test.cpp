// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded poses are asked as they were recorded, and a wrong answer to one of them is noticed and replays.
#include "compare/verify/run/trajectory.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compare/poses/poses_file.h"
#include "compare/verify/run/held_again.h"
#include "compare/verify/run/run_chunks.h"
#include "compare/verify/run/run_identity.h"
#include "compare/verify/run/run_verdict.h"
#include "compare/verify/tables/verification_table.h"
#include "meshes/files/text_file.h"
#include "tests/compare/tiny_trajectory.h"
#include "tests/compare/verify/run/repeats_an_answer.h"

namespace pcm::compare::trajectory_test {
namespace {

void run_all(Verification& run, int jobs) {
  run_all(
      run, jobs, [] { return false; }, [](std::int64_t) {});
}

/// The second body goes up by 0.01 a line.
std::string poses_on_the_way(int number) {
  std::string text;
  for (int i = 0; i < number; ++i)
    text += "1 0 0  0 1 0  0 0 1   0.8 0.13 0.0" + std::to_string(i) + "   0 0 0  0 0 0\n";
  return text;
}

/// A second pairing, the other way round, in the clipped scheme with the second body as master: six poses.
void add_pairing(const TinyTrajectory& trajectory) {
  trajectory.write_index([](Json& json) {
    Json pairing = json["pairings"][0];
    pairing["E"] = 1;
    pairing["F"] = 0;
    pairing["mode"] = "E";
    pairing["scheme"] = "clipped";
    pairing["law"]["friction"] = "0x1p-1";
    pairing["poses"] = "1.poses";
    json["pairings"].push_back(pairing);
  });
  trajectory.folder().write("1.poses", poses_on_the_way(6));
}

std::vector<std::int64_t> lines_of(const RecordedPoses& recorded) {
  std::vector<std::int64_t> lines;
  for (const std::size_t i : recorded.chosen) lines.push_back(recorded.states[i].line);
  return lines;
}

TEST(Trajectory, IsAskedBitForBitWithLawModeAndSchemeOfItsPairing) {
  const TinyTrajectory trajectory;
  add_pairing(trajectory);
  const Verification run(read_trajectory(trajectory.file()));
  ASSERT_EQ(run.cells().size(), 2U);
  const Cell& first = run.cells()[0];
  EXPECT_EQ(first.mode, Mode::F);
  EXPECT_EQ(first.scheme, Scheme::barycentric);
  EXPECT_EQ(first.poses, 3);
  EXPECT_EQ(run.poses().pose_name(first, 2), "block-brick/trajectory/5/F");
  const HeldPairing::State asked = run.poses().asked(first, 1);
  const State written =
      parse_state("1 0 0  0 0.96 -0.28  0 0.28 0.96   0x1.8p-1 0.13 0.05   -1 0.5 0  0 0 0.5").value();
  EXPECT_EQ(asked.pose.A, written.pose.A);
  EXPECT_EQ(asked.pose.r, written.pose.r);
  EXPECT_EQ(asked.velocity.v, written.velocity.v);
  EXPECT_EQ(asked.velocity.w, written.velocity.w);
  EXPECT_EQ(asked.scheme, Scheme::barycentric);
  EXPECT_EQ(asked.law.stiffness, 0x1p+19);
  EXPECT_EQ(asked.law.damping, 0x1p+9);
  EXPECT_EQ(asked.law.transition_depth, 0x1p-10);
  EXPECT_EQ(asked.law.friction, 0.25);
  EXPECT_EQ(asked.law.slip_velocity, 0x1p-7);
  EXPECT_EQ(asked.law.damping_mode, DampingMode::compression);
  EXPECT_FALSE(asked.law.layers);
  const Cell& second = run.cells()[1];
  EXPECT_EQ(second.mode, Mode::E);
  EXPECT_EQ(second.poses, 6);
  EXPECT_EQ(run.poses().pose_name(second, 0), "brick-block/trajectory/1/E/clipped");
  EXPECT_EQ(run.poses().asked(second, 0).law.friction, 0.5);
  EXPECT_EQ(run.poses().asked(second, 0).scheme, Scheme::clipped);
}

TEST(Trajectory, EachPoseComesWithTheSixStatesRecordedBeforeItAlsoWhereFewAreAsked) {
  const TinyTrajectory trajectory;
  trajectory.folder().write("0.poses", poses_on_the_way(9));
  const auto heights_before = [](const Verification& run, std::int64_t pose) {
    std::vector<double> heights;
    for (const MovingPose& state : run.poses().asked(run.cells()[0], pose).before) heights.push_back(state.pose.r.z());
    return heights;
  };
  const Verification all(read_trajectory(trajectory.file()));
  EXPECT_TRUE(heights_before(all, 0).empty());
  EXPECT_EQ(heights_before(all, 2), (std::vector{0.0, 0.01}));
  EXPECT_EQ(heights_before(all, 8), (std::vector{0.02, 0.03, 0.04, 0.05, 0.06, 0.07}));
  const Verification three(read_trajectory(trajectory.file(), {3, {}, {}}));
  EXPECT_TRUE(heights_before(three, 0).empty());
  EXPECT_EQ(heights_before(three, 1), (std::vector{0.0, 0.01, 0.02}));
  EXPECT_EQ(heights_before(three, 2), (std::vector{0.0, 0.01, 0.02, 0.03, 0.04, 0.05}));
}

TEST(Trajectory, ASceneThatAnswersAsAnEarlierStepIsFlaggedAndItsCaseReplays) {
  const TinyTrajectory trajectory;
  trajectory.folder().write("0.poses", poses_on_the_way(9));
  const RepeatsAnAnswer seam;
  const Verification run(read_trajectory(trajectory.file()));
  const Case posed = run.poses().as_case(run.cells()[0], 8);
  EXPECT_EQ(posed.before.size(), 6U);
  const std::vector<Disagreement> found = held_again(posed, seam).disagreements;
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.front().text.starts_with("motion: ")) << found.front().text;
  EXPECT_TRUE(held_again(posed).disagreements.empty());
}

TEST(Trajectory, StatesBeforeThatNoSceneTakesAreLeftOut) {
  const TinyTrajectory trajectory;
  // Off orthogonal by 5e-10: a pose for the engine, and none for a scene.
  trajectory.folder().write("0.poses",
                            "1 5e-10 0  0 1 0  0 0 1   0.8 0.13 0.05   0 0 0  0 0 0\n" + poses_on_the_way(2));
  Verification run(read_trajectory(trajectory.file()));
  run_all(run, 1);
  EXPECT_EQ(verdict_line(run), "verified: 3 poses, 3 touching, 0 disagreements");
}

TEST(Trajectory, OfPairingsInDifferentModesEachPoseIsAskedOnce) {
  const TinyTrajectory trajectory;
  add_pairing(trajectory);
  Verification run(read_trajectory(trajectory.file()));
  run_all(run, 2);
  EXPECT_EQ(verdict_line(run), "verified: 9 poses, 9 touching, 0 disagreements");
  ASSERT_EQ(run.by_mode().size(), 2U);
  EXPECT_EQ(run.by_mode()[0].tally.poses, 6);
  EXPECT_EQ(run.by_mode()[1].tally.poses, 3);
  ASSERT_EQ(run.by_scheme().size(), 2U);
  EXPECT_EQ(run.by_scheme()[1].tally.poses, 6);
}

TEST(Trajectory, FewerPosesAreSpreadEvenlyAndEachPairingKeepsItsShare) {
  const TinyTrajectory trajectory;
  add_pairing(trajectory);
  const VerificationPlan plan = read_trajectory(trajectory.file(), {3, {}, {}});
  EXPECT_EQ(plan.poses, 3);
  EXPECT_EQ(lines_of(plan.recorded[0]), (std::vector<std::int64_t>{2}));
  EXPECT_EQ(lines_of(plan.recorded[1]), (std::vector<std::int64_t>{1, 4}));
  EXPECT_EQ(lines_of(read_trajectory(trajectory.file(), {8, {}, {}}).recorded[0]),
            (std::vector<std::int64_t>{2, 3, 5}));
  EXPECT_EQ(read_trajectory(trajectory.file(), {1000, {}, {}}).poses, 9);
}

TEST(Trajectory, PairingsWithoutAPoseAreNamed) {
  const TinyTrajectory trajectory;
  add_pairing(trajectory);
  const Verification few(read_trajectory(trajectory.file(), {1, {}, {}}));
  ASSERT_EQ(few.poses().omissions().size(), 1U);
  EXPECT_EQ(few.poses().omissions()[0], "pair brick-block gets no pose: 1 poses are too few");
  trajectory.folder().write("1.poses", "");
  const Verification never(read_trajectory(trajectory.file()));
  ASSERT_EQ(never.poses().omissions().size(), 1U);
  EXPECT_EQ(never.poses().omissions()[0], "pair brick-block gets no pose: none is recorded, for it never touched");
  EXPECT_EQ(never.poses().without_poses(), "1 of 2 pairs");
}

/// The force on E at the second of the tiny trajectory's poses is too large by a part in 10^9.
class AltersSecondPose final : public EngineSeam {
 public:
  const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                const Ask& ask, fast::Workspace& workspace) const override {
    const fast::Contact& answer = EngineSeam::evaluate(pairing, pose, velocity, ask, workspace);
    if (pose.r.x() != 0.75) return answer;
    altered_ = answer;
    altered_.force_Me *= 1 + 1e-9;
    return altered_;
  }

 private:
  mutable fast::Contact altered_;
};

TEST(Trajectory, AnAlteredAnswerIsADisagreementWhoseCaseIsTheRecordedPose) {
  const TinyTrajectory trajectory;
  const AltersSecondPose seam;
  Verification run(read_trajectory(trajectory.file()), seam);
  run_all(run, 1);
  EXPECT_EQ(run.total().disagreeing, 1);
  EXPECT_FALSE(is_verified(run));
  EXPECT_EQ(run.total().by_kind[static_cast<std::size_t>(Kind::force)], 1);
  ASSERT_EQ(run.findings().size(), 1U);
  const Finding& finding = run.findings()[0];
  EXPECT_EQ(run.poses().pose_name(run.cells()[finding.cell], finding.pose), "block-brick/trajectory/3/F");

  const std::string file = trajectory.folder().path("case.json");
  write_text_file(file, format_case(run.as_case(finding), {}, {}));
  const Case posed = read_case(file);
  EXPECT_EQ(posed.origin, trajectory.folder().path("0.poses") + ":3, block-brick/trajectory/3/F");
  EXPECT_EQ(posed.pose.r, Eigen::Vector3d(0.75, 0.13, 0.05));
  EXPECT_EQ(posed.velocity.w, Eigen::Vector3d(0, 0, 0.5));
  EXPECT_EQ(posed.law.friction, 0.25);
  EXPECT_EQ(posed.mode, Mode::F);
  EXPECT_EQ(posed.file_E.filename(), "first.obj");
}

TEST(Trajectory, StateOfAnotherRecordingIsToldApart) {
  const TinyTrajectory trajectory;
  const Verification run(read_trajectory(trajectory.file()));
  EXPECT_EQ(difference_from(run.plan(), identity_of(run.plan())), "");
  const auto expect_other = [&] {
    const Verification other(read_trajectory(trajectory.file()));
    EXPECT_TRUE(same_arguments(other.plan(), identity_of(run.plan())));
    EXPECT_EQ(difference_from(other.plan(), identity_of(run.plan())), "of another recording");
  };
  trajectory.write_index([](Json& json) { json["pairings"][0]["law"]["friction"] = "0x1p-1"; });
  expect_other();
  trajectory.write_index([](Json&) {});
  std::string text(TinyTrajectory::kPoses);
  trajectory.folder().write("0.poses", text.replace(text.find("0 0 0.5"), 7, "0 0 0.4"));
  expect_other();
}

}  // namespace
}  // namespace pcm::compare::trajectory_test
