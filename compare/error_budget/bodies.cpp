// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/error_budget/bodies.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>

namespace pcm::compare {

Expectation second_order(double leading, double off, Extent extent, const std::string& reason) {
  const double wide = extent == Extent::full ? off : 4 * off;
  Expectation expected;
  expected.finest = {leading - wide, leading + wide};
  if (extent == Extent::full) expected.order = Band{1.9, 2.1};
  expected.reason = fmt::format("{}: {:.3g} +- {:.2g}", reason, leading, wide);
  return expected;
}

Expectation second_order(Extent extent, const std::string& reason) {
  // Few orientations scatter about the mean.
  return {{}, extent == Extent::full ? Band{1.9, 2.1} : Band{1.7, 2.3}, reason};
}

Expectation no_more_than(double bound, const std::string& reason) {
  return {within(bound), {}, fmt::format("{}: at most {:.2g}", reason, bound)};
}

double enclosed_volume(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.faces)
    six_volumes += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
  return six_volumes / 6;
}

TriangleMesh scaled_to_volume(TriangleMesh mesh, double now, double wanted) {
  const double factor = std::cbrt(wanted / now);
  for (Eigen::Vector3d& x : mesh.vertices) x *= factor;
  return mesh;
}

}  // namespace pcm::compare
