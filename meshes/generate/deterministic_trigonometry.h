// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// Sines and cosines with the same bits on every machine.
///
/// The standard library's are not correctly rounded everywhere, so a mesh made with them would differ from machine to
/// machine. These use only + - * / and std::fma, which IEEE 754 rounds correctly: the angle is reduced exactly to an
/// octant, then a Taylor series in double-double (about 106 bits) is rounded to double. The results are within
/// 0.5001 ulp of the true values; 0, 1 and -1 come out exactly where they are the true values, and angles that are
/// mirror images in the axes or the diagonals give mirror images bit for bit. Zeros are positive zeros.
/// Cost: about a microsecond a call.
namespace pcm {

/// A point of the unit circle.
struct CosineSine {
  double cosine = 1;
  double sine = 0;
};

/// Of the angle 2 pi numerator / denominator. Precondition: denominator >= 1, both below 2^53 in magnitude.
CosineSine cosine_sine_of_turn(std::int64_t numerator, std::int64_t denominator);

/// Of a finite angle in degrees, reduced exactly.
CosineSine cosine_sine_of_degrees(double degrees);

/// Of an angle in radians of magnitude below 1000; close to a zero of the sine or cosine other than 0 the error is
/// 2^-96 in absolute terms.
CosineSine cosine_sine_of_radians(double radians);

}  // namespace pcm
