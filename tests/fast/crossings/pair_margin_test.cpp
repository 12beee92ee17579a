// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/crossings/pair_margin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace pcm::fast {
namespace {

using Eigen::Vector3d;
using Points = std::array<Vector3d, 3>;

std::array<RankedPoint, 3> ranked(const Points& points, std::int64_t first) {
  return {RankedPoint{points[0].data(), first}, {points[1].data(), first + 1}, {points[2].data(), first + 2}};
}

PairSigns signs_of(const Points& e, const Points& f) {
  WorkCounters work;
  return find_signs(ranked(e, 0), ranked(f, 3), SureSigns(), kNeverSure, work);
}

class RandomFaces {
 public:
  explicit RandomFaces(unsigned seed) : generator_(seed) {}

  Vector3d vector() { return {uniform_(generator_), uniform_(generator_), uniform_(generator_)}; }
  Points face() { return {vector(), vector(), vector()}; }
  /// Corners within a ball of this radius about those of a face, on its border but for a millionth.
  Points moved(const Points& face, double radius) {
    Points points = face;
    for (Vector3d& x : points) x += (1 - 1e-6) * radius * vector().normalized();
    return points;
  }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// Whatever way corners go, and there are many.
TEST(PairMargin, FacesCrossAsTheyDidUntilCornersHaveMovedByAsMuch) {
  constexpr unsigned kSeed = 17;
  RandomFaces random(kSeed);
  int crossing = 0, apart = 0;
  for (int k = 0; k < 4000; ++k) {
    const Points e = random.face(), f = random.face();
    const PairSigns signs = signs_of(e, f);
    const double margin = pair_margin(e, f, signs);
    if (!(margin > 0)) continue;
    (signs.passing != 0 ? crossing : apart) += 1;
    for (int i = 0; i < 50; ++i) {
      const PairSigns moved = signs_of(e, random.moved(f, margin));
      ASSERT_EQ(moved.passing != 0, signs.passing != 0) << "seed " << kSeed << ", pair " << k;
      if (signs.passing != 0) {
        ASSERT_TRUE(pair_crossing(moved) == pair_crossing(signs)) << "seed " << kSeed << ", pair " << k;
      }
    }
  }
  EXPECT_GT(crossing, 300);
  EXPECT_GT(apart, 1000);
}

TEST(PairMargin, ScalesWithAllLengths) {
  constexpr unsigned kSeed = 23;
  RandomFaces random(kSeed);
  int positive = 0;
  for (int k = 0; k < 500; ++k) {
    const Points e = random.face(), f = random.face();
    const double margin = pair_margin(e, f, signs_of(e, f));
    positive += margin > 0 ? 1 : 0;
    for (const int exponent : {-1000, -400, -300, -42, -41, -40, -39, -38, -20, 20, 38, 39, 40, 41, 300}) {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", pair " + std::to_string(k) + ", 2^" + std::to_string(exponent));
      const double scale = std::ldexp(1.0, exponent);
      Points scaled_e = e, scaled_f = f;
      for (Points* const face : {&scaled_e, &scaled_f}) {
        for (Vector3d& x : *face) x *= scale;
      }
      const double scaled_margin = pair_margin(scaled_e, scaled_f, signs_of(scaled_e, scaled_f));
      ASSERT_EQ(scaled_margin, margin * scale);
    }
  }
  EXPECT_GT(positive, 100);
}

TEST(PairMargin, IsNothingBelowTheLeastNormalNumber) {
  const double least = std::numeric_limits<double>::denorm_min();
  const Points e{Vector3d(-64, -64, 0) * least, Vector3d(64, -64, 0) * least, Vector3d(0, 128, 0) * least};
  const Points above{Vector3d(0, 0, 2) * least, Vector3d(64, 0, 64) * least, Vector3d(0, 64, 64) * least};
  EXPECT_EQ(pair_margin(e, above, signs_of(e, above)), 0);
}

/// A corner of f a hair above the middle of e, and a long edge that passes there.
TEST(PairMargin, IsTheDistanceWhereItIsKnown) {
  const Points e{Vector3d(-1, -1, 0), Vector3d(1, -1, 0), Vector3d(0, 2, 0)};
  for (const double height : {0x1p-3, 0x1p-20, 0x1p-40}) {
    const Points above{Vector3d(0, 0, height), Vector3d(1, 0, 1), Vector3d(0, 1, 1)};
    EXPECT_NEAR(pair_margin(e, above, signs_of(e, above)), height, 1e-3 * height + 2e-14);
    const Points through{Vector3d(0, 0, -height), Vector3d(4, 0, 4), Vector3d(0, 4, 4)};
    const double margin = pair_margin(e, through, signs_of(e, through));
    EXPECT_LE(margin, height);
    EXPECT_GE(margin, height / 8);
  }
}

/// Ties are decided, but a move by next to nothing may decide them the other way.
TEST(PairMargin, OfFacesThatTouchIsNotPositive) {
  const Points e{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)};
  const std::array<Points, 4> touching{Points{Vector3d(0.25, 0.25, 0), Vector3d(1, 0, 1), Vector3d(0, 1, 1)},
                                       Points{Vector3d(0, 0, 0), Vector3d(-1, 0, 1), Vector3d(0, -1, 1)},
                                       Points{Vector3d(0.5, 0.5, -1), Vector3d(0.5, 0.5, 1), Vector3d(2, 2, 0)},
                                       Points{Vector3d(0.25, 0, 0), Vector3d(0, 0.25, 0), Vector3d(0.25, 0.25, 0)}};
  for (const Points& f : touching) EXPECT_LE(pair_margin(e, f, signs_of(e, f)), 0);
}

}  // namespace
}  // namespace pcm::fast
