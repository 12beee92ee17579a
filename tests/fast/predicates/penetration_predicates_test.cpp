// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fast/predicates/penetration_predicates.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <string>

#include "tests/fast/exact_numbers.h"

namespace pcm::fast {
namespace {

/// The definitions of PCM section 6 taken literally over rationals; a shift is made by a d smaller than anything that
/// polynomials of degree 7 in doubles can tell from zero.
class LiteralLine {
 public:
  explicit LiteralLine(const FacePoints& p) {
    const RationalVector p0 = rational(p[0]);
    e1_ = minus(rational(p[1]), p0);
    e2_ = minus(rational(p[2]), p0);
    n_ = cross(e1_, e2_);
    for (std::size_t j = 0; j < 3; ++j) c_[j] = p0[j] + (e1_[j] + e2_[j]) / 3;
  }

  int facing(const FacePoints& f) const { return sgn(dot(n_, normal(f))); }

  mpq_class distance(const FacePoints& f, const RationalVector& c) const {
    return -dot(minus(rational(f[0]), c), normal(f)) / dot(n_, normal(f));
  }
  int distance_sign(const FacePoints& f) const { return sgn(distance(f, c_)); }

  int compare_distance(const FacePoints& f, const FacePoints& g) const {
    const int sign = sgn(mpq_class(distance(f, c_) - distance(g, c_)));
    return sign != 0 ? sign : sgn(mpq_class(distance(f, shifted()) - distance(g, shifted())));
  }

  bool passes_through(const FacePoints& f) const {
    std::array<int, 3> signs{};
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalVector from = rational(f[i]), to = rational(f[(i + 1) % 3]);
      signs[i] = sgn(side(from, to, c_));
      if (signs[i] == 0) signs[i] = sgn(side(from, to, shifted()));
    }
    return signs[0] != 0 && signs[0] == signs[1] && signs[1] == signs[2];
  }

 private:
  static RationalVector normal(const FacePoints& f) {
    return cross(minus(rational(f[1]), rational(f[0])), minus(rational(f[2]), rational(f[0])));
  }
  mpq_class side(const RationalVector& from, const RationalVector& to, const RationalVector& c) const {
    return dot(n_, cross(minus(from, c), minus(to, c)));
  }
  RationalVector shifted() const {
    const mpq_class d(mpz_class(1), mpz_class(1) << 16000);
    RationalVector c;
    for (std::size_t j = 0; j < 3; ++j) c[j] = c_[j] + d * (e1_[j] + d * e2_[j]);
    return c;
  }

  RationalVector e1_, e2_, n_, c_;
};

struct Query {
  FacePoints master, f, g;
};

PenetrationLine line_of(const FacePoints& p) {
  return {p[0], p[1], p[2]};
}

/// Every predicate on one query against its definition, and the antisymmetries.
void expect_right(const Query& query, WorkCounters& work) {
  const PenetrationLine line = line_of(query.master);
  const LiteralLine literal(query.master);
  const auto& [master, f, g] = query;
  const int facing_f = facing(line, f, work);
  const int facing_g = facing(line, g, work);
  ASSERT_EQ(facing_f, literal.facing(f));
  ASSERT_EQ(facing_g, literal.facing(g));
  if (facing_f != 0) {
    const bool hit = passes_through(line, f, work);
    ASSERT_EQ(hit, literal.passes_through(f));
    ASSERT_EQ(distance_sign(line, f, work), literal.distance_sign(f));
    const FacePoints turned{f[0], f[2], f[1]};
    WorkCounters other;
    ASSERT_EQ(facing(line, turned, other), -facing_f);
    ASSERT_EQ(passes_through(line, turned, other), hit);
    ASSERT_EQ(compare_distance(line, f, f, other), 0);
    ASSERT_EQ(compare_distance(line, f, turned, other), 0);
  }
  if (facing_f != 0 && facing_g != 0) {
    const int order = compare_distance(line, f, g, work);
    ASSERT_EQ(order, literal.compare_distance(f, g));
    WorkCounters other;
    ASSERT_EQ(compare_distance(line, g, f, other), -order);
  }
}

void expect_right(const std::string& what, int count, const std::function<Query()>& draw, double ceiling) {
  WorkCounters work;
  for (int i = 0; i < count; ++i) {
    expect_right(draw(), work);
    if (testing::Test::HasFatalFailure()) FAIL() << what << ", query " << i;
  }
  std::printf("  %-42s predicates %6lld  exact %6lld  ties %6lld\n", what.c_str(),
              static_cast<long long>(work.predicates), static_cast<long long>(work.exact_predicates),
              static_cast<long long>(work.tie_breaks));
  EXPECT_LE(static_cast<double>(work.exact_predicates), ceiling * static_cast<double>(work.predicates)) << what;
}

Query query_of(const std::function<double()>& coordinate) {
  Query query;
  for (FacePoints* face : {&query.master, &query.f, &query.g}) {
    for (auto& x : *face) x = Doubles::point(coordinate);
  }
  return query;
}

TEST(PenetrationPredicates, AgreeWithTheirDefinitionsOverRationals) {
  Doubles doubles(1848);
  const auto check = [&](const std::string& what, int count, const std::function<double()>& coordinate,
                         double ceiling) {
    expect_right(
        what, count, [&] { return query_of(coordinate); }, ceiling);
  };
  check(
      "uniform", 3000, [&] { return doubles.unit(); }, 1e-3);
  check(
      "uniform, 1e12 from the origin", 3000, [&] { return 1e12 + doubles.unit(); }, 0.01);
  check(
      "uniform, scaled by 2^-40", 1000, [&] { return doubles.unit() * 0x1p-40; }, 1e-3);
  check(
      "uniform, scaled by 2^40", 1000, [&] { return doubles.unit() * 0x1p40; }, 1e-3);
  check(
      "uniform, scaled by 2^-300", 1000, [&] { return doubles.unit() * 0x1p-300; }, 1);
  check(
      "uniform, scaled by 2^300", 1000, [&] { return doubles.unit() * 0x1p300; }, 1);
  check(
      "small integers", 4000, [&] { return doubles.small_integer(2); }, 1);
  check(
      "multiples of three", 4000, [&] { return 3 * doubles.small_integer(1); }, 1);
  check(
      "exponents between -300 and 300", 1000, [&] { return doubles.scaled(300); }, 1);
  check(
      "exponents between -140 and 140", 1000, [&] { return doubles.scaled(140); }, 1);
  check(
      "any bit pattern", 500, [&] { return doubles.any(); }, 1);
  check(
      "products of four about underflow", 2000, [&] { return doubles.unit() * 0x1p-267; }, 1);
  check(
      "products of seven about underflow", 2000, [&] { return doubles.unit() * 0x1p-153; }, 1);
  check(
      "ends of the range", 1000, [&] { return doubles.extreme(); }, 1);
  check(
      "denormals", 2000, [&] { return doubles.denormal(); }, 1);
}

/// Faces whose edge or vertex the line meets and pairs of faces whose planes it meets in one point, up to rounding and
/// a few units in the last place.
TEST(PenetrationPredicates, AgreeWithTheirDefinitionsNearDegeneracy) {
  Doubles doubles(1905);
  const auto draw = [&](double offset, double scale, int ulps) {
    Query query = query_of([&] { return (offset + doubles.unit()) * scale; });
    const auto& p = query.master;
    const Eigen::Vector3d centre = p[0] + ((p[1] - p[0]) + (p[2] - p[0])) / 3;
    const Eigen::Vector3d direction = ((p[1] - p[0]) / scale).cross((p[2] - p[0]) / scale) * scale;
    const Eigen::Vector3d point = centre - direction * doubles.unit();
    switch (doubles.integer(0, 3)) {
      case 0:
        query.f[1] = point - 0.7 * (query.f[0] - point);
        break;  // an edge through the line
      case 1:
        query.f[2] = point;
        break;  // a vertex on it
      case 2:
        query.f[2] = query.f[0] + direction + doubles.unit() * (query.f[1] - query.f[0]);
        break;  // parallel to it
      default:
        query.f[0] = centre + doubles.unit() * (p[1] - p[0]);
        break;  // near the master's plane
    }
    query.g[0] = point;
    if (doubles.integer(0, 1) == 0) query.f[0] = point;  // both planes pass through one point of the line
    for (FacePoints* face : {&query.f, &query.g}) {
      for (auto& x : *face) {
        for (Eigen::Index j = 0; j < 3; ++j) x[j] = doubles.nudged(x[j], ulps);
      }
    }
    return query;
  };
  expect_right(
      "nearly degenerate", 3000, [&] { return draw(0, 1, 4); }, 0.5);
  expect_right(
      "nearly degenerate, off the origin", 3000, [&] { return draw(1e3, 1, 4); }, 0.5);
  expect_right(
      "nearly degenerate, scaled by 2^-130", 2000, [&] { return draw(0, 0x1p-130, 2); }, 1);
}

TEST(PenetrationPredicates, LineThroughTheMiddleOfACubeLeavesItsTopAndEntersItsBottom) {
  // The master's outside is up, so its line runs down: it leaves F where F's outward normal points down.
  WorkCounters work;
  const PenetrationLine line({0, 0, 2}, {3, 0, 2}, {0, 3, 2});
  const FacePoints down{{{0, 0, -1}, {0, 9, -1}, {9, 0, -1}}};
  const FacePoints up{{{0, 0, 1}, {9, 0, 1}, {0, 9, 1}}};
  EXPECT_EQ(facing(line, down, work), -1);
  EXPECT_EQ(facing(line, up, work), 1);
  EXPECT_TRUE(passes_through(line, down, work));
  EXPECT_TRUE(passes_through(line, up, work));
  EXPECT_EQ(distance_sign(line, down, work), 1);
  EXPECT_EQ(distance_sign(line, {{{0, 0, 3}, {0, 9, 3}, {9, 0, 3}}}, work), -1);
  EXPECT_EQ(compare_distance(line, up, down, work), -1);
  EXPECT_EQ(work.exact_predicates, 0);
  EXPECT_EQ(distance_sign(line, {{{0, 0, 2}, {0, 9, 2}, {9, 0, 2}}}, work), 0);
  EXPECT_EQ(facing(line, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}}, work), 0);
}

/// A fan about the point the line passes: the shift puts it into exactly one triangle.
TEST(PenetrationPredicates, LineThroughAVertexPassesThroughOneFaceOfItsFan) {
  const PenetrationLine line({0, 0, 0}, {3, 0, 0}, {0, 3, 0});  // barycentre (1, 1, 0)
  const Eigen::Vector3d hub(1, 1, -1);
  const std::array<Eigen::Vector3d, 4> rim{{{3, 1, -1}, {1, 3, -2}, {-1, 1, -1}, {1, -1, 0}}};
  WorkCounters work;
  int hits = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool hit = passes_through(line, {hub, rim[i], rim[(i + 1) % 4]}, work);
    hits += hit;
    EXPECT_EQ(hit, i == 0) << "the shift is along +x, then +y";
  }
  EXPECT_EQ(hits, 1);
  EXPECT_GT(work.tie_breaks, 0);
}

TEST(PenetrationPredicates, StagesDecideWhatTheyShould) {
  const PenetrationLine line({0, 0, 0}, {3, 0, 0}, {0, 3, 0});
  const FacePoints flat{{{0, 0, -1}, {0, 9, -1}, {9, 0, -1}}};
  const FacePoints steep{{{1, 1, -1}, {1, 9, -1}, {9, 0, -5}}};  // meets the line where `flat` does, and falls off
  const FacePoints same_plane{{{5, 5, -1}, {5, 6, -1}, {6, 5, -1}}};
  {
    SCOPED_TRACE("different depths are the filter's");
    WorkCounters work;
    const FacePoints lower{{{0, 0, -1.0625}, {0, 9, -1.0625}, {9, 0, -1.0625}}};
    EXPECT_EQ(compare_distance(line, flat, lower, work), -1);
    EXPECT_EQ(work.exact_predicates, 0);
  }
  {
    SCOPED_TRACE("depths one ulp apart need exact arithmetic");
    WorkCounters work;
    const double z = std::nextafter(-1.0, -2.0);
    const FacePoints lower{{{0, 0, z}, {0, 9, z}, {9, 0, z}}};
    EXPECT_EQ(compare_distance(line, flat, lower, work), -1);
    EXPECT_EQ(work.exact_predicates, 1);
    EXPECT_EQ(work.tie_breaks, 0);
  }
  {
    SCOPED_TRACE("planes that meet on the line are the shift's: along +x the steep face falls off, so it comes later");
    WorkCounters work;
    EXPECT_EQ(compare_distance(line, flat, steep, work), -1);
    EXPECT_EQ(work.exact_predicates, 1);
    EXPECT_EQ(work.tie_breaks, 1);
  }
  {
    SCOPED_TRACE("faces in one plane stay tied");
    WorkCounters work;
    EXPECT_EQ(compare_distance(line, flat, same_plane, work), 0);
    EXPECT_EQ(work.exact_predicates, 3);
    EXPECT_EQ(work.tie_breaks, 1);
  }
  {
    SCOPED_TRACE("an edge that the line meets is the shift's");
    WorkCounters work;
    EXPECT_TRUE(passes_through(line, {{{1, 0, -1}, {1, 2, -1}, {9, 1, -1}}}, work) !=
                passes_through(line, {{{1, 0, -1}, {1, 2, -1}, {-9, 1, -1}}}, work));
    EXPECT_EQ(work.exact_predicates, 2);
    EXPECT_EQ(work.tie_breaks, 2);
  }
}

TEST(PenetrationPredicates, ResultsDoNotChangeUnderScalingByPowersOfTwo) {
  Doubles doubles(5);
  WorkCounters work;
  for (int i = 0; i < 500; ++i) {
    const Query query = query_of(
        [&] { return i % 2 == 0 ? doubles.small_integer(3) : std::ldexp(doubles.small_integer(1 << 20), -20); });
    const PenetrationLine line = line_of(query.master);
    if (facing(line, query.f, work) == 0 || facing(line, query.g, work) == 0) continue;
    for (const int exponent : {-1000, -160, -100, 30, 100, 160, 1000}) {
      Query scaled = query;
      for (FacePoints* face : {&scaled.master, &scaled.f, &scaled.g}) {
        for (auto& x : *face) x *= std::ldexp(1.0, exponent);
      }
      const PenetrationLine scaled_line = line_of(scaled.master);
      ASSERT_EQ(facing(scaled_line, scaled.f, work), facing(line, query.f, work));
      ASSERT_EQ(passes_through(scaled_line, scaled.f, work), passes_through(line, query.f, work));
      ASSERT_EQ(distance_sign(scaled_line, scaled.f, work), distance_sign(line, query.f, work));
      ASSERT_EQ(compare_distance(scaled_line, scaled.f, scaled.g, work),
                compare_distance(line, query.f, query.g, work));
    }
  }
}

}  // namespace
}  // namespace pcm::fast
