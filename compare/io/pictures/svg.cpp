// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/pictures/svg.h"

#include <fmt/core.h>

#include <algorithm>

namespace pcm::compare {

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
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::vector<std::string> wrapped(std::string_view words, std::size_t most) {
  // The bytes of a UTF-8 character but its first are 10xxxxxx.
  const auto characters = [](std::string_view s) {
    return static_cast<std::size_t>(std::count_if(s.begin(), s.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  };
  std::vector<std::string> paragraph;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    if (word.empty()) continue;
    if (paragraph.empty() || characters(paragraph.back()) + 1 + characters(word) > most)
      paragraph.emplace_back(word);
    else
      paragraph.back() += ' ' + std::string(word);
  }
  return paragraph;
}

}  // namespace pcm::compare
