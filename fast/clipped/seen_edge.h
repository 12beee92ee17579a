// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// Places along a line, from the first to the last; none where the first is not before the last.
struct Places {
  double first, last;

  /// Those at which a function is not negative that is linear and has these values at places 0 and 1.
  Places where_not_negative(double at_0, double at_1) const {
    const double rise = at_1 - at_0, zero = -at_0 / rise;
    if (rise > 0) return {std::max(first, zero), last};
    if (rise < 0) return {first, std::min(last, zero)};
    return at_0 >= 0 ? *this : Places{0, 0};
  }
};

/// Depths that differ by no more than this part of the greatest count as one: their roundings are kHeightError of it.
inline constexpr double kLevel = 0x1p-30;

/// A face's edge as it is seen, and the depths of points on its line. Far beyond its ends the line parts nothing but
/// pieces of what is seen, and any motion will do that both get: there the depth is that as far from the edge as it is
/// long, or it would be beyond all measure for an edge that is seen on end.
class SeenEdge {
 public:
  SeenEdge(const ProjectedFace& h, std::size_t edge)
      : from_(h.corners[edge]),
        along_(h.corners[(edge + 1) % 3] - from_),
        wider_(std::abs(along_[kS]) >= std::abs(along_[kT]) ? kS : kT) {}

  /// 0 and 1 at the edge's ends.
  double place(const PrismPoint& at) const { return (at[wider_] - from_[wider_]) / along_[wider_]; }
  double depth(double place) const { return from_[kDepth] + std::clamp(place, kFirst, kLast) * along_[kDepth]; }

  /// Where the edge lies not above the master.
  Places beneath_master() const {
    return Places{0, 1}.where_not_negative(from_[kDepth], from_[kDepth] + along_[kDepth]);
  }
  /// There and before f. a and b: points of f on the edge's line, in two places.
  Places before(const PrismPoint& a, const PrismPoint& b) const {
    const double place_a = place(a), per_place = (b[kDepth] - a[kDepth]) / (place(b) - place_a);
    const double f_at_0 = a[kDepth] - place_a * per_place;
    return beneath_master().where_not_negative(f_at_0 - from_[kDepth],
                                               f_at_0 + per_place - (from_[kDepth] + along_[kDepth]));
  }

  /// How the edge's line lies to f and to the master from a to b, points of f on it.
  enum class Standing : std::uint8_t {
    before,  ///< within the edge's ends, before f and not above the master
    level,   ///< on f, or on the master, as far as roundings can tell and farther
    partly   ///< before f somewhere, or nowhere
  };
  Standing standing(const PrismPoint& a, double place_a, const PrismPoint& b, double place_b) const {
    const double depth_a = depth(place_a), depth_b = depth(place_b);
    const double lead_a = a[kDepth] - depth_a, lead_b = b[kDepth] - depth_b;
    const double level = kLevel * std::max(std::abs(a[kDepth]), std::abs(b[kDepth]));
    if (std::max(std::abs(lead_a), std::abs(lead_b)) <= level ||
        std::max(std::abs(depth_a), std::abs(depth_b)) <= level)
      return Standing::level;
    const bool between = std::min(place_a, place_b) >= 0 && std::max(place_a, place_b) <= 1;
    return between && std::min({lead_a, lead_b, depth_a, depth_b}) >= 0 ? Standing::before : Standing::partly;
  }

  /// Where the depth is not linear.
  static constexpr double kFirst = -1, kLast = 2;

 private:
  const PrismPoint& from_;
  PrismPoint along_;
  int wider_;
};

}  // namespace pcm::fast
