// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/c/guard.h"

#include <algorithm>
#include <string>

#include "meshes/base/utf8_character.h"

namespace pcm::c {

namespace {

/// One line of UTF-8: a `?` for each control character and for each byte of what is none, as a path may hold.
std::string printable(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const auto [code, size] = first_character(text);
    const bool is_control = code < 0x20 || code == 0x7F;
    if (is_control)
      line += '?';
    else
      line += text.substr(0, size);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return line;
}

/// Whether a byte of UTF-8 goes on with a character that another one begins.
bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

/// No longer than this, with its middle left out: a path goes before the reason, and may be the longer of the two.
std::string shortened(const std::string& line, std::size_t greatest) {
  if (line.size() <= greatest) return line;
  static constexpr std::string_view kLeftOut = " [...] ";
  std::size_t head = greatest / 3, tail = line.size() - (greatest - head - kLeftOut.size());
  while (head > 0 && continues_character(line[head])) --head;
  while (tail < line.size() && continues_character(line[tail])) ++tail;
  return line.substr(0, head) + std::string(kLeftOut) + line.substr(tail);
}

}  // namespace

void write_error(pcm_error* error, std::string_view text) noexcept {
  if (error == nullptr) return;
  constexpr std::size_t kGreatest = sizeof error->text - 1;
  std::size_t length = std::min(text.size(), kGreatest);
  try {
    const std::string line = shortened(printable(text), kGreatest);
    length = line.copy(error->text, kGreatest);
  } catch (...) {  // no memory for the copies: as it is
    text.copy(error->text, length);
  }
  error->text[length] = '\0';
}

}  // namespace pcm::c
