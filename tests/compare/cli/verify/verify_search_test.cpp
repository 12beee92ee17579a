// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `pcm verify --search`, as a user calls it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/io/split_at_commas.h"
#include "meshes/files/text_file.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

TEST(VerifySearch, PrintsAndWritesTablesAndCasesThatReplayAndAreClimbedFrom) {
  const TemporaryFolder scratch;
  const fs::path out = scratch.path("out"), cases = out / "hardest";
  const Outcome outcome = run_pcm({"verify", "--search", "--poses", "5", "--scheme", "barycentric", "--out", out});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(lines_of(outcome.out).back(), "verified: 5 climbs, 0 disagreements");
  for (const std::string& line : lines_of(outcome.out)) EXPECT_LE(line.size(), 120U) << line;

  const auto written = nlohmann::json::parse(read_text_file(out / "search.json"));
  EXPECT_EQ(written["provenance"]["question"]["climbs"], 5);
  EXPECT_EQ(written["goals"].size(), 5U);
  ASSERT_EQ(written["hardest"].size(), 5U);
  for (const char* table : {"search.csv", "hardest.csv"}) {
    const std::vector<std::string> rows = lines_of(read_text_file(out / table));
    EXPECT_EQ(rows.size(), 6U);
    for (const std::string& row : rows) EXPECT_EQ(split_at_commas(row).size(), split_at_commas(rows[0]).size()) << row;
  }
  for (const char* file : {"search.md", "search.tex", "search.provenance.json"}) EXPECT_TRUE(fs::exists(out / file));
  EXPECT_FALSE(fs::exists(out / "search.kept"));

  EXPECT_EQ(files_in(cases).size(), 5U);
  for (const auto& row : written["hardest"]) {
    const Outcome replayed = run_pcm({"verify", "--case", cases / row["case"].get<std::string>()});
    EXPECT_EQ(replayed.status, 0) << replayed.err;
  }

  const Outcome own = run_pcm({"verify", "--search", "--from", cases, "--poses", "1", "--out", out});
  EXPECT_EQ(own.status, 2);
  EXPECT_NE(own.err.find("would remove it"), std::string::npos) << own.err;
  EXPECT_EQ(files_in(cases).size(), 5U);

  const Outcome further = run_pcm({"verify", "--search", "--from", cases, "--poses", "3"});
  EXPECT_EQ(further.status, 0) << further.err;
  EXPECT_EQ(lines_of(further.out).back(), "verified: 3 climbs, 0 disagreements");
}

TEST(VerifySearch, ASearchThatIsKeptGoesOn) {
  const TemporaryFolder scratch;
  const fs::path out = scratch.path("out");
  const auto searched = [&](const char* poses) {
    return run_pcm({"verify", "--search", "--poses", poses, "--scheme", "barycentric", "--out", out});
  };
  // Killed while it writes its last table, it would leave its values: a folder in a table's place does the same.
  fs::create_directories(out / "hardest" / "case_margins_barycentric_cube-cube_0.json" / "in the way");
  const Outcome first = searched("2");
  EXPECT_EQ(first.status, 2) << first.out;
  EXPECT_TRUE(fs::exists(out / "search.kept"));
  fs::remove_all(out / "hardest");
  const Outcome second = searched("3");
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_NE(second.err.find("continued, 2 climbs are kept"), std::string::npos) << second.err;
  EXPECT_EQ(files_in(out / "hardest").size(), 3U);
}

TEST(VerifySearch, WhatItWouldNotHeedOrCannotReadIsRefused) {
  const TemporaryFolder scratch;
  const auto expect_refused = [](const std::vector<std::string>& options, const std::string& named) {
    std::vector<std::string> arguments{"verify"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(options);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(named), std::string::npos) << "expected '" << named << "' in: " << outcome.err;
  };
  const std::string empty = scratch.path("empty");
  fs::create_directory(empty);
  expect_refused({"--from", empty}, "--search");
  expect_refused({"--search", "--from", empty}, "no case file");
  expect_refused({"--search", "--from", scratch.path("none.json")}, "none.json");
  expect_refused({"--search", "--poses", "0"}, "--poses");
  expect_refused({"--search", "--poses", "100001"}, "--poses");
  expect_refused({"--search", "--mode", "E"}, "--search");
  expect_refused({"--search", "--strata", "generic"}, "--search");
  expect_refused({"--search", "--stability"}, "--search");
  expect_refused({"--search", "--quick"}, "--quick");
  expect_refused({"--search", "--stiffness", "1e6"}, "force law");
  expect_refused({"--search", "--part", "1/2", "--out", empty}, "--part");
  const std::string large = scratch.path("large.obj");
  ASSERT_EQ(run_pcm({"mesh", "make", "icosphere", "--level=3", "-o", large}).status, 0);
  expect_refused({"--search", "--pair", large, large}, "large-large has 2560 faces");
  const fs::path others = scratch.path("others");
  fs::create_directory(others);
  write_text_file(others / "search.csv", "mine");
  expect_refused({"--search", "--poses", "1", "--out", others.string()}, "search.csv");
  EXPECT_EQ(read_text_file(others / "search.csv"), "mine");
}

}  // namespace
}  // namespace pcm::compare
