// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>

#include "compare/verify/bounds/master_view.h"

namespace pcm::compare {

/// By r and a turn of F about Mf, per coordinate.
using Speeds = Eigen::Array<double, 1, 6>;

/// From here to there along a line, m.
struct Stretch {
  double first, last;
};

/// Where a line is near to another one.
struct NearStretch : Stretch {
  bool side_by_side = false;  ///< all along, of what both have side by side; else they cross or diverge

  double length() const { return last - first; }
};

/// A line of sight and how fast it moves along its normal.
struct MovingLine {
  Eigen::Vector2d from, along;  ///< m, and of length 1
  double length, off;
  Stretch borders;               ///< where faces may end on it or meet
  std::array<Speeds, 2> speeds;  ///< at its ends
  double speed_error;            ///< for a motion of 1, m
  Speeds any_way;                ///< greatest speeds of a point of it in any direction, times its pull
  std::array<double, 2> depths;  ///< of the slave face, m
  SightLine::Continuation continuation;
  bool surely_before;

  Speeds speed_at(double at) const {
    const double share = length > 0 ? at / length : 0;
    return (1 - share) * speeds[0] + share * speeds[1];
  }
  double depth_at(double at) const {
    const double share = length > 0 ? at / length : 0;
    return std::max((1 - share) * depths[0] + share * depths[1], 0.0);
  }
  double deepest(const Stretch& stretch) const { return std::max(depth_at(stretch.first), depth_at(stretch.last)); }
  Speeds greatest_speed() const { return speeds[0].abs().max(speeds[1].abs()) + speed_error; }
};

/// Where a line is no farther than that from another one, and both may be a border.
std::optional<NearStretch> stretch_near(const MovingLine& on, const MovingLine& other, double near);

/// Of the speeds to one side, of points of two lines side by side.
Speeds speed_difference(const MovingLine& on, const Stretch& stretch, const MovingLine& other);

/// What goes on beyond one of two lines side by side, where the other one is a border beyond it as before it; or
/// nothing. Where that is the slave's sheet, lines that lie on it move otherwise beyond, where it has another slope.
SightLine::Continuation continuation_beside(const MovingLine& a, const MovingLine& b);

}  // namespace pcm::compare
