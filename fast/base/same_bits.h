// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>

#include "pcm/inputs.h"

/// Whether two values are the same doubles, zeros' signs included: whatever is computed from one of them has the bits
/// that it has from the other.
namespace pcm::fast {

inline bool same_bits(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are meant
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}
inline bool same_bits(const Pose& a, const Pose& b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are meant
  return std::memcmp(a.A.data(), b.A.data(), 9 * sizeof(double)) == 0 && same_bits(a.r, b.r);
}
inline bool same_bits(const Velocity& a, const Velocity& b) {
  return same_bits(a.v, b.v) && same_bits(a.w, b.w);
}

}  // namespace pcm::fast
