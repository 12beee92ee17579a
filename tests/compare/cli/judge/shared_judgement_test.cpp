// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A judgement that several processes share in has the tables and cases of one.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "meshes/generate/boxes.h"
#include "pcm/write_obj.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::shared_judgement_test {
namespace {

using Words = std::vector<std::string>;

class SharedJudgement : public testing::Test {
 protected:
  void SetUp() override {
    write_obj(generate::box({1, 1, 1}), scratch_.path("box.obj"));
    const std::string box = scratch_.path("box.obj");
    ASSERT_EQ(run_pcm({"poses", "--out", poses_, "--poses", "240", "--pair", box, box, "--jobs", "1"}).status, 0);
    const Outcome answered = run_pcm({"answer", "--poses", poses_});
    ASSERT_EQ(answered.status, 0) << answered.err;
    write_answers(answered.out);
    alone_ = run_pcm(judge("alone"));
    ASSERT_EQ(alone_.status, 1) << alone_.err;
  }

  /// Every seventh says the opposite of what it knows of touching.
  void write_answers(const std::string& right) const {
    std::string wrong;
    int line = 0;
    for (std::string text : lines_of(right)) {
      const std::size_t yes = text.find("\"touching\":true"), no = text.find("\"touching\":false");
      if (line++ % 7 == 0 && yes != std::string::npos)
        text.replace(yes, 15, "\"touching\":false");
      else if (line % 7 == 1 && no != std::string::npos)
        text.replace(no, 16, "\"touching\":true");
      if (line % 5 == 1) elements_to_number(text);
      wrong += text + "\n";
    }
    scratch_.write("answers.jsonl", wrong);
  }

  /// A mere number of elements, which has no truth in the clipped scheme.
  static void elements_to_number(std::string& text) {
    auto answer = nlohmann::ordered_json::parse(text);
    if (!answer.contains("elements")) return;
    answer["elements"] = answer["elements"].size();
    text = answer.dump();
  }

  Words judge(const std::string& folder, const Words& more = {}) const {
    Words words{"judge", scratch_.path("answers.jsonl"), "--poses", poses_, "--ulps", "0", "--jobs", "1",
                "--out", scratch_.path(folder)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  std::map<std::string, std::string> tables_in(const std::string& folder) const {
    std::map<std::string, std::string> tables;
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.path(folder))) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(".csv") || name.starts_with("case_")) tables[name] = content_of(entry.path());
    }
    return tables;
  }

  TemporaryFolder scratch_;
  std::string poses_ = scratch_.path("poses");
  Outcome alone_;
};

TEST_F(SharedJudgement, HasTheTablesAndCasesOfOneThatIsNot) {
  const Outcome shared = run_pcm(judge("shared", {"--shared"}));
  EXPECT_EQ(shared.status, 1) << shared.err;
  EXPECT_EQ(shared.out, alone_.out.replace(alone_.out.find("alone/judgement"), 5, "shared"));
  EXPECT_EQ(tables_in("shared"), tables_in("alone"));
  EXPECT_GT(tables_in("shared").size(), 20U);
  EXPECT_EQ(run_pcm(judge("shared", {"--shared"})).out, shared.out) << "asked again";
}

TEST_F(SharedJudgement, OfMpirunHasTheTablesAndCasesOfOneProcess) {
  if (!has_mpirun()) GTEST_SKIP() << "mpirun (Debian: openmpi-bin) is not installed";
  const Outcome outcome = run_by_mpirun(3, judge("ranks", {"--shared"}));
  EXPECT_NE(outcome.status, 0);
  const std::string& printed = outcome.out;
  const std::string verdict = "\n" + lines_of(alone_.out).back();
  EXPECT_NE(printed.find(verdict), std::string::npos) << printed << outcome.err;
  EXPECT_EQ(printed.find(verdict), printed.rfind(verdict)) << printed;
  EXPECT_EQ(tables_in("ranks"), tables_in("alone"));
}

TEST_F(SharedJudgement, AsksAnEngineAboutEachPoseOnce) {
  const std::string log = scratch_.path("asked");
  scratch_.write("engine.sh", "tee -a '" + log + "' | '" PCM_PROGRAM "' answer\n");
  const Words words{"judge",    "--command", "sh " + scratch_.path("engine.sh"), "--poses", poses_, "--jobs", "2",
                    "--shared", "--out",     scratch_.path("asked engine")};
  for (int k = 0; k < 2; ++k) {
    const Outcome outcome = run_pcm(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
    EXPECT_EQ(lines_of(outcome.out).back(), "right: 240 answers, 0 wrong, 0 near another answer");
  }
  EXPECT_EQ(lines_of(content_of(log)).size(), 241U) << "a header and each pose";
}

TEST_F(SharedJudgement, WithOtherAnswersOrTolerancesIsAnother) {
  ASSERT_EQ(run_pcm(judge("shared", {"--shared"})).status, 1);
  const auto refused = [](const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("it holds another judgement"), std::string::npos) << outcome.err;
  };
  Words other = judge("shared", {"--shared"});
  other[5] = "9";
  refused(run_pcm(other));
  refused(run_pcm(judge("shared", {"--shared", "--tolerance", "force=1e-3"})));
  scratch_.write("answers.jsonl", content_of(scratch_.path("answers.jsonl")) + "\n");
  refused(run_pcm(judge("shared", {"--shared"})));
}

TEST_F(SharedJudgement, OfAFileThatEndsInAHalfLineKeepsWhatCameBefore) {
  std::string text = content_of(scratch_.path("answers.jsonl"));
  const std::vector<std::string> lines = lines_of(text);
  text.clear();
  for (std::size_t k = 0; k < 100; ++k) text += lines[k] + "\n";
  scratch_.write("answers.jsonl", text + lines[100].substr(0, 20));
  const Outcome alone = run_pcm(judge("half alone")), shared = run_pcm(judge("half", {"--shared"}));
  EXPECT_EQ(shared.status, 2);
  EXPECT_EQ(shared.err, alone.err);
  EXPECT_NE(shared.err.find("answers.jsonl:101"), std::string::npos) << shared.err;
  EXPECT_EQ(tables_in("half"), tables_in("half alone"));
}

TEST_F(SharedJudgement, WantsAFolderAndAFile) {
  Words without = judge("x", {"--shared"});
  without.erase(without.begin() + 8, without.begin() + 10);
  EXPECT_EQ(run_pcm(without).status, 2);
  Words piped = judge("x", {"--shared"});
  piped[1] = "/dev/null";
  const Outcome outcome = run_pcm(piped);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("/dev/null: no file"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace pcm::compare::shared_judgement_test
