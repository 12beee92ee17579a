// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "pcm/inputs.h"

/// The words by which tables and options call the inputs' choices.
namespace pcm::compare {

inline std::string_view name(Side side) {
  return side == Side::E ? "E" : "F";
}

inline std::string_view name(Mode mode) {
  return mode == Mode::E ? "E" : mode == Mode::F ? "F" : "both";
}

inline std::string_view name(Scheme scheme) {
  return scheme == Scheme::barycentric ? "barycentric" : "clipped";
}

inline std::string_view name(DampingMode mode) {
  return mode == DampingMode::no_tension ? "no-tension" : mode == DampingMode::full ? "full" : "compression";
}

/// The other way round, of words that an option allows.
inline Mode mode_named(std::string_view word) {
  if (word == "F") return Mode::F;
  return word == "both" ? Mode::both : Mode::E;
}

inline Scheme scheme_named(std::string_view word) {
  return word == "clipped" ? Scheme::clipped : Scheme::barycentric;
}

}  // namespace pcm::compare
