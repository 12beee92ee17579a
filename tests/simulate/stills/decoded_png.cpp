// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/stills/decoded_png.h"

#include <gtest/gtest.h>
#include <png.h>

namespace pcm::simulate {

Image decoded_png(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  Image image;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    ADD_FAILURE() << png.message;
    return image;
  }
  EXPECT_EQ(png.format, PNG_FORMAT_RGB);
  image.width = static_cast<int>(png.width);
  image.height = static_cast<int>(png.height);
  image.pixels.resize(std::size_t{png.width} * png.height);
  EXPECT_NE(png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr), 0) << png.message;
  return image;
}

}  // namespace pcm::simulate
