// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// Lanes as vectors of four doubles, for files that are compiled for different instructions: everything here is local to
// the file that includes it, so that no wide instruction leaks out.
#pragma once

#include "fast/simd/elements.h"
#include "fast/simd/vector_types.h"

namespace pcm::fast {

namespace {

using Vector4 = WideVector<Double4>;

inline Double4 load(const DoubleLanes& lanes) {
  return load_lanes<Double4>(lanes.value);
}
inline Vector4 load(const VectorLanes& lanes) {
  return {load(lanes.component[0]), load(lanes.component[1]), load(lanes.component[2])};
}
inline Vector4 load(const std::array<const double*, kElementLanes>& points) {
  const auto component = [&points](std::size_t k) {
    return Double4{points[0][k], points[1][k], points[2][k], points[3][k]};
  };
  return {component(0), component(1), component(2)};
}
inline void store(const Double4& value, DoubleLanes& lanes) {
  __builtin_memcpy(lanes.value.data(), &value, sizeof value);
}
inline void store(const Vector4& v, VectorLanes& lanes) {
  store(v.x, lanes.component[0]);
  store(v.y, lanes.component[1]);
  store(v.z, lanes.component[2]);
}
inline Double4 four(double value) {
  return Double4{value, value, value, value};
}
inline Vector4 four(const std::array<double, 3>& v) {
  return {four(v[0]), four(v[1]), four(v[2])};
}
inline Double4 greatest(const Double4& a, const Double4& b) {
  return a < b ? b : a;
}
inline Double4 least(const Double4& a, const Double4& b) {
  return b < a ? b : a;
}
inline Double4 root(Double4 a) {
#if defined(__AVX__)
  __m256d vector;
  __builtin_memcpy(&vector, &a, sizeof vector);
  vector = _mm256_sqrt_pd(vector);
  __builtin_memcpy(&a, &vector, sizeof vector);
#elif defined(__SSE2__)
  __m128d halves[2];
  __builtin_memcpy(halves, &a, sizeof halves);
  for (__m128d& half : halves) half = _mm_sqrt_pd(half);
  __builtin_memcpy(&a, halves, sizeof halves);
#else
  for (std::size_t i = 0; i < kElementLanes; ++i) a[i] = __builtin_sqrt(a[i]);
#endif
  return a;
}
inline Vector4 operator-(const Vector4& a) {
  return {-a.x, -a.y, -a.z};
}
inline Vector4 operator/(const Vector4& a, const Double4& divisor) {
  return {a.x / divisor, a.y / divisor, a.z / divisor};
}
inline Double4 norm_1(const Vector4& a) {
  return (absolute(a.x) + absolute(a.y)) + absolute(a.z);
}

}  // namespace

}  // namespace pcm::fast
