// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

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
  Outcome run() const { return compare::run_pcm({"simulate", scene, "--out", out}); }
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

// It can't pass the floor's surface by more than 1e-6 m, and gives up there: what was computed is shown.
TEST(SimulateCommand, WhoseIntegratorGivesUpSaysWhenInOneLineAndShowsWhatThereIs) {
  const Folder folder(block_over_floor("1e-6"));
  const Outcome outcome = folder.run();
  EXPECT_EQ(outcome.status, 1);
  expect_one_line(outcome.err);
  EXPECT_NE(outcome.err.find("scene.json: CVODE, BDF gave up at t = 0.14"), std::string::npos) << outcome.err;
  EXPECT_NE(folder.bytes("tables.md").find("steps to t = 0.14"), std::string::npos);
  EXPECT_GT(folder.bytes("page.html").size(), 100000U);
  EXPECT_EQ(folder.run().status, 1);  // goes on from the checkpoint, to the same end
}

TEST(SimulateCommand, RefusesAFolderInPlaceOfAScene) {
  const TemporaryFolder folder;
  const Outcome outcome = compare::run_pcm({"simulate", folder.path("")});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("is a folder"), std::string::npos) << outcome.err;
}

TEST(SimulateCommand, TellsThatTheDiskIsFull) {
  for (const char* file : {"states.csv", "page.html", "tables.md"}) {
    SCOPED_TRACE(file);
    const Folder folder(block_over_floor("0.1"));
    fs::create_directories(folder.out);
    fs::create_symlink("/dev/full", fs::path(folder.out) / file);
    const Outcome outcome = folder.run();
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome.err);
  }
}

}  // namespace
}  // namespace pcm::simulate
