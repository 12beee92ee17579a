// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "pcm/inputs.h"

namespace pcm::compare {

/// What tells one element of an answer, the engine's or the oracle's, from the others, and puts them in order.
using ElementKey = std::tuple<Side, Index, Index>;

template <class Element>
ElementKey key(const Element& e) {
  return {e.master, e.master_face, e.slave_face};
}

/// Whether both have the same elements in the same order.
template <class A, class B>
bool same_elements(const std::vector<A>& a, const std::vector<B>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const A& x, const B& y) { return key(x) == key(y); });
}

}  // namespace pcm::compare
