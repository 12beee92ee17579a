// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/predicates/penetration_predicates.h"

#include <cassert>
#include <cstddef>

namespace pcm::fast {

namespace {

template <class Number>
using Vector = NumberVector<Number>;

template <class Number>
Vector<Number> difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return fast::difference<Number>(a.data(), b.data());
}

// The polynomials, each written once for all number types.

/// (f1 - f0) x (f2 - f0).
template <class Number>
Vector<Number> normal(const FacePoints& f) {
  return cross(difference<Number>(f[1], f[0]), difference<Number>(f[2], f[0]));
}

/// 3 (x - C) = (x - p0) + (x - p1) + (x - p2): no division, and no error that grows with the distance from the origin.
template <class Number>
Vector<Number> three_times_from_barycentre(const PenetrationLine& line, const Eigen::Vector3d& x) {
  const FacePoints& p = line.points();
  return difference<Number>(x, p[0]) + difference<Number>(x, p[1]) + difference<Number>(x, p[2]);
}

/// 9 D(C) for an edge whose ends are given by three_times_from_barycentre.
template <class Number>
constexpr Number side(const Vector<Number>& line_normal, const Vector<Number>& from, const Vector<Number>& to) {
  return dot(line_normal, cross(from, to));
}

/// The derivative of the side test when C moves along `shift`.
template <class Number>
constexpr Number shifted_side(const Vector<Number>& line_normal, const Vector<Number>& edge,
                              const Vector<Number>& shift) {
  return dot(edge, cross(line_normal, shift));
}

/// A quotient num / den, and the numerator of the difference of two.
template <class Number>
struct Quotient {
  Number numerator, denominator;
};

template <class Number>
constexpr Number numerator_of_difference(const Quotient<Number>& a, const Quotient<Number>& b) {
  return a.numerator * b.denominator - b.numerator * a.denominator;
}

/// -3 q_f.
template <class Number>
Quotient<Number> minus_three_distances(const PenetrationLine& line, const Vector<Number>& line_normal,
                                       const FacePoints& f) {
  const Vector<Number> face_normal = normal<Number>(f);
  return {dot(three_times_from_barycentre<Number>(line, f[0]), face_normal), dot(line_normal, face_normal)};
}

/// The derivative of q_f when C moves along `shift`.
template <class Number>
Quotient<Number> shifted_distance(const Vector<Number>& line_normal, const Vector<Number>& shift, const FacePoints& f) {
  const Vector<Number> face_normal = normal<Number>(f);
  return {dot(shift, face_normal), dot(line_normal, face_normal)};
}

// How many roundings a term of each polynomial suffers.

constexpr Vector<RoundingCount> kRoundedNormal = cross(kRoundedDifference, kRoundedDifference);
constexpr Vector<RoundingCount> kRoundedFromBarycentre = kRoundedDifference + kRoundedDifference + kRoundedDifference;
constexpr RoundingCount kRoundedFacing = dot(kRoundedNormal, kRoundedNormal);
constexpr RoundingCount kRoundedSide = side(kRoundedNormal, kRoundedFromBarycentre, kRoundedFromBarycentre);
constexpr RoundingCount kRoundedShiftedSide = shifted_side(kRoundedNormal, kRoundedDifference, kRoundedDifference);
constexpr Quotient<RoundingCount> kRoundedDistance{dot(kRoundedFromBarycentre, kRoundedNormal), kRoundedFacing};
constexpr Quotient<RoundingCount> kRoundedShiftedDistance{dot(kRoundedDifference, kRoundedNormal), kRoundedFacing};
constexpr RoundingCount kRoundedOrder = numerator_of_difference(kRoundedDistance, kRoundedDistance);
constexpr RoundingCount kRoundedShiftedOrder =
    numerator_of_difference(kRoundedShiftedDistance, kRoundedShiftedDistance);

// The stages.

/// The sign of `polynomial`, a generic callable that takes a number type: by the filter, else exactly.
template <int Roundings, class Polynomial>
int sign_of(const Polynomial& polynomial, WorkCounters& work) {
  ++work.predicates;
  const int sign = sure_sign<Roundings>(polynomial.template operator()<Bounded>());
  if (sign != 0) return sign;
  ++work.exact_predicates;
  return polynomial.template operator()<Dyadic>().sign();
}

/// The master face's normal in the wanted number type.
template <class Number>
Vector<Number> line_normal(const PenetrationLine& line) {
  return normal<Number>(line.points());
}
template <>
Vector<Bounded> line_normal<Bounded>(const PenetrationLine& line) {
  return line.approximate_normal();
}

/// The directions C is shifted in, the greater shift first.
template <class Number>
Vector<Number> shift(const PenetrationLine& line, std::size_t order) {
  return difference<Number>(line.points()[order], line.points()[0]);
}

}  // namespace

PenetrationLine::PenetrationLine(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& p2)
    : points_{p0, p1, p2}, normal_(normal<Bounded>(points_)) {}

int facing(const PenetrationLine& line, const FacePoints& f, WorkCounters& work) {
  return sign_of<kRoundedFacing.count>(
      [&]<class Number>() { return dot(line_normal<Number>(line), normal<Number>(f)); }, work);
}

int side_sign(const PenetrationLine& line, const Eigen::Vector3d& from, const Eigen::Vector3d& to, WorkCounters& work) {
  int sign = sign_of<kRoundedSide.count>(
      [&]<class Number>() {
        return side(line_normal<Number>(line), three_times_from_barycentre<Number>(line, from),
                    three_times_from_barycentre<Number>(line, to));
      },
      work);
  if (sign != 0) return sign;
  ++work.tie_breaks;
  for (std::size_t order = 1; order <= 2 && sign == 0; ++order) {
    sign = sign_of<kRoundedShiftedSide.count>(
        [&]<class Number>() {
          return shifted_side(line_normal<Number>(line), difference<Number>(from, to), shift<Number>(line, order));
        },
        work);
  }
  return sign;
}

bool passes_through(const PenetrationLine& line, const FacePoints& f, WorkCounters& work) {
  const int sign = side_sign(line, f[0], f[1], work);
  return sign != 0 && side_sign(line, f[1], f[2], work) == sign && side_sign(line, f[2], f[0], work) == sign;
}

int distance_sign(const PenetrationLine& line, const FacePoints& f, WorkCounters& work) {
  const int numerator = sign_of<kRoundedDistance.numerator.count>(
      [&]<class Number>() { return dot(three_times_from_barycentre<Number>(line, f[0]), normal<Number>(f)); }, work);
  return numerator == 0 ? 0 : -numerator * facing(line, f, work);
}

int compare_distance(const PenetrationLine& line, const FacePoints& f, const FacePoints& g, WorkCounters& work) {
  const int denominators = facing(line, f, work) * facing(line, g, work);
  assert(denominators != 0);
  // q_f - q_g has the sign of numerator_of_difference(-3 q_g, -3 q_f) times that of the product of the denominators.
  int sign = sign_of<kRoundedOrder.count>(
      [&]<class Number>() {
        const Vector<Number> n = line_normal<Number>(line);
        return numerator_of_difference(minus_three_distances(line, n, g), minus_three_distances(line, n, f));
      },
      work);
  if (sign != 0) return sign * denominators;
  ++work.tie_breaks;
  for (std::size_t order = 1; order <= 2 && sign == 0; ++order) {
    sign = sign_of<kRoundedShiftedOrder.count>(
        [&]<class Number>() {
          const Vector<Number> n = line_normal<Number>(line);
          const Vector<Number> s = shift<Number>(line, order);
          return numerator_of_difference(shifted_distance(n, s, f), shifted_distance(n, s, g));
        },
        work);
  }
  return sign * denominators;
}

int side_of_prism(const FacePoints& master, std::size_t k, const Eigen::Vector3d& x, WorkCounters& work) {
  constexpr RoundingCount kRoundedSideOfPrism = dot(kRoundedNormal, cross(kRoundedDifference, kRoundedDifference));
  const std::size_t next = (k + 1) % 3;
  return sign_of<kRoundedSideOfPrism.count>(
      [&]<class Number>() {
        return dot(normal<Number>(master),
                   cross(difference<Number>(master[next], master[k]), difference<Number>(x, master[k])));
      },
      work);
}

}  // namespace pcm::fast
