// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page as text: what is in it, how it is written, what is refused.

#include "simulate/page/page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "meshes/generate/boxes.h"
#include "pcm/bad_input.h"
#include "simulate/page/page_files.h"
#include "tests/compare/io/base64_decoded.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/temporary_folder.h"
#include "tests/simulate/page/falling_box.h"

namespace {

using namespace pcm;
using namespace pcm::simulate;
using nlohmann::json;

/// Stands for three.js, which need not be installed here.
PageFiles small_files() {
  PageFiles files = page_files();
  files.three = "const THREE = undefined;";
  return files;
}

std::string small_page(const Recording& recording) {
  return page(recording, small_files());
}

std::string data_text(const std::string& page) {
  const std::string begin_mark = R"(<script type="application/json" id="data">)";
  const std::size_t begin = page.find(begin_mark) + begin_mark.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

template <typename Number>
std::vector<double> decoded_as(const std::string& text) {
  const std::string bytes = compare::base64_decoded(text);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return {numbers.begin(), numbers.end()};
}

std::vector<double> numbers(const json& array) {
  const std::string type = array.at("type");
  const std::string text = array.at("base64");
  if (type == "Float32") return decoded_as<float>(text);
  if (type == "Float64") return decoded_as<double>(text);
  return type == "Uint16" ? decoded_as<std::uint16_t>(text) : decoded_as<std::uint32_t>(text);
}

/// Two tetrahedra, two pairings, three frames, of numbers that are all different and of which most are no floats.
Recording sentinels() {
  const TriangleMesh tetrahedron{{{0.1, 0.2, 0.3}, {1.1, 0.25, 0.35}, {0.15, 1.2, 0.4}, {0.17, 0.27, 1.3}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
                                 ""};
  Recording recording;
  recording.title = "sentinels";
  recording.surfaces = {{"one", tetrahedron, {1, 2, 3}}, {"two", tetrahedron, {250, 251, 252}}};
  recording.pairings = {{"p", 0, 1}, {"q", 1, 0}};
  for (int i = 0; i < 3; ++i) {
    Frame frame;
    frame.t = 0.1 * i;
    frame.poses_W.resize(2);
    frame.poses_W[1].A << 1, 0, 0, 0, 0.96, -0.28, 0, 0.28, 0.96;
    frame.poses_W[1].r = {10.1 + i, 20.2, 30.3};
    recording.frames.push_back(frame);
  }
  // Out of the order in which they are written; none in the middle frame.
  recording.frames[0].elements = {{1, Side::F, 3, 1001.1}, {0, Side::F, 2, 1002.2}, {1, Side::F, 1, 1003.3}};
  recording.frames[2].elements = {{1, Side::F, 0, 1004.4}};
  recording.frames[2].contacts = {{1, {0.11, 0.12, 0.13}, {-100.1, 200.2, 300.3}}, {0, {0.21, 0.22, 0.23}, {1, 2, 4}}};
  const std::vector<double> steps{0, 0.05, 0.05, 0.2};
  recording.series = {{"a", "J", "Energy", steps, {1.1, std::nan(""), 1e300, -1e-50}, false},
                      {"b", "s", "Step", steps, {1, 2, 3, 4}, true},
                      {"c", "N", "Force", {0, 0.2}, {5, 6}, false}};
  return recording;
}

std::vector<double> as_floats(std::vector<double> values) {
  for (double& value : values) value = double{static_cast<float>(value)};
  return values;
}

TEST(Page, HoldsTheSurfaces) {
  const json data = json::parse(data_text(small_page(sentinels())));
  ASSERT_EQ(data["surfaces"].size(), 2U);
  const json& surface = data["surfaces"][1];
  EXPECT_EQ(surface["name"], "two");
  EXPECT_EQ(surface["colour"], json({250, 251, 252}));
  EXPECT_EQ(numbers(surface["vertices"]), as_floats({0.1, 0.2, 0.3, 1.1, 0.25, 0.35, 0.15, 1.2, 0.4, 0.17, 0.27, 1.3}));
  EXPECT_EQ(surface["faces"]["type"], "Uint16") << "as short as can be";
  EXPECT_EQ(numbers(surface["faces"]), (std::vector<double>{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}));
  EXPECT_EQ(data["pairings"][1], json({{"name", "q"}, {"surfaces", {1, 0}}}));
}

TEST(Page, HoldsThePosesOfEveryFrame) {
  const json frames = json::parse(data_text(small_page(sentinels())))["frames"];
  EXPECT_EQ(numbers(frames["t"]), (std::vector<double>{0, 0.1, 0.1 * 2})) << "times of frames are not rounded";
  const std::vector<double> poses = numbers(frames["poses"]);
  ASSERT_EQ(poses.size(), 3U * 2 * 7);
  // Half of the angle whose cosine is 0.96 and whose sine is 0.28, about x.
  const double half = std::atan2(0.28, 0.96) / 2;
  const std::vector<double> expected{std::sin(half), 0, 0, std::cos(half), 12.1, 20.2, 30.3};
  // The last of six.
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(poses[35 + i], expected[i], 2e-6) << i;
}

TEST(Page, HoldsTheElementsInRunsOfOneMaster) {
  const json frames = json::parse(data_text(small_page(sentinels())))["frames"];
  EXPECT_EQ(numbers(frames["element_runs"]), (std::vector<double>{2, 0, 1}));
  EXPECT_EQ(numbers(frames["run_master"]), (std::vector<double>{1, 3, 3}));
  EXPECT_EQ(numbers(frames["run_length"]), (std::vector<double>{1, 2, 1}));
  EXPECT_EQ(numbers(frames["face"]), (std::vector<double>{2, 3, 1, 0}));
  EXPECT_EQ(numbers(frames["pressure"]), as_floats({1002.2, 1001.1, 1003.3, 1004.4}));
}

TEST(Page, HoldsTheContacts) {
  const json frames = json::parse(data_text(small_page(sentinels())))["frames"];
  EXPECT_EQ(numbers(frames["contacts"]), (std::vector<double>{0, 0, 2}));
  EXPECT_EQ(numbers(frames["contact_pairing"]), (std::vector<double>{1, 0}));
  EXPECT_EQ(numbers(frames["contact"]), as_floats({0.11, 0.12, 0.13, -100.1, 200.2, 300.3, 0.21, 0.22, 0.23, 1, 2, 4}));
}

TEST(Page, HoldsSeriesWithGapsAndSharedTimesOnce) {
  const json data = json::parse(data_text(small_page(sentinels())));
  ASSERT_EQ(data["times"].size(), 2U);
  EXPECT_EQ(numbers(data["times"][0]), as_floats({0, 0.05, 0.05, 0.2}));
  ASSERT_EQ(data["series"].size(), 3U);
  EXPECT_EQ(data["series"][1]["times"], 0);
  EXPECT_EQ(data["series"][2]["times"], 1);
  EXPECT_EQ(data["series"][1]["logarithmic"], true);
  EXPECT_EQ(data["series"][1]["plot"], "Step");
  EXPECT_EQ(data["series"][1]["unit"], "s");
  const std::vector<double> values = numbers(data["series"][0]["value"]);
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values[0], double{1.1F});
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(values[2], std::numeric_limits<double>::infinity()) << "no float";
  EXPECT_EQ(values[3], 0);
}

TEST(Page, TakesThirtyTwoBitsForLongMeshes) {
  Recording recording = sentinels();
  recording.surfaces[0].mesh.vertices.resize(70000, Eigen::Vector3d::Zero());
  recording.surfaces[0].mesh.faces[3] = {0, 3, 69999};
  const json faces = json::parse(data_text(small_page(recording)))["surfaces"][0]["faces"];
  EXPECT_EQ(faces["type"], "Uint32");
  EXPECT_EQ(numbers(faces).back(), 69999);
}

TEST(Page, EscapesNames) {
  Recording recording = sentinels();
  const std::string hostile = "</script><script>alert(1)</script>{{css}}<!--&\"'\xff";
  recording.title = recording.surfaces[0].name = recording.pairings[0].name = recording.series[0].name = hostile;
  const std::string plain = small_page(sentinels());
  const std::string text = small_page(recording);
  EXPECT_EQ(text.find("alert(1)</script>"), text.npos);
  EXPECT_NE(text.find("<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;{{css}}&lt;!--&amp;\"'\xff</title>"),
            text.npos);
  EXPECT_EQ(json::parse(data_text(text))["surfaces"][0]["name"],
            "</script><script>alert(1)</script>{{css}}<!--&\"'\xef\xbf\xbd");
  const auto count = [](const std::string& page, const std::string& what) {
    int times = 0;
    for (std::size_t at = page.find(what); at != page.npos; at = page.find(what, at + 1)) ++times;
    return times;
  };
  for (const std::string tag : {"<script", "</script", "<!--", "-->"}) EXPECT_EQ(count(text, tag), count(plain, tag));
}

TEST(Page, LoadsNothingAndNamesTheLicenceOfThree) {
  const std::string text = small_page(sentinels());
  EXPECT_NE(text.find("default-src 'none'"), text.npos);
  for (const std::string word : {" src=", " href=", "@import", "url("}) EXPECT_EQ(text.find(word), text.npos) << word;
  EXPECT_NE(text.find("The MIT License"), text.npos);
  EXPECT_EQ(text.find("{{"), text.npos) << "something was not put in";
}

// A man and a car over 3 s: 15 segments and a car, 28,000 triangles, 600 frames of 500 elements, and ten thousand
// steps.
TEST(Page, IsSmall) {
  Recording recording;
  for (int i = 0; i < 16; ++i) recording.surfaces.push_back({"segment", generate::gridded_box(1.0, 12), {}});
  for (int i = 0; i < 27; ++i) recording.pairings.push_back({"pair", i % 16, 15});
  std::size_t triangles = 0;
  for (const RecordedSurface& surface : recording.surfaces) triangles += surface.mesh.faces.size();
  ASSERT_GE(triangles, 27000U);
  for (int i = 0; i < 600; ++i) {
    Frame frame;
    frame.t = 0.005 * i;
    frame.poses_W.resize(recording.surfaces.size());
    for (int k = 0; k < 500; ++k) frame.elements.push_back({k % 27, Side::F, k, 1e5 + k});
    for (int k = 0; k < 20; ++k) frame.contacts.push_back({k, {1, 2, 3}, {4, 5, 6}});
    recording.frames.push_back(frame);
  }
  std::vector<double> steps;
  for (int i = 0; i < 10000; ++i) steps.push_back(3e-4 * i);
  for (int i = 0; i < 40; ++i) recording.series.push_back({std::to_string(i), "J", "p", steps, steps, false});
  EXPECT_LT(small_page(recording).size(), 10'000'000U);
}

TEST(Page, IsRefusedWithoutThree) {
  PageFiles files = page_files();
  files.three = "";
  try {
    page(sentinels(), files);
    FAIL() << "not refused";
  } catch (const BadInput& error) {
    EXPECT_NE(std::string{error.what()}.find("libjs-three"), std::string::npos) << error.what();
  }
}

TEST(Page, IsWrittenToAFile) {
  if (page_files().three.empty()) GTEST_SKIP() << "libjs-three was not installed when this was built";
  const TemporaryFolder folder;
  write_page(folder.path("a.html"), sentinels());
  const std::string content = content_of(folder.path("a.html"));
  EXPECT_EQ(content, page(sentinels()));
  EXPECT_NE(content.find("OrbitControls"), std::string::npos);
  EXPECT_THROW(write_page(folder.path("missing/a.html"), sentinels()), BadInput);
}

TEST(Page, OfOneFrameAndNoSeriesIsMade) {
  Recording recording = sentinels();
  recording.frames.resize(1);
  recording.series.clear();
  EXPECT_NO_THROW(small_page(recording));
}

struct Refusal {
  std::string words;  // in the message
  std::function<void(Recording&)> spoil;
};

TEST(Page, RefusesContradictionsAndNamesThePlace) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Refusal> refusals{
      {"no surfaces", [](Recording& r) { r = Recording{}; }},
      {"no surfaces", [](Recording& r) { r.surfaces.clear(); }},
      {"no frames", [](Recording& r) { r.frames.clear(); }},
      {"'two' has no faces", [](Recording& r) { r.surfaces[1].mesh.faces.clear(); }},
      {"'two': face 3 names vertex 4, of 4", [](Recording& r) { r.surfaces[1].mesh.faces[3][1] = 4; }},
      {"'two': face 0 names vertex -1", [](Recording& r) { r.surfaces[1].mesh.faces[0][0] = -1; }},
      {"'one': vertex 2 is not finite", [](Recording& r) { r.surfaces[0].mesh.vertices[2].y() = std::nan(""); }},
      {"'one': vertex 2 is not finite", [](Recording& r) { r.surfaces[0].mesh.vertices[2].y() = -1e39; }},
      {"pairing 'q' names surface 2, of 2", [](Recording& r) { r.pairings[1].surface_F = 2; }},
      {"t = 0.1 s: 1 poses for 2 surfaces", [](Recording& r) { r.frames[1].poses_W.pop_back(); }},
      {"t = 0.1 s: the pose of surface 'two'", [](Recording& r) { r.frames[1].poses_W[1].A *= 1.001; }},
      {"t = 0.1 s: the pose of surface 'two'", [](Recording& r) { r.frames[1].poses_W[1].A *= -1; }},
      {"t = 0.1 s: the pose of surface 'one'", [=](Recording& r) { r.frames[1].poses_W[0].r.z() = infinity; }},
      {"follows that at t = 0 s", [](Recording& r) { r.frames[1].t = 0; }},
      {"the time is not finite", [](Recording& r) { r.frames[1].t = std::nan(""); }},
      {"names pairing 2, of 2", [](Recording& r) { r.frames[0].elements[0].pairing = 2; }},
      {"names face 4 of surface 'one', which has 4", [](Recording& r) { r.frames[0].elements[0].face = 4; }},
      {"pressure on face 3 of surface 'one'", [](Recording& r) { r.frames[0].elements[0].pressure = std::nan(""); }},
      {"a contact names pairing -1", [](Recording& r) { r.frames[2].contacts[0].pairing = -1; }},
      {"position or force", [=](Recording& r) { r.frames[2].contacts[1].force_W.x() = infinity; }},
      {"series 'c': 2 times and 1 values", [](Recording& r) { r.series[2].value.pop_back(); }},
      {"series 'b': times have to be finite", [](Recording& r) { r.series[1].t[3] = 0.01; }},
  };
  for (const Refusal& refusal : refusals) {
    Recording recording = sentinels();
    refusal.spoil(recording);
    try {
      small_page(recording);
      ADD_FAILURE() << "not refused: " << refusal.words;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string{error.what()}.find(refusal.words), std::string::npos) << error.what();
    }
  }
}

}  // namespace
