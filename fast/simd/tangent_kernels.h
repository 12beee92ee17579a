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

/// Which of four elements there are; the others add nothing, whatever is in their lanes.
struct UsedLanes {
  Long4 used;

  Double4 operator()(const DoubleLanes& x) const { return used ? load(x) : four(0); }
  Vector4 operator()(const Vector4& x) const { return choice(used, x, Vector4{four(0), four(0), four(0)}); }
  Vector4 operator()(const VectorLanes& x) const { return (*this)(load(x)); }
};

/// What moves elements' forces, of elements whose forces are in the lanes.
struct ForceMotion {
  UsedLanes used;
  Vector4 n, t;  ///< normals of the elements, directions of slip
  Vector4 force, lever;
  Double4 area;
  Vector4 force_by_depth;  ///< where they are
  Vector4 p, q;            ///< dF/dv_k = n p^T + t q^T + drag I
  Double4 drag;
  Vector4 w;
  Double4 from_master;  ///< 1, or -1 where the master is F, against whose motion the slave moves

  /// K v.
  Vector4 force_by(const Vector4& v) const { return dot(p, v) * n + dot(q, v) * t + drag * v; }
};

/// A number of the elements' geometry: what force and torque do with it.
struct LoadBy {
  Vector4 force, torque;
};

/// As elements are carried along by the number, where they are not when it is 0.
LoadBy load_by_place(const ForceMotion& motion, const Vector4& along) {
  const Vector4 carried = motion.from_master * along;
  const Vector4 force = motion.force_by(cross(motion.w, carried));
  return {force, cross(carried, motion.force) + cross(motion.lever, force)};
}

/// Adds what velocities do, and returns the rest.
ForceMotion add_velocities(const ElementLanes& lanes, const ForceLimits& limits, LaneBits which, TangentLanes& sums) {
  const UsedLanes used{chosen(which)};
  const Double4 zero = four(0);
  const Vector4 nothing{zero, zero, zero};
  ForceMotion motion{.used = used,
                     .n = -used(lanes.n_Me),
                     .t = nothing,
                     .force = used(lanes.force_Me),
                     .lever = used(lanes.position_Me) - used(four(limits.r_Me)),
                     .area = used(lanes.area),
                     .force_by_depth = nothing,
                     .p = nothing,
                     .q = nothing,
                     .drag = zero,
                     .w = four(limits.w_Me),
                     .from_master = four(limits.master_E ? 1 : -1)};
  const Vector4& n = motion.n;
  const Double4 v_n = used(lanes.normal_velocity), v_t = used(lanes.tangential_velocity);
  const auto slopes = element_force_slopes(limits.law, limits.c_l, motion.area, used(lanes.depth), v_n, v_t);
  motion.force_by_depth = slopes.normal_by_depth * n;
  if (!limits.with_velocities) return motion;

  const Vector4& lever = motion.lever;
  const Vector4 v_F = four(limits.v_Me) + cross(motion.w, lever);
  const Vector4 v_k = limits.master_E ? v_F : -v_F;  // (17)
  const Vector4 t = motion.t = choice(used.used & (v_t > zero), (v_k - v_n * n) / v_t, nothing);
  motion.force_by_depth = motion.force_by_depth + slopes.tangential_by_depth * t;
  const Double4 drag = motion.drag = slopes.tangential_over_slip;
  const Vector4 p = motion.p = (slopes.normal_by_approach - drag) * n;
  const Vector4 q = motion.q = slopes.tangential_by_approach * n + (slopes.tangential_by_slip - drag) * t;

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
  return motion;
}

/// Adds what a number does that changes by these as the slave moves.
void add_number(const LoadBy& load, const Vector4& by_position, const Vector4& by_rotation, TangentLanes& sums) {
  add_product(Components(load.force), Components(by_position), sums.force_by_position);
  add_product(Components(load.force), Components(by_rotation), sums.force_by_rotation);
  add_product(Components(load.torque), Components(by_position), sums.torque_by_position);
  add_product(Components(load.torque), Components(by_rotation), sums.torque_by_rotation);
}

/// With the shift of the element along n_k (13).
LoadBy load_by_depth(const ForceMotion& motion, const ForceLimits& limits) {
  const LoadBy shifted = load_by_place(motion, four(limits.shift) * motion.n);
  return {motion.force_by_depth + shifted.force, shifted.torque + cross(motion.lever, motion.force_by_depth)};
}

void add_tangent(const ElementLanes& lanes, const ForceLimits& limits, LaneBits which, TangentLanes& sums) {
  const ForceMotion motion = add_velocities(lanes, limits, which, sums);
  const UsedLanes& used = motion.used;
  const Vector4 gradient = used(lanes.depth_gradient_Me);
  const Vector4 met = (used(lanes.barycentre_Me) + used(lanes.depth) * motion.n) - used(four(limits.r_Me));
  add_number(load_by_depth(motion, limits), gradient, cross(met, gradient), sums);
}

void add_tangent_of_parts(const ElementLanes& lanes, const ElementMotionLanes& parts, const ForceLimits& limits,
                          LaneBits which, TangentLanes& sums) {
  const ForceMotion motion = add_velocities(lanes, limits, which, sums);
  const auto add = [&](const LoadBy& load, const ElementMotionLanes::Slope& slope) {
    add_number(load, motion.used(slope.by_position), motion.used(slope.by_rotation), sums);
  };
  add(load_by_depth(motion, limits), parts.depth);
  add(load_by_place(motion, motion.used(parts.edge_s_Me)), parts.s);
  add(load_by_place(motion, motion.used(parts.edge_t_Me)), parts.t);
  // All forces grow with the area.
  const Double4 area = motion.used.used ? motion.area : four(1);
  const Vector4 per_area = motion.from_master * (motion.force / area);
  add({per_area, cross(motion.lever, per_area)}, parts.area);
}

}  // namespace

}  // namespace pcm::fast
