// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/degenerate/catalogue.h"

#include <utility>

#include "meshes/bad_input.h"

namespace pcm::degenerate {

std::vector<Case> catalogue() {
  std::vector<Case> all = meeting_features();
  for (auto more : {coplanar_faces(), unusual_topologies()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

Case find_case(const std::string& name) {
  std::string known;
  for (Case& candidate : catalogue()) {
    if (candidate.name == name) return std::move(candidate);
    known += (known.empty() ? "" : ", ") + candidate.name;
  }
  throw BadInput("there is no degenerate case '" + name + "'; the cases are " + known);
}

}  // namespace pcm::degenerate
