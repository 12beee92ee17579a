// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcm::simulate {
namespace {

constexpr Rgb kPaper{200, 200, 200}, kRed{250, 0, 0}, kBlue{0, 0, 250};

/// 40 by 40 pixels, 10 m before the eye 1 m a pixel: x and y from -20 to 20.
Canvas canvas() {
  return {40, 40, 2, 0.1, kPaper};
}

/// Half of a square of that half edge in the plane z = -depth, in the middle of the picture: right of its diagonal from
/// the lower left to the upper right, or left of it.
CameraTriangle half_square(double half_edge, double depth, bool is_right = true) {
  const double h = half_edge, z = -depth;
  if (is_right) return {Eigen::Vector3d(-h, -h, z), {h, -h, z}, {h, h, z}};
  return {Eigen::Vector3d(-h, -h, z), {h, h, z}, {-h, h, z}};
}

void draw_square(Canvas& canvas, double half_edge, double depth, const Rgb& colour, Hiding hiding = Hiding::by_depth) {
  for (const bool is_right : {false, true}) canvas.draw(half_square(half_edge, depth, is_right), colour, hiding);
}

void expect_only_paper(const Canvas& canvas) {
  for (const Rgb& pixel : canvas.image().pixels) ASSERT_EQ(pixel, kPaper);
}

TEST(Canvas, WithoutATriangleIsPaper) {
  const Image image = canvas().image();
  EXPECT_EQ(image.width, 40);
  EXPECT_EQ(image.height, 40);
  EXPECT_EQ(image.pixels.size(), 1600U);
  expect_only_paper(canvas());
}

TEST(Canvas, ASquareFillsItsPixelsAndNoOther) {
  Canvas drawn = canvas();
  draw_square(drawn, 8, 10, kRed);
  const Image image = drawn.image();
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const bool is_inside = x >= 12 && x < 28 && y >= 12 && y < 28;
      ASSERT_EQ(image.at(x, y), is_inside ? kRed : kPaper) << x << ' ' << y;
    }
}

// Twice as far, half as large.
TEST(Canvas, WhatIsFartherLooksSmaller) {
  Canvas near = canvas(), far = canvas();
  draw_square(near, 8, 10, kRed);
  draw_square(far, 16, 20, kRed);
  EXPECT_EQ(near.image().pixels, far.image().pixels);
}

TEST(Canvas, XIsToTheRightAndYUpwards) {
  Canvas drawn = canvas();
  drawn.draw({Eigen::Vector3d(2, 2, -10), {18, 2, -10}, {18, 18, -10}}, kRed, Hiding::by_depth);
  const Image image = drawn.image();
  EXPECT_EQ(image.at(36, 15), kRed);  // right, above
  EXPECT_EQ(image.at(3, 15), kPaper);
  EXPECT_EQ(image.at(36, 24), kPaper);
}

// Its lower edge goes through the middles of the pixels of a row: two of three rows of samples are covered.
TEST(Canvas, APixelIsTheMeanOfItsSamples) {
  Canvas drawn = canvas();
  drawn.draw({Eigen::Vector3d(-100, 0.4, -10), {100, 0.4, -10}, {0, 100, -10}}, kRed, Hiding::by_depth);
  const Image image = drawn.image();
  EXPECT_EQ(image.at(20, 18), kRed);
  EXPECT_EQ(image.at(20, 19), (Rgb{233, 67, 67}));
  EXPECT_EQ(image.at(20, 20), kPaper);
}

TEST(Canvas, WhatIsInFrontHidesWhatIsBehindInEitherOrder) {
  for (const bool is_front_first : {true, false}) {
    SCOPED_TRACE(is_front_first);
    Canvas drawn = canvas();
    if (is_front_first) draw_square(drawn, 4, 8, kRed);
    draw_square(drawn, 8, 10, kBlue);
    if (!is_front_first) draw_square(drawn, 4, 8, kRed);
    const Image image = drawn.image();
    EXPECT_EQ(image.at(20, 20), kRed);
    EXPECT_EQ(image.at(13, 20), kBlue);
  }
}

// They cross in the plane x = 0 and lean to opposite sides, so that each is in front on one half.
TEST(Canvas, OfTwoThatIntersectEachIsSeenWhereItIsInFront) {
  for (const bool is_red_first : {true, false}) {
    SCOPED_TRACE(is_red_first);
    Canvas drawn = canvas();
    const CameraTriangle red{Eigen::Vector3d(-8, -30, -6), {-8, 30, -6}, {32, 0, -26}};
    const CameraTriangle blue{Eigen::Vector3d(8, -30, -6), {8, 30, -6}, {-32, 0, -26}};
    if (is_red_first) drawn.draw(red, kRed, Hiding::by_depth);
    drawn.draw(blue, kBlue, Hiding::by_depth);
    if (!is_red_first) drawn.draw(red, kRed, Hiding::by_depth);
    const Image image = drawn.image();
    for (int x = 15; x < 25; ++x) ASSERT_EQ(image.at(x, 20), x < 20 ? kRed : kBlue) << x;
  }
}

// Along the red one the depth is 10 + x / 2: it comes before the blue one at x = 4, which is seen 3.33 pixels from the
// middle. Were depths taken as linear in the picture, it would be left of the middle.
TEST(Canvas, WhatIntersectsDoesSoWhereItIsInSpaceAndNotInThePicture) {
  Canvas drawn = canvas();
  draw_square(drawn, 100, 12, kBlue);
  drawn.draw({Eigen::Vector3d(-8, -30, -6), {-8, 30, -6}, {32, 0, -26}}, kRed, Hiding::by_depth);
  const Image image = drawn.image();
  for (int x = 10; x < 23; ++x) ASSERT_EQ(image.at(x, 20), kRed) << x;
  for (int x = 24; x < 30; ++x) ASSERT_EQ(image.at(x, 20), kBlue) << x;
}

TEST(Canvas, WithoutHidingItCoversWhatIsInFrontAndHidesNothing) {
  Canvas drawn = canvas();
  draw_square(drawn, 4, 8, kBlue);
  draw_square(drawn, 8, 10, kRed, Hiding::none);
  EXPECT_EQ(drawn.image().at(20, 20), kRed);
  draw_square(drawn, 12, 12, kBlue);  // behind both, and hidden by the first alone
  EXPECT_EQ(drawn.image().at(20, 20), kRed);
  EXPECT_EQ(drawn.image().at(13, 20), kBlue);
}

TEST(Canvas, WhatIsBehindTheEyeIsNotSeen) {
  Canvas drawn = canvas();
  draw_square(drawn, 8, -10, kRed);
  draw_square(drawn, 8, 0, kRed);
  draw_square(drawn, 0.01, 0.05, kRed);  // nearer than allowed
  expect_only_paper(drawn);
}

// A floor below the eye that begins behind it: its horizon is the middle row.
TEST(Canvas, WhatPassesTheEyeIsCutOff) {
  Canvas drawn = canvas();
  drawn.draw({Eigen::Vector3d(0, -1, 100), {-1e5, -1, -1e5}, {1e5, -1, -1e5}}, kRed, Hiding::by_depth);
  const Image image = drawn.image();
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y) ASSERT_EQ(image.at(x, y), y < 20 ? kPaper : kRed) << x << ' ' << y;
}

TEST(Canvas, TrianglesWithoutAreaAreNotSeen) {
  Canvas drawn = canvas();
  const Eigen::Vector3d a(-5, -3, -10), b(5, 3, -10);
  drawn.draw({a, a, a}, kRed, Hiding::by_depth);
  drawn.draw({a, a, b}, kRed, Hiding::by_depth);
  drawn.draw({a, b, (a + b) / 2}, kRed, Hiding::none);
  drawn.draw({a, b, 2 * b}, kRed, Hiding::by_depth);  // seen edge on
  expect_only_paper(drawn);
}

// A fan around a point that lies on no sample and on no pixel's edge.
TEST(Canvas, NothingShowsBetweenFacesThatShareAnEdge) {
  Canvas drawn = canvas();
  const auto rim = [](int i) { return Eigen::Vector3d(30 * std::cos(0.37 * i), 30 * std::sin(0.37 * i), -10); };
  for (int i = 0; i < 18; ++i)
    drawn.draw({Eigen::Vector3d(0.123, -0.456, -9), rim(i), rim(i + 1)}, kRed, Hiding::by_depth);
  const Image image = drawn.image();
  for (const Rgb& pixel : image.pixels) ASSERT_EQ(pixel, kRed);
}

TEST(Canvas, WhatIsFarOutsideThePictureDoesNoHarm) {
  Canvas drawn = canvas();
  drawn.draw({Eigen::Vector3d(-1e300, -1e300, -0.2), {1e300, -1e300, -0.2}, {0, -1e299, -0.2}}, kRed, Hiding::by_depth);
  drawn.draw({Eigen::Vector3d(100, 0, -10), {120, 0, -10}, {110, 10, -10}}, kRed, Hiding::by_depth);
  expect_only_paper(drawn);
}

}  // namespace
}  // namespace pcm::simulate
