// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `pcm contact` with everything about a contact: --full, --csv, --elements, --no-polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "compare/io/json/exact_json.h"
#include "compare/io/provenance/sha256.h"
#include "tests/compare/cli/two_boxes.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kOverlap = "1 0 0  0 1 0  0 0 1  0.125 0.25 0.875\n";
constexpr const char* kTilted = "0.6 -0.8 0  0.8 0.6 0  0 0 1  0.1 0.2 0.9  0.5 -0.25 -1  0.1 0.2 0.3\n";
constexpr const char* kApart = "1 0 0  0 1 0  0 0 1  3 0 0\n";

/// The keys that --full adds to an answer, to a side and to a polygon.
const std::set<std::string> kAdded{"coincident", "crossing_pairs", "patch_list", "element_list", "pose", "provenance"};
const std::set<std::string> kAddedToSides{"area_open", "area_closed", "intersected_faces", "inner_faces"};
const std::set<std::string> kAddedToPolygons{"crossings", "patch"};

void expect_and_erase(Json& json, const std::set<std::string>& keys) {
  for (const std::string& key : keys) EXPECT_EQ(json.erase(key), 1U) << key;
}

/// Fields of a CSV line; none here is in quotes.
Words fields_of(const std::string& line) {
  Words fields(1);
  for (const char c : line) {
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

/// A CSV file by the names of its columns.
struct Csv {
  explicit Csv(const std::string& path) {
    const Words lines = lines_of(content_of(path));
    if (lines.empty()) return;
    names = fields_of(lines.front());
    for (std::size_t i = 1; i < lines.size(); ++i) rows.push_back(fields_of(lines[i]));
  }
  std::string at(std::size_t row, const std::string& name) const {
    for (std::size_t c = 0; c < names.size(); ++c)
      if (names[c] == name) return rows.at(row).at(c);
    ADD_FAILURE() << "no column " << name;
    return "";
  }
  double number(std::size_t row, const std::string& name) const { return std::stod(at(row, name)); }

  Words names;
  std::vector<Words> rows;
};

class ContactCommand : public TwoBoxes {};

TEST_F(ContactCommand, AFileIsWrittenThatIsNeitherReadNorWrittenOtherwise) {
  const std::string poses = scratch_.write("poses.txt", kOverlap), csv = scratch_.path("rows.csv");
  const std::string around = scratch_.path("./") + "rows.csv", box = content_of(box_);
  for (const Words& options : {Words{"--elements", box_}, Words{"--csv", poses}, Words{"--csv", csv, "--elements", csv},
                               Words{"--csv", csv, "--elements", around}, Words{"--csv", scratch_.path().string()},
                               Words{"--csv", ""}, Words{"--elements", "-"}, Words{"--vtk", ""}}) {
    Words arguments{"contact", box_, box_, "--poses", poses};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2) << options.back();
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(" name a"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(content_of(box_), box);
  EXPECT_EQ(content_of(poses), kOverlap);
  EXPECT_FALSE(std::filesystem::exists(csv));
  const std::string nowhere = scratch_.path("no") + "/rows.csv";
  const Outcome outcome = run_pcm({"contact", box_, box_, "--poses", poses, "--csv", nowhere});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find(nowhere + ": the file can't be created"), std::string::npos) << outcome.err;
}

TEST_F(ContactCommand, NoTableIsWrittenIntoTheFileThatTheAnswersArePrintedInto) {
  const std::string poses = scratch_.write("poses.txt", kOverlap), file = scratch_.path("rows.csv");
  for (const std::string& table : {file, std::string("/dev/stdout")}) {
    const Outcome outcome = run_pcm({"contact", box_, box_, "--poses", poses, "--csv", table}, file);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(table + ": what is printed goes there already"), std::string::npos) << outcome.err;
    EXPECT_EQ(content_of(file), "");
  }
}

TEST_F(ContactCommand, NoFileIsWrittenThatStandardInputIsReadFrom) {
  const std::string two_poses = std::string(kOverlap) + kOverlap, poses = scratch_.write("poses.txt", two_poses);
  for (const Words& words : {Words{"contact", box_, box_, "--poses", "-", "--csv", poses},
                             Words{"inspect", box_, box_, "--path", "-", "--out", poses},
                             Words{"explain", box_, box_, "--poses", "-", "--map", poses}}) {
    const Outcome outcome = run_pcm(words, {}, poses);
    EXPECT_EQ(outcome.status, 2) << words[0];
    EXPECT_NE(outcome.err.find("poses.txt: is read or written already"), std::string::npos) << outcome.err;
    EXPECT_EQ(content_of(poses), two_poses) << words[0];
  }
}

TEST_F(ContactCommand, ATableThatIsThereStaysWhereAnotherOutputCannotBeWritten) {
  const std::string poses = scratch_.write("poses.txt", kOverlap), table = scratch_.write("rows.csv", "precious");
  const std::string file = scratch_.write("file", "");
  const auto expect_kept = [&](const Words& options, const std::string& output, const std::string& named) {
    Words words{"contact", box_, box_, "--poses", poses, "--csv", table};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(words, output);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    EXPECT_EQ(content_of(table), "precious") << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(table + ".provenance.json"));
  };
  expect_kept({"--vtk", file}, {}, file);
  expect_kept({"--vtk", file + "/sub"}, {}, file);
  expect_kept({"--elements", scratch_.path("no") + "/x.csv"}, {}, "can't be created");
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  expect_kept({"--elements", "/dev/full"}, {}, "/dev/full");
  expect_kept({}, "/dev/full", "standard output");
}

TEST_F(ContactCommand, FilesOfOthersUnderTheNamesOfWhatItAddsAreLeftAlone) {
  const std::string poses = scratch_.write("poses.txt", kOverlap), csv = scratch_.path("rows.csv");
  const std::string mine = scratch_.write("rows.csv.provenance.json", "{\"mine\": 1}");
  const Outcome table = run_pcm({"contact", box_, box_, "--poses", poses, "--csv", csv});
  EXPECT_EQ(table.status, 2);
  EXPECT_NE(table.err.find(mine + ": would be overwritten"), std::string::npos) << table.err;
  EXPECT_EQ(content_of(mine), "{\"mine\": 1}");
  EXPECT_FALSE(std::filesystem::exists(csv));

  const std::string folder = scratch_.path("vtk");
  std::filesystem::create_directory(folder);
  const std::string picture = scratch_.write("vtk/E_7.vtp", "mine");
  const Words with_pictures{"contact", box_, box_, "--poses", poses, "--vtk", folder};
  const Outcome refused = run_pcm(with_pictures);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("E_7.vtp is there, and no provenance.json"), std::string::npos) << refused.err;
  EXPECT_EQ(content_of(picture), "mine");
  std::filesystem::remove(picture);
  EXPECT_EQ(run_pcm(with_pictures).status, 0);
  EXPECT_EQ(run_pcm(with_pictures).status, 0) << "its own are replaced";
}

TEST_F(ContactCommand, NoFileForParaViewIsOneThatIsReadOrWrittenOtherwise) {
  const std::string folder = scratch_.path("vtk");
  std::filesystem::create_directory(folder);
  const std::string poses = scratch_.write("vtk/polygons_1.vtp", kOverlap);
  const Outcome outcome = run_pcm({"contact", box_, box_, "--poses", poses, "--vtk", folder});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("name another folder for --vtk"), std::string::npos) << outcome.err;
  EXPECT_EQ(content_of(poses), kOverlap);
  for (const char* table : {"E_1.vtp", "contacts.pvd", "elements_12.vtp"})
    EXPECT_EQ(run_pcm({"contact", box_, box_, "--poses", poses, "--csv", folder + "/" + table, "--vtk", folder + "/."})
                  .status,
              2);
  EXPECT_EQ(
      run_pcm({"contact", box_, box_, "--poses", poses, "--csv", folder + "/rows.vtp", "--vtk", scratch_.path("other")})
          .status,
      0);
}

TEST_F(ContactCommand, BadInputEmptiesNoFileOfAnEarlierRun) {
  const std::string csv = scratch_.write("rows.csv", "precious\n");
  for (const std::string poses : {"", "1 0 0  0 1 0  0 0 1  0.1 0 zero\n"}) {
    const Outcome outcome = run_pcm({"contact", box_, box_, "--poses", scratch_.write("poses.txt", poses), "--csv", csv,
                                     "--elements", scratch_.path("elements.csv"), "--vtk", scratch_.path("vtk")});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(content_of(csv), "precious\n");
    EXPECT_FALSE(std::filesystem::exists(scratch_.path("elements.csv")));
    EXPECT_FALSE(std::filesystem::exists(scratch_.path("vtk")));
  }
}

TEST_F(ContactCommand, FullAddsToWhatIsThereAndChangesNothingOfIt) {
  for (const std::string engine : {"fast", "reference"}) {
    const std::vector<Json> plain = contact(std::string(kOverlap) + kTilted + kApart, {"--engine", engine});
    std::vector<Json> full = contact(std::string(kOverlap) + kTilted + kApart, {"--engine", engine, "--full"});
    ASSERT_EQ(full.size(), plain.size());
    for (std::size_t i = 0; i < full.size(); ++i) {
      expect_and_erase(full[i], kAdded);
      for (const char* side : {"E", "F"}) expect_and_erase(full[i][side], kAddedToSides);
      for (Json& polygon : full[i]["polygons"]) expect_and_erase(polygon, kAddedToPolygons);
      if (engine == "reference") expect_and_erase(full[i], {"statistics"});
      EXPECT_EQ(dump_exactly(full[i]), dump_exactly(plain[i])) << engine;
    }
  }
}

TEST_F(ContactCommand, ElementsOfStackedBoxesAreThoseWorkedOutByHand) {
  // E's top, z = 1/2, is two triangles of area 1/2; F's bottom is at z = 3/8 below both of their barycentres. Stiffness
  // 1e6 N/m^3 times 1/8 m is 1.25e5 Pa.
  for (const std::string engine : {"fast", "reference"}) {
    const Json full = contact(kOverlap, {"--engine", engine, "--full"}).front();
    ASSERT_EQ(full["element_list"].size(), 2U);
    for (const Json& element : full["element_list"]) {
      EXPECT_EQ(element["master"], "E");
      EXPECT_EQ(element["area"], 0.5);
      EXPECT_EQ(element["penetration"], 0.125);
      EXPECT_EQ(element["pressure"], 1.25e5);
      EXPECT_EQ(element["normal_force"], 62500.0);
      EXPECT_EQ(element["tangential_force"], 0.0);
      EXPECT_EQ(element["normal"][2], -1.0);
      EXPECT_EQ(element["force"][2], -62500.0);
      EXPECT_EQ(element["face_centroid"][2], 0.5);
      EXPECT_NEAR(std::abs(element["face_centroid"][0].get<double>()), 1.0 / 6, 1e-16);
      EXPECT_EQ(element["position"][2], 0.5 - 0.125 / 2) << "in the middle of two equal layers";
    }
    EXPECT_EQ(full["statistics"]["patch_area"], 1.0);
    EXPECT_EQ(full["statistics"]["max_pressure"], 1.25e5);
    EXPECT_EQ(full["statistics"]["mean_penetration"], 0.125);
  }
}

TEST_F(ContactCommand, FacesPairsAndPolygonsOfFullFitTogether) {
  for (const std::string engine : {"fast", "reference"}) {
    const Json full = contact(kTilted, {"--engine", engine, "--mode", "both", "--full"}).front();
    std::set<int> faces_E, faces_F;
    for (const Json& pair : full["crossing_pairs"]) {
      faces_E.insert(pair[0].get<int>());
      faces_F.insert(pair[1].get<int>());
    }
    EXPECT_EQ(full["E"]["intersected_faces"], Json(faces_E));
    EXPECT_EQ(full["F"]["intersected_faces"], Json(faces_F));
    for (const char* side : {"E", "F"})
      for (const std::string kind : {"intersected", "inner"})
        EXPECT_EQ(full[side][kind], full[side][kind + "_faces"].size());
    ASSERT_EQ(full["polygons"].size(), 1U);
    const Json& polygon = full["polygons"][0];
    EXPECT_EQ(polygon["crossings"].size(), polygon["points"].size());
    for (const Json& crossing : polygon["crossings"]) {
      const std::string other = crossing["edge_of"] == "E" ? "F" : "E";
      const Json& crossed = full[other]["intersected_faces"];
      EXPECT_NE(std::find(crossed.begin(), crossed.end(), crossing["face"]), crossed.end());
      EXPECT_LT(crossing["edge"][0], crossing["edge"][1]);
    }
    EXPECT_EQ(full["patch_list"], Json::parse(R"([{"polygons":[0]}])"));
    EXPECT_EQ(full["elements"], full["element_list"].size());
  }
}

TEST_F(ContactCommand, EngineAndOracleTellTheSameInFull) {
  const Words law{"--mode", "both", "--damping", "1e3", "--friction", "0.3", "--slip-velocity", "0.01", "--full"};
  Words exact = law;
  exact.insert(exact.end(), {"--engine", "reference"});
  const Json fast = contact(kTilted, law).front(), truth = contact(kTilted, exact).front();
  EXPECT_EQ(fast["crossing_pairs"], truth["crossing_pairs"]);
  EXPECT_EQ(fast["pose"], truth["pose"]);
  EXPECT_EQ(fast["polygons"][0]["crossings"], truth["polygons"][0]["crossings"]);
  ASSERT_EQ(fast["element_list"].size(), truth["element_list"].size());
  ASSERT_GT(fast["element_list"].size(), 0U);
  for (std::size_t i = 0; i < fast["element_list"].size(); ++i) {
    const Json &a = fast["element_list"][i], &b = truth["element_list"][i];
    for (const char* key : {"master", "master_face", "slave_face", "face_centroid"}) EXPECT_EQ(a[key], b[key]);
    for (const char* key : {"area", "penetration", "pressure", "normal_velocity", "tangential_velocity", "normal_force",
                            "tangential_force"})
      EXPECT_NEAR(a[key].get<double>(), b[key].get<double>(), 1e-12 * std::abs(b[key].get<double>())) << key;
  }
}

TEST_F(ContactCommand, ProvenanceNamesProgramQuestionAndSurfaces) {
  const Json from = contact(kOverlap, {"--engine", "reference", "--problem", "exact", "--scheme", "clipped", "--mode",
                                       "F", "--stiffness", "5e5", "--full"})
                        .front()["provenance"];
  EXPECT_EQ("pcm " + from["version"].get<std::string>() + "\n", run_pcm({"--version"}).out);
  EXPECT_EQ(from["engine"], "reference");
  EXPECT_EQ(from["problem"], "exact");
  EXPECT_EQ(from["scheme"], "clipped");
  EXPECT_EQ(from["mode"], "F");
  EXPECT_EQ(from["law"]["stiffness"], 5e5);
  EXPECT_EQ(from["law"]["max_penetration"], "inf");
  EXPECT_EQ(from["E"]["file"], box_);
  EXPECT_EQ(from["E"]["sha256"], sha256(content_of(box_)));
  EXPECT_EQ(from["F"]["faces"], 12);
  const std::string commit = from["commit"];
  const std::size_t digits = std::min(commit.find_first_not_of("0123456789abcdef"), commit.size());
  EXPECT_TRUE(commit == "unknown" || (digits == 12 && (commit.size() == 12 || commit.substr(12) == "-dirty")))
      << commit;
}

TEST_F(ContactCommand, PublishedAlgorithmsAnswerInFullAsWellAndSayNothingOfWhatTheyDoNotKnow) {
  for (const std::string engine : {"published-2003", "published-2023"}) {
    const std::string csv = scratch_.path(engine + ".csv");
    const Json full = contact(kTilted, {"--engine", engine, "--full", "--csv", csv}).front();
    const Csv table(csv);
    EXPECT_EQ(full["touching"], true);
    EXPECT_EQ(full["element_list"].size(), full["elements"]);
    const bool knows_faces = engine == "published-2003";
    for (const char* key : {"nested", "ambiguous", "too_deep", "undefined_areas", "volume"}) {
      EXPECT_TRUE(full[key].is_null()) << engine << ' ' << key;
      EXPECT_EQ(table.at(0, std::string(key) + (std::string(key) == "volume" ? " [m^3]" : "")), "") << engine;
    }
    for (const char* key : {"polygons", "patches", "patch_list", "crossing_pairs"})
      EXPECT_EQ(full[key].is_null(), !knows_faces) << engine << ' ' << key;
    for (const char* column : {"polygons", "patches", "E_intersected", "F_inner"})
      EXPECT_EQ(table.at(0, column).empty(), !knows_faces) << engine << ' ' << column;
    for (const char* side : {"E", "F"}) {
      for (const char* key : {"area", "vector_area"}) EXPECT_TRUE(full[side][key].is_null()) << engine << ' ' << key;
      for (const char* key : {"intersected", "inner", "intersected_faces", "inner_faces"})
        EXPECT_EQ(full[side][key].is_null(), !knows_faces) << engine << ' ' << key;
    }
    EXPECT_EQ(table.at(0, "E_area [m^2]"), "");
  }
}

TEST_F(ContactCommand, CsvFilesHoldARowAPoseAndARowAnElement) {
  const std::string poses = scratch_.path("contacts.csv"), elements = scratch_.path("elements.csv");
  for (const std::string engine : {"fast", "reference"}) {
    const std::vector<Json> full = contact(std::string(kOverlap) + kTilted + kApart,
                                           {"--engine", engine, "--full", "--csv", poses, "--elements", elements});
    const Csv table(poses);
    ASSERT_EQ(table.rows.size(), 3U);
    std::size_t row = 0;
    const Csv listed(elements);
    for (std::size_t i = 0; i < 3; ++i) {
      const Json& answer = full[i];
      EXPECT_EQ(table.rows[i].size(), table.names.size());
      EXPECT_EQ(table.at(i, "pose"), std::to_string(i + 1));
      EXPECT_EQ(table.number(i, "r_x [m]"), answer["pose"]["r"][0]);
      EXPECT_EQ(table.number(i, "A_12"), answer["pose"]["A"][0][1]);
      EXPECT_EQ(table.number(i, "w_z [rad/s]"), answer["pose"]["w"][2]);
      EXPECT_EQ(table.at(i, "touching"), answer["touching"].get<bool>() ? "1" : "0");
      EXPECT_EQ(table.number(i, "polygons"), answer["polygons"].size());
      EXPECT_EQ(table.number(i, "E_area [m^2]"), answer["E"]["area"]);
      EXPECT_EQ(table.number(i, "F_vector_area_z [m^2]"), answer["F"]["vector_area"][2]);
      EXPECT_EQ(table.number(i, "volume [m^3]"), answer["volume"]);
      EXPECT_EQ(table.number(i, "force_z [N]"), answer["force"][2]);
      EXPECT_EQ(table.number(i, "torque_y [N m]"), answer["torque"][1]);
      EXPECT_EQ(table.number(i, "max_pressure [Pa]"), answer["statistics"]["max_pressure"]);
      for (const Json& element : answer["element_list"]) {
        ASSERT_LT(row, listed.rows.size());
        EXPECT_EQ(listed.at(row, "pose"), std::to_string(i + 1));
        EXPECT_EQ(listed.at(row, "master"), element["master"]);
        EXPECT_EQ(listed.number(row, "slave_face"), element["slave_face"]);
        EXPECT_EQ(listed.number(row, "face_centroid_y [m]"), element["face_centroid"][1]);
        EXPECT_EQ(listed.number(row, "position_x [m]"), element["position"][0]);
        EXPECT_EQ(listed.number(row, "normal_z"), element["normal"][2]);
        EXPECT_EQ(listed.number(row, "pressure [Pa]"), element["pressure"]);
        EXPECT_EQ(listed.number(row, "tangential_velocity [m/s]"), element["tangential_velocity"]);
        EXPECT_EQ(listed.number(row, "force_z [N]"), element["force"][2]);
        ++row;
      }
    }
    EXPECT_EQ(row, listed.rows.size());
    EXPECT_GT(row, 0U);
  }
}

TEST_F(ContactCommand, PolygonsLeftOutAreNullAndNothingElseChanges) {
  for (const std::string engine : {"fast", "reference"}) {
    Json plain = contact(kTilted, {"--engine", engine}).front();
    const std::string csv = scratch_.path("contacts.csv");
    Json without = contact(kTilted, {"--engine", engine, "--no-polygons", "--csv", csv}).front();
    for (const char* key : {"polygons", "patches"}) {
      EXPECT_TRUE(without[key].is_null()) << key;
      EXPECT_EQ(Csv(csv).at(0, key), "");
      plain[key] = nullptr;
    }
    for (Json* answer : {&plain, &without}) answer->erase("work");  // less of it
    EXPECT_EQ(dump_exactly(without), dump_exactly(plain));
    const Json full = contact(kTilted, {"--engine", engine, "--no-polygons", "--full"}).front();
    for (const char* key : {"crossing_pairs", "patch_list"}) EXPECT_TRUE(full.at(key).is_null()) << key;
    EXPECT_TRUE(full.contains("element_list"));
  }
}

TEST_F(ContactCommand, PosesComeFromStandardInput) {
  const std::string poses = scratch_.write("poses.txt", std::string(kOverlap) + kTilted);
  const Outcome from_file = run_pcm({"contact", box_, box_, "--poses", poses});
  const Outcome from_input = run_pcm({"contact", box_, box_, "--poses", "-"}, {}, poses);
  EXPECT_EQ(from_input.status, 0) << from_input.err;
  EXPECT_EQ(from_input.out, from_file.out);
  EXPECT_EQ(lines_of(from_input.out).size(), 2U);
  const std::string bad = scratch_.write("bad.txt", std::string(kOverlap) + "1 2 3\n");
  const Outcome refused = run_pcm({"contact", box_, box_, "--poses", "-"}, {}, bad);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("standard input:2"), std::string::npos) << refused.err;
  EXPECT_NE(run_pcm({"contact", box_, box_, "--poses", "-"}).err.find("holds no pose"), std::string::npos);
}

TEST_F(ContactCommand, QuaternionsGiveTheAnswersOfTheirMatrices) {
  // A quarter turn about z, w = z = sqrt(1/2), is off the matrix of zeros and ones by roundings only.
  const std::string half = "0x1.6a09e667f3bcdp-1";
  const Json matrix = contact("0 -1 0  1 0 0  0 0 1  0.125 0.25 0.875\n").front();
  for (const auto& [order, q] :
       {std::pair("wxyz", half + " 0 0 " + half), std::pair("xyzw", "0 0 " + half + " " + half)}) {
    const Json turned = contact(q + "  0.125 0.25 0.875\n", {"--quaternions", order, "--full"}).front();
    EXPECT_NEAR(turned["volume"].get<double>(), matrix["volume"].get<double>(), 1e-14) << order;
    EXPECT_NEAR(turned["pose"]["A"][1][0].get<double>(), 1, 1e-15) << order;
  }
}

TEST_F(ContactCommand, OrientationsAreReplacedOnRequestAndThatIsSaidOnce) {
  const std::string digits = "0.764842 -0.644218 0  0.644218 0.764842 0  0 0 1  0.1 0.2 0.9\n";
  const std::string poses = scratch_.write("poses.txt", kOverlap + digits + digits);
  const Outcome refused = run_pcm({"contact", box_, box_, "--poses", poses});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("poses.txt:2: the first nine numbers are not a rotation"), std::string::npos);
  const Outcome outcome = run_pcm({"contact", box_, box_, "--poses", poses, "--orthonormalise", "--full"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("poses.txt:2: the orientation is off by"), std::string::npos) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(Json::parse(lines[0])["pose"]["replaced_error"], 0.0);
  EXPECT_GT(Json::parse(lines[1])["pose"]["replaced_error"], 1e-9);
  EXPECT_NE(run_pcm({"contact", box_, box_, "--orthonormalise"}).err.find("--poses"), std::string::npos);
  const std::string mirrored = scratch_.write("mirrored.txt", "1 0 0  0 1 0  0 0 -1  0 0 0.5\n");
  for (const Words& request : {Words{}, Words{"--orthonormalise"}}) {
    Words arguments{"contact", box_, box_, "--poses", mirrored};
    arguments.insert(arguments.end(), request.begin(), request.end());
    EXPECT_NE(run_pcm(arguments).err.find("mirrored.txt:1: the first nine numbers are a reflection"),
              std::string::npos);
  }
}

TEST_F(ContactCommand, ScaleMakesMetresOfSurfacesPositionsAndVelocities) {
  // By a power of two every bit of the answer is that of the same contact in metres.
  const std::string large = scratch_.path("large.obj");
  ASSERT_EQ(
      run_pcm({"mesh", "make", "box", "--extent_x=1024", "--extent_y=1024", "--extent_z=1024", "-o", large}).status, 0);
  const std::string turned = "0.6 -0.8 0  0.8 0.6 0  0 0 1  ";
  const std::string poses = scratch_.write("large.txt", turned + "102.4 204.8 921.6  512 -256 -1024  0.1 0.2 0.3\n");
  const Words law{"--damping", "1e3"};
  Words arguments{"contact", large, large, "--poses", poses, "--scale", "0x1p-10", "--damping", "1e3"};
  const Outcome scaled = run_pcm(arguments);
  EXPECT_EQ(scaled.err, "");
  EXPECT_EQ(Json::parse(scaled.out), contact(turned + "0.1 0.2 0.9  0.5 -0.25 -1  0.1 0.2 0.3\n", law).front());
  arguments.emplace_back("--full");
  EXPECT_EQ(Json::parse(run_pcm(arguments).out)["provenance"]["scale"], 0x1p-10);
  for (const std::string bad : {"0", "-1", "nan", "x"}) {
    const Outcome refused = run_pcm({"contact", box_, box_, "--scale", bad});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("--scale"), std::string::npos) << refused.err;
  }
}

TEST_F(ContactCommand, LikelyMillimetresAreRemarkedOnUnlessTheScaleIsGiven) {
  const std::string large = scratch_.path("large.obj");
  ASSERT_EQ(run_pcm({"mesh", "make", "box", "--extent_x=16", "-o", large}).status, 0);
  const Outcome remarked = run_pcm({"contact", large, large});
  EXPECT_EQ(remarked.status, 0);
  EXPECT_EQ(remarked.err,
            "pcm: remark: the surfaces are 16 m and 16 m large; if the files are in millimetres, add --scale 0.001, if "
            "in metres, --scale 1\n");
  EXPECT_EQ(run_pcm({"contact", large, large, "--scale", "1"}).err, "");
  EXPECT_EQ(run_pcm({"contact", large, box_}).err, "") << "one large surface may be the ground";
  const auto layers = [&](const std::string& E, const std::string& F) {
    return run_pcm({"contact", box_, box_, "--layer-E", "1e9,0.3," + E, "--layer-F", "1e9,0.3," + F}).err;
  };
  EXPECT_EQ(layers("0.01", "0.01"), "");
  EXPECT_NE(layers("0.01", "0.0005").find("surface F is 1 m large and its layer 0.0005 m thick"), std::string::npos);
}

TEST_F(ContactCommand, FullSaysWhatCoincidesAndTheAreasWithoutAndWithIt) {
  // Stacked boxes: E's top and F's bottom are one square of 3/4 by 7/8 in one plane, with opposite normals. Left out,
  // the area is 0; counted in, it is that square, wherever the tie rule moves it.
  const std::string stacked = "1 0 0  0 1 0  0 0 1  0.125 0.25 ", below = stacked + "-1\n";
  for (const std::string engine : {"fast", "reference"}) {
    for (const std::string& pose : {stacked + "1\n", below}) {
      const Json full = contact(pose, {"--engine", engine, "--full"}).front();
      EXPECT_EQ(full["coincident"], true);
      for (const char* side : {"E", "F"}) {
        EXPECT_EQ(full[side]["area_open"], 0.0) << engine << ' ' << pose;
        EXPECT_EQ(full[side]["area_closed"], 0.75 * 0.875) << engine << ' ' << pose;
      }
    }
    const Json apart = contact(kApart, {"--engine", engine, "--full"}).front();
    EXPECT_EQ(apart["coincident"], false);
    const Json tilted = contact(kTilted, {"--engine", engine, "--full"}).front();
    EXPECT_EQ(tilted["coincident"], false);
    for (const char* side : {"E", "F"})
      for (const char* bound : {"area_open", "area_closed"}) EXPECT_EQ(tilted[side][bound], tilted[side]["area"]);
  }
  const Json published = contact(below, {"--engine", "published-2003", "--full"}).front();
  EXPECT_EQ(published["coincident"], true);
  EXPECT_TRUE(published["E"]["area_open"].is_null());
}

TEST_F(ContactCommand, FilesThatCannotBeWrittenAndAdviceWithMoreAreRefused) {
  for (const Words& options : {Words{"--csv", "/nowhere/a.csv"}, Words{"--elements", "/nowhere/a.csv"},
                               Words{"--advise", "--full"}, Words{"--csv", "/dev/full"}}) {
    Words arguments{"contact", box_, box_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(options[0] == "--advise" ? options[0] : options[1]), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
}  // namespace pcm::compare
