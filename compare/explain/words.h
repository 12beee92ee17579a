// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "compare/explain/coincidence.h"
#include "compare/explain/sign.h"

/// How features, coincidences and signs are called, in sentences and as keys of JSON.
namespace pcm::compare {

/// "vertex 3 of E", "edge 2-5 of F", "the penetration line of face 7 of E".
std::string text(const Feature& feature);

/// What coincides, of one or of several, e.g. "edge across edge", "edges across edges"; `key`: "edge_across_edge".
struct KindWords {
  std::string_view key, one, several;
};
const KindWords& words(CoincidenceKind kind);

/// "orientation", "filter", "vertex": the names as keys.
std::string_view key(Predicate predicate);
std::string_view key(Stage stage);
std::string_view key(FeatureKind kind);

/// "z of vertex 4 of E", the displacements of a term joined by "times".
std::string text(const std::vector<MovedCoordinate>& term);

/// What the sign is and who decides it, one line.
std::string text(const Sign& sign);

}  // namespace pcm::compare
