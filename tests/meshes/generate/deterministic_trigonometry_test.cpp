// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/deterministic_trigonometry.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <cstdint>

namespace pcm {
namespace {

/// Cosine and sine to 200 bits, rounded to double: correctly rounded but for one angle in 2^140.
class Truth {
 public:
  Truth() { mpfr_inits2(200, angle_, value_, static_cast<mpfr_ptr>(nullptr)); }
  ~Truth() { mpfr_clears(angle_, value_, static_cast<mpfr_ptr>(nullptr)); }
  Truth(const Truth&) = delete;
  Truth& operator=(const Truth&) = delete;

  CosineSine of_turn(int numerator, int denominator) {
    mpfr_const_pi(angle_, MPFR_RNDN);
    mpfr_mul_si(angle_, angle_, 2L * numerator, MPFR_RNDN);
    mpfr_div_si(angle_, angle_, denominator, MPFR_RNDN);
    return of_angle();
  }
  CosineSine of_degrees(double degrees) {
    mpfr_const_pi(angle_, MPFR_RNDN);
    mpfr_mul_d(angle_, angle_, degrees, MPFR_RNDN);
    mpfr_div_si(angle_, angle_, 180, MPFR_RNDN);
    return of_angle();
  }
  CosineSine of_radians(double radians) {
    mpfr_set_d(angle_, radians, MPFR_RNDN);
    return of_angle();
  }

 private:
  CosineSine of_angle() {
    CosineSine result;
    mpfr_cos(value_, angle_, MPFR_RNDN);
    result.cosine = mpfr_get_d(value_, MPFR_RNDN);
    mpfr_sin(value_, angle_, MPFR_RNDN);
    result.sine = mpfr_get_d(value_, MPFR_RNDN);
    return result;
  }

  mpfr_t angle_;
  mpfr_t value_;
};

void expect_same(const CosineSine& computed, const CosineSine& truth) {
  EXPECT_EQ(computed.cosine, truth.cosine);
  EXPECT_EQ(computed.sine, truth.sine);
}

TEST(DeterministicTrigonometry, FractionsOfATurnAreCorrectlyRounded) {
  Truth truth;
  for (int n = 1; n <= 300; ++n) {
    for (int k = 0; k < n; ++k) {
      if (4 * k % n == 0) continue;  // The axes are exact, which rounding pi to 200 bits is not.
      SCOPED_TRACE(testing::Message() << k << " / " << n);
      expect_same(cosine_sine_of_turn(k, n), truth.of_turn(k, n));
    }
  }
}

TEST(DeterministicTrigonometry, DegreesAndRadiansAreCorrectlyRounded) {
  Truth truth;
  for (int i = 1; i < 5000; ++i) {
    const double x = (i - 2500) * 0.37109375 + 1e-3;
    SCOPED_TRACE(x);
    expect_same(cosine_sine_of_degrees(x), truth.of_degrees(x));
    expect_same(cosine_sine_of_radians(x), truth.of_radians(x));
  }
}

TEST(DeterministicTrigonometry, AgreesWithTheStandardLibraryToAnUlp) {
  for (int i = 1; i < 5000; ++i) {
    const double x = (i - 2500) * 0.0371;
    EXPECT_DOUBLE_EQ(cosine_sine_of_radians(x).cosine, std::cos(x));
    EXPECT_DOUBLE_EQ(cosine_sine_of_radians(x).sine, std::sin(x));
  }
}

TEST(DeterministicTrigonometry, AxesAndDiagonalsAreExactWithPositiveZeros) {
  const double half_root = std::sqrt(0.5);
  const double expected_cosine[] = {1, half_root, 0, -half_root, -1, -half_root, 0, half_root};
  for (int k = 0; k < 8; ++k) {
    for (const CosineSine value : {cosine_sine_of_turn(k, 8), cosine_sine_of_turn(3 * k - 24, 24),
                                   cosine_sine_of_degrees(45.0 * k), cosine_sine_of_degrees(45.0 * k - 720)}) {
      EXPECT_EQ(value.cosine, expected_cosine[k]);
      EXPECT_EQ(value.sine, expected_cosine[(k + 6) % 8]);
      EXPECT_FALSE(value.cosine == 0 && std::signbit(value.cosine));
      EXPECT_FALSE(value.sine == 0 && std::signbit(value.sine));
    }
  }
  EXPECT_EQ(cosine_sine_of_radians(0).sine, 0);
  EXPECT_EQ(cosine_sine_of_radians(0).cosine, 1);
}

TEST(DeterministicTrigonometry, MirrorImagesAgreeBitForBit) {
  for (std::int64_t n = 1; n <= 64; ++n) {
    for (std::int64_t k = 0; k < n; ++k) {
      const auto value = cosine_sine_of_turn(k, n);
      const auto mirrored = cosine_sine_of_turn(n - k, n);
      EXPECT_EQ(mirrored.cosine, value.cosine);
      EXPECT_EQ(mirrored.sine, -value.sine);
      const auto across_diagonal = cosine_sine_of_turn(n - 4 * k, 4 * n);
      EXPECT_EQ(across_diagonal.cosine, cosine_sine_of_turn(k, n).sine);
      EXPECT_EQ(across_diagonal.sine, cosine_sine_of_turn(k, n).cosine);
    }
  }
}

}  // namespace
}  // namespace pcm
