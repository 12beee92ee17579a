// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings/pair_margin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/simd/pairs.h"

namespace pcm::fast {

namespace {

using Points = std::array<Eigen::Vector3d, 3>;

/// Between these bounds of the greatest coordinate, m, nothing below over- or underflows that is not said to.
constexpr double kLeastUnscaled = 0x1p-40, kGreatestUnscaled = 0x1p40;

/// No less than the square of the length of a product of two lengths, however small.
double at_least_square(const Eigen::Vector3d& product) {
  return product.dot(product) + 0x1p-400;
}

/// The square of a distance as a fraction: to find the least or the greatest of some takes no root and no division.
struct SquaredDistance {
  double numerator = 0, denominator = 1;

  bool operator<(const SquaredDistance& other) const {
    return numerator * other.denominator < other.numerator * denominator;
  }
  double root() const { return std::sqrt(numerator / denominator); }
};

/// The corners of two faces, seen from the first one of e.
struct CornersFromE0 {
  std::array<Eigen::Vector3d, 2> e;
  std::array<Eigen::Vector3d, 3> f;

  CornersFromE0(const Points& e_points, const Points& f_points)
      : e{e_points[1] - e_points[0], e_points[2] - e_points[0]},
        f{f_points[0] - e_points[0], f_points[1] - e_points[0], f_points[2] - e_points[0]} {}

  double at_least_farthest() const {
    return std::max({e[0].lpNorm<1>(), e[1].lpNorm<1>(), f[0].lpNorm<1>(), f[1].lpNorm<1>(), f[2].lpNorm<1>()});
  }

  /// The gap between the faces along a direction that is a product of two lengths; 0 where they overlap there.
  SquaredDistance gap_along(const Eigen::Vector3d& direction) const {
    const double e1 = direction.dot(e[0]), e2 = direction.dot(e[1]);
    const double f0 = direction.dot(f[0]), f1 = direction.dot(f[1]), f2 = direction.dot(f[2]);
    const double f_above = std::min(f0, std::min(f1, f2)) - std::max(0.0, std::max(e1, e2));
    const double e_above = std::min(0.0, std::min(e1, e2)) - std::max(f0, std::max(f1, f2));
    const double gap = std::max(f_above, e_above);
    return {gap > kLeastSureVolume ? gap * gap : 0, at_least_square(direction)};
  }
};

/// A lower bound of the distance between two faces that do not cross, less the roundings of a gap, m.
double distance_between(const Points& e, const Points& f, const PairSigns& signs) {
  const CornersFromE0 corners(e, f);
  SquaredDistance distance;
  const auto look_along = [&](const Eigen::Vector3d& direction) {
    distance = std::max(distance, corners.gap_along(direction));
  };
  const int lone_E = lone_corner(signs.above_of_E), lone_F = lone_corner(signs.above_of_F);
  look_along((f[1] - f[0]).cross(f[2] - f[0]));
  if (lone_E >= 0) look_along((e[1] - e[0]).cross(e[2] - e[0]));
  if (lone_E >= 0 && lone_F >= 0)
    for (int i = 1; i < 3; ++i) {
      const Eigen::Vector3d b = e[cyclic_corner(lone_E + i)] - e[cyclic_corner(lone_E)];
      for (int j = 1; j < 3; ++j) look_along(b.cross(f[cyclic_corner(lone_F + j)] - f[cyclic_corner(lone_F)]));
    }
  return distance.root() - kVolumeRoundings * corners.at_least_farthest();
}

/// The distance |product| / |across|, less the roundings of either, which are `roundings` and `across_roundings` at
/// most. (a + b)^2 <= (1 + c) a^2 + (1 + 1 / c) b^2, with c = 2^-20.
SquaredDistance distance_of(double product, double roundings, const Eigen::Vector3d& across, double across_roundings) {
  const double numerator = std::abs(product) - roundings;
  const double denominator =
      (1 + 0x1p-20) * at_least_square(across) + (1 + 0x1p20) * across_roundings * across_roundings;
  return {numerator > kLeastSureVolume ? numerator * numerator : 0, denominator};
}

/// Of the line from `from` to `to`, which passes through a face: the least distance of its ends from the face's plane
/// and of itself from the lines of the face's sides.
SquaredDistance margin_of_edge(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Points& face) {
  const std::array<Eigen::Vector3d, 3> sides{face[1] - face[0], face[2] - face[1], face[0] - face[2]};
  const Eigen::Vector3d N = sides[0].cross(sides[1]);
  const double N_roundings = kVolumeRoundings * sides[0].lpNorm<1>() * sides[1].lpNorm<1>();
  const auto from_plane = [&](const Eigen::Vector3d& x) {
    return distance_of(N.dot(x), N_roundings * x.lpNorm<1>(), N, N_roundings);
  };
  SquaredDistance least = std::min(from_plane(from - face[0]), from_plane(to - face[0]));
  const Eigen::Vector3d edge = to - from;
  const double edge_roundings = kVolumeRoundings * edge.lpNorm<1>();
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d across = edge.cross(sides[k]), x = face[k] - from;
    const double roundings = edge_roundings * sides[k].lpNorm<1>();
    least = std::min(least, distance_of(across.dot(x), roundings * x.lpNorm<1>(), across, roundings));
  }
  return least;
}

/// Of faces that cross, m.
double margin_of_passing(const Points& e, const Points& f, const PairSigns& signs) {
  const int lone_E = lone_corner(signs.above_of_E), lone_F = lone_corner(signs.above_of_F);
  SquaredDistance least{1, 0};  // more than any
  for (int i = 0; i < 2; ++i) {
    // As SureSigns numbers them: from the lone corner, and to it.
    const int other = 1 + i;
    if ((signs.passing >> i & 1U) != 0)
      least = std::min(least, margin_of_edge(e[cyclic_corner(lone_E)], e[cyclic_corner(lone_E + other)], f));
    if ((signs.passing >> (2 + i) & 1U) != 0)
      least = std::min(least, margin_of_edge(f[cyclic_corner(lone_F)], f[cyclic_corner(lone_F + other)], e));
  }
  return least.root();
}

double unscaled_margin(const Points& e, const Points& f, const PairSigns& signs) {
  return signs.passing == 0 ? distance_between(e, f, signs) : margin_of_passing(e, f, signs);
}

double greatest_coordinate(const Points& points) {
  return std::max({points[0].cwiseAbs().maxCoeff(), points[1].cwiseAbs().maxCoeff(), points[2].cwiseAbs().maxCoeff()});
}

}  // namespace

double pair_margin(const Points& e, const Points& f, const PairSigns& signs) {
  const double greatest = std::max(greatest_coordinate(e), greatest_coordinate(f));
  if (greatest > kLeastUnscaled && greatest < kGreatestUnscaled) return unscaled_margin(e, f, signs);
  if (greatest == 0 || !std::isfinite(greatest)) return 0;
  const int exponent = std::ilogb(greatest);
  const auto scaled = [&](const Points& points) {
    Points result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = points[k].unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
    return result;
  };
  const double margin = std::ldexp(unscaled_margin(scaled(e), scaled(f), signs), exponent);
  return margin < std::numeric_limits<double>::min() ? 0 : margin;  // or it may have been rounded up
}

}  // namespace pcm::fast
