// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of faces looked at four at a time in double precision, on every set of instructions: what is said to be sure
// against exact signs, and margins against faces that have moved by as much.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "fast/crossings/pair_margin.h"
#include "fast/simd/overlap_sets.h"
#include "fast/simd/pairs.h"

namespace pcm::fast {
namespace {

using Eigen::Vector3d;
using Points = std::array<Vector3d, 3>;

struct Pair {
  Points e, f;
};
using FourPairs = std::array<Pair, kElementLanes>;

PairLanes lanes_of_pairs(const FourPairs& pairs) {
  PairLanes lanes;
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
    for (std::size_t k = 0; k < 3; ++k) {
      lanes.e[k][lane] = pairs[lane].e[k].data();
      lanes.f[k][lane] = pairs[lane].f[k].data();
    }
  }
  return lanes;
}

/// What all sets say, the same bits.
PairsLookedAt look_at(const FourPairs& pairs) {
  const PairLanes lanes = lanes_of_pairs(pairs);
  const auto [portable, wide] = all_wide_tests();
  const PairsLookedAt found = portable->pairs(lanes);
  if (wide != nullptr) {
    const PairsLookedAt others = wide->pairs(lanes);
    EXPECT_EQ(found.sure, others.sure);
    EXPECT_EQ(found.signs, others.signs);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(found.margin.value[lane]),
                std::bit_cast<std::uint64_t>(others.margin.value[lane]));
    }
  }
  return found;
}

/// Of one pair, in each lane by turns.
struct LookedAt {
  bool sure;
  PairSigns signs;
  double margin;
};
LookedAt look_at(const Points& e, const Points& f) {
  static std::size_t turn = 0;
  const std::size_t lane = turn++ % kElementLanes;
  const Pair other{{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)},
                   {Vector3d(0, 0, 5), Vector3d(2, 0, 6), Vector3d(0, 3, 7)}};
  FourPairs pairs{other, other, other, other};
  pairs[lane] = {e, f};
  const PairsLookedAt found = look_at(pairs);
  const SureSigns signs(found.signs[lane]);
  return {
      has_lane(found.sure, lane), {signs.above_of_E(), signs.above_of_F(), signs.passing()}, found.margin.value[lane]};
}

PairSigns exact_signs(const Points& e, const Points& f) {
  WorkCounters work;
  const auto ranked = [](const Points& points, std::int64_t first) {
    return std::array<RankedPoint, 3>{
        RankedPoint{points[0].data(), first}, {points[1].data(), first + 1}, {points[2].data(), first + 2}};
  };
  return find_signs(ranked(e, 0), ranked(f, 3), SureSigns(), kNeverSure, work);
}

bool cross_alike(const PairSigns& a, const PairSigns& b) {
  return (a.passing != 0) == (b.passing != 0) && (a.passing == 0 || pair_crossing(a) == pair_crossing(b));
}

class RandomPairs {
 public:
  explicit RandomPairs(unsigned seed) : generator_(seed) {}

  double number() { return uniform_(generator_); }
  Vector3d vector() { return {number(), number(), number()}; }
  Points face() { return {vector(), vector(), vector()}; }
  /// A needle now and then, and faces of other sizes.
  Points any_face() {
    Points points = face();
    if (number() > 0.5) points[2] = points[0] + 1e-6 * vector();
    if (number() > 0.5) {
      const double size = std::exp2(10 * number());
      for (Vector3d& x : points) x = size * x + 2 * vector();
    }
    return points;
  }
  /// Coordinates moved by some of their units in the last place.
  Vector3d beside(const Vector3d& x) {
    return x.unaryExpr([this](double v) { return v * (1 + 0x1p-52 * std::round(4 * number())); });
  }
  /// One that often ties with others of its kind, exactly.
  Points face_on_grid() {
    Points points = face();
    for (Vector3d& x : points) x = (2.5 * x).array().round();
    return points;
  }
  /// A face with a corner within roundings of the other's plane, or an edge that passes as near to one of the other's.
  Points touching(const Points& e) {
    Points points = face();
    const double s = 0.5 + 0.4 * number(), t = 0.4 + 0.3 * number();
    const Vector3d on_edge = e[0] + s * (e[1] - e[0]), inside = on_edge + t * (e[2] - on_edge);
    points[0] = beside(number() > 0 ? inside : on_edge);
    if (number() > 0) points[1] = beside(2 * on_edge - points[0] + vector());
    if (number() > 0.7) points[1] = beside(2 * on_edge - points[2]);
    return points;
  }
  /// Corners about those of a face, on the border of balls of this radius but for a millionth.
  Points moved(const Points& face, double radius) {
    Points points = face;
    for (Vector3d& x : points) x += (1 - 1e-6) * radius * vector().normalized();
    return points;
  }

 private:
  std::mt19937_64 generator_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST(PairsInLanes, AreSureOfWhatIsSoAloneHoweverNearToATie) {
  constexpr unsigned kSeed = 51;
  RandomPairs random(kSeed);
  int sure = 0, crossing = 0, unsure = 0;
  for (int k = 0; k < 20000; ++k) {
    const Points e = k % 4 == 0 ? random.face_on_grid() : random.any_face();
    const Points f = k % 4 == 0 ? random.face_on_grid() : k % 4 == 1 ? random.any_face() : random.touching(e);
    const LookedAt found = look_at(e, f);
    if (!found.sure) {
      ++unsure;
      continue;
    }
    const PairSigns exact = exact_signs(e, f);
    ++sure;
    crossing += exact.passing != 0 ? 1 : 0;
    ASSERT_EQ(found.signs.passing, exact.passing) << "seed " << kSeed << ", pair " << k;
    if (exact.passing == 0) continue;
    ASSERT_EQ(found.signs.above_of_F, exact.above_of_F) << "seed " << kSeed << ", pair " << k;
    ASSERT_EQ(found.signs.above_of_E, exact.above_of_E) << "seed " << kSeed << ", pair " << k;
  }
  EXPECT_GT(sure, 6000);
  EXPECT_GT(crossing, 1000);
  EXPECT_GT(unsure, 1000);
}

/// Whatever way corners go.
TEST(PairsInLanes, CrossAsTheyDidUntilCornersHaveMovedByTheMargin) {
  constexpr unsigned kSeed = 52;
  RandomPairs random(kSeed);
  int crossing = 0, apart = 0;
  for (int k = 0; k < 4000; ++k) {
    const Points e = random.any_face(), f = k % 4 == 0 ? random.touching(e) : random.any_face();
    const LookedAt found = look_at(e, f);
    if (!found.sure || !(found.margin > 0)) continue;
    const PairSigns signs = exact_signs(e, f);
    (signs.passing != 0 ? crossing : apart) += 1;
    for (int i = 0; i < 50; ++i) {
      ASSERT_TRUE(cross_alike(exact_signs(e, random.moved(f, found.margin)), signs)) << "seed " << kSeed << ", " << k;
    }
  }
  EXPECT_GT(crossing, 300);
  EXPECT_GT(apart, 1000);
}

/// What pair_margin tells of a pair by itself, it asks fewer directions of.
TEST(PairsInLanes, HaveMarginsNoSmallerThanThoseFoundOneByOne) {
  constexpr unsigned kSeed = 53;
  RandomPairs random(kSeed);
  int compared = 0;
  for (int k = 0; k < 4000; ++k) {
    const Points e = random.face(), f = random.face();
    const LookedAt found = look_at(e, f);
    ASSERT_TRUE(found.sure);
    const double margin = pair_margin(e, f, exact_signs(e, f));
    compared += margin > 0 ? 1 : 0;
    EXPECT_GE(found.margin, (1 - 1e-5) * margin - 1e-10) << "seed " << kSeed << ", pair " << k;
  }
  EXPECT_GT(compared, 3000);
}

TEST(PairsInLanes, ScaleUntilProductsAreOutOfReach) {
  constexpr unsigned kSeed = 54;
  RandomPairs random(kSeed);
  for (int k = 0; k < 200; ++k) {
    const Points e = random.face(), f = random.face();
    const LookedAt found = look_at(e, f);
    for (const int exponent : {-1040, -400, -110, -60, -20, 20, 60, 79}) {
      Points scaled_e = e, scaled_f = f;
      for (Points* const face : {&scaled_e, &scaled_f}) {
        for (Vector3d& x : *face) x *= std::ldexp(1.0, exponent);
      }
      const LookedAt scaled = look_at(scaled_e, scaled_f);
      if (exponent < -100) {
        EXPECT_FALSE(scaled.sure);
        continue;
      }
      EXPECT_TRUE(scaled.sure);
      EXPECT_EQ(scaled.signs.passing, found.signs.passing);
      EXPECT_NEAR(std::ldexp(scaled.margin, -exponent), found.margin, 1e-9);
    }
  }
}

TEST(PairsInLanes, OfFacesThatTouchOrHaveNoAreaAreNotSure) {
  const Points e{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)};
  const std::array<Points, 5> faces{Points{Vector3d(0.25, 0.25, 0), Vector3d(1, 0, 1), Vector3d(0, 1, -1)},
                                    Points{Vector3d(0, 0, 0), Vector3d(-1, 0, 1), Vector3d(0, -1, -1)},
                                    Points{Vector3d(0.5, 0.5, -1), Vector3d(0.5, 0.5, 1), Vector3d(2, 2, 0.25)},
                                    Points{Vector3d(0.25, 0, 0), Vector3d(0, 0.25, 0), Vector3d(0.25, 0.25, 0)},
                                    Points{Vector3d(0.25, 0.25, 1), Vector3d(0.25, 0.25, -1), Vector3d(0.25, 0.25, 2)}};
  for (const Points& f : faces) EXPECT_FALSE(look_at(e, f).sure);
}

/// What fast/simd/pairs.h derives, which pairs drawn by chance come nowhere near: two volumes of each kind, each off by
/// 8 u, and four roundings.
TEST(PairsInLanes, RoundingsAreAtLeastWhatIsDerived) {
  EXPECT_GE(kVolumeRoundings, (2 * 8 + 4) * 0x1p-53);
}

/// A corner of f a hair above the middle of e, and a long edge that passes there.
TEST(PairsInLanes, HaveTheDistanceForAMarginWhereItIsKnown) {
  const Points e{Vector3d(-1, -1, 0), Vector3d(1, -1, 0), Vector3d(0, 2, 0)};
  for (const double height : {0x1p-3, 0x1p-20, 0x1p-40}) {
    const Points above{Vector3d(0, 0, height), Vector3d(1, 0, 1), Vector3d(0, 1, 1)};
    EXPECT_NEAR(look_at(e, above).margin, height, 1e-3 * height + 4e-13);
    const Points through{Vector3d(0, 0, -height), Vector3d(4, 0, 4), Vector3d(0, 4, 4)};
    const double margin = look_at(e, through).margin;
    EXPECT_LE(margin, height);
    EXPECT_GE(margin, height / 8);
  }
}

}  // namespace
}  // namespace pcm::fast
