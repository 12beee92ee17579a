// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace pcm::compare {

/// How far the two sides of an identity may be apart.
enum class Sharpness : std::uint8_t {
  bits,      ///< bit for bit
  rounding,  ///< within what is derived for the rounding of both
  exact,     ///< equal rational numbers
};

struct IdentityResult {
  std::string name;
  std::string statement;
  Sharpness sharpness = Sharpness::bits;
  std::int64_t checks = 0;  ///< comparisons made
  std::int64_t violations = 0;
  double worst = 0;   ///< greatest difference in units of what rounding allows; 0 where it is bit for bit
  std::string first;  ///< the first violation: where, and what

  bool passed() const { return violations == 0 && checks > 0; }
};

}  // namespace pcm::compare
