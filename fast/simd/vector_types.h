// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// Vectors of eight floats or four doubles, for files that are compiled for different instructions: everything here is
// local to the file that includes it, so that no wide instruction leaks out.
#pragma once

#include <cstddef>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace pcm::fast {

namespace {

typedef float Float8 __attribute__((vector_size(32)));
typedef std::int32_t Int8 __attribute__((vector_size(32)));
typedef double Double4 __attribute__((vector_size(32)));
typedef std::int64_t Long4 __attribute__((vector_size(32)));

/// One vector of space a lane.
template <class Numbers>
struct WideVector {
  Numbers x, y, z;
};

/// What lies in `memory`, lane by lane; it must be as large.
template <class Numbers, class Memory>
inline Numbers load_lanes(const Memory& memory) {
  static_assert(sizeof memory == sizeof(Numbers));
  Numbers result;
  __builtin_memcpy(&result, &memory, sizeof result);
  return result;
}

inline Float8 absolute(Float8 a) {
  return load_lanes<Float8>(load_lanes<Int8>(a) & 0x7fffffff);
}
inline Double4 absolute(Double4 a) {
  return load_lanes<Double4>(load_lanes<Long4>(a) & 0x7fffffffffffffff);
}

/// Bit i: lane i is true.
inline std::uint32_t lanes_of(Int8 condition) {
#if defined(__AVX__)
  return static_cast<std::uint32_t>(_mm256_movemask_ps(load_lanes<__m256>(condition)));
#elif defined(__SSE2__)
  __m128 halves[2];
  __builtin_memcpy(halves, &condition, sizeof halves);
  return static_cast<std::uint32_t>(_mm_movemask_ps(halves[0]) | (_mm_movemask_ps(halves[1]) << 4));
#else
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= static_cast<std::uint32_t>(condition[i] & 1) << i;
  return bits;
#endif
}
inline std::uint32_t lanes_of(Long4 condition) {
#if defined(__AVX__)
  return static_cast<std::uint32_t>(_mm256_movemask_pd(load_lanes<__m256d>(condition)));
#elif defined(__SSE2__)
  __m128d halves[2];
  __builtin_memcpy(halves, &condition, sizeof halves);
  return static_cast<std::uint32_t>(_mm_movemask_pd(halves[0]) | (_mm_movemask_pd(halves[1]) << 2));
#else
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= static_cast<std::uint32_t>(condition[i] & 1) << i;
  return bits;
#endif
}

template <class Numbers>
inline WideVector<Numbers> operator+(const WideVector<Numbers>& a, const WideVector<Numbers>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Numbers>
inline WideVector<Numbers> operator-(const WideVector<Numbers>& a, const WideVector<Numbers>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// `factor`: one for all lanes, or one each.
template <class Factor, class Numbers>
inline WideVector<Numbers> operator*(const Factor& factor, const WideVector<Numbers>& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
template <class Numbers>
inline Numbers dot(const WideVector<Numbers>& a, const WideVector<Numbers>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
template <class Numbers>
inline WideVector<Numbers> cross(const WideVector<Numbers>& a, const WideVector<Numbers>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Where `condition` a, else b.
template <class Condition, class Numbers>
inline WideVector<Numbers> choice(const Condition& condition, const WideVector<Numbers>& a,
                                  const WideVector<Numbers>& b) {
  return {condition ? a.x : b.x, condition ? a.y : b.y, condition ? a.z : b.z};
}

}  // namespace

}  // namespace pcm::fast
