// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/moving_line.h"

#include <cmath>

namespace pcm::compare {
namespace {

/// Two lines that diverge by no more than this part of what they are off are one line to a right engine, which finds no
/// place where they cross. The verdict's own number.
constexpr double kParallel = 1.0 / 16;

}  // namespace

std::optional<NearStretch> stretch_near(const MovingLine& on, const MovingLine& other, double near) {
  if (!(other.borders.first <= other.borders.last)) return std::nullopt;
  NearStretch stretch{{0, on.length}};
  const auto limit = [&](double first, double last) {
    stretch.first = std::max(stretch.first, first);
    stretch.last = std::min(stretch.last, last);
  };
  const auto beside = [&](double way) { return on.along.dot(other.from + way * other.along - on.from); };
  const double one_end = beside(other.borders.first), other_end = beside(other.borders.last);
  limit(std::min(one_end, other_end) - near, std::max(one_end, other_end) + near);
  limit(on.borders.first - near, on.borders.last + near);
  const Eigen::Vector2d normal(-other.along.y(), other.along.x());
  const double height = normal.dot(on.from - other.from), rise = normal.dot(on.along);
  stretch.side_by_side = std::abs(rise) * stretch.length() <= kParallel * (on.off + other.off);
  if (rise != 0) {
    const double at = -height / rise, way = near / std::abs(rise);
    stretch.side_by_side = stretch.side_by_side && at - way <= stretch.first && stretch.last <= at + way;
    limit(at - way, at + way);
  } else if (std::abs(height) > near) {
    return std::nullopt;
  }
  if (!(stretch.first <= stretch.last)) return std::nullopt;
  return stretch;
}

Speeds speed_difference(const MovingLine& on, const Stretch& stretch, const MovingLine& other) {
  const double sign = on.along.dot(other.along) < 0 ? -1 : 1;
  const auto at = [&](double way) -> Speeds {
    const Eigen::Vector2d x = on.from + way * on.along;
    return (on.speed_at(way) - sign * other.speed_at(other.along.dot(x - other.from))).abs();
  };
  return at(stretch.first).max(at(stretch.last));
}

SightLine::Continuation continuation_beside(const MovingLine& a, const MovingLine& b) {
  using Of = SightLine::Continuation::Of;
  const auto joins = [](const MovingLine& one, const MovingLine& other) {
    return one.continuation.of == Of::master || (one.continuation.of == Of::slave && other.surely_before);
  };
  return joins(a, b) ? a.continuation : joins(b, a) ? b.continuation : SightLine::Continuation{};
}

}  // namespace pcm::compare
