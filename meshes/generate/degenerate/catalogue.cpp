// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/degenerate/catalogue.h"

#include <utility>

#include "pcm/bad_input.h"

namespace pcm::degenerate {

Case shifted_pair(std::string name, std::string shows, TriangleMesh mesh_E, TriangleMesh mesh_F,
                  std::optional<double> volume, const Eigen::Vector3d& r) {
  Case result;
  result.name = std::move(name);
  result.shows = std::move(shows);
  result.E = std::move(mesh_E);
  result.F = std::move(mesh_F);
  result.r = r;
  result.volume = volume;
  return result;
}

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
