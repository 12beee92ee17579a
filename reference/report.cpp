// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/report.h"

#include <algorithm>

#include "reference/ball.h"

namespace pcm::reference {
namespace {

/// Precision of the enclosures to begin with: enough for nearly all crossings.
constexpr mpfr_prec_t kPositionPrecision = 160;

Eigen::Vector3d rounded_position(const CrossingPoints& points, Index crossing) {
  const Vec3<Ball> enclosure = points.position<Ball>(crossing, Field<Ball>{kPositionPrecision});
  Eigen::Vector3d position;
  bool all_rounded = true;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> value = enclosure[i].rounded();
    all_rounded = all_rounded && value;
    position[i] = value.value_or(0);
  }
  if (all_rounded) return position;
  const Vec3<Rational> exact = points.position<Rational>(crossing);
  return {nearest_double(exact.x), nearest_double(exact.y), nearest_double(exact.z)};
}

}  // namespace

void report_polygons(const CrossingPoints& points, const std::vector<Chain>& chains, const std::vector<Index>& patches,
                     Answer& answer) {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Polygon polygon;
    polygon.closed = chains[i].closed;
    polygon.patch = patches[i];
    answer.patches = std::max(answer.patches, patches[i] + 1);
    for (const Index point : chains[i].points) {
      const CrossingId& id = points.ids()[point];
      polygon.points.push_back({id.edge_side, id.edge, id.face, rounded_position(points, point)});
    }
    answer.polygons.push_back(polygon);
  }
}

}  // namespace pcm::reference
