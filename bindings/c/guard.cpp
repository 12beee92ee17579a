// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/c/guard.h"

#include <algorithm>

#include "pcm/utf8_character.h"

namespace pcm::c {

namespace {

/// The text in pieces that are whole characters of one line: a `?` for what has no place there, as in paths.
template <class Action>
void for_each_piece(std::string_view text, const Action& action) {
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    action(has_no_place_in_a_line(character) ? std::string_view("?") : text.substr(0, character.size));
    text.remove_prefix(std::max<std::size_t>(character.size, 1));
  }
}

}  // namespace

void write_error(pcm_error* error, std::string_view text) noexcept {
  if (error == nullptr) return;
  constexpr std::size_t kGreatest = sizeof error->text - 1;
  constexpr std::string_view kLeftOut = " [...] ";
  std::size_t whole = 0;
  for_each_piece(text, [&whole](std::string_view piece) { whole += piece.size(); });
  // A path goes before the reason, and may be the longer of the two: the middle is left out.
  const bool fits = whole <= kGreatest;
  const std::size_t head = fits ? whole : kGreatest / 3;
  const std::size_t tail = fits ? whole : whole - (kGreatest - head - kLeftOut.size());
  char* out = error->text;
  const auto append = [&out](std::string_view piece) { out = std::copy(piece.begin(), piece.end(), out); };
  std::size_t at = 0;
  bool left_out = false;
  for_each_piece(text, [&](std::string_view piece) {
    if (at + piece.size() <= head || at >= tail) {
      append(piece);
    } else if (!left_out) {
      left_out = true;
      append(kLeftOut);
    }
    at += piece.size();
  });
  *out = '\0';
}

}  // namespace pcm::c
