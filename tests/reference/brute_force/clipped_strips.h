// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "pcm/triangle_mesh.h"
#include "tests/reference/brute_force/rational.h"

/// A map of the triangle s, t >= 0, s + t <= 1, drawn by asking points: between the abscissae at which anything may
/// happen the boundaries lie in one order, so the answer is constant between neighbouring boundaries.
namespace pcm::brute_force {

/// The function at_origin + along_s s + along_t t.
struct Linear {
  Rational at_origin;
  Rational along_s;
  Rational along_t;

  Rational at(const Rational& s, const Rational& t) const { return at_origin + along_s * s + along_t * t; }
};

Linear operator-(const Linear& a, const Linear& b);

/// The answer may change where `zero` is 0 and none of `limits` is negative.
struct Boundary {
  Linear zero;
  std::vector<Linear> limits;
};

/// The line t = slope s + offset.
struct Line {
  Rational slope;
  Rational offset;

  Rational at(const Rational& s) const { return slope * s + offset; }
  friend bool operator==(const Line&, const Line&) = default;
};

/// A trapezoid of the map, on which the answer is one.
struct Strip {
  Line lower;
  Line upper;
  Index answer = 0;
  Rational from;  ///< abscissae
  Rational to;
};

/// The answer at a point (s, t).
using Question = std::function<std::optional<Index>(const Rational& s, const Rational& t)>;

/// The parts of the triangle where there is an answer, cut into trapezoids; `question` is asked at points that are on
/// no boundary. Strips are as high and as long as their answer, so that the numbers in them are those of the map's own
/// corners. Cost: that of `question` times the cube of the number of boundaries, at worst.
std::vector<Strip> strips_of(const std::vector<Boundary>& boundaries, const Question& question);

}  // namespace pcm::brute_force
