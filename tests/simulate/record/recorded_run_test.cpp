// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "compare/verify/run/trajectory.h"
#include "simulate/record/recorded_run.h"
#include "simulate/record/run_provenance.h"
#include "simulate/scenes/read_scene.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::simulate {
namespace {

namespace fs = std::filesystem;

/// The bubbles for a second, with checkpoints often enough to be hit between two of them.
Scene short_bubbles() {
  Scene scene = parse_scene(std::string(built_in_scenes().front().text), "bubbles");
  scene.duration = 0.8;
  scene.output.checkpoint_interval = 0.05;
  return scene;
}

fs::path empty_folder(const std::string& name) {
  static const TemporaryFolder temporary;
  const fs::path folder = temporary.path(name);
  fs::remove_all(folder);
  return folder;
}

std::string bytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> tables(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "checkpoint.json")
      files.push_back(fs::relative(entry.path(), folder));
  return files;
}

bool run_in(const fs::path& folder, const std::function<bool()>& stop = {}, const Scene& scene = short_bubbles()) {
  std::string notice;
  return RecordedRun(scene, "bubbles", folder, notice).run(stop, {});
}

void expect_same_tables(const fs::path& a, const fs::path& b) {
  ASSERT_EQ(tables(a).size(), tables(b).size());
  for (const fs::path& file : tables(a)) EXPECT_EQ(bytes(a / file), bytes(b / file)) << file;
}

/// Kills a run, and those that go on from it, ten times, each after a part of a time. How many it met.
int kill_ten_times(const Scene& scene, const fs::path& folder, std::chrono::duration<double> time,
                   std::mt19937& random) {
  int killed_while_running = 0;
  for (int i = 0; i < 10; ++i) {
    const pid_t child = fork();
    EXPECT_GE(child, 0);
    if (child == 0) _exit(run_in(folder, {}, scene) ? 0 : 1);
    std::this_thread::sleep_for(time * std::uniform_real_distribution<>(0.05, 0.3)(random));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    killed_while_running += WIFSIGNALED(status);
  }
  return killed_while_running;
}

/// Killed at ten instants, and then left alone.
void expect_bytes_of_an_uninterrupted_run(const Scene& scene) {
  const fs::path whole = empty_folder("whole"), killed = empty_folder("killed");
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(run_in(whole, {}, scene));
  std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
  EXPECT_GT(bytes(whole / "steps.csv").size(), 10000U);

  const unsigned seed = 20261123;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  // Others on the machine may have made that long: then anew, sooner.
  for (int trial = 0; kill_ten_times(scene, killed, duration, random) < 3; ++trial) {
    ASSERT_LT(trial, 6);
    duration /= 2;
    empty_folder("killed");
  }
  ASSERT_TRUE(run_in(killed, {}, scene));
  expect_same_tables(whole, killed);
}

TEST(RecordedRun, KilledTenTimesEndsWithTheBytesOfAnUninterruptedOne) {
  expect_bytes_of_an_uninterrupted_run(short_bubbles());
}

TEST(RecordedRun, KilledTenTimesEndsWithTheSameBytesWithTangents) {
  Scene scene = short_bubbles();
  scene.integrator.method = Method::bdf;
  scene.integrator.jacobian = JacobianOf::tangents;
  expect_bytes_of_an_uninterrupted_run(scene);
}

TEST(RecordedRun, KilledTenTimesEndsWithTheSameBytesByMethodsOfOneStep) {
  for (const Method method : {Method::rkc, Method::runge_kutta_merson}) {
    SCOPED_TRACE(name(method));
    Scene scene = short_bubbles();
    scene.integrator.method = method;
    expect_bytes_of_an_uninterrupted_run(scene);
  }
}

TEST(RecordedRun, KilledWhileItWritesAFileLeavesNothingOfItOnceItGoesOn) {
  const fs::path whole = empty_folder("whole"), killed = empty_folder("killed");
  ASSERT_TRUE(run_in(whole));
  ASSERT_FALSE(run_in(killed, [] { return true; }));
  for (const char* unfinished : {"checkpoint.json.part7", "scene.json.part4294967295", "trajectory/surface_0.obj.part1",
                                 "trajectory/trajectory.json.part0", "tables.md.part1", "tables.tex.part2",
                                 "run.provenance.json.part3", "page.html.part4"})
    std::ofstream(killed / unfinished) << "half";
  const std::vector<fs::path> of_the_user{"notes.part7", "scene.json.part", "scene.json.part7.txt",
                                          "checkpoint.json.old"};
  for (const fs::path& file : of_the_user) std::ofstream(killed / file) << "mine";
  ASSERT_TRUE(run_in(killed));
  for (const fs::path& file : of_the_user) EXPECT_TRUE(fs::remove(killed / file)) << file;
  expect_same_tables(whole, killed);
}

TEST(RecordedRun, StoppedGoesOnAndFinishedStaysFinished) {
  const fs::path whole = empty_folder("whole"), stopped = empty_folder("stopped");
  ASSERT_TRUE(run_in(whole));
  int checkpoints = 0;
  EXPECT_FALSE(run_in(stopped, [&checkpoints] { return ++checkpoints == 3; }));
  EXPECT_TRUE(run_in(stopped));
  expect_same_tables(whole, stopped);
  const std::string before = bytes(stopped / "checkpoint.json");
  EXPECT_TRUE(run_in(stopped));
  EXPECT_EQ(bytes(stopped / "checkpoint.json"), before);
}

TEST(RecordedRun, SaysNothingOfItsTablesWhileTheyChange) {
  const fs::path folder = empty_folder("changing"), report = folder / "run.provenance.json";
  const auto report_outlives = [&](const std::function<bool()>& stop) {
    std::ofstream(report) << "of the tables as they were";
    run_in(folder, stop);
    return fs::remove(report);
  };
  EXPECT_FALSE(run_in(folder, [] { return true; }));
  EXPECT_FALSE(report_outlives([] { return true; })) << "resumed";
  fs::remove(folder / "checkpoint.json");
  EXPECT_FALSE(report_outlives([] { return true; })) << "begun anew";
}

TEST(RecordedRun, LeavesAFolderThatItRefusesAsItWas) {
  const fs::path folder = empty_folder("left");
  EXPECT_FALSE(run_in(folder, [] { return true; }));
  std::ofstream(folder / "steps.csv", std::ios::app) << "after the checkpoint\n";
  std::ofstream(folder / "run.provenance.json") << "of these tables";
  const std::string steps = bytes(folder / "steps.csv");
  fs::resize_file(folder / "spectrum.csv", 3);
  std::string notice;
  expect_bad_input([&] { RecordedRun(short_bubbles(), "bubbles", folder, notice); },
                   "spectrum.csv: is shorter than it was");
  EXPECT_EQ(bytes(folder / "steps.csv"), steps);
  EXPECT_TRUE(fs::exists(folder / "run.provenance.json"));
}

TEST(RecordedRun, RefusesTheFolderOfAnotherSceneAndTablesThatAreTooShort) {
  const fs::path folder = empty_folder("refused");
  EXPECT_FALSE(run_in(folder, [] { return true; }));
  std::string notice;
  const Scene scene = short_bubbles();
  expect_bad_input([&] { RecordedRun(scene, "other", folder, notice); }, "holds the run of another scene");
  fs::resize_file(folder / "steps.csv", 10);
  expect_bad_input([&] { RecordedRun(scene, "bubbles", folder, notice); }, "steps.csv: is shorter than it was");
}

/// A short run that has stopped at a checkpoint.
fs::path stopped_run(const std::string& name) {
  const fs::path folder = empty_folder(name);
  EXPECT_FALSE(run_in(folder, [] { return true; }));
  return folder;
}

TEST(RecordedRun, RefusesACheckpointThatIsNotAsItWasWritten) {
  const fs::path folder = stopped_run("damaged");
  const std::string whole = bytes(folder / "checkpoint.json");
  const std::size_t digits = whole.find("\"y\"") + 20;
  std::vector<std::string> damaged{"{", "[]", "null", "", whole.substr(0, whole.size() / 2)};
  for (const char c : {'7', '8', 'x'})
    damaged.push_back(std::string(whole).replace(whole.find('p', digits) - 1, 1, 1, c));
  std::string notice;
  const Scene scene = short_bubbles();
  for (const std::string& text : damaged) {
    if (text == whole) continue;
    std::ofstream(folder / "checkpoint.json") << text;
    expect_bad_input([&] { RecordedRun(scene, "bubbles", folder, notice); }, "checkpoint.json: is damaged");
  }
  std::ofstream(folder / "checkpoint.json") << whole;
  RecordedRun(scene, "bubbles", folder, notice);
}

/// As if another build of the program had made it.
void change_build(const fs::path& folder) {
  std::string checkpoint = bytes(folder / "checkpoint.json");
  const std::string key = "\"program\": \"";
  char& digit = checkpoint.at(checkpoint.find(key) + key.size());
  digit = digit == '0' ? '1' : '0';
  std::ofstream(folder / "checkpoint.json") << checkpoint;
}

TEST(RecordedRun, KeepsAFinishedRunOfAnotherBuild) {
  const fs::path folder = empty_folder("finished_elsewhere"), copy = empty_folder("copy");
  ASSERT_TRUE(run_in(folder));
  change_build(folder);
  fs::copy(folder, copy, fs::copy_options::recursive);
  expect_bad_input([&] { run_in(folder); }, "holds a finished run of another build of this program, which is kept");
  expect_same_tables(copy, folder);
  EXPECT_EQ(bytes(folder / "checkpoint.json"), bytes(copy / "checkpoint.json"));
}

TEST(RecordedRun, BeginsAnUnfinishedRunOfAnotherBuildAnewAndSaysSo) {
  const fs::path whole = empty_folder("whole"), folder = stopped_run("begun_elsewhere");
  ASSERT_TRUE(run_in(whole));
  change_build(folder);
  std::string notice;
  EXPECT_TRUE(RecordedRun(short_bubbles(), "bubbles", folder, notice).run({}, {}));
  EXPECT_NE(notice.find("holds an unfinished run of another build of this program; it is begun anew"),
            std::string::npos)
      << notice;
  expect_same_tables(whole, folder);
}

TEST(RecordedRun, RefusesTheFolderOfOtherSurfacesOrSettings) {
  const fs::path folder = stopped_run("other");
  std::string notice;
  Scene longer = short_bubbles(), larger = short_bubbles(), by_bdf = short_bubbles();
  longer.duration = 0.9;
  by_bdf.integrator.method = Method::bdf;
  TriangleMesh moved = larger.surfaces[1].surface.mesh();
  moved.vertices[0].x() += 1e-6;
  larger.surfaces[1].surface = fast::Surface(moved);
  for (const Scene* scene : {&longer, &larger, &by_bdf})
    expect_bad_input([&] { RecordedRun(*scene, "bubbles", folder, notice); }, "or of other surfaces or options");
}

TEST(RecordedRun, IsKnownByItsJacobiansWhereItsIntegratorTakesAny) {
  Scene scene = short_bubbles();
  scene.integrator.jacobian = JacobianOf::tangents;
  scene.integrator.method = Method::adams;
  EXPECT_FALSE(settings_of(scene).contains("jacobian"));
  scene.integrator.method = Method::bdf;
  EXPECT_EQ(settings_of(scene)["jacobian"], "tangents");
  scene.integrator.jacobian = JacobianOf::differences;
  EXPECT_EQ(settings_of(scene)["jacobian"], "differences");
}

TEST(RecordedRun, KeepsItsFolderFromOthersUntilItsEnd) {
  const fs::path alone = empty_folder("alone"), folder = empty_folder("beset");
  ASSERT_TRUE(run_in(alone));
  {
    std::string notice;
    const Scene scene = short_bubbles();
    RecordedRun run(scene, "bubbles", folder, notice);
    EXPECT_FALSE(run.run([] { return true; }, {}));
    for (const char* text : {"bubbles", "other"})
      expect_bad_input([&] { RecordedRun(scene, text, folder, notice); }, "another pcm simulate is writing there");
    EXPECT_TRUE(run.run({}, {}));
  }
  expect_same_tables(alone, folder);
  EXPECT_TRUE(run_in(folder));
}

TEST(RecordedRun, RefusesAFolderWithOthersFilesOfItsNamesAndLeavesThemAsTheyAre) {
  Scene scene = short_bubbles();
  scene.output.stills = {0.45};
  std::string notice;
  for (const char* name : {"scene.json", "steps.csv", "states.csv", "trajectory/0.poses", "trajectory/surface_0.obj",
                           "trajectory/trajectory.json", "tables.md", "tables.tex", "run.provenance.json", "page.html",
                           "still_0.45.png", "paraview/frames.pvd"}) {
    SCOPED_TRACE(name);
    const fs::path folder = empty_folder("of_the_user");
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << "mine";
    expect_bad_input([&] { RecordedRun(scene, "bubbles", folder, notice); }, (folder / name).string() + ": is there");
    EXPECT_EQ(bytes(folder / name), "mine");
    EXPECT_EQ(tables(folder).size(), 1U) << "nothing else is begun";
  }
}

TEST(RecordedRun, RefusesALinkToNowhereOfOneOfItsNames) {
  const fs::path folder = empty_folder("linked");
  fs::create_directories(folder);
  fs::create_symlink("nowhere", folder / "page.html");
  std::string notice;
  expect_bad_input([&] { RecordedRun(short_bubbles(), "bubbles", folder, notice); }, "page.html: is there");
}

TEST(RecordedRun, BeginsBesideFilesThatItDoesNotWrite) {
  const fs::path folder = empty_folder("beside");
  fs::create_directories(folder);
  for (const char* name : {"notes.txt", "mine.json", "still_9.png"}) std::ofstream(folder / name) << "mine";
  EXPECT_FALSE(run_in(folder, [] { return true; }));
  for (const char* name : {"notes.txt", "mine.json", "still_9.png"}) EXPECT_EQ(bytes(folder / name), "mine") << name;
}

TEST(RecordedRun, KilledBeforeItsFirstCheckpointBeginsAnew) {
  const fs::path whole = empty_folder("whole"), killed = empty_folder("killed");
  const Scene scene = short_bubbles();
  ASSERT_TRUE(run_in(whole));
  {
    RunFolder folder(killed, "bubbles", scene);
    folder.begin(Simulation(scene).model().columns());
  }
  ASSERT_TRUE(fs::exists(killed / "scene.json"));
  ASSERT_FALSE(fs::exists(killed / "checkpoint.json"));
  ASSERT_TRUE(run_in(killed));
  expect_same_tables(whole, killed);
}

TEST(RecordedRun, CountsItsWorkOnceHoweverOftenItIsStopped) {
  const Scene scene = short_bubbles();
  std::string notice;
  const fs::path folder = empty_folder("counted");
  RecordedRun run(scene, "bubbles", folder, notice);
  EXPECT_FALSE(run.run([] { return true; }, {}));
  EXPECT_FALSE(run.run([] { return true; }, {}));
  EXPECT_TRUE(run.run({}, {}));
  EXPECT_EQ(run.kept().cost.work.steps, static_cast<std::int64_t>(read_number_table(folder / "steps.csv").rows.size()));
}

TEST(RecordedRun, StatesAreAtTheOutputsInterval) {
  const fs::path folder = empty_folder("states");
  ASSERT_TRUE(run_in(folder));
  const NumberTable states = read_number_table(folder / "states.csv");
  ASSERT_EQ(states.rows.size(), 81U);
  for (std::size_t n = 0; n < states.rows.size(); ++n) EXPECT_EQ(states.rows[n][0], 0.01 * static_cast<double>(n));
}

TEST(RecordedRun, TrajectoryIsOneThatPosesAreHeldFrom) {
  const fs::path folder = empty_folder("trajectory");
  ASSERT_TRUE(run_in(folder));
  const compare::VerificationPlan plan = compare::read_trajectory(folder / "trajectory" / "trajectory.json");
  const Scene scene = short_bubbles();
  ASSERT_EQ(plan.pairs.size(), scene.pairings.size());
  for (std::size_t p = 0; p < scene.pairings.size(); ++p) {
    const ScenePairing& pairing = scene.pairings[p];
    const TriangleMesh& mesh_E = scene.surfaces[static_cast<std::size_t>(pairing.E)].surface.mesh();
    EXPECT_EQ(plan.pairs[p].E.vertices, mesh_E.vertices);
    EXPECT_EQ(plan.pairs[p].E.faces, mesh_E.faces);
    EXPECT_EQ(plan.pairs[p].law.stiffness, pairing.law.stiffness);
    EXPECT_EQ(plan.pairs[p].law.slip_velocity, pairing.law.slip_velocity);
    EXPECT_EQ(plan.pairs[p].law.max_penetration, pairing.law.max_penetration);
    EXPECT_EQ(plan.recorded[p].modes, compare::HeldPairing::Modes{pairing.mode});
    EXPECT_EQ(plan.recorded[p].scheme, pairing.scheme);
  }
  EXPECT_GT(plan.poses, 100);
}

// A stone in free fall, cheap. 3 times 0.1 rounds to more than 0.3, 3 times 0.3 to less than 0.9.
TEST(RecordedRun, StatesAndCheckpointsEndWithTheSceneHoweverMultiplesRound) {
  struct Case {
    double interval, duration;
    std::size_t states;
  };
  for (const auto& [interval, duration, states] :
       {Case{0.1, 0.3, 4}, Case{0.3, 0.9, 4}, Case{0.1, 0.35, 4}, Case{2, 0.5, 1}, Case{0.01, 1.1, 111}}) {
    SCOPED_TRACE(duration);
    Scene scene =
        parse_scene(R"({"bodies": [{"name": "stone", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0]}],
      "duration": 1})",
                    "stone");
    scene.duration = duration;
    scene.output.interval = scene.output.checkpoint_interval = interval;
    const fs::path folder = empty_folder("stone"), stopped = empty_folder("stopped_stone");
    std::string notice;
    ASSERT_TRUE(RecordedRun(scene, "stone", folder, notice).run({}, {}));
    const std::vector<double> t = read_number_table(folder / "states.csv").column("t");
    ASSERT_EQ(t.size(), states);
    for (std::size_t n = 0; n < t.size(); ++n) EXPECT_NEAR(t[n], interval * static_cast<double>(n), 1e-12);
    const bool divides = std::abs(interval * static_cast<double>(states - 1) - duration) < 1e-9;
    EXPECT_EQ(t.back() == duration, divides);
    // Reopened at every checkpoint.
    while (!RecordedRun(scene, "stone", stopped, notice).run([] { return true; }, {})) {
    }
    expect_same_tables(folder, stopped);
  }
}

TEST(NumberTable, RefusesWhatIsNoNumberNamingTheLine) {
  const fs::path file = empty_folder("table.csv");
  std::ofstream(file) << "a,b\n1,2\n3\n";
  expect_bad_input([&] { read_number_table(file); }, ":3: 1 numbers, where the table has 2 columns");
}

TEST(NumberTable, LeavesOutALastLineThatWasBeingWritten) {
  const fs::path file = empty_folder("table.csv");
  for (const char* torn : {"3,4", "3,", "3", "3,-0."}) {
    std::ofstream(file) << "a,b\n1,2\n" << torn;
    EXPECT_EQ(read_number_table(file).rows, (std::vector<std::vector<double>>{{1, 2}})) << torn;
  }
}

}  // namespace
}  // namespace pcm::simulate
