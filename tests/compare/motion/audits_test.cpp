// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/audits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/motion/audits_report.h"
#include "tests/compare/run_pcm.h"

namespace pcm::compare {
namespace {

/// The quick audits whose name begins so.
std::vector<AuditResult> results_of(const std::string& id) {
  std::vector<AuditResult> results;
  for (Audit& audit : audits(Extent::quick))
    if (audit.id.starts_with(id)) results.push_back(run(std::move(audit)));
  return results;
}

void expect_met(const std::string& id) {
  const std::vector<AuditResult> results = results_of(id);
  EXPECT_EQ(results.size(), 6U);
  EXPECT_TRUE(met(results)) << audits_summary(results);
}

TEST(Audits, WedgeGainsTheWorkOfItsClosedFormAndPushesSideways) {
  expect_met("wedge");
}

TEST(Audits, BoxJumpsForEachBarycentreItsWallsPassAndBringsBackTheWorkOfThoseWon) {
  expect_met("box on plate");
}

TEST(Audits, PlateAsMasterIsConservativeInTheClippedScheme) {
  expect_met("bubble on plate");
}

TEST(Audits, WorkAroundASmallSquareIsTheFluxOfTheRotationOfTheForce) {
  expect_met("bubbles, square");
}

/// A box that slides over a grid, with an expectation of the test's own.
AuditResult box_with(const std::function<void(Audit&)>& change) {
  std::vector<Audit> loops = audits(Extent::quick);
  const auto box = std::find_if(loops.begin(), loops.end(), [](const Audit& a) { return a.id.starts_with("box"); });
  change(*box);
  return run(std::move(*box));
}

TEST(Audits, AFigureOutOfItsBandIsMissed) {
  const auto misses = [](const std::function<void(Audit&)>& change) { return box_with(change).misses.size(); };
  EXPECT_EQ(misses([](Audit&) {}), 0U);
  EXPECT_EQ(misses([](Audit& a) { a.work = Band{1, 2}; }), 1U);
  EXPECT_EQ(misses([](Audit& a) { a.tangential = Band{1e-9, 1}; }), 1U);
  EXPECT_EQ(misses([](Audit& a) { a.jumps = Band{a.jumps->least + 1, a.jumps->greatest + 1}; }), 1U);
  EXPECT_EQ(misses([](Audit& a) { a.greatest_jump = Band{0, a.greatest_jump->least * 0.999}; }), 1U);
  // Stiffer by a part in a thousand: work and jumps show it.
  EXPECT_EQ(misses([](Audit& a) {
              ContactLaw law = a.pairing->law();
              law.stiffness *= 1.001;
              a.pairing = std::make_shared<const fast::Pairing>(a.pairing->surface_E(), a.pairing->surface_F(), law,
                                                                a.pairing->mode(), a.pairing->scheme());
            }),
            2U);
}

TEST(Audits, MissesAreInEveryTableAndTheVerdict) {
  const std::vector<AuditResult> results{box_with([](Audit& a) { a.jumps = within(0); })};
  EXPECT_FALSE(met(results));
  EXPECT_NE(audits_summary(results).find("MISSED"), std::string::npos);
  EXPECT_NE(audits_verdict(results).find("NOT met: 1 loops, 4 expectations, 1 rows missed"), std::string::npos)
      << audits_verdict(results);
  EXPECT_NE(audits_markdown(results).find("**no**"), std::string::npos);
  EXPECT_NE(audits_csv(results).find(",false\n"), std::string::npos);
  EXPECT_EQ(audits_json(results)["verdict"]["missed_rows"], 1);
}

TEST(AuditsProgram, OptionsThatItWouldNotHeedAreRefused) {
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--poses", "6"}, {"--mode", "F"}, {"--known-answers"}, {"--error-budget"}, {"--seed", "2"}}) {
    std::vector<std::string> arguments{"verify", "--audits"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("--audits"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace pcm::compare
