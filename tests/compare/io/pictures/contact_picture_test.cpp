// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/pictures/contact_picture.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "meshes/generate/boxes.h"
#include "pcm/engine.h"
#include "tests/compare/io/occurrences.h"
#include "tests/compare/io/well_formed_xml.h"

namespace pcm::compare {
namespace {

/// A box F, half a metre wide, 0.1 m deep in the top of a box E.
class ContactPictureTest : public testing::Test {
 protected:
  const TriangleMesh mesh_E_ = generate::box({1, 1, 1}), mesh_F_ = generate::box({0.5, 0.5, 0.5});
  Pose pose_;
  fast::Workspace workspace_;

  std::string picture_at(double height, Scheme scheme = Scheme::barycentric) {
    pose_.r = {0.05, 0.03, height};
    const fast::Pairing pairing(fast::Surface(mesh_E_), fast::Surface(mesh_F_), {}, Mode::both, scheme);
    const fast::Contact& contact = fast::evaluate(pairing, pose_, Velocity{}, Wanted{}, workspace_);
    return svg({mesh_E_, mesh_F_, pose_, contact, best_view(contact), "box & <box>", "in \"words\""});
  }
};

/// Twice the area a path goes round, positive if counterclockwise as it is seen; y points down on the page.
double turn_of(const std::string& picture, std::size_t at) {
  at = picture.find('"', at) + 1;
  std::istringstream words(picture.substr(at, picture.find('"', at) - at));
  std::vector<std::pair<double, double>> points;
  char comma = 0;
  for (double x = 0, y = 0; words >> x >> comma >> y;) points.emplace_back(x, y);
  double turn = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    turn -= points[i - 1].first * points[i].second - points[i].first * points[i - 1].second;
  return turn;
}

TEST_F(ContactPictureTest, IsWellFormedAndSaysWhatItShows) {
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const std::string picture = picture_at(0.65, scheme);
    EXPECT_EQ(fault_in_xml(picture), "") << picture;
    for (const char* words : {"box &amp; &lt;box&gt;", "in &quot;words&quot;", "Surface E, seen from +z",
                              "Surface F, seen from -z", "0.1 m"})
      EXPECT_NE(picture.find(words), std::string::npos) << words;
  }
}

TEST_F(ContactPictureTest, PolygonRunsCounterclockwiseOnEAndClockwiseOnF) {
  const std::string picture = picture_at(0.65);
  ASSERT_EQ(count(picture, "<polyline points"), 3U);  // one on each surface, one in the legend
  const std::size_t first = picture.find("<polyline points"), second = picture.find("<polyline points", first + 1);
  EXPECT_GT(turn_of(picture, first), 0);
  EXPECT_LT(turn_of(picture, second), 0);
}

TEST_F(ContactPictureTest, FacesTurnedAwayAreNotDrawn) {
  // Only E's top is turned to the viewer: two faces.
  const std::string picture = picture_at(0.65);
  const std::size_t clip = picture.find("<g clip-path");
  const std::string E = picture.substr(clip, picture.find("</g>", clip) - clip);
  EXPECT_EQ(count(E, "<polygon points") - count(E, "stroke=\"none\""), 2U) << E;
}

TEST_F(ContactPictureTest, WithoutContactTheWholeSurfacesAreShown) {
  const std::string picture = picture_at(2);
  EXPECT_EQ(fault_in_xml(picture), "") << picture;
  EXPECT_EQ(count(picture, "<polyline points"), 1U);
  EXPECT_EQ(picture.find("nan"), std::string::npos);
  EXPECT_EQ(picture.find("inf,"), std::string::npos);
}

TEST(ViewAxis, IsReadAndNamed) {
  for (const char* word : {"-x", "-y", "-z", "+x", "+z"}) EXPECT_EQ(view_axis_named(word)->name(), word);
  EXPECT_EQ(view_axis_named("y")->name(), "+y");
  EXPECT_EQ(view_axis_named("-x")->towards_viewer_Me(), Eigen::Vector3d(-1, 0, 0));
  for (const char* word : {"", "-", "w", "xy", "--x", "X"}) EXPECT_FALSE(view_axis_named(word)) << word;
}

}  // namespace
}  // namespace pcm::compare
