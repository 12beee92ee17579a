// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/search/line_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <random>

#include "fast/predicates/penetration_predicates.h"

namespace pcm::fast::line_walk_test {
namespace {

using Eigen::Vector3d;

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : random_(seed) {}

  double number() { return uniform_(random_); }
  Vector3d vector() { return {number(), number(), number()}; }

 private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// How many of 4000 passages are said to be sure; none of them is wrong. Faces of the size `M`, of most of which an
/// edge passes the line within roundings; the sides of the master's face are of the sizes `a` and `b`.
int sure_passages(double M, double a, double b) {
  RandomNumbers random(1);
  int sure = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d side_a = random.vector(), side_b = random.vector();
    const std::array<Vector3d, 3> p{Vector3d::Zero(), a * side_a, b * side_b};
    const Vector3d barycentre = (p[0] + p[1] + p[2]) / 3;
    const Vector3d on_line = barycentre + 0.2 * M * random.number() * side_a.cross(side_b).normalized();
    std::array<Vector3d, 3> f{0.4 * M * random.vector(), 0.4 * M * random.vector(), 0.4 * M * random.vector()};
    if (i % 4 != 0) f[1] = on_line - (0.1 + 0.5 * std::abs(random.number())) * (f[0] - on_line);
    double max_coordinate = 0;
    for (const std::array<Vector3d, 3>& face : {p, f})
      for (const Vector3d& x : face) max_coordinate = std::max(max_coordinate, x.lpNorm<Eigen::Infinity>());
    const LineCoordinates line(p, barycentre, p[1].lpNorm<1>(), p[2].lpNorm<1>(), max_coordinate);
    WorkCounters work;
    const std::optional<Passage> passage = passage_through(line, f, work);
    if (passage == Passage::unknown) continue;
    ++sure;
    const PenetrationLine exactly(p[0], p[1], p[2]);
    const int side = facing(exactly, f, work);
    EXPECT_EQ(passage.has_value(), side != 0 && passes_through(exactly, f, work)) << i;
    if (passage) {
      EXPECT_EQ(*passage == Passage::leaving, side < 0) << i;
    }
  }
  return sure;
}

TEST(PassageThrough, IsSureOfWhatIsTrueHoweverSmallTheMastersFaceIs) {
  std::cout << "seed 1\n";
  EXPECT_GT(sure_passages(1, 1, 0x1p-10), 400);
  EXPECT_GT(sure_passages(0x1p300, 0x1p-600, 0x1p-600), 400);
  // What a bound is made of would underflow.
  for (const int exponent : {-660, -670, -680, -690, -700}) {
    const double side = std::ldexp(1.0, exponent);
    sure_passages(0x1p300, side, side);
    sure_passages(0x1p300, 0x1p-600, side * 0x1p-60);
    sure_passages(0x1p200, side * 0x1p60, side * 0x1p60);
  }
}

}  // namespace
}  // namespace pcm::fast::line_walk_test
