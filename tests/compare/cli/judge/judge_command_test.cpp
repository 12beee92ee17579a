// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The programs as users meet them: poses out, answers in, a conversation, and what they leave behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "compare/io/provenance/sha256.h"
#include "compare/io/split_at_commas.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using Words = std::vector<std::string>;

constexpr std::string_view kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string last_line(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  return lines.empty() ? "" : lines.back();
}

class JudgeCommand : public testing::Test {
 protected:
  void SetUp() override {
    const std::string surface = scratch_.write("tetrahedron.obj", kTetrahedron);
    const Outcome written =
        run_pcm({"poses", "--out", poses_, "--poses", "60", "--pair", surface, surface, "--jobs", "2"});
    ASSERT_EQ(written.status, 0) << written.err;
    const Outcome answered = run_pcm({"answer", "--poses", poses_});
    ASSERT_EQ(answered.status, 0) << answered.err;
    answers_ = lines_of(answered.out);
    ASSERT_EQ(answers_.size(), 61U);
  }

  Outcome judge(const std::vector<std::string>& lines, Words options = {}) const {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    Words words{"judge", scratch_.write("answers.jsonl", text), "--poses", poses_, "--jobs", "2"};
    words.insert(words.end(), options.begin(), options.end());
    return run_pcm(words);
  }
  /// Values of a CSV file by the names of their columns, a map a row.
  static std::vector<std::map<std::string, std::string>> rows_of(const std::string& csv) {
    const std::vector<std::string> lines = lines_of(csv);
    const std::vector<std::string> names = split_at_commas(lines.at(0));
    std::vector<std::map<std::string, std::string>> rows;
    for (std::size_t k = 1; k < lines.size(); ++k) {
      const std::vector<std::string> values = split_at_commas(lines[k]);
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (i == 0) rows.emplace_back();
        rows.back()[names[i]] = values.at(i).starts_with('"') ? values[i].substr(1, values[i].size() - 2) : values[i];
      }
    }
    return rows;
  }
  /// The number that follows a key of a JSON line is replaced.
  static std::string replaced(std::string line, const std::string& from, const std::string& to) {
    const std::size_t at = line.find(from);
    EXPECT_NE(at, std::string::npos) << from << " in " << line;
    return line.replace(at, from.size(), to);
  }

  const TemporaryFolder scratch_;
  const std::string poses_ = scratch_.path("poses");
  std::vector<std::string> answers_;
};

TEST_F(JudgeCommand, OurOwnEngineAsAForeignOneIsRight) {
  const Outcome outcome = judge(answers_, {"--out", scratch_.path("judged")});
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(last_line(outcome.out), "right: 60 answers, 0 wrong, 0 near another answer");
  for (const char* file : {"judgement.md", "judgement.json", "strata.csv", "facts.csv"})
    EXPECT_TRUE(std::filesystem::exists(scratch_.path("judged") + "/" + file)) << file;
  const auto question =
      nlohmann::json::parse(content_of(scratch_.path("judged") + "/judgement.provenance.json")).at("question");
  EXPECT_EQ(question["complete"], true);
  EXPECT_EQ(question["answers"]["sha256"], sha256(content_of(scratch_.path("answers.jsonl"))));
  EXPECT_EQ(question["poses"]["sha256"], sha256(content_of(poses_ + "/poses.jsonl")));

  const Outcome spoken = run_pcm({"judge", "--poses", poses_, "--command", std::string(PCM_PROGRAM) + " answer"});
  EXPECT_EQ(spoken.status, 0) << spoken.err << spoken.out;
  EXPECT_EQ(last_line(spoken.out), "right: 60 answers, 0 wrong, 0 near another answer");
}

TEST_F(JudgeCommand, SurfacesAreCalledAsTheirFilesWhateverTheFolder) {
  const nlohmann::json header = nlohmann::json::parse(lines_of(content_of(poses_ + "/poses.jsonl")).front());
  EXPECT_EQ(header["surfaces"][0]["name"], "tetrahedron");
  EXPECT_EQ(header["surfaces"][0]["file"], "surfaces/tetrahedron.obj");
  EXPECT_EQ(header["surfaces"].at(1)["name"], "tetrahedron-scaled-by-2--3");
}

TEST_F(JudgeCommand, AnswersThatSayNothingAreNeitherRightNorWrong) {
  std::vector<std::string> lines = answers_;
  for (std::string& line : lines) {
    const std::size_t id = line.find("\"id\":\"");
    if (id != std::string::npos) line = "{" + line.substr(id, line.find('"', id + 6) - id + 1) + "}";
  }
  const Outcome nothing = judge(lines);
  EXPECT_EQ(nothing.status, 1) << nothing.err << nothing.out;
  EXPECT_EQ(last_line(nothing.out),
            "nothing judged: 60 answers, 0 wrong, 0 near another answer, 60 with nothing that could be judged");
  lines.back() = answers_.back();
  const Outcome one = judge(lines);
  EXPECT_EQ(one.status, 0) << one.err << one.out;
  EXPECT_EQ(last_line(one.out),
            "right: 60 answers, 0 wrong, 0 near another answer, 59 with nothing that could be judged");
}

TEST_F(JudgeCommand, WrongAnswersOfEveryStratumAreShownAndCountedByPair) {
  std::vector<std::string> lines = answers_;
  for (std::string& line : lines) {
    if (line.find("\"touching\"") == std::string::npos) continue;  // the header
    const bool touches = line.find("\"touching\":true") != std::string::npos;
    line = replaced(line, touches ? "\"touching\":true" : "\"touching\":false",
                    touches ? "\"touching\":false" : "\"touching\":true");
  }
  const std::string out = scratch_.path("judged");
  const Outcome outcome = judge(lines, {"--ulps", "0", "--out", out});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  for (const char* stratum : {"generic", "grazing", "separated", "nested", "degenerate", "near-degenerate"}) {
    const std::string place = '/' + std::string(stratum) + '/';
    std::size_t shown = 0;
    for (const std::string& line : lines_of(outcome.out))
      shown += line.find(place) != std::string::npos && line.find("): touching: ") != std::string::npos ? 1 : 0;
    EXPECT_EQ(shown, 4U) << stratum;
  }
  EXPECT_NE(outcome.out.find("... and 36 more wrong answers; "), std::string::npos) << outcome.out;
  const std::vector<std::string> pairs = lines_of(content_of(out + "/pairs.csv"));
  EXPECT_EQ(pairs.front().rfind("pair,poses,right,near,wrong,wrong_ties,", 0), 0U);
  ASSERT_EQ(pairs.size(), 2U);
  const auto wrong = nlohmann::json::parse(content_of(out + "/judgement.json")).at("wrong_answers");
  ASSERT_EQ(wrong.size(), 60U);
  const auto ties = std::count_if(wrong.begin(), wrong.end(), [](const auto& one) { return one.at("tie") == true; });
  EXPECT_NE(pairs[1].find(",60,0,0,60," + std::to_string(ties) + ","), std::string::npos) << pairs[1];
  EXPECT_GT(ties, 0);
  EXPECT_LT(ties, 60);
}

TEST_F(JudgeCommand, WhatIsNotGivenAndWhatHasNoTruthAreCountedByThemselves) {
  const std::string out = scratch_.path("judged");
  ASSERT_EQ(judge(answers_, {"--out", out}).status, 0);
  std::int64_t without_volume = 0, without_elements = 0;
  for (const std::string& line : answers_) {
    const auto answer = nlohmann::json::parse(line);
    if (!answer.contains("id")) continue;  // the header
    without_volume += !answer.contains("volume") || answer["volume"].is_null();
    without_elements += answer["elements"].empty();
  }
  EXPECT_GT(without_elements, 0);
  std::map<std::string, std::map<std::string, std::string>> facts;
  for (auto& row : rows_of(content_of(out + "/facts.csv")))
    if (row["stratum"] == "all") facts[row["fact"]] = row;
  const auto expect = [&](const std::string& fact, std::int64_t not_given, std::int64_t no_truth) {
    EXPECT_EQ(facts[fact]["judged"], std::to_string(60 - not_given - no_truth)) << fact;
    EXPECT_EQ(facts[fact]["not_given"], std::to_string(not_given)) << fact;
    EXPECT_EQ(facts[fact]["no_truth"], std::to_string(no_truth)) << fact;
  };
  expect("touching", 0, 0);
  expect("volume", without_volume, 0);
  expect("element area", 0, without_elements);
}

TEST_F(JudgeCommand, AWrongAnswerIsShownAndKeptAsACase) {
  std::vector<std::string> lines = answers_;
  for (std::string& line : lines)
    if (line.find("/generic/0/") != std::string::npos) line = replaced(line, "\"touching\":true", "\"touching\":false");
  const std::string out = scratch_.path("judged");
  const Outcome outcome = judge(lines, {"--out", out});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(last_line(outcome.out), "NOT right: 60 answers, 1 wrong, 0 near another answer");
  EXPECT_NE(outcome.out.find(" (clear): touching: engine false, oracle true"), std::string::npos) << outcome.out;
  std::string kept;
  for (const auto& entry : std::filesystem::directory_iterator(out))
    if (entry.path().filename().string().starts_with("case_")) kept = entry.path().string();
  ASSERT_NE(kept, "");
  EXPECT_NE(content_of(kept).find("engine false, oracle true"), std::string::npos);
  const Outcome explained = run_pcm({"explain", kept});
  EXPECT_NE(explained.out.find("The case file says:\n  touching: engine false, oracle true\n"), std::string::npos)
      << explained.out;
  const Outcome replayed = run_pcm({"verify", "--case", kept});
  EXPECT_EQ(replayed.status, 0) << replayed.out;

  EXPECT_EQ(judge(answers_, {"--out", out}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(kept)) << "of an earlier run";
}

TEST_F(JudgeCommand, CaseFilesOfOthersInItsFolderAreLeftAlone) {
  std::vector<std::string> lines = answers_;
  for (std::string& line : lines)
    if (line.find("/generic/0/") != std::string::npos) line = replaced(line, "\"touching\":true", "\"touching\":false");
  const std::string out = scratch_.path("judged");
  ASSERT_EQ(judge(lines, {"--out", out}).status, 1);
  const auto cases = nlohmann::json::parse(content_of(out + "/judgement.json")).at("cases");
  ASSERT_EQ(cases.size(), 1U);
  const std::string own = out + "/" + cases[0].at("file").get<std::string>();
  ASSERT_EQ(cases[0].at("sha256"), sha256(content_of(own)));

  // As a `pcm verify --out` of the same folder has them.
  const std::string of_verify = scratch_.write("judged/case_a.json", R"({"format":"pcm case 1","origin":"a"})");
  EXPECT_EQ(judge(answers_, {"--out", out}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(own));
  EXPECT_TRUE(std::filesystem::exists(of_verify));

  ASSERT_EQ(judge(lines, {"--out", out}).status, 1);
  ASSERT_TRUE(std::filesystem::exists(own));
  std::filesystem::copy_file(of_verify, own, std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(judge(answers_, {"--out", out}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(own)) << "another command has replaced it";
}

TEST_F(JudgeCommand, FilesOfOthersUnderTheNamesOfTablesAreLeftAlone) {
  const std::string out = scratch_.path("judged");
  std::filesystem::create_directory(out);
  const std::string mine = scratch_.write("judged/pairs.csv", "mine");
  const Outcome refused = judge(answers_, {"--out", out});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("pairs.csv is there, and judgement.provenance.json does not say"), std::string::npos)
      << refused.err;
  EXPECT_EQ(content_of(mine), "mine");
  std::filesystem::remove(mine);
  EXPECT_EQ(judge(answers_, {"--out", out}).status, 0);
  EXPECT_EQ(judge(answers_, {"--out", out}).status, 0) << "its own are replaced";

  const std::string of_verify = scratch_.path("verified");
  std::filesystem::create_directory(of_verify);
  scratch_.write("verified/campaign.sqlite", "");
  const std::string beside = scratch_.write("verified/pairs.csv", "mine");
  EXPECT_EQ(judge(answers_, {"--out", of_verify}).status, 2);
  EXPECT_EQ(content_of(beside), "mine");

  const std::string answers = content_of(scratch_.path("answers.jsonl"));
  const std::string among_tables = scratch_.write("judged/facts.csv", answers);
  EXPECT_EQ(run_pcm({"judge", among_tables, "--poses", poses_, "--out", out}).status, 2);
  EXPECT_EQ(content_of(among_tables), answers);
}

TEST_F(JudgeCommand, EachWrongAnswerHasACaseOfItsOwnWhateverItsIdIsMadeOf) {
  // Two names that are one to a file system, and one longer than it takes.
  std::string poses = content_of(poses_ + "/poses.jsonl"), all;
  std::vector<std::string> lines = lines_of(poses), answers = answers_;
  const std::vector<std::string> names = {"a/b", "a_b", std::string(5000, 'x'), "a\\nb"};
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::string id = nlohmann::json::parse(lines[k]).at("id");
    if (k <= names.size()) {
      lines[k] = replaced(lines[k], id, names[k - 1]);
      answers[k] = replaced(answers[k], id, names[k - 1]);
      const bool touches = answers[k].find("\"touching\":true") != std::string::npos;
      answers[k] = touches ? replaced(answers[k], "\"touching\":true", "\"touching\":false")
                           : replaced(answers[k], "\"touching\":false", "\"touching\":true");
    }
  }
  for (const std::string& line : lines) all += line + "\n";
  std::ofstream(poses_ + "/poses.jsonl", std::ios::binary) << all;
  const std::string out = scratch_.path("judged");
  std::filesystem::create_directory(out);
  const std::string mine = scratch_.write("judged/case_a_b.json", "mine");
  const Outcome outcome = judge(answers, {"--out", out});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(content_of(mine), "mine");
  const auto cases = nlohmann::json::parse(content_of(out + "/judgement.json")).at("cases");
  ASSERT_EQ(cases.size(), names.size());
  std::set<std::string> files;
  for (const auto& one : cases) {
    const std::string file = one.at("file");
    files.insert(file);
    EXPECT_EQ(one.at("sha256"), sha256(content_of(out + "/" + file)));
    EXPECT_EQ(file.find('\n'), std::string::npos);
  }
  EXPECT_EQ(files.size(), names.size());
}

TEST_F(JudgeCommand, WaitsForAnEngineHoweverLongTheLimitIs) {
  const Outcome outcome =
      run_pcm({"judge", "--command", std::string(PCM_PROGRAM) + " answer", "--poses", poses_, "--time-limit", "1e300"});
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
}

TEST_F(JudgeCommand, WhatWasJudgedBeforeBadInputIsKept) {
  std::vector<std::string> lines(answers_.begin(), answers_.begin() + 31);
  lines.push_back("{\"id\":");
  const std::string out = scratch_.path("judged");
  const Outcome outcome = judge(lines, {"--out", out});
  EXPECT_EQ(outcome.status, 2);
  ASSERT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("answers.jsonl:32: this is no JSON object"), std::string::npos) << outcome.err;
  EXPECT_EQ(last_line(outcome.out), "unfinished: 30 answers, 0 wrong, 0 near another answer");
  EXPECT_NE(content_of(out + "/judgement.json").find("\"complete\": false"), std::string::npos);
}

TEST_F(JudgeCommand, PosesWithoutAnAnswerAreBadInput) {
  const Outcome outcome = judge({answers_.begin(), answers_.end() - 1});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("1 of 60 poses have no answer"), std::string::npos) << outcome.err;
  EXPECT_EQ(last_line(outcome.out), "unfinished: 59 answers, 0 wrong, 0 near another answer");
}

TEST_F(JudgeCommand, OurAnswersToAFileThatWasCutShortEndWithBadInput) {
  const std::string file = poses_ + "/poses.jsonl", whole = content_of(file);
  scratch_.write("poses/poses.jsonl", whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  const Outcome outcome = run_pcm({"answer", "--poses", poses_});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("59 poses, where the first line says 60"), std::string::npos) << outcome.err;
}

TEST_F(JudgeCommand, AnotherConventionEndsIt) {
  const std::string surface = scratch_.path("tetrahedron.obj");
  ASSERT_EQ(run_pcm({"poses", "--out", poses_, "--poses", "120", "--pair", surface, surface, "--strata",
                     "generic,degenerate", "--scheme", "clipped"})
                .status,
            0);
  std::vector<std::string> lines = lines_of(run_pcm({"answer", "--poses", poses_}).out);
  // Every number of a force gets another sign.
  const std::regex force(R"("force":\[(-?)([^,]*),(-?)([^,]*),(-?)([^\]]*)\])");
  for (std::string& line : lines) {
    std::smatch found;
    if (!std::regex_search(line, found, force)) continue;
    std::ostringstream negated;
    negated << found.prefix() << "\"force\":[";
    for (std::size_t k = 1; k < 7; k += 2)
      negated << (k == 1 ? "" : ",") << (found[k].length() == 0 ? "-" : "") << found[k + 1];
    negated << "]" << found.suffix();
    line = negated.str();
  }
  const Outcome outcome = judge(lines);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("the force has the opposite sign"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("answers.jsonl:"), std::string::npos) << outcome.err;
}

TEST_F(JudgeCommand, BreakdownsOfAnEngineAreCounted) {
  const std::string engine = scratch_.write("engine.sh",
                                            "read -r greeting\nwhile read -r line; do\n"
                                            "  id=${line#'{\"id\":\"'}\n  id=${id%%'\"'*}\n"
                                            "  case $id in\n    */grazing/0/*|*/degenerate/0/*) exit 1 ;;\n"
                                            "    */grazing/1/*) echo nonsense ;;\n"
                                            "    *) echo '{\"id\":\"'\"$id\"'\"}' ;;\n  esac\ndone\n");
  const Outcome outcome = run_pcm({"judge", "--poses", poses_, "--command", "sh '" + engine + "'"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(last_line(outcome.out),
            "NOT right: 60 answers, 3 wrong, 0 near another answer, 3 without an answer, 57 with nothing that could be "
            "judged");
  EXPECT_NE(outcome.out.find(" (clear): crash: it ended with status 1"), std::string::npos) << outcome.out;
  EXPECT_TRUE(std::regex_search(outcome.out, std::regex("/degenerate/0/\\w+ \\(tie\\): crash: "))) << outcome.out;
  EXPECT_NE(outcome.out.find("garbage: this is no JSON object"), std::string::npos) << outcome.out;
}

TEST_F(JudgeCommand, AnswersMayFollowTolerances) {
  std::string text;
  for (const std::string& line : answers_) text += line + "\n";
  const std::string answers = scratch_.write("answers.jsonl", text);
  for (const Words& tolerances :
       {Words{"--tolerance", "force=1e-6"}, Words{"--absolute", "force=1e-6,torque=1e-6"},
        Words{"--tolerance", "force=1e-6", "--absolute", "area=1e-9", "--tolerance", "torque=1e-6"}}) {
    Words words{"judge", "--poses", poses_};
    words.insert(words.end(), tolerances.begin(), tolerances.end());
    words.push_back(answers);
    const Outcome outcome = run_pcm(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
    EXPECT_EQ(last_line(outcome.out), "right: 60 answers, 0 wrong, 0 near another answer");
  }
}

TEST_F(JudgeCommand, RefusesWhatItCannotDo) {
  const auto expect = [&](const Words& words, const std::string& named) {
    const Outcome outcome = run_pcm(words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << "expected '" << named << "' in: " << outcome.err;
  };
  const std::string answers = scratch_.write("answers.jsonl", answers_[0]);
  expect({"judge", answers}, "--poses is missing");
  expect({"judge", "--poses", poses_}, "give either a file of answers or --command");
  expect({"judge", answers, "--command", "cat", "--poses", poses_}, "give either a file of answers or --command");
  expect({"judge", answers, "--poses", scratch_.path("nowhere")}, "poses.jsonl: this is no readable file");
  expect({"judge", scratch_.path("nothing"), "--poses", poses_}, "nothing: this is no readable file");
  expect({"judge", answers, "--poses", poses_, "--tolerance", "touching=1"}, "'touching' is none of area, volume");
  expect({"judge", answers, "--poses", poses_, "--tolerance", "force"}, "'force' has no '='");
  expect({"judge", answers, "--poses", poses_, "--absolute", "force=-1"}, "'-1' is no number from 0 on");
  expect({"judge", answers, "--poses", poses_, "--ulps", "-1"}, "--ulps");
  expect({"judge", "--command", "/no/such/engine", "--poses", poses_}, "'/no/such/engine' can't be started");
  expect({"judge", "--command", "sh 'x", "--poses", poses_}, "has no end");
  expect({"judge", "--command", "cat", "--poses", poses_, "--time-limit", "0"}, "--time-limit: 0 is not positive");
  expect({"poses", "--poses", "10"}, "--out is required");
}

}  // namespace
}  // namespace pcm::compare
