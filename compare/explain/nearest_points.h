// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "reference/numbers/numbers.h"
#include "reference/numbers/vector3.h"

/// Distances between features in exact arithmetic. Each function answers where the nearest points of the lines or
/// planes of its features lie inside both of them, and nothing elsewhere: then parts of these features are nearer.
namespace pcm::compare {

using ExactPoint = reference::Vec3<reference::Exact>;
using ExactSegment = std::array<ExactPoint, 2>;
using ExactTriangle = std::array<ExactPoint, 3>;

struct NearestPoints {
  reference::Exact squared_numerator;    ///< of the squared distance
  reference::Exact squared_denominator;  ///< positive
  /// Along the way from the first feature to the second, of any length; where they meet the direction in which they
  /// part soonest, zero where that is no single one.
  ExactPoint apart;
  /// How far the nearest point of a first feature that is no vertex lies along it, in units of the segment or of the
  /// ray's direction.
  reference::Exact place_numerator = 0;
  reference::Exact place_denominator = 1;

  /// Whether the distance is at most `width`.
  bool within(const reference::Exact& width) const;
  /// Correctly rounded; 0 only where it is 0.
  double distance() const;
  /// `apart`, rounded, of length 1; zero where that is.
  Eigen::Vector3d unit_apart() const;
  /// Rounded.
  double place() const;
};

NearestPoints nearest_points(const ExactPoint& x, const ExactPoint& y);
std::optional<NearestPoints> nearest_points(const ExactPoint& x, const ExactSegment& edge);
std::optional<NearestPoints> nearest_points(const ExactPoint& x, const ExactTriangle& face);
/// Nothing for parallel edges.
std::optional<NearestPoints> nearest_points(const ExactSegment& first, const ExactSegment& second);

/// The ray from `origin` along `direction`, its origin included.
struct ExactRay {
  ExactPoint origin, direction;
};
std::optional<NearestPoints> nearest_points(const ExactRay& ray, const ExactPoint& x);
std::optional<NearestPoints> nearest_points(const ExactRay& ray, const ExactSegment& edge);

}  // namespace pcm::compare
