// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings/pair_margin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/base/geometry.h"

namespace pcm::fast {

namespace {

using Points = std::array<Eigen::Vector3d, 3>;

/// Roundings of a product of two or three differences of points, in units of the product of their lengths: 16 u would
/// do.
constexpr double kProductRoundings = 0x1p-48;
/// Products that are no greater may have lost digits to underflow, and tell nothing.
constexpr double kLeastProductOfLengths = 0x1p-960;

/// The gap between two faces along a direction, less its roundings; not positive where they overlap there, m.
double gap_along(const Eigen::Vector3d& direction, const Points& e, const Points& f) {
  const std::array<Eigen::Vector3d, 6> x{
      Eigen::Vector3d::Zero(), e[1] - e[0], e[2] - e[0], f[0] - e[0], f[1] - e[0], f[2] - e[0]};
  std::array<double, 6> along;
  double farthest = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    along[k] = direction.dot(x[k]);
    farthest = std::max(farthest, length(x[k]));
  }
  const double low_e = std::min({along[0], along[1], along[2]}), high_e = std::max({along[0], along[1], along[2]});
  const double low_f = std::min({along[3], along[4], along[5]}), high_f = std::max({along[3], along[4], along[5]});
  const double gap = std::max(low_f - high_e, low_e - high_f);
  return gap > kLeastProductOfLengths ? gap / length(direction) - kProductRoundings * farthest : 0;
}

/// A lower bound of the distance between two faces that do not cross, m.
double distance_between(const Points& e, const Points& f, const PairSigns& signs) {
  const int lone_E = lone_corner(signs.above_F);
  double distance = gap_along((f[1] - f[0]).cross(f[2] - f[0]), e, f);
  if (lone_E < 0) return distance;
  distance = std::max(distance, gap_along((e[1] - e[0]).cross(e[2] - e[0]), e, f));
  const int lone_F = lone_corner(signs.above_E);
  if (lone_F < 0) return distance;
  for (int i = 1; i < 3; ++i) {
    const Eigen::Vector3d b = e[cyclic_corner(lone_E + i)] - e[cyclic_corner(lone_E)];
    for (int j = 1; j < 3; ++j)
      distance = std::max(distance, gap_along(b.cross(f[cyclic_corner(lone_F + j)] - f[cyclic_corner(lone_F)]), e, f));
  }
  return distance;
}

/// A height or a distance as the quotient of a product of three lengths and one of two, less their roundings, m.
double quotient(double product, double roundings, double divisor) {
  return product > kLeastProductOfLengths ? (product - roundings) / divisor : 0;
}

/// Of the line from `from` to `to`, which passes through a face: the least distance of its ends from the face's plane
/// and of itself from the lines of the face's sides, m.
double margin_of_edge(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Points& face) {
  const Eigen::Vector3d edge = to - from;
  const double edge_length = length(edge);
  const Eigen::Vector3d a = face[1] - face[0], b = face[2] - face[0], N = a.cross(b);
  const double area_roundings = kProductRoundings * length(a) * length(b), twice_area = length(N) + area_roundings;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d* const end : {&from, &to}) {
    const Eigen::Vector3d x = *end - face[0];
    least = std::min(least, quotient(std::abs(N.dot(x)), area_roundings * length(x), twice_area));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d side = face[(k + 1) % 3] - face[k], across = edge.cross(side), x = face[k] - from;
    const double roundings = kProductRoundings * edge_length * length(side);
    least = std::min(least, quotient(std::abs(across.dot(x)), roundings * length(x), length(across) + roundings));
  }
  return least;
}

}  // namespace

double pair_margin(const Points& e, const Points& f, const PairSigns& signs) {
  if (signs.passing == 0) return distance_between(e, f, signs);
  const int lone_E = lone_corner(signs.above_F), lone_F = lone_corner(signs.above_E);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    // As SureSigns numbers them: from the lone corner, and to it.
    const int other = 1 + i;
    if ((signs.passing >> i & 1U) != 0)
      least = std::min(least, margin_of_edge(e[cyclic_corner(lone_E)], e[cyclic_corner(lone_E + other)], f));
    if ((signs.passing >> (2 + i) & 1U) != 0)
      least = std::min(least, margin_of_edge(f[cyclic_corner(lone_F)], f[cyclic_corner(lone_F + other)], e));
  }
  return least;
}

}  // namespace pcm::fast
