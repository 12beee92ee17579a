// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/page/page.h"

#include <cassert>
#include <nlohmann/json.hpp>

#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "simulate/page/check_recording.h"
#include "simulate/page/page_data.h"
#include "simulate/page/page_files.h"

namespace pcm::simulate {
namespace {

std::string replaced(std::string_view text, char what, std::string_view by) {
  std::string out;
  for (const char c : text) {
    if (c == what)
      out += by;
    else
      out += c;
  }
  return out;
}

std::string html_text(std::string_view text) {
  return replaced(replaced(replaced(text, '&', "&amp;"), '<', "&lt;"), '>', "&gt;");
}

/// JSON that no HTML parser takes for the end of its script element. Bytes that are no UTF-8 (names are the user's)
/// become U+FFFD.
std::string json_text(const nlohmann::json& data) {
  return replaced(data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), '<', "\\u003c");
}

/// What stands for {{name}} in page.html.
std::string part(std::string_view name, const Recording& recording, const PageFiles& files) {
  if (name == "title") return html_text(recording.title);
  if (name == "css") return std::string{files.css};
  if (name == "data") return json_text(page_data(recording));
  if (name == "three_licence") return std::string{files.three_licence};
  if (name == "three") return std::string{files.three};
  assert(name == "scripts");
  return std::string{files.scripts};
}

void require_three_js(const PageFiles& files) {
  if (files.three.empty()) {
    throw BadInput(
        "this program was built without three.js, which pages with 3D scenes need: install libjs-three (Debian), "
        "configure and build again");
  }
}

}  // namespace

void require_three_js() {
  require_three_js(page_files());
}

std::string page(const Recording& recording, const PageFiles& files) {
  require_three_js(files);
  check_recording(recording);
  // In one pass, so that braces in what is put in mean nothing.
  std::string out;
  std::string_view rest = files.html;
  for (std::size_t begin = rest.find("{{"); begin != rest.npos; begin = rest.find("{{")) {
    const std::size_t end = rest.find("}}", begin);
    assert(end != rest.npos);
    out += rest.substr(0, begin);
    out += part(rest.substr(begin + 2, end - begin - 2), recording, files);
    rest.remove_prefix(end + 2);
  }
  out += rest;
  return out;
}

std::string page(const Recording& recording) {
  return page(recording, page_files());
}

void write_page(const std::filesystem::path& file, const Recording& recording) {
  write_text_file(file, page(recording));
}

}  // namespace pcm::simulate
