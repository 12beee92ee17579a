// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/still_instants.h"

#include <fmt/format.h>

#include <algorithm>

namespace pcm::simulate {

std::string flaw_of_instant(double t, const std::vector<double>& others, double duration) {
  if (t > duration) return fmt::format("{} s is beyond the end of the scene, {} s", t, duration);
  if (std::find(others.begin(), others.end(), t) != others.end()) return fmt::format("{} s is there twice", t);
  return "";
}

std::string still_name(double t) {
  return fmt::format("still_{}.png", t + 0.0);  // 0 for -0
}

}  // namespace pcm::simulate
