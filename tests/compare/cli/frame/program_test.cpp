// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program prints when all is well: helps, JSON, surfaces.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/io/json/exact_json.h"
#include "compare/verify/run/verify.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "tests/compare/cli/two_boxes.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using Words = std::vector<std::string>;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& member : object.items()) keys.push_back(member.key());
  return keys;
}

class Program : public TwoBoxes {};

constexpr const char* kOverlap = "1 0 0  0 1 0  0 0 1  0.125 0.25 0.875\n";

TEST(ProgramHelp, EveryCommandShowsAnExample) {
  for (const Words& command :
       {Words{}, Words{"bench"}, Words{"bench", "peers"}, Words{"bench", "scaling"}, Words{"bench", "skip"},
        Words{"bench", "work-precision"}, Words{"contact"}, Words{"inspect"}, Words{"poses"}, Words{"judge"},
        Words{"answer"}, Words{"verify"}, Words{"mesh"}, Words{"mesh", "check"}, Words{"mesh", "make"},
        Words{"mesh", "convert"}}) {
    Words arguments = command;
    arguments.emplace_back("--help");
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("Example"), std::string::npos) << outcome.out;
    for (const std::string& word : command) EXPECT_NE(outcome.out.find(word), std::string::npos) << outcome.out;
  }
  EXPECT_EQ(run_pcm({"--version"}).out.substr(0, 4), "pcm ");
}

TEST(ProgramHelp, OfVerifySaysWhatTheMeasureLeavesOutAndHowManyCasesAreKept) {
  std::string help = run_pcm({"verify", "--help"}).out;
  std::replace(help.begin(), help.end(), '\n', ' ');
  for (const std::string words :
       {"one answer at least", "greatest penetrations at the 99th", "pairs made", "unfinished"})
    EXPECT_NE(help.find(words), std::string::npos) << words;
  EXPECT_NE(help.find("first " + std::to_string(kMostFindings) + " answers"), std::string::npos) << help;
}

TEST_F(Program, ContactPrintsTheKeysOfTheContractInTheirOrder) {
  const std::vector<std::string> contract{"touching",
                                          "nested",
                                          "ambiguous",
                                          "polygons",
                                          "E",
                                          "F",
                                          "volume",
                                          "elements",
                                          "force",
                                          "torque",
                                          "max_penetration",
                                          "penetration_exceeded",
                                          "too_deep",
                                          "patches",
                                          "work"};
  for (const std::string engine : {"fast", "reference"}) {
    const std::vector<Json> answers = contact(kOverlap, {"--engine", engine});
    ASSERT_EQ(answers.size(), 1U);
    const Json& answer = answers.front();
    std::vector<std::string> keys = keys_of(answer);
    ASSERT_GE(keys.size(), contract.size());
    keys.resize(contract.size());
    EXPECT_EQ(keys, contract);
    for (const char* side : {"E", "F"}) {
      std::vector<std::string> area_keys = keys_of(answer[side]);
      area_keys.resize(4);
      EXPECT_EQ(area_keys, (std::vector<std::string>{"intersected", "inner", "area", "vector_area"}));
      EXPECT_TRUE(answer[side]["intersected"].is_number_integer());
    }
    ASSERT_EQ(answer["polygons"].size(), 1U);
    EXPECT_EQ(keys_of(answer["polygons"][0]), (std::vector<std::string>{"closed", "points"}));
    EXPECT_EQ(answer["polygons"][0]["closed"], true);
    EXPECT_GE(answer["polygons"][0]["points"].size(), 4U);
    EXPECT_TRUE(answer["work"].is_object());
  }
}

TEST_F(Program, BoxesThatOverlapByAnEighthHaveTheVolumeAndAreasWorkedOutByHand) {
  // [-1/2, 1/2]^3 and the same moved by (1/8, 1/4, 7/8): the intersection is 7/8 by 3/4 by 1/8. On E's side it is
  // bounded by E's top (7/8 3/4), and by strips of the faces at +x and +y.
  const double top = 0.875 * 0.75;
  const double strips = (0.875 + 0.75) * 0.125;
  for (const std::string engine : {"fast", "reference"}) {
    const Json answer = contact(kOverlap, {"--engine", engine}).front();
    EXPECT_EQ(answer["touching"], true);
    EXPECT_EQ(answer["patches"], 1);
    EXPECT_NEAR(answer["volume"].get<double>(), 0.875 * 0.75 * 0.125, 1e-15);
    EXPECT_NEAR(answer["E"]["area"].get<double>(), top + strips, 1e-15);
    EXPECT_NEAR(answer["F"]["area"].get<double>(), top + strips, 1e-15);
  }
}

TEST_F(Program, PublishedAlgorithmsAnswerWithoutAreas) {
  const Json fast = contact("0.6 -0.8 0  0.8 0.6 0  0 0 1  0.1 0.2 0.9\n").front();
  for (const std::string engine : {"published-2003", "published-2023"}) {
    const Json answer = contact("0.6 -0.8 0  0.8 0.6 0  0 0 1  0.1 0.2 0.9\n", {"--engine", engine}).front();
    EXPECT_EQ(answer["elements"], fast["elements"]);
    EXPECT_NEAR(answer["force"][2].get<double>(), fast["force"][2].get<double>(), 1e-9 * 1e6);
    EXPECT_TRUE(answer["E"]["area"].is_null());
    EXPECT_TRUE(answer["volume"].is_null());
  }
}

TEST_F(Program, VerifyHoldsSeveralEnginesSideBySide) {
  const std::string folder = scratch_.path("engines");
  const Outcome outcome = run_pcm({"verify", "--engine", "fast,published-2003,published-2023", "--poses", "80",
                                   "--pair", box_, box_, "--jobs", "1", "--out", folder});
  EXPECT_EQ(outcome.status, 1) << "published-2003 is wrong somewhere";
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("fast 0, published-2003"), std::string::npos) << outcome.out;
  EXPECT_NE(read_text_file(folder + "/wrong_answers.md").find("| degenerate | 10 | 0 |"), std::string::npos);
  const Json whole = Json::parse(read_text_file(folder + "/wrong_answers.json"));
  EXPECT_EQ(whole["complete"], true);
  EXPECT_EQ(whole["strata"].size(), 9u);  // eight and all
  EXPECT_EQ(whole["strata"].back()["fast_wrong"], 0);
  EXPECT_GT(whole["strata"].back()["published_2003_polygons"], 0);
  EXPECT_EQ(lines_of(read_text_file(folder + "/wrong_answers.csv")).size(), 10u);
  EXPECT_EQ(run_pcm({"verify", "--engine", "fast", "--poses", "6", "--pair", box_, box_}).status, 0);
}

TEST_F(Program, EngineAndOracleAgree) {
  const std::string poses = std::string(kOverlap) +
                            "0.6 -0.8 0  0.8 0.6 0  0 0 1  0.1 0.2 0.9  0.5 -0.25 -1  0.1 0.2 0.3\n"
                            "1 0 0  0 1 0  0 0 1  3 0 0\n";
  const Words law{"--mode", "both", "--damping", "1e3", "--friction", "0.3", "--slip-velocity", "0.01"};
  Words exact = law;
  exact.insert(exact.end(), {"--engine", "reference"});
  const std::vector<Json> fast = contact(poses, law);
  const std::vector<Json> reference = contact(poses, exact);
  ASSERT_EQ(fast.size(), 3U);
  ASSERT_EQ(reference.size(), 3U);
  for (std::size_t i = 0; i < fast.size(); ++i) {
    for (const char* key : {"touching", "nested", "ambiguous", "elements", "too_deep", "patches"})
      EXPECT_EQ(fast[i][key], reference[i][key]) << key << " of pose " << i;
    for (const char* side : {"E", "F"}) {
      for (const char* key : {"intersected", "inner"}) EXPECT_EQ(fast[i][side][key], reference[i][side][key]);
      EXPECT_NEAR(fast[i][side]["area"].get<double>(), reference[i][side]["area"].get<double>(), 1e-14);
    }
    EXPECT_NEAR(fast[i]["volume"].get<double>(), reference[i]["volume"].get<double>(), 1e-14);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(fast[i]["force"][k].get<double>(), reference[i]["force"][k].get<double>(), 1e-7);
      EXPECT_NEAR(fast[i]["torque"][k].get<double>(), reference[i]["torque"][k].get<double>(), 1e-7);
    }
  }
}

TEST_F(Program, HexadecimalAndDecimalPosesGiveTheSameBits) {
  const std::string decimal = "0.6 -0.8 0 0.8 0.6 0 0 0 1 0.1 0.2 0.9\n";
  const std::string hexadecimal =
      "0x1.3333333333333p-1 -0x1.999999999999ap-1 0x0p+0 0x1.999999999999ap-1\t0x1.3333333333333p-1 0 0 0 1 "
      "0x1.999999999999ap-4 0x1.999999999999ap-3 0X1.CCCCCCCCCCCCDP-1 # the same\r\n";
  EXPECT_EQ(contact(decimal), contact(hexadecimal));
}

TEST_F(Program, WithoutAPosesFileThePoseIsTheIdentityAtRest) {
  const Outcome outcome = run_pcm({"contact", box_, box_});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(Json::parse(outcome.out), contact("1 0 0 0 1 0 0 0 1 0 0 0\n").front());
}

TEST_F(Program, VolumeIsNullWhereASurfaceIsOpen) {
  const std::string pyramid = scratch_.path("pyramid.obj");
  ASSERT_EQ(run_pcm({"mesh", "make", "pyramid", "-o", pyramid}).status, 0);
  for (const std::string engine : {"fast", "reference"}) {
    const Outcome outcome = run_pcm({"contact", box_, pyramid, "--engine", engine});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(Json::parse(outcome.out)["volume"].is_null());
  }
}

TEST_F(Program, MeshCheckSaysFitOrWhyNot) {
  const Outcome fit = run_pcm({"mesh", "check", box_});
  EXPECT_EQ(fit.status, 0);
  EXPECT_NE(fit.out.find("12 faces"), std::string::npos) << fit.out;

  const std::string open = scratch_.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome open_outcome = run_pcm({"mesh", "check", open});
  EXPECT_EQ(open_outcome.status, 0);
  EXPECT_NE(open_outcome.out.find("open"), std::string::npos) << open_outcome.out;

  const std::string unfit = scratch_.write("unfit.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const Outcome unfit_outcome = run_pcm({"mesh", "check", box_, unfit});
  EXPECT_EQ(unfit_outcome.status, 1);
  EXPECT_EQ(unfit_outcome.err, "");
  EXPECT_NE(unfit_outcome.out.find("zero area"), std::string::npos) << unfit_outcome.out;

  for (const std::string size : {"1e200", "1e-200"}) {
    const std::string vast = scratch_.write("vast.obj", "v " + size + " 0 0\nv 0 " + size + " 0\nv 0 0 0\nf 1 2 3\n");
    const Outcome vast_outcome = run_pcm({"mesh", "check", vast});
    EXPECT_EQ(vast_outcome.status, 1);
    EXPECT_NE(vast_outcome.out.find("not fit"), std::string::npos) << vast_outcome.out;
    EXPECT_NE(vast_outcome.out.find("unit of length"), std::string::npos) << vast_outcome.out;
    EXPECT_EQ(run_pcm({"contact", vast, box_}).status, 2);
  }

  const Outcome unreadable = run_pcm({"mesh", "check", scratch_.path("missing.obj"), unfit});
  EXPECT_EQ(unreadable.status, 2);
  EXPECT_EQ(unreadable.out, lines_of(unfit_outcome.out).size() > 2 ? run_pcm({"mesh", "check", unfit}).out : "");
}

TEST_F(Program, MeshCheckWarnsOfFacesThatIntersect) {
  const std::string crossed = scratch_.write("crossed.obj",
                                             "v 0 0 0\nv 2 0 0\nv 0 2 0\n"
                                             "v 0.5 0.5 -1\nv 0.5 0.5 1\nv 3 3 0\nf 1 2 3\nf 4 5 6\n");
  const Outcome outcome = run_pcm({"mesh", "check", crossed});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("warning"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1-2"), std::string::npos) << outcome.out;
}

TEST_F(Program, ContactAndVerifyWarnOnceOfSurfacesThatIntersectThemselves) {
  const std::string crossed = scratch_.write("crossed.obj",
                                             "v 0 0 0\nv 2 0 0\nv 0 2 0\n"
                                             "v 0.5 0.5 -1\nv 0.5 0.5 1\nv 3 3 0\nf 1 2 3\nf 4 5 6\n");
  for (const Words& arguments : {Words{"contact", crossed, crossed},
                                 Words{"verify", "--poses", "1", "--strata", "generic", "--pair", crossed, crossed}}) {
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("pcm: warning: " + crossed)) << outcome.err;
  }
  EXPECT_EQ(run_pcm({"contact", box_, box_}).err, "");
}

TEST_F(Program, VerifyLabelsPairsSoThatTablesCanHoldThem) {
  const std::string odd = scratch_.path("a,b|\"c\"\xE9.obj");
  std::filesystem::copy_file(box_, odd);
  const Outcome outcome = run_pcm({"verify", "--poses", "8", "--pair", odd, box_, "--out", scratch_.path("tables")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\na_b__c__-box "), std::string::npos) << outcome.out;
  const std::string table = read_text_file(scratch_.path("tables/verification.md"));
  EXPECT_NE(table.find("| a_b__c__-box | generic | barycentric | both | 1 |"), std::string::npos) << table;
  EXPECT_TRUE(std::filesystem::exists(scratch_.path("tables/verification.json")));
  EXPECT_TRUE(lines_of(outcome.out).back().starts_with("verified: 8 poses")) << outcome.out;
}

TEST_F(Program, VerifyAsksAllPosesUnderTheLawThatIsGiven) {
  const std::string tables = scratch_.path("tables");
  const Words verify{"verify", "--poses", "6", "--pair", box_, box_, "--stiffness", "2e5", "--friction", "0.25"};
  Words with_tables = verify;
  with_tables.insert(with_tables.end(), {"--out", tables});
  const Outcome outcome = run_pcm(with_tables);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(lines_of(outcome.out).back().starts_with("verified: 6 poses")) << outcome.out;
  const Json provenance = Json::parse(read_text_file(tables + "/verification.provenance.json"));
  EXPECT_EQ(provenance["question"]["law"]["stiffness"], 2e5);
  EXPECT_EQ(provenance["question"]["law"]["friction"], 0.25);
  EXPECT_EQ(provenance["question"]["law"]["damping"], 0);
  const std::string command_line = provenance["command_line"];
  EXPECT_TRUE(command_line.starts_with("pcm verify --poses 6 --pair ")) << command_line;
  EXPECT_NE(command_line.find(" --stiffness 2e5 --friction 0.25 --out "), std::string::npos) << command_line;
}

TEST_F(Program, VerifyRefusesLawsUnderWhichTheBoundsOfTheVerdictNeedNotHold) {
  const auto refused = [this](const Words& law, const std::string& option, const std::string& range) {
    Words verify{"verify", "--poses", "2", "--pair", box_, box_};
    verify.insert(verify.end(), law.begin(), law.end());
    const Outcome outcome = run_pcm(verify);
    EXPECT_EQ(outcome.status, 2) << option;
    EXPECT_NE(outcome.err.find(option), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(range), std::string::npos) << outcome.err;
  };
  const std::string of_factors = "from 2^-200 to 2^200 (6e-61 to 2e+60)",
                    of_thresholds = "from 2^-400 to 2^400 (4e-121 to 3e+120)";
  for (const char* option : {"--stiffness", "--damping", "--friction"})
    for (const char* number : {"1e308", "1e61", "1e-61", "1e-308"}) refused({option, number}, option, of_factors);
  for (const char* option : {"--transition-depth", "--slip-velocity", "--max-penetration"})
    for (const char* number : {"1e308", "1e121", "1e-121", "1e-308"}) refused({option, number}, option, of_thresholds);
  refused({"--stiffness-E", "1e-61", "--stiffness-F", "1"}, "--stiffness-E or --layer-E", of_factors);
  refused({"--layer-E", "1,0,1", "--layer-F", "1e61,0,1"}, "--stiffness-F or --layer-F", of_factors);
  for (const char* number : {"1e60", "1e-60"}) {
    const Outcome outcome = run_pcm({"verify", "--poses", "600", "--pair", box_, box_, "--stiffness", number,
                                     "--damping", number, "--friction", number, "--slip-velocity", number,
                                     "--transition-depth", number, "--max-penetration", number});
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    EXPECT_NE(outcome.err.find("the stratum is left out"), std::string::npos) << outcome.err;
  }
  const Outcome named =
      run_pcm({"verify", "--poses", "8", "--strata", "extreme", "--pair", box_, box_, "--damping", "1e13"});
  EXPECT_EQ(named.status, 2);
  EXPECT_NE(named.err.find("stratum extreme: with --damping of 1e+13"), std::string::npos) << named.err;
}

TEST_F(Program, TablesOfVerifyCarryWhatMadeThem) {
  const std::string tables = scratch_.path("tables");
  ASSERT_EQ(run_pcm({"verify", "--poses", "6", "--seed", "9", "--pair", box_, box_, "--out", tables}).status, 0);
  const Json provenance = Json::parse(read_text_file(tables + "/verification.provenance.json"));
  EXPECT_EQ(provenance["question"]["seed"], 9);
  EXPECT_EQ(provenance["question"]["complete"], true);
  EXPECT_EQ(provenance["question"]["pairs"][0]["surfaces"].size(), 2U);
  EXPECT_EQ(provenance["files"].size(), 10U);
  EXPECT_EQ(provenance["files"]["overview.csv"]["units"]["force error"], "S/p");
  EXPECT_EQ(provenance["files"]["verification.csv"]["units"]["backward_error_ulps"], "ulp");
  EXPECT_EQ(provenance["files"]["verification.csv"]["units"]["force p99.9"], "S/p");
  EXPECT_FALSE(provenance["files"]["verification.csv"]["units"].contains("poses"));
  EXPECT_EQ(Json::parse(read_text_file(tables + "/verification.json"))["provenance"]["commit"], provenance["commit"]);
  for (const char* file : {"/overview.tex", "/verification.tex", "/times.tex"})
    EXPECT_NE(read_text_file(tables + file).find("\\bottomrule"), std::string::npos) << file;
}

TEST_F(Program, MadeSurfacesArePrintedOrWrittenAlike) {
  const Words make{"mesh", "make", "torus", "--tube_radius=0.1", "--segments", "12"};
  Words to_file = make;
  to_file.insert(to_file.end(), {"-o", scratch_.path("torus.obj")});
  ASSERT_EQ(run_pcm(to_file).status, 0);
  ASSERT_EQ(run_pcm({"mesh", "convert", scratch_.path("torus.obj"), scratch_.path("copy.obj")}).status, 0);
  const Outcome checked = run_pcm({"mesh", "check", scratch_.path("copy.obj")});
  EXPECT_NE(checked.out.find("384 faces"), std::string::npos) << checked.out;
  std::string made = run_pcm(make).out;
  const std::string written = run_pcm({"mesh", "make", "torus", "--tube_radius=0.1", "--segments=12"}).out;
  EXPECT_EQ(made, written);
}

TEST(ExactJson, DoublesReadBackBitForBit) {
  for (const double value : {0.0, -0.0, 1.0, -1e6, 0.1, 1e22, 5e-324, 1.7976931348623157e308, 123456789012345680.0}) {
    const std::string text = dump_exactly(value);
    const double back = Json::parse(text).get<double>();
    EXPECT_EQ(back, value) << text;
    EXPECT_EQ(std::signbit(back), std::signbit(value)) << text;
    EXPECT_TRUE(Json::parse(text).is_number_float()) << text;
  }
}

TEST(ExactJson, WhatIsNotFiniteIsRefusedByName) {
  const Json value{{"force", {0.0, std::numeric_limits<double>::quiet_NaN()}}};
  try {
    dump_exactly(value);
    FAIL() << "a NaN was printed";
  } catch (const pcm::BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("force"), std::string::npos);
  }
}

TEST(ExactJson, KeepsOrderAndStructure) {
  const Json value{{"b", 1}, {"a", {true, nullptr, "x\"y"}}, {"c", Json::object()}};
  EXPECT_EQ(dump_exactly(value), R"({"b":1,"a":[true,null,"x\"y"],"c":{}})");
}

}  // namespace
}  // namespace pcm::compare
