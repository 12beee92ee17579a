// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/c/guard.h"

#include <algorithm>

namespace pcm::c {

namespace {

/// Whether a byte of UTF-8 goes on with a character that another one begins.
bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

}  // namespace

void write_error(pcm_error* error, std::string_view text) noexcept {
  if (error == nullptr) return;
  std::size_t length = std::min(text.size(), sizeof error->text - 1);
  if (length < text.size())
    while (length > 0 && continues_character(text[length])) --length;
  std::copy_n(text.data(), length, error->text);
  error->text[length] = '\0';
}

}  // namespace pcm::c
