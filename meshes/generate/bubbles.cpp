// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/bubbles.h"

#include <vector>

#include "meshes/generate/deterministic_trigonometry.h"
#include "meshes/generate/generator_support.h"

namespace pcm::generate {

TriangleMesh bubble(double length, Index finer) {
  require_length("length", length);
  require_count("finer", finer, 1, 100);
  constexpr Index kSegments = 25;
  constexpr Index kBands = 20;
  static_assert(2 * kSegments * (kBands - 1) == 950);
  std::vector<ProfilePoint> profile;
  const std::int64_t bands = std::int64_t{kBands} * finer;
  for (std::int64_t j = 0; j <= bands; ++j) {
    const auto [cosine, sine] = cosine_sine_of_turn(j, 2 * bands);
    const double cosine_of_double = cosine_sine_of_turn(j, bands).cosine;
    const double distance = length / 2 * ((1 + cosine_of_double / 2) / 1.5);
    profile.push_back({distance * sine, 0.0 - distance * cosine});
  }
  return surface_of_revolution("bubble", profile, kSegments * finer);
}

TriangleMesh pyramid(double width, double depth) {
  require_length("width", width);
  require_length("depth", depth);
  const double w = width / 2;
  return finished("pyramid", {{0, 0, 0}, {w, w, depth}, {-w, w, depth}, {-w, -w, depth}, {w, -w, depth}},
                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
}

}  // namespace pcm::generate
