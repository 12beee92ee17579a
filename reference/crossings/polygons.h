// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/crossings/crossings.h"

namespace pcm::reference {

/// A chain of crossings (PCM section 4): closed, starting at its smallest crossing, or open, starting where the
/// circulation (5) starts. Points count in Crossings::ids.
struct Chain {
  bool closed = true;
  std::vector<Index> points;
};

/// Chains the segments by identity of their crossings; ordered by first crossing.
std::vector<Chain> chain_polygons(const Crossings& crossings);

}  // namespace pcm::reference
