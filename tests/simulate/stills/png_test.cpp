// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/png.h"

#include <gtest/gtest.h>

#include "tests/meshes/expect_bad_input.h"
#include "tests/simulate/stills/decoded_png.h"

namespace pcm::simulate {
namespace {

/// Every pixel another colour.
Image colourful(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.pixels.push_back(
          {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(11 * y), static_cast<std::uint8_t>(x * y + 3)});
  return image;
}

TEST(Png, ReadsBackPixelByPixel) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(31, 17), std::pair(5, 200)}) {
    const Image image = colourful(width, height);
    const Image read = decoded_png(png_bytes(image));
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(read.height, height);
    EXPECT_EQ(read.pixels, image.pixels);
  }
}

TEST(Png, IsTheSameBytesEachTimeAndTellsNoTimeAndNoText) {
  const std::string bytes = png_bytes(colourful(31, 17));
  EXPECT_EQ(bytes, png_bytes(colourful(31, 17)));
  for (const char* chunk : {"tIME", "tEXt", "zTXt", "iTXt"}) EXPECT_EQ(bytes.find(chunk), std::string::npos) << chunk;
}

TEST(Png, RefusesAnImageWithoutPixels) {
  expect_bad_input([] { png_bytes(Image{}); }, "can't be written as PNG");
}

}  // namespace
}  // namespace pcm::simulate
