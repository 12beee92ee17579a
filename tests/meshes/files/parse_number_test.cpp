// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/files/parse_number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace pcm {
namespace {

/// parse_number must be strtod's value bit for bit, or empty where that overflows.
::testing::AssertionResult agrees_with_strtod(const std::string& text) {
  char* end = nullptr;
  const double expected = std::strtod(text.c_str(), &end);
  if (*end != '\0') return ::testing::AssertionFailure() << "test error: strtod doesn't read " << text;
  const auto actual = parse_number(text);
  if (!std::isfinite(expected)) {
    if (!actual) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << text << " overflows but was read as " << *actual;
  }
  if (actual && std::bit_cast<std::uint64_t>(*actual) == std::bit_cast<std::uint64_t>(expected))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << text << ": expected " << expected << ", got "
                                       << (actual ? std::to_string(*actual) : "nothing");
}

using Random = std::mt19937_64;

double random_finite_double(Random& random) {
  for (;;) {
    const double x = std::bit_cast<double>(random());
    if (std::isfinite(x)) return x;
  }
}

std::string printed(const char* format, int digits, double x) {
  std::string text(1600, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, digits, x)));
  return text;
}

std::string random_digits(Random& random, std::size_t longest) {
  std::string digits;
  const std::size_t count = 1 + random() % longest;
  for (std::size_t i = 0; i < count; ++i) digits.push_back(static_cast<char>('0' + random() % 10));
  return digits;
}

/// The exact decimal expansion of the midpoint of x and its upper neighbour; long double holds it.
std::string halfway(double x) {
  const double above = std::nextafter(x, std::numeric_limits<double>::infinity());
  const long double middle = (static_cast<long double>(x) + static_cast<long double>(above)) / 2;
  std::string text(1600, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.780Le", middle)));
  return text;
}

TEST(ParseNumber, AMillionRandomDecimalsAreReadAsStrtodReadsThem) {
  constexpr std::uint64_t kSeed = 20031105;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  Random random(kSeed);
  for (int i = 0; i < 1'000'000; ++i) {
    std::string text;
    switch (random() % 5) {
      case 0:  // any double, more or fewer digits than it takes
        text = printed("%.*e", static_cast<int>(random() % 25), random_finite_double(random));
        break;
      case 1:  // coordinates as files have them
        text = printed("%.*f", static_cast<int>(random() % 12),
                       std::ldexp(random_finite_double(random), 0) > 0 ? static_cast<double>(random() % 1000000) * 1e-3
                                                                       : -static_cast<double>(random() % 1000) * 1e-5);
        break;
      case 2:  // random digits, exponents to both limits and beyond
        text = random_digits(random, 25) + "." + random_digits(random, 25) + "e" +
               std::to_string(static_cast<int>(random() % 720) - 370);
        break;
      case 3:  // denormals
        text =
            printed("%.*e", static_cast<int>(random() % 25), std::bit_cast<double>(random() >> (12 + random() % 52)));
        break;
      default:  // no exponent, point anywhere
        text = std::string(1, random() % 2 ? '+' : '-') + random_digits(random, 30) + (random() % 2 ? "." : "") +
               random_digits(random, 30);
        break;
    }
    ASSERT_TRUE(agrees_with_strtod(text));
  }
}

TEST(ParseNumber, HalfwayCasesAndTheirNeighboursAreRoundedToEven) {
  constexpr std::uint64_t kSeed = 754;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  Random random(kSeed);
  for (int i = 0; i < 20'000; ++i) {
    double x = std::abs(random_finite_double(random));
    if (i % 4 == 0) x = std::bit_cast<double>(random() >> (12 + random() % 52));
    if (x == std::numeric_limits<double>::max()) continue;
    std::string text = halfway(x);
    ASSERT_TRUE(agrees_with_strtod(text));
    const std::size_t last = text.find('e') - 1;
    text[last] = '1';  // just above: all 780 digits matter
    ASSERT_TRUE(agrees_with_strtod(text));
    ASSERT_TRUE(agrees_with_strtod(std::string("-").append(text)));
  }
}

TEST(ParseNumber, HexadecimalFloatsAreReadAsStrtodReadsThem) {
  constexpr std::uint64_t kSeed = 99;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  Random random(kSeed);
  constexpr const char* kDigits = "0123456789abcdefABCDEF";
  for (int i = 0; i < 200'000; ++i) {
    std::string text = random() % 2 ? "-0x" : "0X";
    if (i % 2 == 0) {
      text = printed("%.*a", static_cast<int>(random() % 14), random_finite_double(random));
    } else {
      const std::size_t before = 1 + random() % 20;
      for (std::size_t k = 0; k < before; ++k) text.push_back(kDigits[random() % 22]);
      if (random() % 2) text.push_back('.');
      for (std::size_t k = random() % 20; k > 0; --k) text.push_back(kDigits[random() % 22]);
      if (random() % 4) text += std::string("p") + std::to_string(static_cast<int>(random() % 2300) - 1150);
    }
    ASSERT_TRUE(agrees_with_strtod(text));
  }
}

TEST(ParseNumber, LimitsOfTheRangeAreRead) {
  for (const char* text : {"0",
                           "-0",
                           "+0.0",
                           "-0e400",
                           "0e-400",
                           "1e308",
                           "1.7976931348623157e308",
                           "1.7976931348623158e308",
                           "1.7976931348623159e308",
                           "1e309",
                           "-1e309",
                           "1e99999",
                           "1e-99999",
                           "1e99999999999999999999",
                           "1e-99999999999999999999",
                           "4.9e-324",
                           "2.4703282292062327e-324",
                           "2.4703282292062328e-324",
                           "3e-324",
                           "2e-324",
                           "-1e-400",
                           "2.2250738585072011e-308",
                           "2.2250738585072014e-308",
                           "0x1p1023",
                           "0x1p1024",
                           "0x1p-1074",
                           "0x1p-1075",
                           "0x1.000001p-1075",
                           "-0x1p-1076",
                           "0x1p99999999999999999999",
                           "0x1p-99999999999999999999",
                           "0x0p99999999999",
                           ".5",
                           "5.",
                           "+.5e1",
                           "0x.8p1",
                           "0x8.",
                           "00012",
                           "1E5",
                           "0.000000000000000000000000000000000000000000000000000000000000001e70"})
    EXPECT_TRUE(agrees_with_strtod(text));
}

TEST(ParseNumber, MidwayBetweenTheLargestNumberAndOverflowTheLastDigitDecides) {
  // All but the last digit of 2^1024 - 2^970, the least number that overflows; it ends in 2.
  const std::string digits =
      "1797693134862315807937289714053034150799341327100378269361737789804449682927647509466490179775872070963"
      "3028641669288791094655554785194040263065748867150582068190890200070838367627385484581771153176447573027"
      "006985557136695962284291481986083493647529271907416844436551070434271155969950809304288017790417449779";
  EXPECT_TRUE(agrees_with_strtod(digits + "1"));
  EXPECT_EQ(parse_number(digits + "1"), std::numeric_limits<double>::max());
  EXPECT_TRUE(agrees_with_strtod(digits + "2"));
  EXPECT_FALSE(parse_number(digits + "2").has_value());
}

TEST(ParseNumber, ExponentsNearTheRangeOfIntegersAreTooLargeOrTooSmall) {
  for (const char* large : {"1e9223372036854775807", "10e9223372036854775806", "0x1p9223372036854775807",
                            "0x10p9223372036854775806", "1e99999999999999999999"})
    EXPECT_EQ(parse_number(large), std::nullopt) << large;
  for (const char* small :
       {"1e-9223372036854775807", "0.01e-9223372036854775807", "0x.01p-9223372036854775807", "1e-99999999999999999999"})
    EXPECT_EQ(parse_number(small), 0) << small;
}

TEST(ParseNumber, EverythingElseIsRefused) {
  for (const char* text :
       {"",      " ",    "+",  "-",   ".",    "+.",    "--1",     "+-1",    "-+1", "1 ",       " 1",          "1,5",
        "1.5.2", "e5",   "1e", "1e+", "1d5",  "inf",   "-inf",    "nan",    "NaN", "Infinity", "0x",          "0x.",
        "0xg",   "0x-1", "x1", "1f",  "0x1p", "1_000", "0x1.8p+", "nan(1)", "1/2", "1e5.5",    "\xEF\xBC\x91"})
    EXPECT_FALSE(parse_number(text).has_value()) << text;
}

}  // namespace
}  // namespace pcm
