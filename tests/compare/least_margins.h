// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "compare/poses/orientation_margin.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/poses/strata.h"

namespace pcm::compare {

/// The margins above 0 of all decisions about faces and vertices, edges and edges at a pose, ascending.
inline std::vector<double> least_margins(const FeaturePair& pair, const Pose& pose) {
  const std::vector<Eigen::Vector3d> F = rounded_vertices(pair.F.mesh, pose);
  const std::vector<Eigen::Vector3d>& E = pair.E.mesh.vertices;
  std::vector<double> margins;
  const auto add = [&margins](const std::array<Eigen::Vector3d, 4>& points) {
    const double margin = orientation_margin(points);
    if (margin > 0) margins.push_back(margin);
  };
  const auto add_heights = [&add](const std::vector<Eigen::Vector3d>& faces_of, const Triangle& face,
                                  const std::vector<Eigen::Vector3d>& vertices) {
    const auto at = [&](std::size_t k) { return faces_of[static_cast<std::size_t>(face[k])]; };
    for (const Eigen::Vector3d& x : vertices) add({at(0), at(1), at(2), x});
  };
  for (const Triangle& face : pair.E.mesh.faces) add_heights(E, face, F);
  for (const Triangle& face : pair.F.mesh.faces) add_heights(F, face, E);
  for (const FeatureEdge& e : pair.E.edges)
    for (const FeatureEdge& f : pair.F.edges)
      add({vertex(pair.E, e.ends[0]), vertex(pair.E, e.ends[1]), F[static_cast<std::size_t>(f.ends[0])],
           F[static_cast<std::size_t>(f.ends[1])]});
  std::sort(margins.begin(), margins.end());
  return margins;
}

}  // namespace pcm::compare
