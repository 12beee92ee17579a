// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/neighbour.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "compare/io/json/question_json.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// What of a state is another one in its neighbour.
std::set<std::string> changes(const HardState& from, const HardState& to) {
  std::set<std::string> found;
  const auto note = [&found](const char* what, bool differs) {
    if (differs) found.insert(what);
  };
  note("r", from.state.pose.r != to.state.pose.r);
  note("A", from.state.pose.A != to.state.pose.A);
  note("velocity", from.state.velocity.v != to.state.velocity.v || from.state.velocity.w != to.state.velocity.w);
  note("law", law_json(from.state.law) != law_json(to.state.law));
  note("mode", from.mode != to.mode);
  note("scheme", from.state.scheme != to.state.scheme);
  note("E", from.held->features().E.mesh.vertices != to.held->features().E.mesh.vertices);
  note("F", from.held->features().F.mesh.vertices != to.held->features().F.mesh.vertices);
  return found;
}

HardState cubes() {
  const TriangleMesh cube = generate::box({1, 1, 1});
  ContactLaw law;
  law.layers = LayerStiffness{1e6, 2e6};
  law.damping = 1e3;
  law.friction = 0.5;
  return {held_in_all_modes(cube, cube, law, Scheme::clipped),
          1,
          {{Eigen::Matrix3d::Identity(), {0.5, 0.5, 0.9}}, {{1, 2, 3}, {0, 0, 1}}, law, Scheme::clipped, {}}};
}

std::map<std::set<std::string>, int> changes_of_neighbours(const HardState& from, Goal goal) {
  PoseRandom random(7, 0, 0, 0);
  std::map<std::set<std::string>, int> counts;
  for (int i = 0; i < 2000; ++i) ++counts[changes(from, neighbour(from, goal, random))];
  return counts;
}

TEST(Neighbour, ChangesOneThingAndEachOfAllInItsTurn) {
  const HardState from = cubes();
  std::map<std::set<std::string>, int> counts = changes_of_neighbours(from, Goal::error_over_bound);
  for (const char* one : {"r", "A", "velocity", "law", "mode", "E", "F"}) EXPECT_GT(counts[{one}], 60) << one;
  // A law drawn anew may come with a velocity; a change of less than half an ulp is none.
  for (const auto& [what, count] : counts)
    EXPECT_TRUE(what.size() <= 1 || what == (std::set<std::string>{"law", "velocity"})) << testing::PrintToString(what);
}

TEST(Neighbour, LeavesTheLawWhereItHasNoPartInTheGoal) {
  const HardState from = cubes();
  for (const auto& [what, count] : changes_of_neighbours(from, Goal::margins)) {
    EXPECT_FALSE(what.contains("law") || what.contains("velocity"));
    EXPECT_LE(what.size(), 1U);
  }
}

TEST(Neighbour, LeavesTheVerticesOfLargeSurfaces) {
  HardState from = cubes();
  from.held = held_in_all_modes(generate::icosphere(0.5, 2), generate::box({1, 1, 1}), from.state.law, Scheme::clipped);
  for (const auto& [what, count] : changes_of_neighbours(from, Goal::work))
    EXPECT_FALSE(what.contains("E") || what.contains("F"));
}

TEST(Neighbour, IsAFunctionOfStateAndRandomNumbers) {
  const HardState from = cubes();
  PoseRandom one(7, 0, 0, 3), same(7, 0, 0, 3);
  for (int i = 0; i < 200; ++i)
    EXPECT_TRUE(
        changes(neighbour(from, Goal::bound_over_error, one), neighbour(from, Goal::bound_over_error, same)).empty());
}

TEST(Neighbour, ALawThatCannotBeAskedIsRefused) {
  HardState from = cubes();
  from.state.law.layers.reset();
  from.state.law.stiffness = 0x1p200;
  from.state.law.damping = 0x1p200;
  from.state.law.friction = 0x1p200;
  PoseRandom random(7, 0, 0, 0);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) try {
      neighbour(from, Goal::error_over_bound, random);
    } catch (const BadInput& error) {
      ++refused;
    }
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace pcm::compare
