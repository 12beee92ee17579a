// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "compare/io/tables/kept_values.h"
#include "compare/stability/pose_figures.h"
#include "compare/stability/sweeps.h"

/// `pcm verify --stability`: the engine's rounding error beside the condition of the problem, one thing varied at a
/// time. Error over condition is the engine's own share: about a constant, whatever the condition, where the engine
/// answers as well as doubles allow.
///
/// What it ought to be. The engine solves the exact problem of vertices of F that are off by up to about two ulps of
/// the greatest coordinate S, each on its own (PCM section 1), and rounds some dozen times after that; the condition is
/// how far the answer moves as all vertices of F are displaced alike, by up to an ulp of S. Where the answer depends on
/// the placement of F, both are of the order of 2^-53 S times the same derivative, so their quotient is of the order of
/// 1 at any S and any depth, and less where the errors of many vertices average out. Where the condition is less than
/// 2^-53, the quotient shows that the answer is a double.
///
/// Not so of slivers. A face of length L and height h off the axes has a doubled normal N as long as L h that is
/// computed from products as great as L^2, each rounded: N's direction is off by some 2^-53 L / h. A depth is the
/// distance from the plane through a corner that may be as far off as L, and so off by some 2^-53 L^2 / h. What the
/// rounding of vertices does to it, and an ulp of the pose, is some 2^-53 L. So the quotient grows as L / h, the aspect
/// ratio of the face, at the least: an error of evaluation, which `of_vertices` tells apart from that of vertices.
namespace pcm::compare::stability {

/// Of a number over poses; infinite numbers count as greatest ones. NaN without any.
struct Spread {
  double median = std::numeric_limits<double>::quiet_NaN();
  double greatest = std::numeric_limits<double>::quiet_NaN();

  bool any() const { return median == median; }
};
Spread spread_of(std::vector<double> numbers);

/// What a group of poses has to tell.
struct GroupFigures {
  std::int64_t poses = 0;

  struct OfQuantity {
    Spread error, of_vertices, bound, condition;
    Spread error_over_condition, bound_over_error, bound_over_condition;
  };
  std::array<OfQuantity, kQuantities.size()> quantities;

  /// Barycentric scheme.
  struct OfPublished {
    std::int64_t unanswered = 0;
    std::int64_t other_elements = 0;  ///< than the exact problem has
    std::array<Spread, kQuantities.size()> error;
  };
  std::array<OfPublished, kPublished.size()> published;

  const OfQuantity& of(Quantity quantity) const { return quantities[static_cast<std::size_t>(quantity)]; }
};

/// A point of a sweep in one scheme.
struct PointFigures {
  SweepPoint point;
  Scheme scheme = Scheme::barycentric;
  std::int64_t poses = 0;
  std::int64_t without_force = 0;
  std::int64_t unanswered = 0;  ///< or with numbers that are not finite
  std::int64_t unbounded = 0;
  std::vector<std::string> outside_bound;  ///< each with the pose's number
  GroupFigures settled;                    ///< poses with a force whose decisions are those of the exact problem
  GroupFigures flipped;                    ///< poses with a force of which the bound says that they may be others
};

/// Everything at one point from its poses' figures.
PointFigures figures_of(const SweepPoint& point, Scheme scheme, const std::vector<PoseFigures>& poses);

struct StabilityReport {
  std::uint64_t seed = 0;
  std::int64_t poses = 0;  ///< at each point
  std::vector<PointFigures> points;

  /// Nothing outside its bound, nothing without a finite answer.
  bool met() const;
};

inline constexpr std::array kSchemes = {Scheme::barycentric, Scheme::clipped};

/// Pose i is drawn from the same random numbers at every point of a sweep. The same bits on any number of threads;
/// `progress` is told what comes next. Points that are kept are not worked out again.
StabilityReport run_stability(Extent extent, std::uint64_t seed, int jobs, KeptValues& kept,
                              const std::function<void(const std::string&)>& progress,
                              const AskEngine& ask = ask_engine);

/// One point in both schemes.
std::vector<PointFigures> figures_at_point(const SweepPoint& point, std::int64_t poses, std::uint64_t seed,
                                           const AskEngine& ask, KeptValues& kept);

/// Whether error over condition stays what it is along a sweep: over the points that have settled poses.
struct Flatness {
  Sweep sweep = Sweep::offset;
  Scheme scheme = Scheme::barycentric;
  Quantity quantity = Quantity::force;
  double least_condition = 0, greatest_condition = 0;  ///< medians of the points
  double least = 0, greatest = 0;                      ///< of error over condition, medians of the points
  double greatest_of_all = 0;                          ///< of error over condition, of any pose
  double least_bound = 0, greatest_bound = 0;          ///< of bound over condition, medians; 0 of the area
};
/// The area is told of with the clipped scheme only, for it is the same in both.
std::vector<Flatness> flatness(const StabilityReport& report);
/// Whether the table of a scheme tells of the quantity.
bool told(Scheme scheme, Quantity quantity);

}  // namespace pcm::compare::stability
