// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/predicates/orientation.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <utility>

#include "fast/base/bounded.h"
#include "fast/base/number_vector.h"
#include "meshes/exact/dyadic.h"

namespace pcm::fast {

namespace {

static_assert(dot(cross(kRoundedDifference, kRoundedDifference), kRoundedDifference).count == 8,
              "the filter's bound is for eight roundings");
static_assert(kFilterUnderflow == Bounded::kUnderflow);

constexpr std::size_t kX = 0, kY = 1, kZ = 2;
constexpr std::size_t kNone = 4;

/// A coefficient of the perturbed determinant: `sign` times the minor of rows `rows` and columns (1, `columns`).
/// Three rows and two columns are the orientation of three points in a coordinate plane, two rows and one column a
/// difference of coordinates, one row and no column the constant 1.
struct Minor {
  int sign;
  std::array<std::size_t, 3> rows;
  std::array<std::size_t, 2> columns;
};

/// The table of minors. With the points in the order of their ranks as rows v1, ..., v4,
///     ((v2 - v1) x (v3 - v1)) . (v4 - v1) = det [1 x y z],
/// a polynomial of degree one in each coordinate. Moving coordinates v1z, v1y, v1x, v2z, ... by eps^1, eps^2, eps^4,
/// eps^8, ... (any ranks of the same order give the same order of powers) adds for each set of moved coordinates in
/// different rows and columns the product of their powers of eps times the complementary minor, with the sign of the
/// permutation. The table lists them by increasing power; the first that is not zero decides, and the last is a
/// constant. Left out, as they can never decide: v2y v1z, v2x v1z and v2x v1y repeat minors listed before them, and v2x
/// would come after v3 and v4 were found to coincide.
constexpr std::array<Minor, 13> kMinors{{
    {-1, {1, 2, 3}, {kX, kY}},                // v1z
    {+1, {1, 2, 3}, {kX, kZ}},                // v1y
    {-1, {1, 2, 3}, {kY, kZ}},                // v1x
    {+1, {0, 2, 3}, {kX, kY}},                // v2z
    {+1, {2, 3, kNone}, {kX, kNone}},         // v2z v1y
    {-1, {2, 3, kNone}, {kY, kNone}},         // v2z v1x
    {-1, {0, 2, 3}, {kX, kZ}},                // v2y
    {+1, {2, 3, kNone}, {kZ, kNone}},         // v2y v1x
    {-1, {0, 1, 3}, {kX, kY}},                // v3z
    {-1, {1, 3, kNone}, {kX, kNone}},         // v3z v1y
    {+1, {1, 3, kNone}, {kY, kNone}},         // v3z v1x
    {+1, {0, 3, kNone}, {kX, kNone}},         // v3z v2y
    {-1, {3, kNone, kNone}, {kNone, kNone}},  // v3z v2y v1x
}};

int exact_orientation_in_plane(const double* a, const double* b, const double* c, std::size_t u, std::size_t v) {
  const Dyadic left = difference<Dyadic>(b[u], a[u]) * difference<Dyadic>(c[v], a[v]);
  const Dyadic right = difference<Dyadic>(b[v], a[v]) * difference<Dyadic>(c[u], a[u]);
  return sign_of_difference(left, right);
}

int sign_of_minor(const Minor& minor, const std::array<RankedPoint, 4>& v) {
  const auto [i, j, k] = minor.rows;
  const auto [column, second_column] = minor.columns;
  if (j == kNone) return 1;
  const double* const a = v[i].x_Me;
  const double* const b = v[j].x_Me;
  if (k == kNone) return (b[column] > a[column]) - (b[column] < a[column]);
  return exact_orientation_in_plane(a, b, v[k].x_Me, column, second_column);
}

}  // namespace

int exact_orientation(const double* a, const double* b, const double* c, const double* d) {
  const auto ab = difference<Dyadic>(b, a);
  const auto ac = difference<Dyadic>(c, a);
  const auto ad = difference<Dyadic>(d, a);
  return dot(cross(ab, ac), ad).sign();
}

int tie_rule_orientation(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, const RankedPoint& d) {
  // Sort by rank, with the parity of the permutation: swapping two points negates the determinant.
  std::array<RankedPoint, 4> v{a, b, c, d};
  int parity = 1;
  for (std::size_t last = 3; last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i) {
      assert(v[i].rank != v[i + 1].rank);
      if (v[i].rank > v[i + 1].rank) {
        std::swap(v[i], v[i + 1]);
        parity = -parity;
      }
    }
  }
  int sign = 0;
  for (const Minor& minor : kMinors) {
    sign = minor.sign * sign_of_minor(minor, v);
    if (sign != 0) break;
  }
  return parity * sign;
}

int unfiltered_orientation(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, const RankedPoint& d,
                           WorkCounters& work) {
  ++work.exact_predicates;
  const int sign = exact_orientation(a.x_Me, b.x_Me, c.x_Me, d.x_Me);
  if (sign != 0) return sign;
  ++work.tie_breaks;
  return tie_rule_orientation(a, b, c, d);
}

}  // namespace pcm::fast
