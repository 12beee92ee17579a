// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "compare/explain/rounded_points.h"
#include "compare/explain/signs.h"
#include "fast/predicates/orientation.h"
#include "reference/predicates/orientation.h"

namespace pcm::compare {
namespace {

using reference::Exact;
using reference::ExactPose;
using reference::Vec3;
using reference::Vertex;

/// The coefficient of a term in the perturbed determinant of rows (1, x, y, z): the rows of the moved vertices are
/// replaced by the unit vectors of their coordinates. Expanded along the first column, whose other entries are 1.
Exact coefficient(const ExactPose& pose, const std::array<Vertex, 4>& ascending,
                  const reference::PerturbationTerm<3>& term) {
  std::array<Vec3<Exact>, 4> rows;
  for (std::size_t v = 0; v < 4; ++v) {
    const int moved = term[v];
    rows[v] = moved < 0 ? pose.point<Exact>(ascending[v])
                        : Vec3<Exact>{Exact(moved == 0 ? 1 : 0), Exact(moved == 1 ? 1 : 0), Exact(moved == 2 ? 1 : 0)};
  }
  Exact sum = 0;
  for (std::size_t v = 0; v < 4; ++v) {
    if (term[v] >= 0) continue;
    const Exact minor = determinant(rows[v == 0 ? 1 : 0], rows[v <= 1 ? 2 : 1], rows[v <= 2 ? 3 : 2]);
    sum = v % 2 == 0 ? sum + minor : sum - minor;
  }
  return sum;
}

/// The displacements of the first term that is not 0, greatest first: of earlier vertices more, of z more than of y and
/// x.
std::vector<MovedCoordinate> deciding_term(const ExactPose& pose, std::array<Vertex, 4> vertices) {
  std::sort(vertices.begin(), vertices.end());
  for (const reference::PerturbationTerm<3>& term : reference::perturbation_terms<3>()) {
    if (reference::sign_of(coefficient(pose, vertices, term)) == 0) continue;
    std::vector<MovedCoordinate> moved;
    for (std::size_t v = 0; v < 4; ++v)
      if (term[v] >= 0) moved.push_back({vertices[v].side, vertices[v].index, term[v]});
    return moved;
  }
  return {};
}

}  // namespace

Sign orientation_sign(const ExactPose& pose, const std::array<Vertex, 4>& vertices) {
  std::array<Eigen::Vector3d, 4> points;
  std::array<fast::RankedPoint, 4> ranked;
  const auto count_E = static_cast<std::int64_t>(pose.surface(Side::E).mesh.vertices.size());
  Sign sign;
  for (std::size_t k = 0; k < 4; ++k) {
    points[k] = rounded_point(pose, vertices[k]);
    ranked[k] = {points[k].data(), vertices[k].index + (vertices[k].side == Side::E ? 0 : count_E)};
    sign.of.push_back(vertex_feature(vertices[k].side, vertices[k].index));
  }
  fast::WorkCounters work;
  sign.decided = fast::orientation(ranked[0], ranked[1], ranked[2], ranked[3], work);
  sign.stage = stage_of(work);
  sign.exact = reference::Orientation(pose).exact_orientation(vertices[0], vertices[1], vertices[2], vertices[3]);
  if (sign.stage == Stage::tie_rule) sign.term = deciding_term(pose, vertices);
  return sign;
}

}  // namespace pcm::compare
