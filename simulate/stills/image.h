// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcm::simulate {

using Rgb = std::array<std::uint8_t, 3>;  ///< red, green, blue (sRGB)

/// Rows from top to bottom, each from left to right.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;

  const Rgb& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

}  // namespace pcm::simulate
