// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// The tests of fast/simd/overlap.h, for files that are compiled for different instructions: everything here is local to
// the file that includes it, and no function of another header is called but accessors, which optimized builds do not
// call, so that no wide instruction leaks out.
#pragma once

#include "fast/simd/overlap.h"
#include "fast/simd/pair_kernels.h"
#include "fast/simd/vector_types.h"

namespace pcm::fast {

namespace {

using Vector8 = WideVector<Float8>;

inline Float8 load(const Lanes& lanes) {
  return load_lanes<Float8>(lanes.value);
}
inline Vector8 load(const std::array<Lanes, 3>& lanes) {
  return {load(lanes[0]), load(lanes[1]), load(lanes[2])};
}
inline Float8 all(float value) {
  return Float8{value, value, value, value, value, value, value, value};
}
inline Float8 least(Float8 a, Float8 b) {
  return a < b ? a : b;
}
inline Float8 greatest(Float8 a, Float8 b) {
  return a > b ? a : b;
}

using Matrix = std::array<std::array<float, 3>, 3>;

inline Vector8 turned(const Matrix& A, const Vector8& v) {
  return {A[0][0] * v.x + A[0][1] * v.y + A[0][2] * v.z, A[1][0] * v.x + A[1][1] * v.y + A[1][2] * v.z,
          A[2][0] * v.x + A[2][1] * v.y + A[2][2] * v.z};
}
inline Vector8 turned_back(const Matrix& A, const Vector8& v) {
  return {A[0][0] * v.x + A[1][0] * v.y + A[2][0] * v.z, A[0][1] * v.x + A[1][1] * v.y + A[2][1] * v.z,
          A[0][2] * v.x + A[1][2] * v.y + A[2][2] * v.z};
}
inline Vector8 widened(const Vector8& a, float by) {
  return {a.x + by, a.y + by, a.z + by};
}
inline Vector8 all(const std::array<float, 3>& v) {
  return {all(v[0]), all(v[1]), all(v[2])};
}
inline Vector8 all(const Vector8& v, unsigned lane) {
  return {all(v.x[lane]), all(v.y[lane]), all(v.z[lane])};
}
/// Boxes as one frame's axes see them.
struct Boxes {
  Vector8 centre, half;
};

/// Lanes where |distance| exceeds the sum of half widths along one of three axes.
inline Int8 apart(const Vector8& distance, const Vector8& half_widths) {
  return (absolute(distance.x) > half_widths.x) | (absolute(distance.y) > half_widths.y) |
         (absolute(distance.z) > half_widths.z);
}

/// Both kinds of boxes: their own, and how wide they are along the other frame's axes.
struct BoxesOfE {
  Boxes own;
  Vector8 half_in_F;  ///< with their error there

  BoxesOfE(const Boxes& boxes, const WidePose& pose)
      : own(boxes), half_in_F(widened(turned_back(pose.rotation_absolute, boxes.half), pose.box_error_F)) {}
};
struct BoxesOfF {
  Boxes in_E;    ///< centres in E's coordinates, half widths along E's axes with their error there
  Vector8 half;  ///< along F's axes

  BoxesOfF(const Boxes& boxes, const WidePose& pose) : half(pose.scale * boxes.half) {
    in_E.centre = turned(pose.rotation, pose.scale * boxes.centre) + all(pose.shift);
    in_E.half = widened(turned(pose.rotation_absolute, half), pose.box_error_E);
  }
};

/// Lanes whose boxes are not apart along one of the six axes of both frames.
inline std::uint32_t touching(const BoxesOfE& E, const Vector8& centre_F, const Vector8& half_F_in_E,
                              const Vector8& half_F, const WidePose& pose) {
  const Vector8 distance = centre_F - E.own.centre;
  const Int8 apart_in_E = apart(distance, E.own.half + half_F_in_E);
  const Int8 apart_in_F = apart(turned_back(pose.rotation, distance), E.half_in_F + half_F);
  return ~lanes_of(apart_in_E | apart_in_F) & 0xffU;
}

inline Boxes children(const WideNode& node) {
  return {load(node.centre), load(node.half)};
}
inline Boxes own(const WideNode& node) {
  return {all(node.own_centre), all(node.own_half)};
}

std::uint32_t test_children_of_E(const WideNode& E, const WideNode& F, const WidePose& pose) {
  const BoxesOfF boxes_F(own(F), pose);
  return touching(BoxesOfE(children(E), pose), boxes_F.in_E.centre, boxes_F.in_E.half, boxes_F.half, pose) & E.used();
}

std::uint32_t test_children_of_F(const WideNode& E, const WideNode& F, const WidePose& pose) {
  const BoxesOfF boxes_F(children(F), pose);
  return touching(BoxesOfE(own(E), pose), boxes_F.in_E.centre, boxes_F.in_E.half, boxes_F.half, pose) & F.used();
}

LanePairs test_boxes(const WideNode& E, const WideNode& F, const WidePose& pose) {
  const BoxesOfF boxes_F(children(F), pose);
  std::uint32_t of_F =
      touching(BoxesOfE(own(E), pose), boxes_F.in_E.centre, boxes_F.in_E.half, boxes_F.half, pose) & F.used();
  const BoxesOfE boxes_E(children(E), pose);
  LanePairs pairs = 0;
  for (; of_F != 0; of_F &= of_F - 1) {
    const auto j = static_cast<unsigned>(__builtin_ctz(of_F));
    const std::uint32_t of_E =
        touching(boxes_E, all(boxes_F.in_E.centre, j), all(boxes_F.in_E.half, j), all(boxes_F.half, j), pose) &
        E.used();
    pairs |= static_cast<LanePairs>(of_E) << (8 * j);
  }
  return pairs;
}

/// Boxes along E's axes by their ends.
struct Ends {
  Vector8 low, high;
};

inline Int8 apart(const Ends& a, const Ends& b) {
  return (a.low.x > b.high.x) | (a.high.x < b.low.x) | (a.low.y > b.high.y) | (a.high.y < b.low.y) |
         (a.low.z > b.high.z) | (a.high.z < b.low.z);
}

/// Three points and a plane.
struct Sides {
  Int8 on_one_side;           ///< all of them, surely
  Int8 sure;                  ///< it is known of each where it lies
  std::array<Int8, 3> above;  ///< in that case
};

inline Sides sides_of(const Vector8& normal, const Vector8& point, const std::array<Vector8, 3>& x, float error) {
  const Float8 offset = dot(normal, point);
  const Float8 s0 = dot(normal, x[0]) - offset, s1 = dot(normal, x[1]) - offset, s2 = dot(normal, x[2]) - offset;
  const Float8 nearest = least(least(absolute(s0), absolute(s1)), absolute(s2));
  return {(least(least(s0, s1), s2) > all(error)) | (greatest(greatest(s0, s1), s2) < all(-error)),
          nearest > all(error),
          {s0 > all(0), s1 > all(0), s2 > all(0)}};
}

/// A face seen from its lone corner, the one that lies on its own side of a plane.
struct FromLoneCorner {
  Vector8 corner, next, last;

  FromLoneCorner(const std::array<Vector8, 3>& x, const std::array<Int8, 3>& above) {
    const Int8 first_is_lone = ~(above[1] ^ above[2]), second_is_lone = ~(above[0] ^ above[2]);
    const auto from = [&](std::size_t k) {
      return choice(first_is_lone, x[k], choice(second_is_lone, x[(k + 1) % 3], x[(k + 2) % 3]));
    };
    corner = from(0), next = from(1), last = from(2);
  }
};

/// The edges of SureSigns that pass through the other face, by number.
struct Passing {
  Int8 sure;
  std::array<Int8, 4> edges;
};

/// As find_signs (fast/crossings/pair_signs.h) finds them: from the signs of (a_i - a) x (p - a) . (p_j - p), a and p
/// the lone corners.
inline Passing edges_passing(const FromLoneCorner& E, const FromLoneCorner& F, const Float8& error) {
  const Vector8 c = F.corner - E.corner, d0 = F.next - F.corner, d1 = F.last - F.corner;
  const Vector8 m0 = cross(E.next - E.corner, c), m1 = cross(E.last - E.corner, c);
  const Float8 s00 = dot(m0, d0), s01 = dot(m0, d1), s10 = dot(m1, d0), s11 = dot(m1, d1);
  const Float8 nearest = least(least(absolute(s00), absolute(s01)), least(absolute(s10), absolute(s11)));
  const Int8 a00 = s00 > all(0), a01 = s01 > all(0), a10 = s10 > all(0), a11 = s11 > all(0);
  return {nearest > error, {a00 ^ a01, a10 ^ a11, a00 ^ a10, a01 ^ a11}};
}

/// No less than the 1-norm of any edge in a box of these widths.
inline Float8 edge_length(const Vector8& widths, const WidePose& pose) {
  return widths.x + widths.y + widths.z + 6 * pose.box_error_E;
}

FacePairs test_faces(const WideNode& E, const FaceGroup& faces_E, const WideNode& F, const FaceGroup& faces_F,
                     const WidePose& pose) {
  std::array<Vector8, 3> x_F;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    x_F[corner] = turned(pose.rotation, pose.scale * load(faces_F.vertex[corner])) + all(pose.shift);
  }
  const auto end = [&x_F](auto&& choose) {
    return Vector8{choose(choose(x_F[0].x, x_F[1].x), x_F[2].x), choose(choose(x_F[0].y, x_F[1].y), x_F[2].y),
                   choose(choose(x_F[0].z, x_F[1].z), x_F[2].z)};
  };
  const Ends ends_F{widened(end([](const Float8& a, const Float8& b) { return least(a, b); }), -pose.box_error_E),
                    widened(end([](const Float8& a, const Float8& b) { return greatest(a, b); }), pose.box_error_E)};
  const Vector8 own_centre = all(E.own_centre), own_half = all(E.own_half);
  std::uint32_t of_F = ~lanes_of(apart(ends_F, {own_centre - own_half, own_centre + own_half})) & F.used();
  FacePairs pairs;
  if (of_F == 0) return pairs;

  const Boxes boxes_E = children(E);
  const Ends ends_E{boxes_E.centre - boxes_E.half, boxes_E.centre + boxes_E.half};
  const Float8 length_E = edge_length(2.0F * boxes_E.half, pose),
               length_F = edge_length(ends_F.high - ends_F.low, pose);
  const Vector8 n_E = load(faces_E.normal), n_F = turned(pose.rotation, load(faces_F.normal));
  const std::array<Vector8, 3> x_E{load(faces_E.vertex[0]), load(faces_E.vertex[1]), load(faces_E.vertex[2])};
  for (; of_F != 0; of_F &= of_F - 1) {
    const auto j = static_cast<unsigned>(__builtin_ctz(of_F));
    std::uint32_t of_E = ~lanes_of(apart({all(ends_F.low, j), all(ends_F.high, j)}, ends_E)) & E.used();
    ++pairs.rows;
    if (of_E == 0) continue;
    pairs.live += __builtin_popcount(of_E);
    const std::array<Vector8, 3> x{all(x_F[0], j), all(x_F[1], j), all(x_F[2], j)};
    const Sides sides_F = sides_of(n_E, x_E[0], x, pose.plane_error);
    of_E &= ~lanes_of(sides_F.on_one_side);
    if (of_E == 0) continue;
    const Sides sides_E = sides_of(all(n_F, j), x[0], x_E, pose.plane_error);
    of_E &= ~lanes_of(sides_E.on_one_side);
    if (of_E == 0) continue;
    // |p - a| is no more than both boxes' widths: with gamma = beta + zeta the sum of WidePose is gamma^2 + beta zeta.
    const Float8 beta = length_E, zeta = all(length_F[j]), gamma = beta + zeta;
    const Passing passing = edges_passing(FromLoneCorner(x_E, sides_E.above), FromLoneCorner(x, sides_F.above),
                                          pose.edge_error * (gamma * gamma + beta * zeta));
    Int8 bits{};
    const auto enter = [&bits](const Int8& lanes, unsigned bit) {
      bits |= lanes & static_cast<std::int32_t>(1U << bit);
    };
    for (unsigned corner = 0; corner < 3; ++corner) {
      enter(sides_E.above[corner], SureSigns::kAboveOfE + corner);
      enter(sides_F.above[corner], SureSigns::kAboveOfF + corner);
    }
    for (unsigned edge = 0; edge < 4; ++edge) enter(passing.edges[edge], SureSigns::kPassing + edge);
    enter(sides_E.sure, SureSigns::kSureOfE);
    enter(sides_F.sure, SureSigns::kSureOfF);
    enter(sides_E.sure & sides_F.sure & passing.sure, SureSigns::kSureOfPassing);
    __builtin_memcpy(&pairs.bits[std::size_t{kLanes} * j], &bits, sizeof bits);
    pairs.possible |= static_cast<LanePairs>(of_E) << (8 * j);
  }
  return pairs;
}

std::uint32_t test_boxes_met(const WideNode& node, const WideRay& ray, Lanes& entry) {
  const Vector8 middle = load(node.centre) - all(ray.origin);
  const Vector8 width = widened(load(node.half), ray.box_error);
  const Vector8 low = middle - width, high = middle + width;
  const Vector8 inverse = all(ray.inverse);
  const Vector8 t_low{low.x * inverse.x, low.y * inverse.y, low.z * inverse.z};
  const Vector8 t_high{high.x * inverse.x, high.y * inverse.y, high.z * inverse.z};
  const Float8 first = greatest(greatest(least(t_low.x, t_high.x), least(t_low.y, t_high.y)),
                                greatest(least(t_low.z, t_high.z), all(0)));
  const Float8 last =
      least(least(greatest(t_low.x, t_high.x), greatest(t_low.y, t_high.y)), greatest(t_low.z, t_high.z));
  __builtin_memcpy(entry.value.data(), &first, sizeof first);
  return ~lanes_of(first > last) & node.used();
}

std::uint32_t test_boxes_in_prism(const WideNode& node, const WidePrism& prism) {
  const Vector8 centre = load(node.centre), half = load(node.half);
  const auto along = [](const std::array<float, 3>& axis, const Vector8& v) {
    return axis[0] * v.x + axis[1] * v.y + axis[2] * v.z;
  };
  const Float8 depth = along(prism.axis[3], centre), depth_range = along(prism.axis_absolute[3], half);
  Int8 outside = (depth + depth_range < all(prism.offset[3])) | (depth - depth_range > all(prism.deepest));
  for (std::size_t k = 0; k < 3; ++k) {
    outside |= along(prism.axis[k], centre) + along(prism.axis_absolute[k], half) < all(prism.offset[k]);
  }
  return ~lanes_of(outside) & node.used();
}

// An edge from a to b, both from the line's origin, passes the line at a distance, in the plane across it, of
// direction . (a x (b - a)) over the edge's projected length. A line that is farther than the error to the left of one
// edge and to the right of another misses the face, whichever way that turns. One that is farther to the same side of
// all three passes through it.
FacesMet test_faces_met(const FaceGroup& faces, const WideRay& ray) {
  const Vector8 origin = all(ray.origin), direction = all(ray.direction);
  const std::array<Vector8, 3> x{load(faces.vertex[0]) - origin, load(faces.vertex[1]) - origin,
                                 load(faces.vertex[2]) - origin};
  Int8 some_left{}, some_right{}, all_left = ~Int8{}, all_right = ~Int8{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector8 edge = x[i == 2 ? 0 : i + 1] - x[i];
    const Float8 moment = dot(cross(direction, x[i]), edge);
    const Float8 error = all(ray.box_error) * (absolute(edge.x) + absolute(edge.y) + absolute(edge.z));
    const Int8 left = moment > error, right = moment < -error;
    some_left |= left;
    some_right |= right;
    all_left &= left;
    all_right &= right;
  }
  return {~lanes_of(some_left & some_right) & 0xffU, lanes_of(all_left), lanes_of(all_right)};
}

constexpr WideTests kTests{test_boxes,     test_children_of_E,  test_children_of_F, test_faces,
                           test_boxes_met, test_boxes_in_prism, test_faces_met,     look_at_pairs};

}  // namespace

}  // namespace pcm::fast
