// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstring>
#include <string>

#include "bindings/c/guard.h"

/// Structs that begin with their size, so that they can grow at their ends: the caller may know less of one than the
/// library, which then reads and writes no more than that.
namespace pcm::c {

/// Of the struct in ABI version 1. Nobody knows less of it.
template <class T>
inline constexpr std::size_t kFirstSize = 0;
template <>
inline constexpr std::size_t kFirstSize<pcm_law> = offsetof(pcm_law, reserved) + sizeof(std::int32_t);
template <>
inline constexpr std::size_t kFirstSize<pcm_answer> = offsetof(pcm_answer, statistics) + sizeof(pcm_statistics);

/// How much of it the caller knows, in bytes. Throws BadCall where nobody can know so much, or so little.
template <class T>
std::size_t known_size(std::size_t size, const char* name) {
  static_assert(kFirstSize<T> > 0 && kFirstSize<T> <= sizeof(T));
  if (size < kFirstSize<T> || size > sizeof(T)) {
    throw BadCall(std::string(name) + ": its size is " + std::to_string(size) + " bytes, where this library knows " +
                  std::to_string(kFirstSize<T>) + " to " + std::to_string(sizeof(T)) +
                  "; set it to sizeof, and use no library older than the header");
  }
  return size;
}

/// What the caller says, and the default for what the caller does not know of.
template <class T>
T read_sized(const T* from, const T& defaults, const char* name) {
  T all = defaults;
  std::memcpy(&all, from, known_size<T>(given(from, name).size, name));
  return all;
}

/// Writes what the caller knows of; the size stays the caller's.
template <class T>
void write_sized(T value, std::size_t size, T* to) {
  value.size = size;
  std::memcpy(to, &value, size);
}

}  // namespace pcm::c
