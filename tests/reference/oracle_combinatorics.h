// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/vocabulary/answer.h"
#include "tests/reference/brute_force/combinatorics.h"

namespace pcm::brute_force {

/// The oracle's answer in the twin's words.
inline Combinatorics combinatorics_of(const reference::Answer& answer) {
  return combinatorics_of(
      answer, [](const reference::Polygon& polygon) -> const auto& { return polygon.points; });
}

}  // namespace pcm::brute_force
