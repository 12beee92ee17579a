// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "fast/posed/transform.h"
#include "fast/predicates/penetration_predicates.h"
#include "fast/predicates/side_bound.h"
#include "fast/search/line_search.h"

namespace pcm::fast {

/// How points lie across the penetration line of a master face (p0, p1, p2) with barycentre C: at
///     X = (p1 - p0) . (x - C),  Y = (p2 - p0) . (x - C).
/// For N = (p1 - p0) x (p2 - p0) and any v, w: N . (v x w) = X_v Y_w - Y_v X_w. So the side tests D of
/// fast/predicates/penetration_predicates.h are determinants of two such points.
///
/// Error, with u = 2^-53, M the greatest |coordinate| in Me, |a| and |b| the 1-norms of both edges, W the greatest
/// |coordinate| of x - C, at most 2 M: C is off by 8 u M, x - C by 10 u M, X by 10 u M |a| and five roundings of at
/// most 2 M |a|: 20 u M |a|. Likewise Y. Of D's two products each is at most |a| |b| W^2 and off by 40 u M |a| |b| W
/// and two roundings: 88 u M |a| |b| W for both. 128 pays for rounding the bound itself, whose first factors exceed
/// 2^-1000 together, so that none of it is lost. Other underflow costs nothing beside that where M |a| and M |b| exceed
/// 2^-500 and the bound 2^-900. Products of D are at most 2^47 times the bound, so
/// that none overflows where it is below 2^970; else it is infinite.
class LineCoordinates {
 public:
  struct Point {
    double x, y, width;
  };

  /// `a` and `b`: |a| and |b|, each within a few roundings.
  LineCoordinates(const std::array<Eigen::Vector3d, 3>& p, const Eigen::Vector3d& barycentre, double a, double b,
                  double max_coordinate)
      : C_(barycentre), a_(p[1] - p[0]), b_(p[2] - p[0]) {
    error_per_width_ = kSideError * max_coordinate * a * b;
    usable_ = max_coordinate * a > kLeastSideProduct && max_coordinate * b > kLeastSideProduct &&
              error_per_width_ > kLeastErrorPerWidth;
  }

  /// Whether numbers are neither so large nor so small that the bound fails.
  bool usable() const { return usable_; }

  Point see(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d from_C = x - C_;
    return {a_.dot(from_C), b_.dot(from_C), from_C.cwiseAbs().maxCoeff()};
  }

  /// What |D| of edges between points no wider than `width` must exceed for its sign to be sure.
  double error(double width) const {
    const double error = error_per_width_ * width + kSideUnderflow;
    return error < kGreatestSideBound ? error : std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr double kLeastErrorPerWidth = 0x1p-1000;

  Eigen::Vector3d C_, a_, b_;
  double error_per_width_;
  bool usable_;
};

/// The side test D of an edge from one point to another.
inline double side_of_edge(const LineCoordinates::Point& from, const LineCoordinates::Point& to) {
  return from.x * to.y - from.y * to.x;
}

/// What is sure of the line and a face: `unknown` where nothing is, no value where the line misses it.
inline std::optional<Passage> passage_through(const LineCoordinates& line, const FacePoints& f, WorkCounters& work) {
  if (!line.usable()) return Passage::unknown;
  work.predicates += 3;
  const std::array<LineCoordinates::Point, 3> x{line.see(f[0]), line.see(f[1]), line.see(f[2])};
  const double error = line.error(std::max({x[0].width, x[1].width, x[2].width}));
  const std::array<double, 3> D{side_of_edge(x[0], x[1]), side_of_edge(x[1], x[2]), side_of_edge(x[2], x[0])};
  const double least = std::min({D[0], D[1], D[2]}), greatest = std::max({D[0], D[1], D[2]});
  if (least < -error && greatest > error) return std::nullopt;
  return greatest < -error ? Passage::leaving : least > error ? Passage::entering : Passage::unknown;
}

/// Walks over a surface from face to neighbouring face, each time over an edge that has the line on its far side, until
/// the line surely passes through the face's interior, leaving the body there: that face. -1 where it can't be told,
/// where a border or a face turned away is met, or after too many steps. A neighbour has the edge the other way round,
/// which changes D's sign and no other bit: one vertex and two edges are new with each step.
inline Index walk_to_face_left(PosedSurface& posed, const LineCoordinates& line, Index start, WorkCounters& work) {
  constexpr int kMostSteps = 32;
  const PreparedSurface& surface = posed.surface();
  const auto see = [&](Index v) { return line.see(posed.vertex_Me(v, work)); };
  const Triangle& corners = surface.face(start);
  // Edge k runs from corner k on; corner 0 is the face's corner `first`.
  std::array<LineCoordinates::Point, 3> x{see(corners[0]), see(corners[1]), see(corners[2])};
  std::array<double, 3> D{side_of_edge(x[0], x[1]), side_of_edge(x[1], x[2]), side_of_edge(x[2], x[0])};
  Index face = start;
  std::size_t first = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    work.predicates += step == 0 ? 3 : 2;
    const double error = line.error(std::max({x[0].width, x[1].width, x[2].width}));
    // D0 + D1 + D2 = N . N_f: all are negative where the line leaves through f.
    std::size_t worst = D[1] > D[0] ? 1 : 0;
    if (D[2] > D[worst]) worst = 2;
    if (D[worst] < -error) return face;
    if (!(D[worst] > error) || !(D[0] + D[1] + D[2] < 0)) return -1;
    const std::size_t over = (first + worst) % 3;
    const Index edge = surface.edges_of(face)[over];
    const Index beyond = surface.neighbours_of(face)[over];
    if (beyond == face) return -1;
    face = beyond;
    const std::array<Index, 3>& edges = surface.edges_of(face);
    first = edges[0] == edge ? 0 : edges[1] == edge ? 1 : 2;
    x = {x[(worst + 1) % 3], x[worst], see(surface.face(face)[(first + 2) % 3])};
    D = {-D[worst], side_of_edge(x[1], x[2]), side_of_edge(x[2], x[0])};
  }
  return -1;
}

}  // namespace pcm::fast
