// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pcm {

/// A character of UTF-8.
struct Utf8Character {
  std::uint32_t code = 0;  ///< its number in Unicode; 0 where there is none
  std::size_t size = 0;    ///< bytes; 0 where there is none
};

/// The one that the text, which is not empty, begins with (RFC 3629: neither surrogates nor longer forms than needed).
inline Utf8Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return std::uint32_t{static_cast<unsigned char>(text[k])}; };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return {first, 1};
  if (first < 0xC0 || first >= 0xF8) return {};
  const std::size_t size = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < size) return {};
  std::uint32_t code = first & (0x7FU >> size);
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(k) & 0x3F);
  }
  const std::uint32_t least = size == 2 ? 0x80 : size == 3 ? 0x800 : 0x10000;  // a smaller one takes fewer bytes
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least || code > 0x10FFFF || is_surrogate) return {};
  return {code, size};
}

/// Whether a line of text has no place for it: no character at all, a control character, or what ends a line.
inline bool has_no_place_in_a_line(const Utf8Character& character) {
  const std::uint32_t code = character.code;
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool ends_line = code == 0x2028 || code == 0x2029;
  return character.size == 0 || is_control || ends_line;
}

}  // namespace pcm
