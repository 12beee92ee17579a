// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "compare/io/provenance/sha256.h"
#include "meshes/files/text_file.h"
#include "pcm/read_mesh.h"
#include "simulate/record/folder_lock.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::simulate {
namespace {

namespace fs = std::filesystem;
using compare::Outcome;

/// A stone thrown into a law that allows hardly any depth, or not.
std::string block_over_floor(const std::string& max_penetration) {
  return R"({"laws": {"law": {"stiffness": 1e6, "max_penetration": )" + max_penetration + R"(}},
    "ground": {"surfaces": [{"name": "floor", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 4, "thickness": 2}}]},
    "bodies": [{"name": "block", "mass": 100, "at": {"position": [0.03, 0.02, 0.6]}, "surfaces": [{"name": "block", "make": "box"}]}],
    "pairings": [{"E": "floor", "F": "block", "law": "law"}], "duration": 0.2})";
}

struct Folder {
  TemporaryFolder folder;
  std::string scene, out;
  explicit Folder(const std::string& text) : scene(folder.path("scene.json")), out(folder.path("out")) {
    std::ofstream(scene) << text;
  }
  Outcome run(std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"simulate", scene, "--out", out});
    return compare::run_pcm(options);
  }
  /// Names, in order.
  std::vector<std::string> stills() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(out)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("still_", 0) == 0) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  std::string bytes(const std::string& name) const {
    std::ifstream in(fs::path(out) / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

void expect_one_line(const std::string& text) {
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(SimulateCommand, EndsWithTablesAPageAndTheSceneAsItWas) {
  const Folder folder(block_over_floor("0.1"));
  const Outcome outcome = folder.run();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(folder.bytes("tables.md").find("remainder"), std::string::npos);
  EXPECT_GT(folder.bytes("page.html").size(), 100000U);
  EXPECT_EQ(folder.bytes("scene.json"), block_over_floor("0.1"));
}

TEST(SimulateCommand, TellsWhatMadeItsTables) {
  const Folder folder(block_over_floor("0.1"));
  ASSERT_EQ(folder.run({"--integrator", "adams"}).status, 0);
  EXPECT_NE(folder.bytes("tables.md").find("Made by pcm "), std::string::npos);
  EXPECT_NE(folder.bytes("tables.tex").find("longtable"), std::string::npos);
  const auto told = nlohmann::json::parse(folder.bytes("run.provenance.json"));
  EXPECT_NE(told["command_line"].get<std::string>().find("--integrator adams"), std::string::npos);
  const auto& question = told["question"];
  EXPECT_EQ(question["scene_sha256"], compare::sha256(block_over_floor("0.1")));
  EXPECT_EQ(question["settings"]["method"], "CVODE, Adams");
  EXPECT_EQ(question["pairings"][0]["law"]["max_penetration"], "0x1.999999999999ap-4");
  EXPECT_FALSE(question["settings"].contains("jacobian")) << "Adams takes none";
  ASSERT_EQ(question["surfaces"].size(), 2U);
  for (const int k : {0, 1})
    EXPECT_EQ(question["surfaces"][k]["sha256"],
              compare::sha256(read_mesh(folder.out + "/trajectory/surface_" + std::to_string(k) + ".obj")));
  EXPECT_EQ(question["complete"], true);
  for (const char* table : {"steps.csv", "series.csv", "states.csv", "spectrum.csv", "tables.md", "tables.tex"})
    EXPECT_EQ(told["files"][table]["sha256"], compare::sha256(folder.bytes(table))) << table;
  const auto units_of = [&](const char* table) { return told["files"][table]["units"]; };
  EXPECT_EQ(units_of("series.csv"), nlohmann::json::parse(R"({"t": "s", "kinetic": "J", "gravity": "J", "elastic": "J",
    "bumpers": "J", "lost_to_damping": "J", "lost_to_friction": "J", "lost_to_joints": "J", "brought_by_motions": "J",
    "depth_0": "m", "area_0": "m^2", "normal_force_0": "N", "tangential_force_0": "N"})"));
  EXPECT_EQ(units_of("spectrum.csv"), nlohmann::json::parse(R"({"t": "s", "size": "s", "least_real": "1/s",
    "greatest_imaginary": "1/s", "radius": "1/s"})"));
  const auto of_states = units_of("states.csv");
  EXPECT_EQ(of_states.size(), 14U);
  EXPECT_EQ(of_states.at("block.quaternion_w"), "1");
  EXPECT_EQ(of_states.at("block.z"), "m");
  EXPECT_EQ(of_states.at("block.omega_z"), "rad/s");
  EXPECT_EQ(of_states.at("block.v_z"), "m/s");
  EXPECT_EQ(told["files"]["steps.csv"]["units"], nlohmann::json({{"t", "s"}, {"size", "s"}}));
}

// It can't pass the floor's surface by more than 1e-6 m, and gives up there: what was computed is shown.
TEST(SimulateCommand, WhoseIntegratorGivesUpSaysWhenInOneLineAndShowsWhatThereIs) {
  const Folder folder(block_over_floor("1e-6"));
  const Outcome outcome = folder.run();
  EXPECT_EQ(outcome.status, 1);
  expect_one_line(outcome.err);
  EXPECT_NE(outcome.err.find("scene.json: CVODE, BDF gave up at t = 0.14"), std::string::npos) << outcome.err;
  EXPECT_NE(folder.bytes("tables.md").find("steps to t = 0.14"), std::string::npos);
  EXPECT_GT(folder.bytes("page.html").size(), 100000U);
  EXPECT_EQ(nlohmann::json::parse(folder.bytes("run.provenance.json"))["question"]["complete"], false);
  EXPECT_EQ(folder.run().status, 1);  // goes on from the checkpoint, to the same end
}

TEST(SimulateCommand, RefusesASceneInWhichNothingCanMove) {
  const Folder folder(R"({"bodies": [{"name": "post", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0],
                                      "joint": {"type": "weld"}, "surfaces": [{"name": "post", "make": "box"}]}],
                          "duration": 1})");
  const Outcome outcome = folder.run();
  EXPECT_EQ(outcome.status, 2);
  expect_one_line(outcome.err);
  EXPECT_NE(outcome.err.find("scene.json: nothing can move: every body is welded"), std::string::npos) << outcome.err;
}

TEST(SimulateCommand, RefusesASceneThatHasNothingToShowBeforeItIsIntegrated) {
  const Folder folder(R"({"bodies": [{"name": "bob", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0]}],
                          "duration": 1})");
  const Outcome outcome = folder.run();
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("it has no surfaces, so that there is nothing to show"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder.out));
}

TEST(SimulateCommand, RefusesASceneThatCanNotStartWithItsFileBeforeItBegins) {
  const auto with = [](const std::string& more) {
    std::string text = block_over_floor("0.1");
    return text.replace(text.find("\"mass\": 100"), 11, "\"mass\": 100, " + more);
  };
  std::string too_deep = block_over_floor("1e-3");
  too_deep.replace(too_deep.find("0.6"), 3, "0.4");
  const std::vector<std::pair<std::string, std::string>> refusals{
      {with(R"("velocity": [1e300, 0, 0])"), "scene.json: body 1: velocity: "},
      {too_deep, "scene.json: at the start, 'floor' and 'block' are deeper within one another"}};
  for (const auto& [scene, message] : refusals)
    for (const char* option : {"--stills=0", "--compare-integrators"}) {
      SCOPED_TRACE(message + std::string(" ") + option);
      const Folder folder(scene);
      const Outcome outcome = folder.run({option});
      EXPECT_EQ(outcome.status, 2);
      expect_one_line(outcome.err);
      EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
      EXPECT_FALSE(fs::exists(folder.out));
    }
}

TEST(SimulateCommand, WhoseEnergyOverflowsHasNoNumberThatIsNone) {
  const std::string heavy = R"({"laws": {"law": {"stiffness": 1e7}},
    "ground": {"surfaces": [{"name": "floor", "make": "plate"}]},
    "bodies": [{"name": "box", "at": {"position": [0, 0, 5]}, MORE, "surfaces": [{"name": "box", "make": "box"}]}],
    "pairings": [{"E": "floor", "F": "box", "law": "law"}], "duration": 0.05, "gravity": GRAVITY})";
  const auto scene = [&heavy](const std::string& more, const std::string& gravity) {
    std::string text = heavy;
    text.replace(text.find("MORE"), 4, more);
    return text.replace(text.find("GRAVITY"), 7, gravity);
  };
  const Folder at_the_start(scene(R"("mass": 1e300, "velocity": [0, 0, -1e5])", "[0, 0, -9.81]"));
  const Outcome refused = at_the_start.run();
  EXPECT_EQ(refused.status, 2) << refused.out;
  EXPECT_NE(refused.err.find("the energy at the start exceeds"), std::string::npos) << refused.err;

  const Folder later(scene(R"("mass": 1)", "[0, 0, -1e300]"));
  const Outcome ended = later.run();
  EXPECT_NE(ended.status, 0);
  expect_one_line(ended.err);
  for (const char* file : {"series.csv", "tables.md", "checkpoint.json", "tables.tex"})
    for (const char* none : {"nan", "inf"}) EXPECT_EQ(later.bytes(file).find(none), std::string::npos) << file;
}

TEST(SimulateCommand, MendsTheSceneAndTheIndexOfTheTrajectoryThatWereEmptied) {
  const Folder folder(block_over_floor("0.1"));
  ASSERT_EQ(folder.run().status, 0);
  const std::string scene = folder.bytes("scene.json"), index = folder.bytes("trajectory/trajectory.json");
  for (const char* file : {"scene.json", "trajectory/trajectory.json"})
    std::ofstream(fs::path(folder.out) / file).close();
  ASSERT_EQ(folder.run().status, 0);
  EXPECT_EQ(folder.bytes("scene.json"), scene);
  EXPECT_EQ(folder.bytes("trajectory/trajectory.json"), index);
  std::ofstream(fs::path(folder.out) / "scene.json") << "begun by the user";
  ASSERT_EQ(folder.run().status, 0);
  EXPECT_EQ(folder.bytes("scene.json"), "begun by the user");
}

TEST(SimulateCommand, RefusesOptionsThatWhatItPrintsDoesNotHeed) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"simulate", "bubbles", "--print", "--duration", "7"},
        {"simulate", "--schema", "--duration", "7"},
        {"simulate", "--print", "--schema", "bubbles"}}) {
    const Outcome outcome = compare::run_pcm(words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    expect_one_line(outcome.err);
  }
}

/// The scene with stills of its own.
std::string with_stills(const std::string& instants) {
  std::string text = block_over_floor("0.1");
  return text.insert(text.rfind('}'), R"(, "output": {"stills": )" + instants + "}");
}

using Names = std::vector<std::string>;

TEST(SimulateCommand, MakesTheStillsThatAreAskedForAlsoOfAFinishedRun) {
  const Folder folder(block_over_floor("0.1"));
  const Outcome outcome = folder.run({"--stills", "0.15,0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("still: " + (fs::path(folder.out) / "still_0.15.png").string() + "\n"), std::string::npos);
  EXPECT_EQ(folder.stills(), (Names{"still_0.15.png", "still_0.png"}));
  const std::string still = folder.bytes("still_0.15.png"), steps = folder.bytes("steps.csv");
  EXPECT_EQ(still.substr(1, 3), "PNG");
  EXPECT_NE(still, folder.bytes("still_0.png"));
  fs::remove(fs::path(folder.out) / "still_0.15.png");
  EXPECT_EQ(folder.run({"--stills", "0.150,0.2"}).status, 0);
  EXPECT_EQ(folder.stills(), (Names{"still_0.15.png", "still_0.2.png", "still_0.png"}));
  EXPECT_EQ(folder.bytes("still_0.15.png"), still);
  EXPECT_EQ(folder.bytes("steps.csv"), steps);
}

TEST(SimulateCommand, MakesTheScenesStillsWithinTheDurationUnlessOthersAreAskedFor) {
  const std::string scene = with_stills("[0.1, 0.2]");
  const Folder plain(scene), asked(scene), cut(scene);
  EXPECT_EQ(plain.run().status, 0);
  EXPECT_EQ(plain.stills(), (Names{"still_0.1.png", "still_0.2.png"}));
  EXPECT_EQ(asked.run({"--stills", "0.05"}).status, 0);
  EXPECT_EQ(asked.stills(), Names{"still_0.05.png"});
  EXPECT_EQ(cut.run({"--duration", "0.12"}).status, 0);
  EXPECT_EQ(cut.stills(), Names{"still_0.1.png"});
}

TEST(SimulateCommand, RefusesStillsBeforeItBegins) {
  const Folder folder(block_over_floor("0.1"));
  const std::vector<std::pair<std::string, std::string>> refusals{
      {"-0.1", "--stills: -0.1 is negative"},
      {"0,0.3", "--stills: 0.3 s is beyond the end of the scene, 0.2 s"},
      {"nan", "--stills: 'nan' is not a finite number"},
      {"inf", "--stills: 'inf' is not a finite number"},
      {"0.1,soon", "--stills: 'soon' is not a finite number"},
      {"", "--stills: the value is empty"},
      {"0.1,", "--stills: '' is not a finite number"},
      {"0.1,0.2,0.10", "--stills: 0.1 s is there twice"},
      {"0,-0", "--stills: -0 s is there twice"},
  };
  for (const auto& [instants, message] : refusals) {
    SCOPED_TRACE(instants);
    const Outcome outcome = folder.run({"--stills", instants});
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome.err);
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder.out));
  }
  EXPECT_EQ(folder.run({"--stills", "0.15", "--duration", "0.1"}).status, 2);
}

TEST(SimulateCommand, RefusesOptionsThatWouldTakeForEver) {
  const Folder folder(with_stills("[0.1]"));
  for (const auto& [option, value] :
       {std::pair("--duration", "1e300"), std::pair("--duration", "2e5"), std::pair("--greatest-step", "1e-12")}) {
    SCOPED_TRACE(value);
    const Outcome outcome = folder.run({option, value});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(std::string(option) + ": the scene"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder.out));
  }
}

TEST(SimulateCommand, RefusesAScenesStillsWithFileLineAndKey) {
  const Folder folder(with_stills("[0, 0.3]"));
  const Outcome outcome = folder.run();
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("scene.json:4: output.stills[1]: 0.3 s is beyond the end of the scene, 0.2 s"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(fs::exists(folder.out));
}

// It gives up at 0.14 s.
TEST(SimulateCommand, MakesNoStillOfWhatTheRunDidNotReach) {
  const Folder folder(block_over_floor("1e-6"));
  EXPECT_EQ(folder.run({"--stills", "0.1,0.2"}).status, 1);
  EXPECT_EQ(folder.stills(), Names{"still_0.1.png"});
}

TEST(SimulateCommand, StartsFromARecordedState) {
  const Folder folder(block_over_floor("0.1")), from_it(block_over_floor("0.1"));
  EXPECT_EQ(folder.run().status, 0);
  const Outcome outcome = from_it.run({"--from", folder.out, "--at", "0.15", "--stills", "0.15,0.2"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(from_it.bytes("states.csv").find("\n0,"), std::string::npos);
  EXPECT_NE(from_it.bytes("states.csv").find("\n0.15,"), std::string::npos);
  EXPECT_EQ(from_it.stills(), (Names{"still_0.15.png", "still_0.2.png"}));
}

TEST(SimulateCommand, StartsAndMakesAStillWhereTheRecordedTimeIsRounded) {
  ASSERT_LT(0.15, 3 * 0.05);
  std::string text = block_over_floor("0.1");
  text.insert(text.rfind('}'), R"(, "output": {"interval": 0.05, "stills": [0.1, 0.15]})");
  const Folder folder(text), by_scene(text), by_option(text);
  EXPECT_EQ(folder.run().status, 0);
  EXPECT_EQ(by_scene.run({"--from", folder.out, "--at", "0.15"}).status, 0);
  EXPECT_EQ(by_scene.stills(), Names{"still_0.15.png"});
  EXPECT_EQ(by_option.run({"--from", folder.out, "--at", "0.15", "--stills", "0.15"}).status, 0);
  EXPECT_EQ(by_option.stills(), Names{"still_0.15.png"});
}

TEST(SimulateCommand, RefusesToStartFromWhatIsNotRecorded) {
  const Folder folder(block_over_floor("0.1")), from_it(block_over_floor("0.1"));
  EXPECT_EQ(folder.run().status, 0);
  const std::vector<std::pair<std::vector<std::string>, std::string>> refusals{
      {{"--from", folder.out}, "--from and --at go together"},
      {{"--at", "0.1"}, "--from and --at go together"},
      {{"--from", folder.out, "--at", "0.155"}, "has no state at t = 0.155 s"},
      {{"--from", folder.out, "--at", "-1"}, "--at: -1 is negative"},
      {{"--from", folder.out, "--at", "0.2"}, "is not before the end"},
      {{"--from", folder.out + "x", "--at", "0.1"}, "states.csv: can't be read"},
      {{"--from", folder.out, "--at", "0.15", "--stills", "0.1,0.2"}, "--stills: 0.1 s is before the start, 0.15 s"},
  };
  for (const auto& [options, message] : refusals) {
    SCOPED_TRACE(message);
    const Outcome outcome = from_it.run(options);
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome.err);
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(from_it.out));
  }
}

TEST(SimulateCommand, TellsWhatMadeAComparisonOfIntegrators) {
  const TemporaryFolder folder;
  const std::string out = folder.path("compared");
  const Outcome outcome =
      compare::run_pcm({"simulate", "creep", "--compare-integrators", "--duration", "0.01", "--out", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto told = nlohmann::json::parse(read_text_file(out + "/integrators.provenance.json"));
  EXPECT_EQ(told["question"]["duration"], 0.01);
  EXPECT_EQ(told["question"]["integrators"].size(), 7U);
  EXPECT_EQ(told["question"]["jacobians"], nlohmann::json::parse(R"(["differences", "tangents"])"));
  EXPECT_EQ(told["question"]["tolerances"], nlohmann::json::parse("[1e-3, 1e-4, 1e-5, 1e-6]"));
  EXPECT_EQ(told["question"]["slip_velocities"].size(), 4U);
  EXPECT_EQ(told["files"]["integrators.md"]["sha256"], compare::sha256(read_text_file(out + "/integrators.md")));
}

TEST(SimulateCommand, ComparesIntegratorsOfScenesWithFriction) {
  const Folder folder(block_over_floor("0.1"));
  const Outcome outcome = folder.run({"--compare-integrators"});
  EXPECT_EQ(outcome.status, 2);
  expect_one_line(outcome.err);
  EXPECT_NE(outcome.err.find("no law of this scene has friction"), std::string::npos) << outcome.err;
  const Outcome zero = folder.run({"--slip-velocity", "0"});
  EXPECT_EQ(zero.status, 2);
  EXPECT_NE(zero.err.find("--slip-velocity: 0 is not positive"), std::string::npos) << zero.err;
}

TEST(SimulateCommand, TellsWhenTheReferenceOfAComparisonOfIntegratorsFails) {
  std::string text = block_over_floor("1e-6");
  text.insert(text.find("\"max_penetration\""), R"("friction": 0.3, "slip_velocity": 1e-2, )");
  const Folder folder(text);
  const Outcome outcome = folder.run({"--compare-integrators"});
  EXPECT_EQ(outcome.status, 1);
  expect_one_line(outcome.err);
  for (const char* words : {"scene.json: the reference run failed: CVODE, BDF gave up at t = 0.14", "--duration"})
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(SimulateCommand, RefusesAJacobianForAnIntegratorThatTakesNone) {
  const Folder folder(block_over_floor("0.1"));
  const Outcome outcome = folder.run({"--integrator", "adams", "--jacobian", "tangents"});
  EXPECT_EQ(outcome.status, 2);
  expect_one_line(outcome.err);
  EXPECT_NE(outcome.err.find("the integrator (CVODE, Adams) takes none; leave it out, or choose bdf, ida or esdirk"),
            std::string::npos)
      << outcome.err;
}

TEST(SimulateCommand, RefusesWhatAComparisonOfIntegratorsHasInSeveralWaysOrNotAtAll) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--integrator", "adams"},
                                                  {"--jacobian", "tangents"},
                                                  {"--relative-tolerance", "1e-5"},
                                                  {"--absolute-tolerance", "1e-5"},
                                                  {"--spectrum", "5"},
                                                  {"--stills", "0.005"},
                                                  {"--paraview"}}) {
    SCOPED_TRACE(options[0]);
    std::vector<std::string> arguments{"simulate", "creep", "--compare-integrators", "--duration",
                                       "0.01",     "--out", folder.path("out")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = compare::run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome.err);
    EXPECT_NE(outcome.err.find(options[0]), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder.path("out")));
  }
}

TEST(SimulateCommand, RefusesAFolderThatAnotherRunIsWritingIn) {
  const Folder folder(block_over_floor("0.1"));
  fs::create_directories(folder.out);
  {
    const FolderLock other(folder.out);
    const Outcome outcome = folder.run();
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome.err);
    EXPECT_NE(outcome.err.find("out: another pcm simulate is writing there"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.out), {}), 1) << "the lock alone";
  }
  EXPECT_EQ(folder.run().status, 0);
}

TEST(SimulateCommand, RefusesToReplaceASceneOfTheUsers) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("scene.json", block_over_floor("0.1"));
  const Outcome outcome = compare::run_pcm({"simulate", "creep", "--out", folder.path("")});
  EXPECT_EQ(outcome.status, 2);
  expect_one_line(outcome.err);
  EXPECT_NE(outcome.err.find("scene.json: is there, and no run's"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_text_file(scene), block_over_floor("0.1"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path("")), {}), 1) << "the scene alone";
}

/// A program on its way.
class Started {
 public:
  Started(const std::string& program, const std::vector<std::string>& arguments) : process_(fork()) {
    if (process_ != 0) return;
    std::vector<char*> words{const_cast<char*>(program.c_str())};                                // NOLINT: execv's
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));  // NOLINT: the same
    words.push_back(nullptr);
    if (freopen("/dev/null", "w", stdout) == nullptr || freopen(err_.c_str(), "w", stderr) == nullptr) _exit(126);
    execv(program.c_str(), words.data());
    _exit(127);
  }
  void signal(int number) const { kill(process_, number); }
  /// Of waitpid. What goes on for a minute is killed.
  int end() const {
    int status = 0;
    for (int k = 0; k < 6000; ++k) {
      if (waitpid(process_, &status, WNOHANG) == process_) return status;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(process_, SIGKILL);
    waitpid(process_, &status, 0);
    return status;
  }
  std::string err() const { return read_text_file(err_); }

 private:
  TemporaryFolder folder_;
  std::string err_ = folder_.path("err");
  pid_t process_;
};

/// Minutes of work, with checkpoints so far apart, s.
std::string long_run(const std::string& between_checkpoints) {
  std::string text = block_over_floor("0.1");
  text.replace(text.rfind("0.2"), 3, "10000");
  return text.insert(text.rfind('}'),
                     R"(, "integrator": {"greatest_step": 1e-3}, "output": {"interval": 100, "checkpoint_interval": )" +
                         between_checkpoints + "}");
}

/// Until the run in the folder has taken steps, in a table that had so many bytes. A minute at most.
void wait_for_steps(const Folder& folder, std::size_t before = 200) {
  for (int k = 0; k < 6000 && folder.bytes("steps.csv").size() <= before; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

TEST(SimulateCommand, InterruptedStopsAtACheckpointFromWhichItGoesOn) {
  for (const int signal : {SIGINT, SIGTERM}) {
    SCOPED_TRACE(signal);
    const Folder folder(long_run("0.05"));
    for (const char* run : {"begun", "gone on"}) {
      SCOPED_TRACE(run);
      const std::size_t steps = std::max<std::size_t>(200, folder.bytes("steps.csv").size());
      const Started started(PCM_PROGRAM, {"simulate", folder.scene, "--out", folder.out});
      wait_for_steps(folder, steps);
      started.signal(signal);
      const int status = started.end();
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << status;
      EXPECT_NE(started.err().find("the same command goes on from there"), std::string::npos) << started.err();
      EXPECT_GT(folder.bytes("steps.csv").size(), steps);
      EXPECT_GT(folder.bytes("page.html").size(), 100000U);
    }
  }
}

TEST(SimulateCommand, EndsAtASecondSignal) {
  for (const auto& [first, second] : {std::pair(SIGINT, SIGINT), std::pair(SIGINT, SIGTERM)}) {
    SCOPED_TRACE(second);
    const Folder folder(long_run("5000"));
    const Started started(PCM_PROGRAM, {"simulate", folder.scene, "--out", folder.out});
    wait_for_steps(folder);
    started.signal(first);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // or the two would be one
    started.signal(second);
    const int status = started.end();
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == second) << status;
  }
}

TEST(SimulateCommand, BuiltWithoutThreeJsRefusesBeforeItBegins) {
  const Folder folder(block_over_floor("0.1"));
  const Started started(PCM_PROGRAM_WITHOUT_THREE, {"simulate", folder.scene, "--out", folder.out});
  const int status = started.end();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2) << status;
  expect_one_line(started.err());
  EXPECT_NE(started.err().find("libjs-three"), std::string::npos) << started.err();
  EXPECT_FALSE(fs::exists(folder.out));
}

TEST(SimulateCommand, RefusesAFolderInPlaceOfAScene) {
  const TemporaryFolder folder;
  const Outcome outcome = compare::run_pcm({"simulate", folder.path("")});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("is a folder"), std::string::npos) << outcome.err;
}

TEST(SimulateCommand, TellsThatTheDiskIsFull) {
  for (const char* file : {"states.csv", "page.html", "tables.md", "still_0.png"}) {
    SCOPED_TRACE(file);
    const Folder folder(block_over_floor("0.1"));
    fs::create_directories(folder.out);
    { const FolderLock lock(folder.out); }  // of an earlier run, so that the file counts as that run's
    fs::create_symlink("/dev/full", fs::path(folder.out) / file);
    const Outcome outcome = folder.run({"--stills", "0"});
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome.err);
    EXPECT_EQ(outcome.err.find("is there"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace pcm::simulate
