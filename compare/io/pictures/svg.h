// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What our SVG pictures share: the document, its sizes, and text.
namespace pcm::compare {

// Lengths in pixels.
inline constexpr double kMargin = 24;
inline constexpr double kTitleSize = 19, kHeadingSize = 14, kTextSize = 12.5;
inline constexpr double kLine = 17;  ///< from one line of text to the next

inline constexpr const char* kBlack = "#222222";

/// A picture of this size on white, black where nothing else is said; `drawn` are its elements.
std::string svg_document(double width, double height, std::string_view title, std::string_view description,
                         std::string_view drawn);

/// How many characters of size kTextSize about fill this width.
std::size_t characters_in(double width);

/// Words broken at blanks into lines of at most so many characters (a longer word stands alone); UTF-8.
std::vector<std::string> wrapped(std::string_view words, std::size_t most);

/// Text as XML takes it: bytes that are no UTF-8 and control characters are replaced, each by U+FFFD.
std::string escaped(std::string_view text);

}  // namespace pcm::compare
