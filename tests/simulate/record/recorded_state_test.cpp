// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/recorded_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "simulate/record/recorded_run.h"
#include "simulate/record/run_tables.h"
#include "simulate/scenes/read_scene.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"
#include "tests/simulate/scenes/built_in_scene.h"

namespace pcm::simulate {
namespace {

namespace fs = std::filesystem;

/// The creeping block for half a second, with states and checkpoints at tenths.
Scene short_creep() {
  Scene scene = built_in_scene("creep");
  scene.duration = 0.5;
  scene.output.interval = scene.output.checkpoint_interval = 0.1;
  return scene;
}

Scene short_creep_from(const InitialState& state) {
  Scene scene = short_creep();
  scene.initial_state = state;
  return scene;
}

bool run(const Scene& scene, const fs::path& folder, const std::function<bool()>& stop = {}) {
  std::string notice;
  return RecordedRun(scene, "creep", folder, notice).run(stop, {});
}

std::string lines_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string header;
  std::getline(in, header);
  return {std::istreambuf_iterator<char>(in), {}};
}

class RecordedState : public testing::Test {
 protected:
  RecordedState() { EXPECT_TRUE(run(short_creep(), whole)); }

  TemporaryFolder temporary;
  fs::path whole = temporary.path("whole"), part = temporary.path("part");
};

// 0.3 is a checkpoint of the whole run too, where its integrator started anew.
TEST_F(RecordedState, IsWhereARunStartsAndGoesOnWithTheSameBits) {
  const InitialState state = recorded_state(whole, 0.3);
  EXPECT_EQ(state.t, 3 * 0.1);  // which is not 0.3
  ASSERT_TRUE(run(short_creep_from(state), part));
  for (const char* table : {"steps.csv", "states.csv"}) {
    const std::string of_whole = lines_of(whole / table);
    std::string of_part = lines_of(part / table);
    // The state at the start is there with its quaternions' lengths made 1, as both runs go on with them.
    if (table == std::string("states.csv")) of_part = of_part.substr(of_part.find('\n') + 1);
    EXPECT_GT(of_part.size(), 300U);
    EXPECT_LT(of_part.size(), of_whole.size());
    EXPECT_EQ(of_part, of_whole.substr(of_whole.size() - of_part.size())) << table;
  }
}

TEST_F(RecordedState, RunsFromItCanBeInterrupted) {
  const Scene scene = short_creep_from(recorded_state(whole, 0.2));
  const fs::path stopped = temporary.path("stopped");
  ASSERT_TRUE(run(scene, part));
  ASSERT_FALSE(run(scene, stopped, [] { return true; }));
  ASSERT_TRUE(run(scene, stopped));
  for (const char* table : {"steps.csv", "states.csv", "series.csv"})
    EXPECT_EQ(lines_of(part / table), lines_of(stopped / table));
}

TEST_F(RecordedState, IsPartOfWhatARunIsKnownBy) {
  const Scene scene = short_creep_from(recorded_state(whole, 0.2));
  ASSERT_TRUE(run(scene, part));
  Scene other = scene;
  other.initial_state->y[10] += 1e-12;
  expect_bad_input([&] { run(other, part); }, "or of other surfaces or options");
  expect_bad_input([&] { run(short_creep(), part); }, "or of other surfaces or options");
}

TEST_F(RecordedState, WithoutAnOrientationIsRefused) {
  InitialState state = recorded_state(whole, 0.2);
  const auto first = std::find_if(state.columns.begin(), state.columns.end(), [](const std::string& column) {
    return column.find("quaternion_w") != std::string::npos;
  });
  ASSERT_NE(first, state.columns.end()) << testing::PrintToString(state.columns);
  state.y.segment<4>(first - state.columns.begin()).setZero();
  expect_bad_input([&] { run(short_creep_from(state), part); }, "has length 0.000000; it must be 1");
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(RecordedState, CostIsThatOfTheTimeSimulatedFromIt) {
  const Scene scene = short_creep_from(recorded_state(whole, 0.4));
  KeptRun kept;
  kept.checkpoint.t = 0.5;
  kept.cost.work.steps = 100;
  kept.cost.integration_seconds = 2;
  const std::string table = markdown(cost_table("bubbles", scene, kept));
  EXPECT_NE(table.find("| 1 |"), std::string::npos) << table;
  EXPECT_NE(table.find("| 2 | 20 |"), std::string::npos) << table;
  EXPECT_EQ(table.find("LSODE"), std::string::npos) << "published rows are of the whole scene";
  EXPECT_EQ(table.find("tangents"), std::string::npos);
  EXPECT_EQ(table.find("Iterations"), std::string::npos);
  kept.cost.work.nonlinear_iterations = 208;
  EXPECT_NE(cost_table("bubbles", scene, kept).notes.find("Iterations for the implicit equations: 208."),
            std::string::npos);
  kept.cost.work.linear_derivatives = 26;
  EXPECT_NE(cost_table("bubbles", scene, kept).notes.find("their 26 columns asked no engine"), std::string::npos);
}

TEST_F(RecordedState, IsRefusedWhereThereIsNone) {
  expect_bad_input([&] { recorded_state(whole, 0.25); },
                   "states.csv: has no state at t = 0.25 s; the nearest is at 0.");
  expect_bad_input([&] { recorded_state(whole, 0.6); }, "the nearest is at 0.5 s");
  expect_bad_input([&] { recorded_state(temporary.path("nowhere"), 0); }, "states.csv: can't be read");
  for (const char* text : {"\n\n", "", "time,y\n0,1\n"}) {
    std::ofstream(whole / "states.csv") << text;
    expect_bad_input([&] { recorded_state(whole, 0); }, "states.csv: is no table of states");
  }
}

TEST_F(RecordedState, IsRefusedByAnotherSceneAndAtItsEnd) {
  const InitialState state = recorded_state(whole, 0.4);
  InitialState longer = state;
  longer.y.conservativeResize(20);
  longer.columns.resize(20);
  expect_bad_input([&] { Simulation{short_creep_from(longer)}; }, "has 20 numbers, this scene 13");
  Scene renamed = short_creep_from(state);
  renamed.bodies[0].name = "slab";
  expect_bad_input([&] { Simulation{renamed}; },
                   "has 'block.quaternion_w' where this scene has 'slab.quaternion_w': it is of a scene whose bodies, "
                   "their order or their joints are others");
  InitialState last = state;
  last.columns.back() = "block.rate";
  expect_bad_input([&] { Simulation{short_creep_from(last)}; }, "has 'block.rate' where this scene has 'block.v_z'");
  Scene shorter = short_creep_from(state);
  shorter.duration = 0.4;
  expect_bad_input([&] { Simulation{shorter}; }, "is not before the end");
  InitialState infinite = state;
  infinite.y[3] = HUGE_VAL;
  expect_bad_input([&] { Simulation{short_creep_from(infinite)}; }, "is not finite");
}

}  // namespace
}  // namespace pcm::simulate
