// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcm::compare {

/// What keeps a text from being well-formed XML, as far as the program writes it (elements, attributes in double
/// quotes, the five entities; no comments); empty where nothing does.
inline std::string fault_in_xml(std::string_view xml) {
  std::vector<std::string_view> open;
  bool had_root = false;
  if (xml.substr(0, 5) == "<?xml") xml.remove_prefix(xml.find("?>") + 2);
  while (!xml.empty()) {
    const std::string_view words = xml.substr(0, xml.find('<'));
    for (std::size_t at = words.find('&'); at != std::string_view::npos; at = words.find('&', at + 1)) {
      bool known = false;
      for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"})
        known = known || words.substr(at).substr(0, std::string_view(entity).size()) == entity;
      if (!known) return "unknown entity: " + std::string(words.substr(at, 10));
    }
    if (open.empty() && words.find_first_not_of(" \n") != std::string_view::npos) return "text outside the root";
    xml.remove_prefix(words.size());
    if (xml.empty()) break;
    // The end of the tag is the first > that stands in no quotes.
    std::size_t end = 1;
    bool quoted = false;
    for (; end < xml.size() && (quoted || xml[end] != '>'); ++end) {
      if (xml[end] == '"') quoted = !quoted;
      if (xml[end] == '<') return "< in a tag: " + std::string(xml.substr(0, end + 1));
    }
    if (end == xml.size()) return "a tag without end: " + std::string(xml.substr(0, 40));
    std::string_view tag = xml.substr(1, end - 1);
    xml.remove_prefix(end + 1);
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "closed but not open: " + std::string(tag);
      open.pop_back();
      continue;
    }
    if (open.empty() && had_root) return "a second root";
    had_root = true;
    if (tag.back() != '/') open.push_back(tag.substr(0, tag.find(' ')));
  }
  if (!had_root) return "no root";
  return open.empty() ? "" : "never closed: " + std::string(open.back());
}

}  // namespace pcm::compare
