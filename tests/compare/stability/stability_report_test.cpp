// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/stability_report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "compare/io/split_at_commas.h"
#include "meshes/files/text_file.h"
#include "tests/compare/io/well_formed_xml.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::stability {
namespace {

TEST(StabilityProgram, PrintsTablesForAScreenAndWritesThemWithPlots) {
  const TemporaryFolder scratch;
  const std::filesystem::path out = scratch.path("out");
  const Outcome outcome = run_pcm({"verify", "--stability", "--quick", "--seed", "2", "--out", out});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_FALSE(lines.empty());
  EXPECT_TRUE(lines.back().starts_with("stability met: 136 answers at 17 points of 6 sweeps, ")) << lines.back();
  EXPECT_TRUE(lines.back().ends_with(" flipped, 0 outside their bounds, 0 not finite")) << lines.back();
  for (const std::string& line : lines) EXPECT_LE(line.size(), 120U) << line;

  const auto written = nlohmann::json::parse(read_text_file(out / "stability.json"));
  EXPECT_EQ(written["provenance"]["question"]["seed"], 2);
  EXPECT_TRUE(written["verdict"]["met"]);
  for (const auto& point : written["points"]) {
    EXPECT_GT(point["poses"], 0);
    EXPECT_EQ(point["outside_bound"], 0);
    EXPECT_FALSE(point["error_median"].is_null());
  }
  for (const auto& flat : written["flatness"]) {
    const double most = flat["sweep"] == "aspect" ? 1e12 : 16;
    EXPECT_LT(flat["greatest_error_over_condition"], most) << flat.dump();
  }
  EXPECT_TRUE(read_text_file(out / "stability.csv").starts_with("sweep,value,parameter,scheme,group,quantity,poses,"));
  for (const char* table : {"stability.csv", "flatness.csv"}) {
    const std::vector<std::string> rows = lines_of(read_text_file(out / table));
    EXPECT_GT(rows.size(), 1U);
    for (const std::string& row : rows)
      EXPECT_EQ(split_at_commas(row).size(), split_at_commas(rows.front()).size()) << table << ": " << row;
  }
  EXPECT_TRUE(std::filesystem::exists(out / "stability.provenance.json"));
  EXPECT_NE(read_text_file(out / "stability.md").find("## aspect ratio of both bodies"), std::string::npos);
  for (const Sweep sweep : kSweeps) {
    const std::string picture = read_text_file(out / ("stability_" + std::string(name(sweep)) + ".svg"));
    EXPECT_EQ(fault_in_xml(picture), "") << name(sweep);
    EXPECT_NE(picture.find(std::string(title(sweep))), std::string::npos);
    EXPECT_NE(picture.find("error of the engine"), std::string::npos);
  }
}

TEST(StabilityProgram, PicturesOfOthersAreRefusedBeforeAnythingIsWorkedOut) {
  const TemporaryFolder scratch;
  const std::filesystem::path picture = scratch.path("stability_depth.svg");
  write_text_file(picture, "mine");
  const Outcome outcome = run_pcm({"verify", "--stability", "--quick", "--out", scratch.path().string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("stability_depth.svg is there"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_text_file(picture), "mine");
  EXPECT_FALSE(std::filesystem::exists(scratch.path("stability.kept")));
}

TEST(StabilityProgram, OptionsThatItWouldNotHeedAreRefused) {
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--poses", "6"}, {"--mode", "F"}, {"--known-answers"}, {"--audits"}, {"--engine", "fast"}}) {
    std::vector<std::string> arguments{"verify", "--stability"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("--stability"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace pcm::compare::stability
