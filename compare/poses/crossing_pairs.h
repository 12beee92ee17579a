// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "compare/poses/surface_features.h"
#include "pcm/inputs.h"

namespace pcm::compare {

/// A face of E and a face of F.
using FacePair = std::array<Index, 2>;

/// The pairs of faces that cross, ascending: an edge that passes through a face makes a pair of that with each face at
/// the edge, and every pair has such an edge (PCM section 4). `crossings` are those of all polygons.
template <class Crossings>
std::vector<FacePair> crossing_pairs(const SurfaceFeatures& E, const SurfaceFeatures& F, const Crossings& crossings) {
  std::vector<FacePair> pairs;
  for (const auto& x : crossings)
    for (const Index at_edge : (x.edge_side == Side::E ? E : F).faces_at(x.edge))
      pairs.push_back(x.edge_side == Side::E ? FacePair{at_edge, x.face} : FacePair{x.face, at_edge});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace pcm::compare
