// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/report_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/io/provenance/program_provenance.h"
#include "compare/io/provenance/sha256.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/version.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::report_folder_test {
namespace {

using Json = nlohmann::ordered_json;

class ReportFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    ReportFolder report(scratch_.path(), "first", {{"seed", 7}});
    report.markdown("table", "# Table\n\n| a |\n|--:|\n| 1 |\n");
    report.csv("table", "pair,median_us,force max,edge,maximum,edge_12,12\nx,1,2,3,4,5,6\n",
               {{"us", "us"}, {"max", "N"}, {"edge", "m"}, {"imum", "wrong"}});
    report.json("table", {{"rows", {1, 2}}});
    report.json("list", Json::array({1, 2}));
    report.finish();
  }
  std::string content(const std::string& file) const { return read_text_file(scratch_.path(file)); }

  TemporaryFolder scratch_;
};

TEST_F(ReportFolderTest, EveryTableSaysWhatMadeIt) {
  const Json provenance = Json::parse(content("first.provenance.json"));
  EXPECT_EQ(provenance["version"], PCM_VERSION);
  EXPECT_EQ(provenance["question"], Json({{"seed", 7}}));
  for (const char* key : {"commit", "command_line", "processor", "compiler", "flags"}) {
    const std::string text = provenance[key];
    EXPECT_FALSE(text.empty()) << key;
    for (const char* file : {"table.md", "table.tex"})
      EXPECT_NE(content(file).find(text), std::string::npos) << key << " in " << file;
    EXPECT_EQ(Json::parse(content("table.json"))["provenance"][key], text);
  }
  const std::string command_line = provenance["command_line"];
  EXPECT_EQ(command_line.rfind("test_compare_", 0), 0U) << command_line;
}

TEST_F(ReportFolderTest, TablesStandAsTheyWere) {
  EXPECT_EQ(content("table.md").rfind("# Table\n\n| a |\n|--:|\n| 1 |\n", 0), 0U);
  EXPECT_EQ(content("table.csv"), "pair,median_us,force max,edge,maximum,edge_12,12\nx,1,2,3,4,5,6\n");
  EXPECT_EQ(Json::parse(content("table.json"))["rows"], Json({1, 2}));
  EXPECT_EQ(Json::parse(content("list.json")), Json({1, 2}));
  EXPECT_NE(content("table.tex").find("\\begin{longtable}{r}"), std::string::npos);
}

TEST_F(ReportFolderTest, ProvenanceHasHashesOfAllTablesAndUnitsOfColumns) {
  const Json files = Json::parse(content("first.provenance.json"))["files"];
  EXPECT_EQ(files.size(), 5U);
  for (const auto& [file, entry] : files.items()) EXPECT_EQ(entry["sha256"], sha256(content(file))) << file;
  EXPECT_EQ(files["table.csv"]["units"],
            Json({{"median_us", "us"}, {"force max", "N"}, {"edge", "m"}, {"edge_12", "m"}}));
}

TEST_F(ReportFolderTest, OfTwoCommandsKeepsWhatEachSaysOfItsTables) {
  ReportFolder second(scratch_.path(), "second", {{"seed", 8}});
  second.csv("other", "a\n1\n", {});
  second.finish();
  EXPECT_EQ(Json::parse(content("first.provenance.json"))["question"]["seed"], 7);
  EXPECT_EQ(Json::parse(content("second.provenance.json"))["question"]["seed"], 8);
  EXPECT_EQ(Json::parse(content("second.provenance.json"))["files"].size(), 1U);
}

TEST_F(ReportFolderTest, BegunAnewSaysNothingOfTheTablesOfBefore) {
  const ReportFolder again(scratch_.path(), "first", {});
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("first.provenance.json")));
}

TEST_F(ReportFolderTest, FilesOfOthersAreRefusedAndThoseOfAnUnfinishedCallAreNot) {
  const auto is_refused = [this](const char* command, const char* file) {
    try {
      refuse_files_of_others(scratch_.path(), command, {file});
      return false;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(std::string(file) + " is there"), std::string::npos) << error.what();
      return true;
    }
  };
  scratch_.write("mine.csv", "mine");
  EXPECT_TRUE(is_refused("first", "mine.csv"));
  EXPECT_TRUE(is_refused("second", "table.csv"));
  EXPECT_FALSE(is_refused("first", "table.csv"));
  EXPECT_FALSE(is_refused("first", "none.csv"));
  ReportFolder unfinished(scratch_.path(), "first", {});
  EXPECT_FALSE(is_refused("first", "table.csv"));
  unfinished.csv("new", "a\n1\n", {});
  EXPECT_FALSE(is_refused("first", "new.csv"));
  unfinished.finish();
  EXPECT_FALSE(is_refused("first", "new.csv"));
  EXPECT_TRUE(is_refused("first", "table.csv")) << "the last call has not written it";
  std::filesystem::create_directory(scratch_.path("third.provenance.json"));
  EXPECT_TRUE(is_refused("third", "mine.csv"));
}

TEST_F(ReportFolderTest, PicturesAreToldOfAsTablesAre) {
  ReportFolder again(scratch_.path(), "first", {});
  again.picture("picture", "<svg/>");
  again.finish();
  EXPECT_EQ(content("picture.svg"), "<svg/>");
  const Json files = Json::parse(content("first.provenance.json"))["files"];
  EXPECT_EQ(files["picture.svg"]["sha256"], sha256("<svg/>"));
}

TEST(ProgramProvenance, IsReadBackAsItWasWritten) {
  const ProgramProvenance program = this_program();
  EXPECT_EQ(provenance_json(program_from(provenance_json(program))), provenance_json(program));
  EXPECT_THROW(program_from({{"version", "1"}}), nlohmann::json::exception);
}

TEST(ProgramProvenance, WordsAreQuotedAsAShellWantsThem) {
  EXPECT_EQ(quoted_for_shell("--poses=200,x_y/z.obj"), "--poses=200,x_y/z.obj");
  EXPECT_EQ(quoted_for_shell("my results"), "'my results'");
  EXPECT_EQ(quoted_for_shell("it's"), "'it'\\''s'");
  EXPECT_EQ(quoted_for_shell(""), "''");
  EXPECT_EQ(quoted_for_shell("$HOME;rm"), "'$HOME;rm'");
  EXPECT_EQ(quoted_for_shell("~"), "'~'");
  EXPECT_EQ(quoted_for_shell("a\r'\xff"), "$'a\\x0d\\'\\xff'");
}

}  // namespace
}  // namespace pcm::compare::report_folder_test
