// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

#include "pcm/inputs.h"

namespace pcm::compare {

/// What tells one element of an answer, the engine's or the oracle's, from the others, and puts them in order.
using ElementKey = std::tuple<Side, Index, Index>;

template <class Element>
ElementKey key(const Element& e) {
  return {e.master, e.master_face, e.slave_face};
}

}  // namespace pcm::compare
