// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/chebyshev_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcm::simulate {
namespace {

/// By what a step of h lambda = z multiplies the solution of y' = lambda y: its polynomial's value.
double amplification(const std::vector<ChebyshevStage>& stages, double z) {
  double before = 1, y = 1 + stages[0].c * z;
  for (std::size_t j = 1; j < stages.size(); ++j) {
    const ChebyshevStage& stage = stages[j];
    const double next =
        (1 - stage.mu - stage.nu) + stage.mu * y + stage.nu * before + z * (stage.mu_slope * y + stage.gamma_slope);
    before = y;
    y = next;
  }
  return y;
}

/// The greatest |amplification| for z from -from to -to.
double greatest_amplification(const std::vector<ChebyshevStage>& stages, double from, double to) {
  double greatest = 0;
  for (int i = 0; i <= 20000; ++i)
    greatest = std::max(greatest, std::abs(amplification(stages, -from - (to - from) * i / 20000)));
  return greatest;
}

constexpr std::array kNumbers = {2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 17, 25, 40, 77, 150, 400};

TEST(ChebyshevStages, AreStableUpToTheLimitAndLittleBeyond) {
  for (const int number : kNumbers) {
    const std::vector<ChebyshevStage> stages = chebyshev_stages(number);
    const double limit = chebyshev_limit(number);
    EXPECT_LE(greatest_amplification(stages, 0, limit), 1 + 1e-11 * number) << number;
    EXPECT_GE(limit, 0.65 * (number * number - 1));
    if (number % 2 == 0) {  // an odd polynomial passes 1 farther on, where it falls below -1
      EXPECT_GT(greatest_amplification(stages, limit, 1.03 * limit), 1) << number;
    }
  }
}

// b_s (T_s(w_0) + 1) = 1 - a_s + b_s is what the damping of 2/13 leaves, 1 - (2/13)/3 for many stages, where T_s is 1
// again for the second time.
TEST(ChebyshevStages, DampWhatIsStiff) {
  for (const int number : {5, 10, 40, 150})
    EXPECT_LT(greatest_amplification(chebyshev_stages(number), 0.3 * chebyshev_limit(number), chebyshev_limit(number)),
              0.96)
        << number;
}

// Stage y_j of y' = y is e^(c_j h) up to h^2, so that f_j is right up to h^2 and y_s too.
TEST(ChebyshevStages, AreOfSecondOrderEach) {
  for (const int number : kNumbers) {
    std::vector<ChebyshevStage> stages = chebyshev_stages(number);
    EXPECT_EQ(stages.back().c, 1);
    for (std::size_t last = 2; last <= stages.size(); ++last) {
      const std::vector<ChebyshevStage> up_to(stages.begin(), stages.begin() + static_cast<std::ptrdiff_t>(last));
      const double h = 1e-4, c = up_to.back().c;
      const double plus = amplification(up_to, h), minus = amplification(up_to, -h);
      EXPECT_NEAR((plus - minus) / (2 * h), c, 1e-7) << number << ' ' << last;
      EXPECT_NEAR((plus - 2 + minus) / (h * h), c * c, 1e-4) << number << ' ' << last;
      EXPECT_GT(up_to.back().c, up_to[last - 2].c);
    }
  }
}

TEST(ChebyshevStages, AreAsFewAsTheLimitAllows) {
  EXPECT_EQ(chebyshev_stages_for(0), 2);
  for (const double z : {1.0, 1.96, 7.0, 93.0, 1e4, 3.3e7}) {
    const int number = chebyshev_stages_for(z);
    EXPECT_GE(chebyshev_limit(number), z);
    EXPECT_TRUE(number == 2 || chebyshev_limit(number - 1) < z) << z;
  }
}

}  // namespace
}  // namespace pcm::simulate
