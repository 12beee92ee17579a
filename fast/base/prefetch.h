// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcm::fast {

/// Asks for an object that is soon read to be brought into the caches meanwhile. Changes no value.
template <class T>
void prefetch(const T& object) {
  constexpr std::size_t kCacheLine = 64;
  const char* const first = reinterpret_cast<const char*>(&object);
  for (std::size_t at = 0; at < sizeof(T); at += kCacheLine) __builtin_prefetch(first + at);
}

}  // namespace pcm::fast
