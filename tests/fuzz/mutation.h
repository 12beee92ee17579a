// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace pcm::fuzz {

/// Words that readers look for, and numbers at the ends of what they take.
inline constexpr std::array<std::string_view, 24> kWords = {
    "v ",        "f ",  "OFF\n", "#",  "\\\n",       "\r",         "\xef\xbb\xbf", "1e308", "-1e400",
    "0x1p-1074", "nan", "inf",   "-0", "2147483648", "-1",         "//",           "1/1/1", "{",
    "}",         "[]",  "null",  "\"", ",",          "0x1.8p+1023"};

/// One to six small changes: bytes flipped, inserted, removed, repeated, a word put in, a part of another input.
inline std::string mutate(std::string text, std::span<const std::string> others, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); };
  for (std::size_t change = 1 + below(6); change > 0; --change) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(1 + below(16), text.size() - at);
    switch (below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        text.insert(at, 1, static_cast<char>(below(256)));
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(below(text.size() + 1), text.substr(at, length));
        break;
      case 4:
        text.insert(at, kWords[below(kWords.size())]);
        break;
      default: {
        const std::string& other = others[below(others.size())];
        const std::size_t from = below(other.size() + 1);
        text.replace(at, length, other, from, 1 + below(32));
      }
    }
  }
  return text;
}

}  // namespace pcm::fuzz
