// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of elements' forces, four at a time, for files that are compiled for different instructions: everything
// here is local to the file that includes it, so that no wide instruction leaks out. What is summed is derived in
// fast/force/tangent_sum.h.
#pragma once

#include "fast/law/element_force.h"
#include "fast/simd/element_vectors.h"
#include "fast/simd/elements.h"

namespace pcm::fast {

namespace {

/// (11): the slave's face moves by d, so u_k grows by d . N_f / (n_k . N_f).
void find_gradient(ElementLanes& lanes) {
  const Vector4 f0 = load(lanes.slave_corners[0]);
  const Vector4 N_f = cross(load(lanes.slave_corners[1]) - f0, load(lanes.slave_corners[2]) - f0);
  const Double4 slope = -dot(load(lanes.n_Me), N_f);
  const Vector4 gradient = N_f / slope;
  // Not where roundings have left nothing of the angle between the faces.
  const Long4 known = (slope > four(0)) & (norm_1(gradient) <= four(0x1.fffffffffffffp1023));
  const Vector4 none{four(0), four(0), four(0)};
  store(choice(known, gradient, none), lanes.depth_gradient_Me);
}

/// A vector's components, to be counted through.
struct Components {
  Double4 of[3];

  explicit Components(const Vector4& v) : of{v.x, v.y, v.z} {}
  const Double4& operator[](std::size_t i) const { return of[i]; }
};

/// sum += a b^T.
inline void add_product(const Components& a, const Components& b, MatrixLanes& sum) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) store(load(sum[3 * i + j]) + a[i] * b[j], sum[3 * i + j]);
}

/// sum += a b^T + c d^T.
inline void add_products(const Components& a, const Components& b, const Components& c, const Components& d,
                         MatrixLanes& sum) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) store(load(sum[3 * i + j]) + (a[i] * b[j] + c[i] * d[j]), sum[3 * i + j]);
}

/// sum += diagonal.
inline void add_diagonal(const Double4& diagonal, MatrixLanes& sum) {
  for (std::size_t i = 0; i < 3; ++i) store(load(sum[4 * i]) + diagonal, sum[4 * i]);
}

/// sum += the matrix of (a x).
inline void add_cross(const Components& a, MatrixLanes& sum) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    store(load(sum[3 * k + j]) + a[i], sum[3 * k + j]);
    store(load(sum[3 * j + k]) - a[i], sum[3 * j + k]);
  }
}

/// sum += the matrix of a x (b x), a and b being parallel: by no difference of squares.
inline void add_cross_of_cross(const Components& a, const Components& b, MatrixLanes& sum) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    store(load(sum[4 * i]) - (a[j] * b[j] + a[k] * b[k]), sum[4 * i]);
    store(load(sum[3 * i + j]) + a[i] * b[j], sum[3 * i + j]);
    store(load(sum[3 * i + k]) + a[i] * b[k], sum[3 * i + k]);
  }
}

inline Long4 chosen(LaneBits which) {
  const auto lane = [which](unsigned i) { return -static_cast<std::int64_t>(which >> i & 1U); };
  return Long4{lane(0), lane(1), lane(2), lane(3)};
}

void add_tangent(const ElementLanes& lanes, const ForceLimits& limits, LaneBits which, TangentLanes& sums) {
  // Lanes without an element add nothing, whatever is in them.
  const Long4 used = chosen(which);
  const Double4 zero = four(0);
  const Vector4 nothing{zero, zero, zero};
  const auto number = [&](const DoubleLanes& x) -> Double4 { return used ? load(x) : zero; };
  const auto vector = [&](const VectorLanes& x) { return choice(used, load(x), nothing); };
  const Vector4 n = -vector(lanes.n_Me), gradient = vector(lanes.depth_gradient_Me), force = vector(lanes.force_Me);
  const Double4 depth = number(lanes.depth), v_n = number(lanes.normal_velocity),
                v_t = number(lanes.tangential_velocity);
  const Vector4 r = choice(used, four(limits.r_Me), nothing), w = four(limits.w_Me);
  const Vector4 lever = vector(lanes.position_Me) - r;
  const Vector4 met = (vector(lanes.barycentre_Me) + depth * n) - r;
  const auto slopes = element_force_slopes(limits.law, limits.c_l, number(lanes.area), depth, v_n, v_t);
  const Double4 shift = four(limits.master_E ? limits.shift : -limits.shift);

  Vector4 force_by_depth = slopes.normal_by_depth * n;
  if (limits.with_velocities) {
    const Vector4 v_F = four(limits.v_Me) + cross(w, lever);
    const Vector4 v_k = limits.master_E ? v_F : -v_F;  // (17)
    const Vector4 t = choice(used & (v_t > zero), (v_k - v_n * n) / v_t, nothing);
    force_by_depth = force_by_depth + slopes.tangential_by_depth * t;
    // dF/dv_k = n p^T + t q^T + drag I.
    const Double4 drag = slopes.tangential_over_slip;
    const Vector4 p = (slopes.normal_by_approach - drag) * n;
    const Vector4 q = slopes.tangential_by_approach * n + (slopes.tangential_by_slip - drag) * t;
    const Vector4 carried = shift * cross(w, n);
    force_by_depth = force_by_depth + (dot(p, carried) * n + dot(q, carried) * t + drag * carried);

    const Vector4 lever_n = cross(lever, n), lever_t = cross(lever, t), p_lever = cross(p, lever),
                  q_lever = cross(q, lever), dragged = drag * lever;
    add_products(Components(n), Components(p), Components(t), Components(q), sums.force_by_velocity);
    add_diagonal(drag, sums.force_by_velocity);
    add_products(Components(n), Components(p_lever), Components(t), Components(q_lever), sums.force_by_lever);
    add_cross(Components(dragged), sums.force_by_lever);
    add_products(Components(lever_n), Components(p), Components(lever_t), Components(q), sums.torque_by_velocity);
    add_cross(Components(dragged), sums.torque_by_velocity);
    add_products(Components(lever_n), Components(p_lever), Components(lever_t), Components(q_lever),
                 sums.torque_by_lever);
    add_cross_of_cross(Components(dragged), Components(lever), sums.torque_by_lever);
  }
  const Vector4 torque_by_depth = shift * cross(n, force) + cross(lever, force_by_depth);
  const Vector4 depth_by_rotation = cross(met, gradient);
  add_product(Components(force_by_depth), Components(gradient), sums.force_by_position);
  add_product(Components(force_by_depth), Components(depth_by_rotation), sums.force_by_rotation);
  add_product(Components(torque_by_depth), Components(gradient), sums.torque_by_position);
  add_product(Components(torque_by_depth), Components(depth_by_rotation), sums.torque_by_rotation);
}

}  // namespace

}  // namespace pcm::fast
