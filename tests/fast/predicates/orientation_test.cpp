// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fast/predicates/orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/fast/exact_numbers.h"

namespace pcm::fast {
namespace {

using Points = std::array<Eigen::Vector3d, 4>;
using Ranks = std::array<int, 4>;

int orientation(const Points& p, const Ranks& ranks, WorkCounters& work) {
  return orientation({p[0].data(), ranks[0]}, {p[1].data(), ranks[1]}, {p[2].data(), ranks[2]}, {p[3].data(), ranks[3]},
                     work);
}

int filtered(const Points& p) {
  return filtered_orientation(p[0].data(), p[1].data(), p[2].data(), p[3].data());
}
int exact(const Points& p) {
  return exact_orientation(p[0].data(), p[1].data(), p[2].data(), p[3].data());
}

int exact_by_rationals(const Points& p) {
  const RationalVector a = rational(p[0]);
  return sgn(dot(cross(minus(rational(p[1]), a), minus(rational(p[2]), a)), minus(rational(p[3]), a)));
}

/// The determinant with its points moved by a tiny eps, the definition of the tie rule taken literally: coordinates
/// must be integers up to 16, ranks 1 to 4. eps = 2^-20, everything multiplied by 2^(20 * 2^11). The coefficients of
/// the polynomial in eps are below 6 * 33^3 < 2^18 and at most 34 in number, so the first non-zero one decides.
int perturbed_by_integers(const Points& p, const Ranks& ranks) {
  constexpr unsigned kStep = 20, kScale = kStep << 11;
  std::array<std::array<mpz_class, 3>, 4> x;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int exponent = 3 * ranks[i] - static_cast<int>(j + 1);
      x[i][j] =
          (mpz_class(p[i][static_cast<Eigen::Index>(j)]) << kScale) + (mpz_class(1) << (kScale - (kStep << exponent)));
    }
  }
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) x[i][j] -= x[0][j];
  }
  const auto& [a, b, c, d] = x;
  return sgn(mpz_class((b[1] * c[2] - b[2] * c[1]) * d[0] + (b[2] * c[0] - b[0] * c[2]) * d[1] +
                       (b[0] * c[1] - b[1] * c[0]) * d[2]));
}

TEST(Orientation, IsPositiveAboveThePlane) {
  WorkCounters work;
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orientation({a, b, c, {0.2, 0.2, 1}}, {1, 2, 3, 4}, work), 1);
  EXPECT_EQ(orientation({a, b, c, {0.2, 0.2, -1}}, {1, 2, 3, 4}, work), -1);
  EXPECT_EQ(work.predicates, 2);
  EXPECT_EQ(work.exact_predicates, 0);
}

/// Every one of the 24 assignments of ranks, on points of a small grid: coplanar, collinear and coinciding ones. Four
/// points in one place reach the constant at the end of the table.
TEST(Orientation, TieRuleIsTheDeterminantOfPointsMovedByTinyEps) {
  Doubles doubles(4711);
  WorkCounters work;
  for (int i = 0; i < 150; ++i) {
    const std::int64_t greatest = i % 5;  // 0: all coordinates coincide
    Points p;
    for (auto& x : p) {
      x = Doubles::point([&] { return doubles.small_integer(greatest); });
    }
    if (doubles.integer(0, 1) == 0) {
      const double level = doubles.small_integer(2);
      const auto axis = doubles.integer(0, 2);
      for (auto& x : p) x[axis] = level;
    }
    if (doubles.integer(0, 3) == 0) p[3] = p[0] + (p[1] - p[0]) * doubles.small_integer(1);
    Ranks ranks{1, 2, 3, 4};
    do {
      ASSERT_EQ(orientation(p, ranks, work), perturbed_by_integers(p, ranks)) << "configuration " << i;
    } while (std::next_permutation(ranks.begin(), ranks.end()));
  }
  EXPECT_GT(work.tie_breaks, 1500);
}

TEST(Orientation, TieRuleHoldsOnCornersOfACubeInAllOrders) {
  WorkCounters work;
  for (unsigned code = 0; code < 64; ++code) {
    Points p;
    p.fill(Eigen::Vector3d::Zero());
    for (unsigned bit = 0; bit < 6; ++bit) p[1 + bit / 3][bit % 3] = (code >> bit) & 1;
    Ranks ranks{1, 2, 3, 4};
    do {
      ASSERT_EQ(orientation(p, ranks, work), perturbed_by_integers(p, ranks)) << "code " << code;
    } while (std::next_permutation(ranks.begin(), ranks.end()));
  }
}

/// Whether the edge (x[0], x[1]) crosses the face (x[2], x[3], x[4]) (PCM section 4).
bool crosses(const std::array<Eigen::Vector3d, 5>& x, const std::array<int, 5>& ranks, WorkCounters& work) {
  const auto side = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return orientation({x[i], x[j], x[k], x[l]}, {ranks[i], ranks[j], ranks[k], ranks[l]}, work);
  };
  const int turn = side(0, 1, 2, 3);
  return side(2, 3, 4, 0) != side(2, 3, 4, 1) && side(0, 1, 3, 4) == turn && side(0, 1, 4, 2) == turn;
}

/// On lattice points of one plane, also collinear and coinciding ones. Whose vertices come first does not matter, but
/// that all of one body do: with ranks mixed, edges do cross.
TEST(Orientation, EdgeInThePlaneOfAFaceDoesNotCrossItWhenAllOfOneBodyRanksFirst) {
  Doubles doubles(15);
  WorkCounters work;
  int crossed_when_mixed = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&] { return Doubles::point([&] { return doubles.small_integer(2); }); };
    const Eigen::Vector3d u = draw(), v = draw();
    std::array<Eigen::Vector3d, 5> x;
    for (Eigen::Vector3d& point : x) point = doubles.small_integer(2) * u + doubles.small_integer(2) * v;
    ASSERT_FALSE(crosses(x, {1, 2, 3, 4, 5}, work)) << "configuration " << i;
    ASSERT_FALSE(crosses(x, {4, 5, 1, 2, 3}, work)) << "configuration " << i;
    crossed_when_mixed += crosses(x, {1, 3, 2, 4, 5}, work);
  }
  EXPECT_GT(crossed_when_mixed, 200);
}

TEST(Orientation, SwappingTwoPointsWithTheirRanksNegates) {
  Doubles doubles(12);
  WorkCounters work;
  for (int i = 0; i < 2000; ++i) {
    Points p;
    for (auto& x : p) x = Doubles::point([&] { return doubles.small_integer(1); });
    const Ranks ranks{70, 3, 1000000, 12};
    const int sign = orientation(p, ranks, work);
    ASSERT_NE(sign, 0);
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        Points q = p;
        Ranks swapped = ranks;
        std::swap(q[a], q[b]);
        std::swap(swapped[a], swapped[b]);
        EXPECT_EQ(orientation(q, swapped, work), -sign);
      }
    }
  }
}

TEST(Orientation, StagesDecideWhatTheyShould) {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  {
    SCOPED_TRACE("a generic point is the filter's");
    WorkCounters work;
    orientation({a, b, c, {0.3, 0.3, 0x1p-40}}, {1, 2, 3, 4}, work);
    EXPECT_EQ(work.exact_predicates, 0);
  }
  {
    SCOPED_TRACE("one ulp off a tilted plane needs exact arithmetic");
    WorkCounters work;
    const Eigen::Vector3d p(0.1, 0.2, 0.3), q(0.7, 0.9, 0.4), r(0.5, 0.3, 0.8);
    const Eigen::Vector3d middle = (p + q + r) / 3;
    EXPECT_NE(orientation({p, q, r, middle}, {1, 2, 3, 4}, work), 0);
    EXPECT_EQ(work.exact_predicates, 1);
    EXPECT_EQ(work.tie_breaks, 0);
  }
  {
    SCOPED_TRACE("a point in the plane is the tie rule's");
    WorkCounters work;
    EXPECT_NE(orientation({a, b, c, {0.25, 0.25, 0}}, {1, 2, 3, 4}, work), 0);
    EXPECT_EQ(work.exact_predicates, 1);
    EXPECT_EQ(work.tie_breaks, 1);
  }
  {
    SCOPED_TRACE("denormal and huge coordinates are exact arithmetic's");
    const double tiny = 0x1p-1074, huge = 0x1p1023;
    WorkCounters work;
    EXPECT_EQ(orientation({a, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}, {1, 2, 3, 4}, work), 1);
    EXPECT_EQ(orientation({a, {huge, 0, 0}, {0, huge, 0}, {0, 0, -huge}}, {1, 2, 3, 4}, work), -1);
    EXPECT_EQ(orientation({Eigen::Vector3d(-huge, 0, 0), {huge, 0, 0}, {0, huge, 0}, {0, 0, tiny}}, {1, 2, 3, 4}, work),
              1);
    EXPECT_EQ(work.exact_predicates, 3);
    EXPECT_EQ(work.tie_breaks, 0);
  }
}

/// No two of the points are farther apart along any axis.
double extent_of(const Points& p) {
  double extent = 0;
  for (const auto& x : p)
    for (const auto& y : p) extent = std::max(extent, (1 + 0x1p-50) * (x - y).cwiseAbs().maxCoeff());
  return extent;
}

/// A plane asked about its points answers as `orientation` does, with one bound for all of them and without any.
void expect_plane_right(const Points& p) {
  WorkCounters work;
  const RankedPoint a{p[0].data(), 1}, b{p[1].data(), 2}, c{p[2].data(), 3}, d{p[3].data(), 4};
  const bool above = orientation(a, b, c, d, work) > 0;
  for (const double sure : {sure_determinant(extent_of(p)), kNeverSure})
    ASSERT_EQ(OrientedPlane(a, b, c, sure).above(d, work), above) << sure;
}

/// Where the filter answers it must answer right; where it does not, how often is printed.
void expect_filter_right(const std::string& what, int count, const std::function<Points()>& draw, double ceiling) {
  int unsure = 0;
  for (int i = 0; i < count; ++i) {
    const Points p = draw();
    const int truth = exact_by_rationals(p);
    ASSERT_EQ(exact(p), truth) << what;
    const int guess = filtered(p);
    if (guess == 0)
      ++unsure;
    else
      ASSERT_EQ(guess, truth) << what;
    expect_plane_right(p);
    if (testing::Test::HasFatalFailure()) return;
  }
  std::printf("  %-40s filter unsure %6d of %d\n", what.c_str(), unsure, count);
  EXPECT_LE(unsure, ceiling * count) << what;
}

TEST(Orientation, FilterAndExactStageAgreeWithRationals) {
  Doubles doubles(99);
  const auto points = [&](auto&& coordinate) {
    Points p;
    for (auto& x : p) x = Doubles::point(coordinate);
    return p;
  };
  /// The fourth point in the plane of the others up to rounding, then moved by a few ulps.
  const auto nearly_coplanar = [&](double offset, int exponent) {
    Points p;
    const double scale = std::ldexp(1.0, exponent);
    for (auto& x : p) x = Doubles::point([&] { return (doubles.unit() + offset) * scale; });
    p[3] = p[0] + doubles.unit() * (p[1] - p[0]) + doubles.unit() * (p[2] - p[0]);
    for (Eigen::Index j = 0; j < 3; ++j) p[3][j] = doubles.nudged(p[3][j], 4);
    return p;
  };
  expect_filter_right(
      "uniform", 20000, [&] { return points([&] { return doubles.unit(); }); }, 1e-3);
  expect_filter_right(
      "uniform, 1e12 from the origin", 20000, [&] { return points([&] { return 1e12 + doubles.unit(); }); }, 0.1);
  expect_filter_right(
      "scaled by 2^-300", 20000, [&] { return points([&] { return doubles.unit() * 0x1p-300; }); }, 1e-3);
  expect_filter_right(
      "scaled by 2^300", 20000, [&] { return points([&] { return doubles.unit() * 0x1p300; }); }, 1e-3);
  expect_filter_right(
      "exponents between -300 and 300", 20000, [&] { return points([&] { return doubles.scaled(300); }); }, 1);
  expect_filter_right(
      "any bit pattern", 20000, [&] { return points([&] { return doubles.any(); }); }, 1);
  expect_filter_right(
      "ends of the range", 5000, [&] { return points([&] { return doubles.extreme(); }); }, 1);
  expect_filter_right(
      "denormals", 5000, [&] { return points([&] { return doubles.denormal(); }); }, 1);
  expect_filter_right(
      "exponents about the underflow of products", 20000,
      [&] { return points([&] { return std::ldexp(doubles.unit(), static_cast<int>(doubles.integer(-560, -300))); }); },
      1);
  expect_filter_right(
      "small integers", 20000, [&] { return points([&] { return doubles.small_integer(3); }); }, 1);
  expect_filter_right(
      "nearly coplanar", 20000, [&] { return nearly_coplanar(0, 0); }, 1);
  expect_filter_right(
      "nearly coplanar, off the origin", 20000, [&] { return nearly_coplanar(1000, 0); }, 1);
  expect_filter_right(
      "nearly coplanar, scaled by 2^-330", 20000, [&] { return nearly_coplanar(0, -330); }, 1);
}

/// What the filter compares the determinant of such points with, `d` being the distances from the first of them.
double bound_of_filter(const std::array<Eigen::Vector3d, 3>& d) {
  const auto [b, c, x] = std::array{d[0].cwiseAbs().eval(), d[1].cwiseAbs().eval(), d[2].cwiseAbs().eval()};
  const Eigen::Vector3d N(b[1] * c[2] + b[2] * c[1], b[2] * c[0] + b[0] * c[2], b[0] * c[1] + b[1] * c[0]);
  return kFilterRelative * ((N.array() + kFilterUnderflow).matrix().dot(x) + kFilterUnderflow);
}

TEST(Orientation, BoundForAllPointsOfAnExtentIsNoLessThanThatOfAny) {
  Doubles random(64);
  SCOPED_TRACE("seed 64");
  for (const double extent : {0x1p-320, 0x1p-200, 0.3, 1.0, 0x1p300}) {
    const double sure = sure_determinant(extent);
    const Eigen::Vector3d farthest = Eigen::Vector3d::Constant(extent);
    EXPECT_GE(sure, bound_of_filter({farthest, farthest, farthest}));
    EXPECT_LE(sure, (1 + 0x1p-39) * bound_of_filter({farthest, farthest, farthest}));
    for (int i = 0; i < 200; ++i) {
      std::array<Eigen::Vector3d, 3> d;
      for (Eigen::Vector3d& to : d) to = extent * Doubles::point([&] { return random.unit(); });
      EXPECT_GE(sure, bound_of_filter(d));
    }
  }
}

TEST(Orientation, ResultsDoNotChangeUnderScalingByPowersOfTwo) {
  Doubles doubles(31);
  WorkCounters work;
  for (int i = 0; i < 3000; ++i) {
    Points p;
    for (auto& x : p) x = Doubles::point([&] { return i % 2 == 0 ? doubles.small_integer(2) : doubles.unit(); });
    p[3] = p[0] + 0.5 * (p[1] - p[0]) + 0.25 * (p[2] - p[0]);
    const int sign = orientation(p, {4, 2, 1, 3}, work);
    for (const int exponent : {-900, -400, -40, 40, 400, 1000}) {
      Points q = p;
      for (auto& x : q) x *= std::ldexp(1.0, exponent);
      ASSERT_EQ(orientation(q, {4, 2, 1, 3}, work), sign) << "2^" << exponent;
    }
  }
}

}  // namespace
}  // namespace pcm::fast
