// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/barycentric/line_margin.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/base/depth.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Pays for a few roundings of quantities that are off by less than 2^-30 of themselves (kLeastShare in
/// penetration_walks.cpp), and for what F turns by beyond `turning_radius` where A is a rotation to 1e-9 only, at most
/// 6e-9 in all. That roundings tilt the normals of F's small faces from pose to pose, by up to 2^-17, is paid by
/// clearances: they are less by what a move of any vertex by 2^-30 of the greatest coordinate would tilt them, 64 times
/// as much.
constexpr double kDown = 1 - 0x1p-20;

/// How far the line is from the nearest side of f, seen along it, m; 0 where it may be on one.
double distance_from_sides(const DecidedLine& line) {
  const std::array<LineCoordinates::Point, 3> x{line.coordinates.see(line.f_Me[0]), line.coordinates.see(line.f_Me[1]),
                                                line.coordinates.see(line.f_Me[2])};
  const double error = line.coordinates.error(std::max({x[0].width, x[1].width, x[2].width}));
  double least = kInfinity;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = k == 2 ? 0 : k + 1;
    // |D| is the side's length, seen along the line, times its distance and |N|.
    const double surely = -side_of_edge(x[k], x[next]) - error;
    if (!(surely > 0)) return 0;
    least = std::min(least, surely / (2 * line.geometry.area * length(line.f_Me[next] - line.f_Me[k])));
  }
  return kDown * least;
}

}  // namespace

double travel_until_undecided(const DecidedLine& line, const LineMotion& motion) {
  const double from_sides = distance_from_sides(line);
  const DepthBelow below(line.geometry, line.f_Me);
  const double distance = -below.height / below.slope, near_cosine = -below.slope / length(below.N_f);
  const double cosine = kDown * near_cosine;
  const double nearest = (line.element ? distance : -distance) - line.distance_error;
  const double farthest = distance + line.distance_error;
  if (!(from_sides > 0 && cosine > 0 && nearest > 0)) return 0;
  double way = std::min(from_sides, cosine * nearest);
  if (line.element) {
    const double to_own_faces = line.thickness - farthest;
    if (!(to_own_faces > 0)) return 0;
    way = std::min(way, cosine * to_own_faces);
  }
  double travel = 0;
  const auto certify = [&](double at_most) {
    travel = std::max(travel, std::min(at_most, way / motion.way_over_travel));
  };
  // At twice the distance, which it can't exceed, a turn adds as much to the depth.
  const double depth = farthest * near_cosine / kDown;
  const double deeper = motion.way_over_travel + 2 * farthest / motion.turning_radius;
  for (std::size_t cone = 0; cone < kConeCosine.size(); ++cone) {
    const double until_outside = (cosine - kConeCosine[cone]) * motion.turning_radius;
    const double clear_beneath = line.clearance.beneath[cone] * line.greatest_of_slave;
    if (line.element) certify(std::min((clear_beneath - depth) / deeper, until_outside));
    if (!line.element && line.clearance.above[cone]) certify(until_outside);
  }
  if (line.element) {
    const double free_way = cosine * (line.slave_free - farthest);
    certify(std::min(free_way / motion.way_over_travel, line.slave_free_travel));
  } else if (line.slave_free == kInfinity) {
    certify(line.slave_free_travel);
  }
  return kDown * travel;
}

}  // namespace pcm::fast
