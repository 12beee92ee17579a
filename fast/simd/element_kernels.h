// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// The steps of fast/simd/elements.h, for files that are compiled for different instructions: everything here is local
// to the file that includes it, and no function of another header is called unless it is as local (or nothing but an
// accessor, which optimized builds do not call), so that no wide instruction leaks out.
#pragma once

#include "fast/law/element_force.h"
#include "fast/predicates/side_bound.h"
#include "fast/simd/element_vectors.h"
#include "fast/simd/elements.h"
#include "fast/simd/tangent_kernels.h"

namespace pcm::fast {

namespace {

/// `length` of fast/base/geometry.h where no scaling is needed.
struct Length {
  Double4 value;
  Long4 known, zero;

  explicit Length(const Vector4& v) : value(root(dot(v, v))) {
    const Double4 widest = greatest(greatest(absolute(v.x), absolute(v.y)), absolute(v.z));
    known = (widest > four(0x1p-450)) & (widest < four(0x1p450));
    zero = widest == four(0);
  }
};

LaneBits find_geometry(ElementLanes& lanes) {
  const Vector4 p0 = load(lanes.master_corners[0]), p1 = load(lanes.master_corners[1]),
                p2 = load(lanes.master_corners[2]);
  const Vector4 a = p1 - p0, b = p2 - p0;
  const Vector4 N = cross(a, b);
  const Length twice_area(N);
  store(p0, lanes.p_Me[0]);
  store(p1, lanes.p_Me[1]);
  store(p2, lanes.p_Me[2]);
  store(four(0.5) * twice_area.value, lanes.area);
  store(N / twice_area.value, lanes.n_Me);
  store(p0 + (a + b) / four(3), lanes.barycentre_Me);
  store(norm_1(a), lanes.side[0]);
  store(norm_1(b), lanes.side[1]);
  return lanes_of(twice_area.known);
}

/// The side tests of LineCoordinates (fast/search/line_walk.h), with their bound.
LeavingLanes leave(const ElementLanes& lanes, const DecisionLimits& limits) {
  const Vector4 p0 = load(lanes.p_Me[0]), C = load(lanes.barycentre_Me);
  const Vector4 a = load(lanes.p_Me[1]) - p0, b = load(lanes.p_Me[2]) - p0;
  std::array<Double4, 3> x, y;
  Double4 width = four(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector4 from_C = load(lanes.slave_corners[k]) - C;
    x[k] = dot(a, from_C);
    y[k] = dot(b, from_C);
    width = greatest(width, greatest(greatest(absolute(from_C.x), absolute(from_C.y)), absolute(from_C.z)));
  }
  const Double4 M = four(limits.max_coordinate), side_a = load(lanes.side[0]), side_b = load(lanes.side[1]);
  const Double4 error = four(kSideError) * M * side_a * side_b * width + four(kSideUnderflow);
  const Long4 usable = (M * side_a > four(kLeastSideProduct)) & (M * side_b > four(kLeastSideProduct)) &
                       (error < four(kGreatestSideBound)) &
                       (load(lanes.area) > four(limits.least_share) * (side_a * side_b));
  Long4 inside = usable, outside = usable & (four(0) > four(0));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Double4 side = x[k] * y[next] - y[k] * x[next];
    inside = inside & (side < -error);
    outside = outside | (side > error);
  }
  return {lanes_of(inside), lanes_of(usable & outside)};
}

/// The slave's faces, and -n . N_f of the master's normals and theirs.
struct SlaveFaces {
  std::array<Vector4, 3> f;
  Vector4 first_side, second_side, N_f;
  Double4 slope;

  explicit SlaveFaces(const ElementLanes& lanes)
      : f{load(lanes.slave_corners[0]), load(lanes.slave_corners[1]), load(lanes.slave_corners[2])},
        first_side(f[1] - f[0]),
        second_side(f[2] - f[0]),
        N_f(cross(first_side, second_side)),
        slope(-dot(load(lanes.n_Me), N_f)) {}
};

/// (11) from the nearest corner, as DepthBelow takes it; returns the lanes where one surely is the nearest.
LaneBits depth_below(const SlaveFaces& slave, ElementLanes& lanes) {
  const std::array<Vector4, 3> p{load(lanes.p_Me[0]), load(lanes.p_Me[1]), load(lanes.p_Me[2])};
  std::array<Vector4, 3> offset;
  std::array<Double4, 3> squares;
  for (std::size_t k = 0; k < 3; ++k) {
    offset[k] = (slave.f[k] - p[0]) + (slave.f[k] - p[1]) + (slave.f[k] - p[2]);
    squares[k] = dot(offset[k], offset[k]);
  }
  const auto nearest = [&](std::size_t k, std::size_t i, std::size_t j) -> Long4 {
    return (squares[k] < four(1 - 0x1p-40) * least(squares[i], squares[j])) & (squares[k] > four(0x1p-900));
  };
  const Long4 first = nearest(0, 1, 2), second = nearest(1, 2, 0), third = nearest(2, 0, 1);
  const Vector4 from_C = choice(first, offset[0], choice(second, offset[1], offset[2])) / four(3);
  const Double4 depth = dot(from_C, slave.N_f) / slave.slope;
  const Long4 finite = absolute(depth) <= four(0x1.fffffffffffffp1023);
  store(finite ? greatest(depth, four(0)) : four(0), lanes.depth);
  return lanes_of(first | second | third);
}

LaneBits find_depth(ElementLanes& lanes) {
  return depth_below(SlaveFaces(lanes), lanes);
}

DecidedLanes decide(ElementLanes& lanes, const DecisionLimits& limits) {
  const SlaveFaces slave(lanes);
  const Vector4& N_f = slave.N_f;
  const Double4& slope = slave.slope;
  const Double4 square = dot(N_f, N_f);
  const Double4 share = four(2 * limits.least_share) * (norm_1(slave.first_side) * norm_1(slave.second_side));
  const Long4 fair =
      (square > share * share) & (square > four(0x1p-900)) & (slope > four(0)) & (four(16) * slope * slope > square);

  const Double4 distance = dot(N_f, slave.f[0] - load(lanes.barycentre_Me)) / slope;
  const Double4 square_cosine = slope * slope / square;
  const Long4 in_wide_cone = square_cosine > four(limits.cone_cosine_square[1]);
  const Long4 in_narrow_cone = in_wide_cone & (square_cosine > four(limits.cone_cosine_square[0]));
  const auto by_cone = [&](const auto& clearance_in) {
    return in_narrow_cone ? clearance_in(0) : in_wide_cone ? clearance_in(1) : four(0);
  };
  const auto beneath = [&lanes](std::size_t cone) {
    const auto& c = lanes.clearance;
    return Double4{c[0].beneath[cone], c[1].beneath[cone], c[2].beneath[cone], c[3].beneath[cone]};
  };
  const auto above = [&lanes](std::size_t cone) {
    const auto of = [&](std::size_t lane) { return lanes.clearance[lane].above[cone] ? 1.0 : 0.0; };
    return Double4{of(0), of(1), of(2), of(3)};
  };
  const Double4 farthest = distance + four(limits.error);
  const Long4 left = fair & (distance > four(limits.error));
  const Double4 slave_free = load(lanes.slave_free);
  // The depth is the distance times the cosine.
  const Double4 farthest_of_clear = farthest / (by_cone(beneath) * four(limits.slave_max_coordinate));
  const Long4 clear =
      (farthest_of_clear * farthest_of_clear * square_cosine < four(1 - 0x1p-20)) | (farthest < slave_free);
  const Long4 thick =
      (farthest < load(lanes.thickness)) & (four(limits.thick_edges) * (load(lanes.side[0]) + load(lanes.side[1])) <
                                            four(limits.thick_area) * load(lanes.area));
  DecidedLanes decided;
  decided.nothing = lanes_of(fair & (distance < four(-limits.error)) &
                             ((by_cone(above) > four(0)) | (slave_free == four(__builtin_inf()))));
  decided.left = lanes_of(left);
  decided.oblique = lanes_of(~(fair & in_wide_cone));
  decided.thin = lanes_of(~thick);
  decided.element = lanes_of(left & clear & thick);
  if (decided.element == 0) return decided;

  decided.nearest_known = depth_below(slave, lanes);
  return decided;
}

LaneBits find_force(ElementLanes& lanes, const ForceLimits& limits) {
  const Vector4 n = -load(lanes.n_Me);
  const Double4 area = load(lanes.area), depth = load(lanes.depth);
  const Vector4 position = load(lanes.barycentre_Me) + (four(limits.shift) * depth) * n;  // (13)
  const Vector4 lever = position - four(limits.r_Me);
  Double4 v_n = four(0), v_t = four(0);
  Vector4 slip = {four(0), four(0), four(0)};
  LaneBits known = 0xf;
  if (limits.with_velocities) {
    const Vector4 v_F = four(limits.v_Me) + cross(four(limits.w_Me), lever);
    const Vector4 v_k = limits.master_E ? v_F : -v_F;  // (17)
    v_n = dot(n, v_k);                                 // (16)
    slip = v_k - v_n * n;
    const Length length(slip);
    v_t = length.value;  // (19)
    known = lanes_of(length.known | length.zero);
  }
  const auto [normal, tangential] = element_forces(limits.law, limits.c_l, area, depth, v_n, v_t);
  const Long4 slides = v_t > four(0);
  const Vector4 straight = normal * n;
  Vector4 force = choice(slides, straight + tangential * (slip / v_t), straight);  // (21)
  if (!limits.master_E) force = -force;
  store(v_n, lanes.normal_velocity);
  store(v_t, lanes.tangential_velocity);
  store(normal, lanes.normal_force);
  store(tangential, lanes.tangential_force);
  store(position, lanes.position_Me);
  store(force, lanes.force_Me);
  store(cross(lever, force), lanes.torque_Me);
  return known;
}

constexpr WideElements kElements{find_geometry, leave,         decide,      find_depth,
                                 find_force,    find_gradient, add_tangent, add_tangent_of_parts};

}  // namespace

}  // namespace pcm::fast
