// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/files/parse_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "meshes/base/floating_point_environment.h"

namespace pcm {
namespace {

bool is_hexadecimal_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// Whether a well-formed unsigned number that doesn't fit a double is too small rather than too large: the exponent of
/// its first significant digit tells, for only numbers far from 1 don't fit.
bool is_too_small(std::string_view digits, bool hexadecimal) {
  const std::size_t mark = digits.find_first_of(hexadecimal ? "pP" : "eE");
  const std::string_view mantissa = digits.substr(0, mark);
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));
  const auto leading = static_cast<std::int64_t>(std::min(mantissa.find_first_not_of("0."), mantissa.size()));
  std::int64_t order = (point - leading) * (hexadecimal ? 4 : 1);
  if (mark != std::string_view::npos) {
    std::string_view exponent = digits.substr(mark + 1);
    const bool negative = exponent.starts_with('-');
    if (negative || exponent.starts_with('+')) exponent.remove_prefix(1);
    std::int64_t value = 0;
    const auto result = std::from_chars(exponent.data(), exponent.data() + exponent.size(), value);
    if (result.ec == std::errc::result_out_of_range) return negative;
    // No text is so long that its point could make up for more.
    constexpr std::int64_t kGreatest = std::int64_t{1} << 62;
    order += negative ? -std::min(value, kGreatest) : std::min(value, kGreatest);
  }
  return order < 0;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const DefaultFloatingPoint environment;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);

  // What follows the sign must be a digit, or a point and a digit: no second sign, "inf" or "nan".
  const std::string_view start = text.starts_with('.') ? text.substr(1) : text;
  if (start.empty()) return std::nullopt;
  const bool digit = hexadecimal ? is_hexadecimal_digit(start[0]) : start[0] >= '0' && start[0] <= '9';
  if (!digit) return std::nullopt;

  double magnitude = 0;
  const char* end = text.data() + text.size();
  const auto result =
      std::from_chars(text.data(), end, magnitude, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (result.ptr != end) return std::nullopt;
  if (result.ec == std::errc::result_out_of_range) {
    if (!is_too_small(text, hexadecimal)) return std::nullopt;
    magnitude = 0;
  } else if (result.ec != std::errc() || !std::isfinite(magnitude)) {
    return std::nullopt;
  }
  return negative ? -magnitude : magnitude;
}

}  // namespace pcm
