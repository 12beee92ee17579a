// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/pictures/svg.h"

#include <gtest/gtest.h>

#include <string>

namespace pcm::compare {
namespace {

const std::string kReplaced = "\xEF\xBF\xBD";

TEST(Svg, TextThatXmlTakesIsLeftAsItIs) {
  EXPECT_EQ(escaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  // Characters of one byte to four, the last before and the first after what is left out.
  for (const char* text : {"\t\n\r ~", "\xC2\x80", "\xC3\xA4", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                           "\xEF\xBF\xBD", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(escaped(text), text);
}

TEST(Svg, ControlCharactersAreReplaced) {
  EXPECT_EQ(escaped(std::string("a\0b", 3)), "a" + kReplaced + "b");
  for (const char* control : {"\x01", "\x08", "\x0B", "\x1B", "\x1F"}) EXPECT_EQ(escaped(control), kReplaced);
}

TEST(Svg, BytesThatAreNoUtf8AreReplacedOneByOne) {
  EXPECT_EQ(escaped("\xE4rger"), kReplaced + "rger") << "Latin-1";
  EXPECT_EQ(escaped("\x80"
                    "a"),
            kReplaced + "a")
      << "no first byte";
  EXPECT_EQ(escaped("\xFF"), kReplaced);
  EXPECT_EQ(escaped("\xF8"), kReplaced);
  EXPECT_EQ(escaped("\xC3"), kReplaced) << "cut off";
  EXPECT_EQ(escaped("\xE2\x82<"), kReplaced + kReplaced + "&lt;") << "cut off within";
  EXPECT_EQ(escaped("\xC0\xBC"), kReplaced + kReplaced) << "< in too many bytes";
  EXPECT_EQ(escaped("\xE0\x9F\xBF"), kReplaced + kReplaced + kReplaced) << "in too many bytes";
  EXPECT_EQ(escaped("\xED\xA0\x80"), kReplaced + kReplaced + kReplaced) << "half of a pair of UTF-16";
  EXPECT_EQ(escaped("\xEF\xBF\xBE"), kReplaced + kReplaced + kReplaced) << "U+FFFE is no character";
  EXPECT_EQ(escaped("\xF4\x90\x80\x80"), kReplaced + kReplaced + kReplaced + kReplaced) << "beyond Unicode";
}

}  // namespace
}  // namespace pcm::compare
