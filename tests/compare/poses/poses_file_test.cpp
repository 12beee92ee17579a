// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/poses_file.h"

#include <gtest/gtest.h>

#include "pcm/bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

TEST(PosesFile, TwelveNumbersArePositionAndOrientationAtRest) {
  const std::optional<State> state = parse_state("0 -1 0  1 0 0  0 0 1  4 5 6");
  ASSERT_TRUE(state);
  EXPECT_EQ(state->pose.A * Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  EXPECT_EQ(state->pose.r, Eigen::Vector3d(4, 5, 6));
  EXPECT_TRUE(state->velocity.v.isZero(0));
  EXPECT_TRUE(state->velocity.w.isZero(0));
}

TEST(PosesFile, SixMoreAreTheVelocities) {
  const std::optional<State> state = parse_state("1 0 0 0 1 0 0 0 1 0 0 0\t7 8 9 -1 -2 -3 # moving");
  ASSERT_TRUE(state);
  EXPECT_EQ(state->velocity.v, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(state->velocity.w, Eigen::Vector3d(-1, -2, -3));
}

TEST(PosesFile, BlankLinesAndCommentsAreNoPoses) {
  EXPECT_FALSE(parse_state(""));
  EXPECT_FALSE(parse_state(" \t\r"));
  EXPECT_FALSE(parse_state("# 1 2 3"));
}

TEST(PosesFile, OrientationsAreRotationsToOnePartInABillion) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  A(0, 0) = 1 + 4.9e-10;  // Its square is 9.8e-10 off.
  EXPECT_TRUE(is_rotation(A));
  A(0, 0) = 1 + 5.1e-10;
  EXPECT_FALSE(is_rotation(A));
  EXPECT_FALSE(is_rotation(-Eigen::Matrix3d::Identity()));
}

TEST(PosesFile, TheLastLineNeedsNoLineFeedAndPlacesAreCountedFromOne) {
  const TemporaryFolder scratch;
  PosesFile file(scratch.write("poses.txt", "# first\n1 0 0 0 1 0 0 0 1 1 0 0\n\n1 0 0 0 1 0 0 0 1 2 0 0"));
  EXPECT_EQ(file.next()->pose.r.x(), 1);
  EXPECT_TRUE(file.place().ends_with("poses.txt:2"));
  EXPECT_EQ(file.next()->pose.r.x(), 2);
  EXPECT_TRUE(file.place().ends_with("poses.txt:4"));
  EXPECT_FALSE(file.next());
}

TEST(PosesFile, LengthsAreMadeMetres) {
  PoseReading reading;
  reading.metres_per_unit = 0.125;
  const std::optional<State> state = parse_state("1 0 0 0 1 0 0 0 1  8 16 24  1 2 4  3 5 7", reading);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->pose.r, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(state->velocity.v, Eigen::Vector3d(0.125, 0.25, 0.5));
  EXPECT_EQ(state->velocity.w, Eigen::Vector3d(3, 5, 7));
  reading.metres_per_unit = 1e10;
  EXPECT_THROW(parse_state("1 0 0 0 1 0 0 0 1  1e300 0 0", reading), BadInput);
}

TEST(PosesFile, AnyLineEndingsAByteOrderMarkAndLongCommentsAreUnderstood) {
  const std::string pose = "1 0 0 0 1 0 0 0 1 0 0 ";
  const TemporaryFolder scratch;
  PosesFile file(scratch.write("poses.txt", "\xEF\xBB\xBF" + pose + "1\r" + pose + "2\r\n\r" + pose + "3 #" +
                                                std::string(3'000'000, 'x') + "\n" + pose + "4"));
  for (const auto& [z, line] :
       {std::pair(1.0, ":1"), std::pair(2.0, ":2"), std::pair(3.0, ":4"), std::pair(4.0, ":5")}) {
    EXPECT_EQ(file.next()->pose.r.z(), z);
    EXPECT_TRUE(file.place().ends_with(line)) << file.place();
  }
  EXPECT_FALSE(file.next());
}

}  // namespace
}  // namespace pcm::compare
