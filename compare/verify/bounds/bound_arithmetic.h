// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What bounds on rounding errors are worked out with.
namespace pcm::compare {

/// Unit roundoff: |fl(x op y) - (x op y)| <= kRoundoff |x op y|.
inline constexpr double kRoundoff = 0x1p-53;
/// As error analysis writes it: for a using-declaration in files that consist of such formulas.
namespace roundoff {
inline constexpr double u = kRoundoff;
}  // namespace roundoff

/// Terms of second order in the unit roundoff, and the rounding of the bounds themselves, are covered by doubling.
inline constexpr double kHigherOrder = 2;

/// More than any number of underflows in one operation, or in the few of one formula, make.
inline constexpr double kUnderflow = 0x1p-1060;

/// The value, and no more than `most`; that as well where the value is no number.
inline double no_more(double value, double most) {
  return value <= most ? value : most;
}

/// a b for bounds, of which one may be infinite where the other is exactly 0: nothing, however often, is nothing.
template <class A, class B>
auto times(A a, B b) -> decltype(a * b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

}  // namespace pcm::compare
