// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/utf8_character.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pcm {
namespace {

/// In memory of its own without a byte behind it, so that a sanitizer sees what reads on.
Utf8Character first_of(std::string_view bytes) {
  const std::vector<char> alone(bytes.begin(), bytes.end());
  return first_character({alone.data(), alone.size()});
}

TEST(Utf8Character, OfEveryLengthFromTheLeastToTheGreatest) {
  struct Case {
    std::string_view bytes;
    std::uint32_t code;
  };
  for (const auto& [bytes, code] :
       {Case{std::string_view("\0", 1), 0}, Case{"\x7F", 0x7F}, Case{"\xC2\x80", 0x80}, Case{"\xDF\xBF", 0x7FF},
        Case{"\xE0\xA0\x80", 0x800}, Case{"\xED\x9F\xBF", 0xD7FF}, Case{"\xEE\x80\x80", 0xE000},
        Case{"\xEF\xBF\xBF", 0xFFFF}, Case{"\xF0\x90\x80\x80", 0x10000}, Case{"\xF4\x8F\xBF\xBF", 0x10FFFF}}) {
    SCOPED_TRACE(code);
    EXPECT_EQ(first_of(bytes).code, code);
    EXPECT_EQ(first_of(bytes).size, bytes.size());
    EXPECT_EQ(first_of(std::string(bytes) + "\x80 and more").size, bytes.size());
    for (std::size_t size = 1; size < bytes.size(); ++size) EXPECT_EQ(first_of(bytes.substr(0, size)).size, 0U) << size;
  }
}

TEST(Utf8Character, IsNoneWhereTheBytesAreNoUtf8) {
  for (const std::string_view bytes :
       {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF8\x90\x80\x80", "\xFF\xBF\xBF\xBF", "\xC3(", "\xE2\x82(", "\xF0\x9F\x98("})
    EXPECT_EQ(first_of(bytes).size, 0U) << testing::PrintToString(bytes);
}

TEST(Utf8Character, HasNoPlaceInALineWhereItControlsOrEndsOne) {
  for (const std::string_view bytes :
       {"\n", "\t", "\x1F", "\x7F", "\xC2\x80", "\xC2\x85", "\xC2\x9F", "\xE2\x80\xA8", "\xE2\x80\xA9", "\xFF"})
    EXPECT_TRUE(has_no_place_in_a_line(first_of(bytes))) << testing::PrintToString(bytes);
  for (const std::string_view bytes : {" ", "~", "\xC2\xA0", "\xE2\x80\xA7", "\xE2\x80\xAA", "\xF0\x9F\x98\x80"})
    EXPECT_FALSE(has_no_place_in_a_line(first_of(bytes))) << testing::PrintToString(bytes);
}

}  // namespace
}  // namespace pcm
