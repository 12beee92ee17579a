// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fast/bounds/face_enclosure.h"
#include "fast/posed/vertex_rounding.h"
#include "fast/prism/convex_polygon.h"

namespace pcm::fast {

/// A convex piece of the master is the outcome of no more cuts than that.
inline constexpr int kMostPieceCuts = 60;
/// What a piece may lack in s and in t. A cut puts a vertex off the line between its neighbours by u times what these
/// are apart, and u times itself: by no more than 2.1 u over the master, where both are at most 1; the centre of up to
/// twelve points is off by 13 u. All that is said of a piece holds as far beyond its border.
inline constexpr double kLostByCuts = 144 * kUnitRoundoff;
static_assert((2.1 * kMostPieceCuts + 13) * kUnitRoundoff <= kLostByCuts);

/// The sign of a linear function over a piece.
enum class Sign : std::uint8_t { negative, unsure, positive };

struct Range {
  double low, high;
};

/// A linear function c_s (s - s_0) + c_t (t - t_0) + value, that is off by no more than `error` over the master.
class UncertainFunction {
 public:
  UncertainFunction(double c_s, double s_0, double c_t, double t_0, double value, double error)
      : c_s_(c_s),
        s_0_(s_0),
        c_t_(c_t),
        t_0_(t_0),
        value_(value),
        lost_((std::abs(c_s) + std::abs(c_t)) * kLostByCuts),
        // Two differences, two products and two sums, and what made the value and the gradients.
        rounding_(8 * kUnitRoundoff *
                  (std::abs(c_s) * (1 + std::abs(s_0)) + std::abs(c_t) * (1 + std::abs(t_0)) + std::abs(value))),
        error_(kSafetyFactor * error + lost_ + rounding_) {}
  explicit UncertainFunction(const LinearDepth& depth, double error)
      : UncertainFunction(depth.per_s, depth.s_0, depth.per_t, depth.t_0, depth.value, error) {}

  double operator()(const PrismPoint& x) const { return c_s_ * (x[kS] - s_0_) + c_t_ * (x[kT] - t_0_) + value_; }
  Range over(const ConvexPolygon& piece) const {
    Range range{(*this)(piece[0]), (*this)(piece[0])};
    for (int i = 1; i < piece.count; ++i) {
      const double value = (*this)(piece[i]);
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
    return range;
  }
  Sign sign(const Range& range) const {
    return range.low > error_ ? Sign::positive : range.high < -error_ ? Sign::negative : Sign::unsure;
  }
  Sign sign_over(const ConvexPolygon& piece) const { return sign(over(piece)); }
  Sign sign_at(const PrismPoint& x) const { return sign({(*this)(x), (*this)(x)}); }
  /// No value over the piece is greater.
  double greatest_over(const ConvexPolygon& piece) const { return over(piece).high + error_; }

  /// Within that the sign is left open where a piece is parted: what lies beyond is sure then.
  double parted_at() const { return error_ + lost_; }
  /// The part where it is left open goes as far: the function is computed anew at each vertex, so that parts which end
  /// at the same value would leave a gap between them.
  double open_until() const { return parted_at() + 2 * rounding_; }
  /// Whether parting the piece makes the sign sure on some of it, which is more than what roundings make of a piece
  /// that was parted there.
  bool parts(const ConvexPolygon& piece) const {
    const Range range = over(piece);
    const double most = open_until() + 2 * rounding_ + lost_;
    return sign(range) == Sign::unsure && (range.high > most || range.low < -most);
  }

 private:
  double c_s_, s_0_, c_t_, t_0_, value_, lost_, rounding_, error_;
};

/// Cuts away where `sign` times the function is less than `level`.
inline void keep_above(ConvexPolygon& polygon, const UncertainFunction& function, double sign, double level) {
  if (polygon.count == 0) return;
  Heights heights{};
  for (int i = 0; i < polygon.count; ++i) heights[static_cast<std::size_t>(i)] = sign * function(polygon[i]) - level;
  keep_where_not_negative(polygon, heights);
}

}  // namespace pcm::fast
