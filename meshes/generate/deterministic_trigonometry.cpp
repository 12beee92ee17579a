// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/deterministic_trigonometry.h"

#include <cassert>
#include <cmath>

namespace pcm {
namespace {

/// The unevaluated sum high + low, |low| <= ulp(high) / 2.
struct DoubleDouble {
  double high = 0;
  double low = 0;
};

/// pi / 4 to 107 bits: the two leading doubles of its expansion.
constexpr DoubleDouble kEighthTurn{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};

/// Exact sum of two doubles (Knuth).
DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// Exact sum of two doubles with |a| >= |b| or a = 0 (Dekker).
DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble sum = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(sum.high, sum.low + low.low);
}

DoubleDouble operator-(DoubleDouble a) {
  return {-a.high, -a.low};
}

DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const double product = a.high * b.high;
  const double error = std::fma(a.high, b.high, -product);
  return fast_two_sum(product, error + (a.high * b.low + a.low * b.high));
}

DoubleDouble operator/(DoubleDouble a, double b) {
  const double quotient = a.high / b;
  const double remainder = std::fma(-quotient, b, a.high) + a.low;
  return fast_two_sum(quotient, remainder / b);
}

/// first * (1 - x^2 / (k + 1)(k + 2) + x^4 / (k + 1)(k + 2)(k + 3)(k + 4) - ...): the sine for first = x, k = 1, the
/// cosine for first = 1, k = 0. For 0 <= x <= pi / 4 the first term left out is below 2^-106 of the sum.
DoubleDouble alternating_series(DoubleDouble first, int k, DoubleDouble x) {
  constexpr int kTerms = 14;
  const DoubleDouble x_squared = x * x;
  DoubleDouble term = first;
  DoubleDouble sum = first;
  for (int i = 0; i < kTerms; ++i, k += 2) {
    term = -(term * x_squared) / static_cast<double>((k + 1) * (k + 2));
    sum = sum + term;
  }
  return sum;
}

/// Of octant * 45 degrees + angle, where angle and its complement to 45 degrees lie between 0 and pi / 4 radians.
/// An odd octant is measured back from the next axis, so that mirror images have the same angle.
CosineSine in_octant(std::int64_t octant, DoubleDouble angle, DoubleDouble complement) {
  const DoubleDouble x = octant % 2 == 0 ? angle : complement;
  const double c = alternating_series({1, 0}, 0, x).high;
  const double s = alternating_series(x, 1, x).high;
  CosineSine result;
  switch (octant) {
    case 0:
      result = {c, s};
      break;
    case 1:
      result = {s, c};
      break;
    case 2:
      result = {-s, c};
      break;
    case 3:
      result = {-c, s};
      break;
    case 4:
      result = {-c, -s};
      break;
    case 5:
      result = {-s, -c};
      break;
    case 6:
      result = {s, -c};
      break;
    default:
      result = {c, -s};
      break;
  }
  return {result.cosine + 0.0, result.sine + 0.0};  // Turns -0 into +0.
}

CosineSine mirrored(CosineSine value) {
  return {value.cosine, 0.0 - value.sine};
}

}  // namespace

CosineSine cosine_sine_of_turn(std::int64_t numerator, std::int64_t denominator) {
  assert(denominator >= 1);
  const std::int64_t part = (numerator % denominator + denominator) % denominator;
  const std::int64_t octant = 8 * part / denominator;
  const std::int64_t remainder = 8 * part - octant * denominator;
  const auto fraction_of_octant = [denominator](std::int64_t count) {
    return kEighthTurn * DoubleDouble{static_cast<double>(count), 0} / static_cast<double>(denominator);
  };
  return in_octant(octant, fraction_of_octant(remainder), fraction_of_octant(denominator - remainder));
}

CosineSine cosine_sine_of_degrees(double degrees) {
  assert(std::isfinite(degrees));
  if (degrees < 0) return mirrored(cosine_sine_of_degrees(-degrees));
  const double part = std::fmod(degrees, 360.0);  // exact
  double octant = std::floor(part / 45.0);
  if (octant * 45.0 > part) octant -= 1;          // The quotient may have been rounded up to an integer.
  const double remainder = part - octant * 45.0;  // exact, by Sterbenz's lemma
  return in_octant(static_cast<std::int64_t>(octant), kEighthTurn * DoubleDouble{remainder, 0} / 45.0,
                   kEighthTurn * two_sum(45.0, -remainder) / 45.0);
}

CosineSine cosine_sine_of_radians(double radians) {
  assert(std::fabs(radians) < 1000);
  if (radians < 0) return mirrored(cosine_sine_of_radians(-radians));
  const double octants = std::floor(radians / kEighthTurn.high);
  const DoubleDouble angle = DoubleDouble{radians, 0} + -(kEighthTurn * DoubleDouble{octants, 0});
  return in_octant(static_cast<std::int64_t>(octants) % 8, angle, kEighthTurn + -angle);
}

}  // namespace pcm
