// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_force/combinatorics.h"

#include <sstream>

namespace pcm::brute_force {
namespace {

std::string text(const std::vector<Index>& faces) {
  std::ostringstream out;
  for (const Index f : faces) out << ' ' << f;
  return out.str();
}

std::string text(const std::vector<Polygon>& polygons) {
  std::ostringstream out;
  for (const Polygon& polygon : polygons) {
    out << (polygon.closed ? "\n  closed" : "\n  open") << ", patch " << polygon.patch << ':';
    for (const Crossing& c : polygon.points)
      out << ' ' << (c.edge_side == Side::E ? 'E' : 'F') << c.edge[0] << '-' << c.edge[1] << '/' << c.face;
  }
  return out.str();
}

std::string text(const std::vector<std::tuple<Side, Index, Index>>& elements) {
  std::ostringstream out;
  for (const auto& [master, e, f] : elements) out << ' ' << (master == Side::E ? 'E' : 'F') << e << '/' << f;
  return out.str();
}

std::string text(Index value) {
  return ' ' + std::to_string(value);
}

}  // namespace

Combinatorics combinatorics_of(const Answer& answer) {
  return combinatorics_of(
      answer, [](const Polygon& polygon) -> const auto& { return polygon.points; });
}

std::string difference(const Combinatorics& truth, const Combinatorics& subj) {
  std::string result;
  const auto compare = [&](const char* what, const std::string& expected, const std::string& found) {
    if (expected != found) result += std::string(what) + ": twin" + expected + "\n   against" + found + '\n';
  };
  compare("touching", text(Index{truth.touching}), text(Index{subj.touching}));
  compare("nested", text(Index{truth.nested}), text(Index{subj.nested}));
  compare("ambiguous", text(Index{truth.ambiguous}), text(Index{subj.ambiguous}));
  compare("patches", text(truth.patches), text(subj.patches));
  compare("undefined areas", text(truth.undefined_areas), text(subj.undefined_areas));
  compare("too deep", text(truth.too_deep), text(subj.too_deep));
  compare("polygons", text(truth.polygons), text(subj.polygons));
  compare("intersected faces of E", text(truth.intersected[0]), text(subj.intersected[0]));
  compare("intersected faces of F", text(truth.intersected[1]), text(subj.intersected[1]));
  compare("inner faces of E", text(truth.inner[0]), text(subj.inner[0]));
  compare("inner faces of F", text(truth.inner[1]), text(subj.inner[1]));
  compare("elements", text(truth.elements), text(subj.elements));
  return result;
}

}  // namespace pcm::brute_force
