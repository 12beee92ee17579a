// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/colours.h"

#include <algorithm>
#include <cmath>

namespace pcm::simulate {
namespace {

// Of light, 0 to 1 by colour.
const Eigen::Vector3d kSky(1, 1, 1), kGround = Eigen::Vector3d(0xb4, 0xbc, 0xc6) / 255;
constexpr double kSkyIntensity = 0.66, kLampIntensity = 0.42;

std::uint8_t rounded(double colour) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(colour, 0.0, 255.0)));
}

}  // namespace

Rgb bar_colour(double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * (kColourStops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), kColourStops.size() - 2);
  Rgb colour;
  for (std::size_t k = 0; k < 3; ++k) {
    const double from = kColourStops[i][k], to = kColourStops[i + 1][k];
    colour[k] = rounded(from + (place - static_cast<double>(i)) * (to - from));
  }
  return colour;
}

Rgb lit(const Rgb& colour, const Eigen::Vector3d& normal_C, const Eigen::Vector3d& up_C) {
  const Eigen::Vector3d to_lamp_C = Eigen::Vector3d(-0.6, 0.5, 1).normalized();
  const double share_of_sky = 0.5 + 0.5 * normal_C.dot(up_C);
  const double lamp = kLampIntensity * std::max(0.0, normal_C.dot(to_lamp_C));
  const Eigen::Vector3d light =
      kSkyIntensity * (share_of_sky * kSky + (1 - share_of_sky) * kGround) + Eigen::Vector3d::Constant(lamp);
  Rgb shaded;
  for (std::size_t k = 0; k < 3; ++k) shaded[k] = rounded(colour[k] * light[static_cast<Eigen::Index>(k)]);
  return shaded;
}

}  // namespace pcm::simulate
