// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/pictures/svg.h"

#include <fmt/core.h>

#include <algorithm>

#include "compare/io/characters_in.h"
#include "pcm/utf8_character.h"

namespace pcm::compare {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// How many bytes the character has that the text, which is not empty, begins with; 0 where these bytes are no UTF-8 or
/// no character that XML 1.0 takes.
std::size_t size_of_xml_character(std::string_view text) {
  const auto [code, size] = first_character(text);
  const bool is_control = code < 0x20 && code != '\t' && code != '\n' && code != '\r';
  return is_control || code == 0xFFFE || code == 0xFFFF ? 0 : size;
}

}  // namespace

std::string svg_document(double width, double height, std::string_view title, std::string_view description,
                         std::string_view drawn) {
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>)"
                     "\n"
                     R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
                     R"(viewBox="0 0 {0:.0f} {1:.0f}" font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif" )"
                     R"(fill="{2}" role="img">)"
                     "\n<title>{3}</title>\n<desc>{4}</desc>\n"
                     R"(<rect width="100%" height="100%" fill="#ffffff"/>)"
                     "\n{5}</svg>\n",
                     width, height, kBlack, escaped(title), escaped(description), drawn);
}

std::size_t characters_in(double width) {
  constexpr double kCharacter = 6.7;  // Mean width in a wide sans-serif.
  return static_cast<std::size_t>(width / kCharacter);
}

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t size = size_of_xml_character(text);
    const std::string_view character = text.substr(0, size);
    if (size == 0)
      out += kReplacement;
    else if (character == "&")
      out += "&amp;";
    else if (character == "<")
      out += "&lt;";
    else if (character == ">")
      out += "&gt;";
    else if (character == "\"")
      out += "&quot;";
    else
      out += character;
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

std::vector<std::string> wrapped(std::string_view words, std::size_t most) {
  std::vector<std::string> paragraph;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    if (word.empty()) continue;
    if (paragraph.empty() || characters_in(paragraph.back()) + 1 + characters_in(word) > most)
      paragraph.emplace_back(word);
    else
      paragraph.back() += ' ' + std::string(word);
  }
  return paragraph;
}

}  // namespace pcm::compare
