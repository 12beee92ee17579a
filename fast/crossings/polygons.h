// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/crossings/crossings.h"
#include "pcm/contact.h"

namespace pcm::fast {

/// The crossings chained to intersection polygons.
struct PolygonChains {
  /// In canonical order; `first` and `count` are places in crossing_order.
  std::vector<Polygon> polygons;
  std::vector<Index> crossing_order;  ///< crossings of all polygons, one polygon after the other

  void clear() {
    polygons.clear();
    crossing_order.clear();
  }
};

/// Chains the segments to polygons by identity (PCM section 4), and enters each crossing's polygon. Canonical order:
/// crossings are compared by (side, edge, face); a closed polygon starts at its smallest crossing, an open one where
/// the circulation of (5) starts; polygons are sorted by their first crossing. Linear but for the sort of the polygons.
/// `unsorted` is scratch.
void chain_polygons(Crossings& crossings, std::vector<Index>& unsorted, PolygonChains& chains);

}  // namespace pcm::fast
