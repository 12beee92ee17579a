// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/png.h"

#include <png.h>

#include "pcm/bad_input.h"

namespace pcm::simulate {

std::string png_bytes(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  // Asked once for the length, once for the bytes.
  std::string bytes;
  png_alloc_size_t length = 0;
  for (const bool is_measured : {false, true}) {
    bytes.resize(length);
    const int written = png_image_write_to_memory(&png, is_measured ? bytes.data() : nullptr, &length, 0,
                                                  image.pixels.data(), 0, nullptr);
    if (written == 0) throw BadInput(std::string("the picture can't be written as PNG: ") + png.message);
  }
  return bytes;
}

}  // namespace pcm::simulate
