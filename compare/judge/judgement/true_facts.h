// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/judge/lines/given_answer.h"
#include "compare/verify/bounds/question.h"
#include "reference/vocabulary/answer.h"

/// Facts of the oracle's answer in the form in which answers give them.
namespace pcm::compare {

/// What the oracle has to work out for what an answer gives.
Wanted wanted_for(const GivenAnswer& answer);

/// Intersected and inner faces together, ascending.
std::vector<Index> active_faces(const std::vector<Index>& intersected, const std::vector<Index>& inner);

/// The pairs of faces that cross, ascending: an edge that passes through a face makes a pair of that with each face at
/// the edge, and every pair has such an edge (PCM section 4). `polygon_points` visits all crossings.
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
std::vector<FacePair> true_crossing_pairs(const Question& question, const reference::Answer& truth);

/// Whether both are alike in everything discrete: polygons as cycles, faces, elements.
bool same_discrete_facts(const reference::Answer& a, const reference::Answer& b);

}  // namespace pcm::compare
