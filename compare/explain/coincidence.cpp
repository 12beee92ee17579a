// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/coincidence.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace pcm::compare {
namespace {

/// The feature itself and those on its border.
std::vector<Feature> closure_of(const Feature& feature, const TriangleMesh& mesh) {
  std::vector<Feature> closure{feature};
  if (feature.kind == FeatureKind::edge) {
    for (const Index v : feature.index) closure.push_back(vertex_feature(feature.side, v));
  } else if (feature.kind == FeatureKind::face) {
    const Triangle& t = mesh.faces[static_cast<std::size_t>(feature.index[0])];
    for (std::size_t k = 0; k < 3; ++k) {
      closure.push_back(vertex_feature(feature.side, t[k]));
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      closure.push_back(edge_feature(feature.side, {low, high}));
    }
  }
  return closure;
}

}  // namespace

bool are_different_places(const Coincidence& a, const Coincidence& b, double width) {
  return (a.exact() && b.exact()) || (a.position_Me - b.position_Me).norm() > 2 * width;
}

void sort_by_margin(std::vector<Coincidence>& coincidences) {
  std::sort(coincidences.begin(), coincidences.end(), [](const Coincidence& a, const Coincidence& b) {
    return std::tie(a.margin, a.kind, a.features) < std::tie(b.margin, b.kind, b.features);
  });
}

void leave_out_told_by_parts(std::vector<Coincidence>& coincidences, const TriangleMesh& mesh_E,
                             const TriangleMesh& mesh_F) {
  std::set<std::array<Feature, 2>> told;
  for (const Coincidence& c : coincidences) told.insert(c.features);
  const auto closure = [&](const Feature& x) { return closure_of(x, x.side == Side::E ? mesh_E : mesh_F); };
  std::erase_if(coincidences, [&](const Coincidence& c) {
    if (c.exact()) return false;
    for (const Feature& first : closure(c.features[0]))
      for (const Feature& second : closure(c.features[1]))
        if (std::array part{first, second}; part != c.features && told.contains(part)) return true;
    return false;
  });
}

}  // namespace pcm::compare
