// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/contact.h"

#include <utility>

namespace pcm::fast {

void Contact::clear() {
  Contact empty;
  const auto keep = [](auto& list, auto& memory) {
    memory.clear();
    list.swap(memory);
  };
  keep(empty.crossings, crossings);
  keep(empty.polygons, polygons);
  keep(empty.elements, elements);
  keep(empty.E.intersected, E.intersected);
  keep(empty.E.inner, E.inner);
  keep(empty.F.intersected, F.intersected);
  keep(empty.F.inner, F.inner);
  *this = std::move(empty);
}

}  // namespace pcm::fast
