// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pcm/bad_input.h"

namespace pcm::compare {

/// Calls `ask`: with which words it refuses to answer; none where it does not.
template <class Call>
std::string refusal_of(const Call& ask) {
  try {
    ask();
    return {};
  } catch (const BadInput& error) {
    return error.what();
  }
}

}  // namespace pcm::compare
