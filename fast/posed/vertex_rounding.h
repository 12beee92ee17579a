// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "fast/surface/prepared_surface.h"
#include "pcm/inputs.h"

namespace pcm::fast {

/// Unit roundoff: |fl(x op y) - (x op y)| <= kUnitRoundoff |x op y|.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// Bounds are sums, products and quotients of numbers that are not negative, k roundings deep, so the computed bound
/// is at least (1 - u)^k of itself; and written with n u in place of gamma_n = n u / (1 - n u). Multiplying by this
/// once pays for both up to k + n = 2^32, more than any sum over faces of 32-bit indices reaches.
inline constexpr double kSafetyFactor = 1 + 0x1p-20;

/// A bound on |fl(A x + r) - (A x + r)|, component by component, that holds for every vertex of F, m: how far the
/// rounded problem's vertices are from the exact problem's (PCM section 1). E's vertices are the same in both.
///
/// Order of operations: products first (u each), then (first + second), + third, + r_i, each off by u times its result.
/// With B_j = |a_ij| max_coordinates_j the first and the second product are part of three sums, the third of two, r of
/// one: u (4 B_1 + 4 B_2 + 3 B_3 + |r_i|). Three products may underflow, erring by 2^-1075 each.
inline Eigen::Vector3d greatest_vertex_rounding(const PreparedSurface& surface_F, const Pose& pose) {
  const Eigen::Vector3d& max_coordinates = surface_F.max_coordinates;
  Eigen::Vector3d bound;
  for (int i = 0; i < 3; ++i) {
    const double B_1 = std::abs(pose.A(i, 0)) * max_coordinates[0];
    const double B_2 = std::abs(pose.A(i, 1)) * max_coordinates[1];
    const double B_3 = std::abs(pose.A(i, 2)) * max_coordinates[2];
    bound[i] = kSafetyFactor * kUnitRoundoff * (4 * (B_1 + B_2) + 3 * B_3 + std::abs(pose.r[i])) + 0x1p-1072;
  }
  return bound;
}

/// The same for one vertex: each of the six operations that round is off by at most u times its computed result, and
/// the errors only add up.
inline Eigen::Vector3d vertex_rounding(const Pose& pose, const Eigen::Vector3d& x_Mf) {
  Eigen::Vector3d bound;
  for (int i = 0; i < 3; ++i) {
    const double first = pose.A(i, 0) * x_Mf[0], second = pose.A(i, 1) * x_Mf[1], third = pose.A(i, 2) * x_Mf[2];
    const double two = first + second, three = two + third, all = three + pose.r[i];
    bound[i] =
        kSafetyFactor * kUnitRoundoff *
            (std::abs(first) + std::abs(second) + std::abs(two) + std::abs(third) + std::abs(three) + std::abs(all)) +
        0x1p-1072;
  }
  return bound;
}

/// What a sum of two numbers rounds off, exactly (Knuth).
inline double rounded_off(double a, double b, double sum) {
  const double b_part = sum - a;
  return (a - (sum - b_part)) + (b - b_part);
}

/// The same for one vertex, sharp: what each operation rounds off is itself a floating-point number (Dekker 1971),
/// so that their sum is known but for its own roundings. Products that underflow err by 2^-1074 each.
inline Eigen::Vector3d sharp_vertex_rounding(const Pose& pose, const Eigen::Vector3d& x_Mf) {
  Eigen::Vector3d bound;
  for (int i = 0; i < 3; ++i) {
    const double first = pose.A(i, 0) * x_Mf[0], second = pose.A(i, 1) * x_Mf[1], third = pose.A(i, 2) * x_Mf[2];
    const double two = first + second, three = two + third, all = three + pose.r[i];
    const std::array<double, 6> off{std::fma(pose.A(i, 0), x_Mf[0], -first), std::fma(pose.A(i, 1), x_Mf[1], -second),
                                    std::fma(pose.A(i, 2), x_Mf[2], -third), rounded_off(first, second, two),
                                    rounded_off(two, third, three),          rounded_off(three, pose.r[i], all)};
    double sum = 0, size = 0;
    for (const double part : off) {
      sum += part;
      size += std::abs(part);
    }
    bound[i] = kSafetyFactor * (std::abs(sum) + 8 * kUnitRoundoff * size) + 0x1p-1072;
  }
  return bound;
}

/// And for the vertices of one face of F, by `vertex_rounding`, which is not sharp: the greatest of the three.
inline Eigen::Vector3d face_rounding(const PreparedSurface& surface_F, const Pose& pose, Index face) {
  const Triangle& t = surface_F.face(face);
  return vertex_rounding(pose, surface_F.vertex(t[0]))
      .cwiseMax(vertex_rounding(pose, surface_F.vertex(t[1])))
      .cwiseMax(vertex_rounding(pose, surface_F.vertex(t[2])));
}

}  // namespace pcm::fast
