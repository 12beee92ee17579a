// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `pcm bench`: what is measured, and that nobody wins by missing some. Nothing here depends on how long anything takes.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/bench/bodies.h"
#include "compare/bench/timing.h"
#include "compare/bench/work_precision.h"
#include "compare/io/tables/table.h"
#include "meshes/files/text_file.h"
#include "pcm/engine.h"
#include "tests/compare/io/well_formed_xml.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::bench_test {
namespace {

using Json = nlohmann::ordered_json;

/// A quick run of `pcm bench` and the tables that it wrote.
class QuickBench {
 public:
  explicit QuickBench(const std::string& what, const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments{"bench", what, "--quick", "--out", tables_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    out_ = outcome.out;
  }

  /// What it printed.
  const std::string& out() const { return out_; }
  /// The text of a file that it wrote.
  std::string table(const std::string& name) const { return read_text_file(tables_ + "/" + name); }

 private:
  const TemporaryFolder folder_;
  const std::string tables_ = folder_.path("tables");
  std::string out_;
};

TEST(BenchTiming, QuantilesAreNearestRanks) {
  const std::vector<double> values{5, 1, 4, 2, 3};
  EXPECT_EQ(quantile(values, 0.5), 3);
  EXPECT_EQ(quantile(values, 0.95), 5);
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile({}, 0.5), 0);
}

TEST(BenchTiming, ExponentOfAPowerIsFound) {
  EXPECT_NEAR(fitted_exponent({1, 2, 4, 8}, {3, 3 * 1.5, 3 * 2.25, 3 * 3.375}), std::log2(1.5), 1e-14);
}

TEST(BenchTiming, EveryQueryIsPreparedAndOneAtLeastIsMeasured) {
  int prepared = 0, asked = 0;
  least_time([&] { ++prepared; }, [&] { ++asked; });
  EXPECT_EQ(prepared, asked);
  EXPECT_GE(asked, 2);
  EXPECT_LE(asked, 6);
}

TEST(Table, IsTheSameInAllFormats) {
  const Table table{{{"who", "who", false}, {"time us", "time_us"}},
                    {{"a \"b\"", number_cell(12.345, 3)}, {"c", empty_cell()}}};
  EXPECT_EQ(on_screen(table), "who    time us\na \"b\"     12.3\nc            -\n");
  EXPECT_EQ(markdown(table), "| who | time us |\n|---|--:|\n| a \"b\" | 12.3 |\n| c | - |\n");
  EXPECT_EQ(csv(table), "who,time_us\n\"a \"\"b\"\"\",12.345\n\"c\",\n");
  EXPECT_EQ(json(table).dump(), R"([{"who":"a \"b\"","time_us":12.345},{"who":"c","time_us":null}])");
}

TEST(BenchPoses, TouchOrAreParted) {
  for (const std::string& name : bench_body_names()) {
    const BenchBody body = bench_body(name);
    const fast::Surface surface(body.mesh);
    const fast::Pairing pairing(surface, surface);
    fast::Workspace workspace;
    for (const Distance distance : {Distance::touching, Distance::separated}) {
      const std::vector<Pose> poses = bench_poses(body.mesh, distance, 5);
      EXPECT_EQ(poses.size(), 5U);
      for (const Pose& pose : poses)
        EXPECT_EQ(fast::evaluate(pairing, pose, {}, {}, workspace).touching, distance == Distance::touching) << name;
    }
  }
}

TEST(BenchPeers, EverybodyWhoCountsPairsFindsTheSameNumber) {
  const QuickBench bench("peers", {"--bodies", "bubbles"});
  EXPECT_NE(bench.out().find("pcm barycentric"), std::string::npos) << bench.out();

  const Json all = Json::parse(bench.table("peers.json"));
  EXPECT_EQ(all["poses"], 3);
  EXPECT_FALSE(all["machine"]["processor"].get<std::string>().empty());
  std::map<std::string, double> pairs;
  int who = 0;
  for (const Json& row : all["contestants"]) {
    ++who;
    if (row["median_us"].is_null()) {
      EXPECT_NE(row["computes"].get<std::string>().find("not in this build: lib"), std::string::npos) << row;
      continue;
    }
    EXPECT_GT(row["median_us"], 0) << row;
    EXPECT_GE(row["p95_us"], row["median_us"]) << row;
    EXPECT_GT(row["repeated_us"], 0) << row;
    EXPECT_GT(row["ratio_to_all"], 0) << row;
    if (row["computes"] == "touch only") continue;
    if (row["finds"] != "pairs" && row["finds"] != "segments") continue;
    const double found = row["found"];
    EXPECT_EQ(pairs.emplace(row["poses"], found).first->second, found) << row;
  }
  EXPECT_GE(who, 12);
  EXPECT_GT(pairs.at("touching"), 10);
  EXPECT_EQ(pairs.at("separated"), 0);
  EXPECT_NE(bench.table("peers.md").find("| pcm clipped | everything |"), std::string::npos);
  EXPECT_EQ(lines_of(bench.table("peers.csv")).size(), static_cast<std::size_t>(who) + 1);
}

TEST(BenchScaling, WorkGrowsAsTheMeshesDo) {
  const QuickBench bench("scaling");
  const Json all = Json::parse(bench.table("scaling.json"));
  ASSERT_EQ(all["setup"].size(), 3U);
  EXPECT_EQ(all["setup"][2]["faces"], 5120);
  ASSERT_GE(all["points"].size(), 9U);
  // The same patch on finer meshes: twice the crossings, four times the elements, about.
  for (std::size_t level : {0U, 1U}) {
    const Json &coarse = all["points"][level], &fine = all["points"][level + 1];
    EXPECT_EQ(coarse["series"], "mesh size, same patch");
    EXPECT_GT(fine["crossings"], 1.5 * coarse["crossings"].get<double>());
    EXPECT_GT(fine["elements"], 2.5 * coarse["elements"].get<double>());
  }
  EXPECT_EQ(all["exponents"].size(), 3U);
  for (const char* name : {"scaling.md", "scaling.csv", "setup.csv"}) EXPECT_FALSE(bench.table(name).empty());
}

TEST(BenchSkip, NothingSkippedChangesNoBitAndEachSavingSparesWork) {
  const QuickBench bench("skip");
  const Json all = Json::parse(bench.table("skip.json"));
  EXPECT_EQ(all["bubbles"], 8);
  EXPECT_EQ(all["pairings"], 36);
  // Four steps, eight settings beside the first.
  EXPECT_EQ(all["answers_compared"], 36 * 4 * 8);
  EXPECT_EQ(all["answers_different"], 0);
  ASSERT_EQ(all["scene"].size(), 9U);
  EXPECT_EQ(all["scene"][8]["evaluated"], 36);
  EXPECT_LT(all["scene"][0]["evaluated"], 36);
  ASSERT_EQ(all["savings"].size(), 9U);
  for (const Json& saving : all["savings"]) {
    const double on = saving["work_on"], off = saving["work_off"];
    EXPECT_LE(on, 0.5 * off) << saving;
  }
  for (const char* name : {"skip.md", "skip.csv", "skip_scene.csv"}) EXPECT_FALSE(bench.table(name).empty());
}

TEST(BenchSteps, WhatIsKnownChangesNoBitAndSparesWork) {
  const QuickBench bench("steps");
  const Json all = Json::parse(bench.table("steps.json"));
  // Six kinds of steps of two pairs in two schemes, then the recorded scenes.
  ASSERT_EQ(all["steps"].size(), 25U);
  for (const Json& row : all["steps"]) {
    EXPECT_EQ(row["different"], 0) << row;
    EXPECT_GT(row["following_us"], 0) << row;
    EXPECT_GT(row["isolated_us"], 0) << row;
    if (row["steps"] == "as recorded") {
      EXPECT_GT(row["evaluations"], 200) << row;
    } else {
      EXPECT_EQ(row["evaluations"], 24) << row;
    }
  }
  ASSERT_EQ(all["work"].size(), 2 * all["steps"].size());
  for (const Json& row : all["work"]) {
    const bool following = row["past"] == "following", barycentric = row["scheme"] == "barycentric";
    if (row["steps"] == "another velocity" && barycentric) {
      EXPECT_EQ(row["lines"].get<double>() > 0, !following) << row;
    }
    if (row["steps"] == "differences by 10 nm" && barycentric) {
      EXPECT_EQ(row["candidate_pairs"].get<double>() > 0, !following) << row;
      EXPECT_GE(row["lines_settled"], following ? 0.8 * row["lines"].get<double>() : 0.0) << row;
      EXPECT_GE(row["live_lanes"], row["candidate_pairs"]) << row;
    }
    if (!following) {
      EXPECT_EQ(row["lines_settled"], 0) << row;
    }
  }
  EXPECT_NE(bench.out().find("0 different"), std::string::npos) << bench.out();
  for (const char* name : {"steps.md", "steps.csv", "steps_work.csv"}) EXPECT_FALSE(bench.table(name).empty());
}

/// A curve with error = factor / time and edges that halve as the time grows fourfold.
WorkPrecisionCurve inverse_in_time(double factor, double first_us, int points) {
  WorkPrecisionCurve curve;
  for (int k = 0; k < points; ++k) {
    const double time = first_us * std::pow(4.0, k);
    curve.points.push_back({100, 1 / std::sqrt(time), time, factor / time, factor / time});
  }
  return curve;
}

TEST(BenchWorkPrecision, ErrorsAreComparedAtEqualTime) {
  const WorkPrecisionCurve over = inverse_in_time(12, 10, 4), under = inverse_in_time(3, 30, 4);
  const auto ratio = errors_at_equal_time(over, under, ErrorAgainst::smooth);
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(ratio->from_us, 30, 1e-12);
  EXPECT_NEAR(ratio->to_us, 640, 1e-10);
  EXPECT_NEAR(ratio->least, 4, 1e-12);
  EXPECT_NEAR(ratio->greatest, 4, 1e-12);
  EXPECT_NEAR(*over.order(ErrorAgainst::smooth), 2, 1e-12);
  EXPECT_FALSE(errors_at_equal_time(over, inverse_in_time(3, 1000, 4), ErrorAgainst::smooth)) << "no common time";
  EXPECT_FALSE(errors_at_equal_time(over, {}, ErrorAgainst::smooth));
  EXPECT_FALSE(inverse_in_time(12, 10, 1).order(ErrorAgainst::smooth));
}

TEST(BenchWorkPrecision, TheLeastAndTheGreatestRatioAreAtPointsOfEitherCurve) {
  // A kink at 20 us lies between the ends of the times that both curves cover.
  WorkPrecisionCurve kinked;
  kinked.points = {{1, 1, 10, 1, 1}, {1, 1, 20, 0.01, 1}, {1, 1, 40, 0.01, 1}};
  const auto ratio = errors_at_equal_time(kinked, inverse_in_time(1, 10, 2), ErrorAgainst::smooth);
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(ratio->least, 0.2, 1e-12);
  EXPECT_NEAR(ratio->greatest, 10, 1e-12);
}

TEST(BenchWorkPrecision, ErrorsAreOfSecondOrderAndThePlotsSayWhatTheyShow) {
  const QuickBench bench("work-precision");
  const Json all = Json::parse(bench.table("work_precision.json"));
  EXPECT_EQ(all["orientations"], 5);

  // By bodies, engine, scheme and meshes, from coarse to fine. What takes long is left out of the fine ones.
  std::map<std::string, std::vector<Json>> curves;
  for (const Json& row : all["points"]) {
    EXPECT_GT(row["median_us"], 0) << row;
    std::string curve;
    for (const char* key : {"bodies", "engine", "scheme", "meshes"}) curve += row[key].get<std::string>() + '|';
    curves[curve].push_back(row);
  }
  EXPECT_EQ(curves.size(), 4U * work_precision_methods().size());
  for (const auto& [curve, points] : curves) {
    for (std::size_t k = 1; k < points.size(); ++k) {
      const auto order = [&coarse = points[k - 1], &fine = points[k]](const char* error) {
        return std::log2(coarse[error].get<double>() / fine[error].get<double>()) /
               std::log2(coarse["edge_m"].get<double>() / fine["edge_m"].get<double>());
      };
      EXPECT_NEAR(order("error_against_smooth"), 2, 0.6) << curve;
      if (curve.find("barycentric") == std::string::npos) continue;
      EXPECT_NEAR(order("error_against_integral"), 2, 0.8) << curve;
    }
    if (curve.find("clipped") == std::string::npos) continue;
    for (const Json& point : points) EXPECT_LT(point["error_against_integral"], 1e-9) << point;
  }
  EXPECT_EQ(all["barycentric_over_clipped"].size(), 12U);
  for (const Json& row : all["barycentric_over_clipped"]) {
    if (row["against"] == "smooth bodies") continue;
    EXPECT_GT(row["ratio_same_meshes"], 1e6) << row;
  }

  EXPECT_NE(bench.table("work_precision.md").find("| ball in socket | fast | clipped |"), std::string::npos);
  EXPECT_EQ(lines_of(bench.table("work_precision.csv")).size(), all["points"].size() + 1);
  for (const char* pair : {"sphere-on-plane", "sphere-on-sphere", "ball-in-socket", "bubble-on-bubble"}) {
    const std::string picture = bench.table(std::string("work_precision_") + pair + ".svg");
    EXPECT_EQ(fault_in_xml(picture), "") << pair;
    for (const char* words : {"time for one evaluation of force and torque", "relative error of the force",
                              "Error against the smooth bodies", "At equal time the barycentric error is",
                              "5 fixed orientations", "pcm, clipped scheme", "algorithm as published in 2003"})
      EXPECT_NE(picture.find(words), std::string::npos) << pair << ": " << words;
  }
}

TEST(BenchBadInput, IsRefusedInOneLine) {
  const TemporaryFolder scratch;
  const std::string file = scratch.write("file", "");
  const auto expect_bad_input = [](const std::vector<std::string>& arguments, const std::string& named) {
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
  };
  expect_bad_input({"bench"}, "pcm bench --help");
  expect_bad_input({"bench", "sausage"}, "sausage");
  expect_bad_input({"bench", "peers", "--poses", "0"}, "--poses");
  expect_bad_input({"bench", "peers", "--poses", "many"}, "--poses");
  expect_bad_input({"bench", "peers", "--bodies", "bubbles,sausage"}, "sausage");
  expect_bad_input({"bench", "peers", "--quick", "--out", file}, file);
  expect_bad_input({"bench", "scaling", "--quick", "--out", file}, file);
  expect_bad_input({"bench", "scaling", "--quick", "more"}, "more");
  expect_bad_input({"bench", "skip", "--steps", "0"}, "--steps");
  expect_bad_input({"bench", "skip", "--quick", "--out", file}, file);
  expect_bad_input({"bench", "work-precision", "--quick", "--out", file}, file);
}

}  // namespace
}  // namespace pcm::compare::bench_test
