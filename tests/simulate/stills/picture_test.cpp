// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulate/stills/colours.h"
#include "tests/simulate/page/falling_box.h"

namespace pcm::simulate {
namespace {

/// Where a point of W is seen.
const Rgb& pixel_at(const Image& image, const RunView& view, const Eigen::Vector3d& x_W) {
  const Eigen::Vector3d x_C = view.camera.to_camera(x_W);
  const double scale = image.height / 2.0 / view.camera.tan_half_height / -x_C.z();
  return image.at(static_cast<int>(std::floor(image.width / 2.0 + scale * x_C.x())),
                  static_cast<int>(std::floor(image.height / 2.0 - scale * x_C.y())));
}

std::ptrdiff_t count(const Image& image, const Rgb& colour) {
  return std::count(image.pixels.begin(), image.pixels.end(), colour);
}

Eigen::Vector3d middle_W(const Recording& recording, const Frame& frame, std::size_t surface, std::size_t face) {
  const TriangleMesh& mesh = recording.surfaces[surface].mesh;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Index vertex : mesh.faces[face]) middle += mesh.vertices[static_cast<std::size_t>(vertex)] / 3;
  return frame.poses_W[surface].A * middle + frame.poses_W[surface].r;
}

TEST(Picture, ShowsEverySurfaceInItsColourWhereItIs) {
  const Recording recording = falling_box();
  const RunView view = view_of(recording);
  const Frame& frame = recording.frames.front();
  const Image image = picture(recording, frame, view);
  ASSERT_EQ(image.width, kStillWidth);
  ASSERT_EQ(image.height, kStillHeight);
  const Eigen::Vector3d up_C = view.camera.A_CW.col(2);
  const Eigen::Vector3d top_of_box = box_point_W(recording, 0, {0.02, 0.03, kBoxEdge / 2});
  EXPECT_EQ(pixel_at(image, view, top_of_box), lit(recording.surfaces[1].colour, up_C, up_C));
  const double top = recording.surfaces[0].mesh.vertices[0].z();  // of the plate, or its lower side
  EXPECT_EQ(pixel_at(image, view, {0.9, -0.5, std::abs(top)}), lit(recording.surfaces[0].colour, up_C, up_C));
  EXPECT_EQ(image.at(0, 0), kBackgroundColour);
}

TEST(Picture, ShowsPressureThroughBodiesAndForcesOverAll) {
  const Recording recording = falling_box();
  const RunView view = view_of(recording);
  const PressedFace most = most_pressed(recording);
  const Frame& frame = recording.frames[most.frame];
  EXPECT_EQ(view.greatest_pressure, most.element.pressure);
  const Image image = picture(recording, frame, view);
  // The box's lower side is beneath the box and within the plate.
  EXPECT_EQ(pixel_at(image, view, middle_W(recording, frame, 1, static_cast<std::size_t>(most.element.face))),
            kColourStops.back());
  const RecordedContact& contact = frame.contacts.front();
  EXPECT_EQ(pixel_at(image, view, contact.position_W + 0.5 * view.metres_per_newton * contact.force_W), kArrowColour);
  const Image before = picture(recording, recording.frames.front(), view);
  EXPECT_EQ(count(before, kArrowColour), 0);
  EXPECT_EQ(count(before, kColourStops.back()), 0);
}

TEST(Picture, OfSeveralElementsOnAFaceShowsTheGreatestPressureAndTensionAsNone) {
  Recording recording = falling_box();
  const RunView view = view_of(recording);
  Frame frame = recording.frames.front();
  const Index face = recording.frames[most_pressed(recording).frame].elements.front().face;
  const Eigen::Vector3d place_W = middle_W(recording, frame, 1, static_cast<std::size_t>(face));
  const double most = view.greatest_pressure;
  for (const auto& [pressures, fraction] :
       {std::pair(std::vector{0.5 * most, most, 0.2 * most}, 1.0), std::pair(std::vector{-most}, 0.0),
        std::pair(std::vector{most / 3}, 1.0 / 3)}) {
    frame.elements.clear();
    for (const double pressure : pressures) frame.elements.push_back({0, Side::E, face, pressure});
    EXPECT_EQ(pixel_at(picture(recording, frame, view), view, place_W), bar_colour(fraction));
  }
}

TEST(Picture, TheGreatestForceIsAFifthOfTheSceneLong) {
  const Recording recording = falling_box();
  const RunView view = view_of(recording);
  double greatest = 0;
  for (const Frame& frame : recording.frames)
    for (const RecordedContact& contact : frame.contacts) greatest = std::max(greatest, contact.force_W.norm());
  EXPECT_NEAR(view.metres_per_newton * greatest, view.size / 5, 1e-12);
  EXPECT_GT(view.size, 2.4);  // the plate is
  EXPECT_LT(view.size, 3.2);
}

TEST(Picture, TheViewHoldsEveryFrame) {
  Recording recording = falling_box();
  recording.frames[70].poses_W[1].r = {9, 0, 0};
  recording.frames.back().poses_W[1].r = {0, 0, 7};
  const RunView view = view_of(recording);
  EXPECT_GT(view.size, std::hypot(9, 7));
  for (const std::size_t i : {std::size_t{0}, std::size_t{70}, recording.frames.size() - 1}) {
    const Eigen::Vector3d x_C = view.camera.to_camera(recording.frames[i].poses_W[1].r) / view.camera.tan_half_height;
    EXPECT_LT(std::abs(x_C.x() / x_C.z()), 0.9 * view.width / view.height) << i;
    EXPECT_LT(std::abs(x_C.y() / x_C.z()), 0.9) << i;
  }
}

TEST(Picture, ShowsTheInsideOfASurfaceToo) {
  Recording recording;
  recording.surfaces = {{"face", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}, ""}, {200, 0, 0}}};
  recording.frames.resize(1);
  recording.frames[0].poses_W.resize(1);
  const RunView view = view_of(recording);
  const Rgb there = pixel_at(picture(recording, recording.frames[0], view), view, {0, 0, 0.3});
  recording.surfaces[0].mesh.faces[0] = {0, 2, 1};
  EXPECT_EQ(pixel_at(picture(recording, recording.frames[0], view), view, {0, 0, 0.3}), there);
  EXPECT_GT(there[0], 60);
}

TEST(Picture, WithoutASurfaceIsEmpty) {
  Recording recording;
  recording.frames.resize(1);
  const RunView view = view_of(recording);
  EXPECT_TRUE(view.camera.eye_W.allFinite());
  EXPECT_EQ(view.size, 1);
  const Image image = picture(recording, recording.frames[0], view);
  EXPECT_EQ(count(image, kBackgroundColour), kStillWidth * kStillHeight);
}

}  // namespace
}  // namespace pcm::simulate
