// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/exact/dyadic.h"

/// Three-vectors over any number type with + - *, so that a predicate's polynomial is written once and evaluated in
/// floating point with an error bound, exactly, and (at compile time) to count its roundings.
namespace pcm::fast {

template <class Number>
struct NumberVector {
  Number x, y, z;
};

template <class Number>
constexpr NumberVector<Number> operator+(const NumberVector<Number>& a, const NumberVector<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Number>
constexpr Number dot(const NumberVector<Number>& a, const NumberVector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
constexpr NumberVector<Number> cross(const NumberVector<Number>& a, const NumberVector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The difference of two coordinates as a Number; every number type of a predicate specialises it.
template <class Number>
Number difference(double a, double b);

template <>
inline Dyadic difference<Dyadic>(double a, double b) {
  return Dyadic(a) - Dyadic(b);
}

/// The difference of two points given by their coordinates.
template <class Number>
NumberVector<Number> difference(const double* a, const double* b) {
  return {difference<Number>(a[0], b[0]), difference<Number>(a[1], b[1]), difference<Number>(a[2], b[2])};
}

}  // namespace pcm::fast
