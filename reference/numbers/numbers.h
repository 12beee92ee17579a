// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

/// The kinds of numbers of the oracle. A double is turned into any of them without loss by Field.
namespace pcm::reference {

/// Sums and products of doubles, exactly: binary floating point of any length. No division.
using Exact = CGAL::Mpzf;
/// Exact with division.
using Rational = CGAL::Gmpq;
/// Encloses the true value; used under CGAL::Protect_FPU_rounding only. A filter: decides most signs cheaply.
using Interval = CGAL::Interval_nt<false>;

/// Makes numbers of kind T out of doubles, without loss. Kinds with a precision carry it here.
template <class T>
struct Field {
  T operator()(double x) const { return T(x); }
};

template <>
struct Field<Rational> {
  Rational operator()(double x) const { return Rational(x); }
  Rational operator()(const Rational& x) const { return x; }
};

/// A double near a number, and how far from it at most; infinitely where nothing is known.
struct NearDouble {
  double value;
  double error;
};

/// -1, 0 or 1.
inline int sign_of(const Exact& x) {
  return static_cast<int>(x.sign());
}
inline int sign_of(const Rational& x) {
  return static_cast<int>(CGAL::sign(x));
}

/// -1 or 1 where the interval lies on one side of zero; 0 where it does not tell (also for overflowed intervals).
inline int certain_sign(const Interval& x) {
  return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0;
}

}  // namespace pcm::reference
