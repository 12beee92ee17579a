// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/dynamics.h"

#include <cmath>

namespace pcm::compare {

double DynamicAnswer::relative_error() const {
  return std::abs(computed / expected - 1);
}

}  // namespace pcm::compare
