// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// What fast/simd/pairs.h says, for files that are compiled for different instructions: everything here is local to the
// file that includes it, so that no wide instruction leaks out.
#pragma once

#include <array>

#include "fast/simd/element_vectors.h"
#include "fast/simd/overlap.h"
#include "fast/simd/pairs.h"

namespace pcm::fast {

namespace {

/// How far a volume surely is from 0; 0 where it may have either sign.
inline Double4 surely(const Double4& volume, const Double4& roundings) {
  const Double4 least_absolute = absolute(volume) - roundings;
  return least_absolute > four(kLeastSureVolume) ? least_absolute : four(0);
}

/// The squares of distances, as fractions: to find the least or the greatest takes no root and no division.
struct SquaredDistances {
  Double4 numerator, denominator;

  /// A volume, surely, over the length of a normal whose parts are off by `roundings` at most:
  /// (a + b)^2 <= (1 + c) a^2 + (1 + 1 / c) b^2, with c = 2^-20.
  SquaredDistances(const Double4& volume, const Vector4& normal, const Double4& roundings)
      : numerator(volume * volume),
        denominator(four(1 + 0x1p-20) * (dot(normal, normal) + four(0x1p-400)) +
                    four(1 + 0x1p20) * (roundings * roundings)) {}
  SquaredDistances(const Double4& numerator_is, const Double4& denominator_is)
      : numerator(numerator_is), denominator(denominator_is) {}

  Long4 less_than(const SquaredDistances& other) const {
    return numerator * other.denominator < other.numerator * denominator;
  }
  Double4 roots() const { return root(numerator / denominator); }
};

inline SquaredDistances choice(const Long4& condition, const SquaredDistances& a, const SquaredDistances& b) {
  return {condition ? a.numerator : b.numerator, condition ? a.denominator : b.denominator};
}
inline SquaredDistances least(const SquaredDistances& a, const SquaredDistances& b) {
  return choice(b.less_than(a), b, a);
}
inline SquaredDistances greatest(const SquaredDistances& a, const SquaredDistances& b) {
  return choice(a.less_than(b), b, a);
}

/// A face's three corners and the other one's plane.
struct Heights {
  std::array<Double4, 3> value, surely;  ///< times the length of the plane's normal
  std::array<Long4, 3> above;
  Double4 nearest;    ///< of `surely`
  Long4 on_one_side;  ///< all of them, surely

  Heights(const Vector4& normal, const std::array<Vector4, 3>& from_plane, const Double4& roundings) {
    for (std::size_t k = 0; k < 3; ++k) {
      value[k] = dot(normal, from_plane[k]);
      surely[k] = fast::surely(value[k], roundings);
      above[k] = value[k] > four(0);
    }
    nearest = least(least(surely[0], surely[1]), surely[2]);
    on_one_side = sure() & ~((above[0] ^ above[1]) | (above[0] ^ above[2]));
  }
  Long4 sure() const { return nearest > four(0); }
};

/// A face seen from the corner that lies alone on its side of the other plane; from any where none does.
struct SidesFromLoneCorner {
  Vector4 corner;
  std::array<Vector4, 2> side;     ///< to the next corner, and to the last
  std::array<Double4, 2> higher;   ///< those corners than the lone one: normal . side
  std::array<Double4, 2> nearest;  ///< of both ends of a side, to the plane, surely

  SidesFromLoneCorner(const std::array<Vector4, 3>& x, const Heights& heights) {
    const Long4 first_is_lone = ~(heights.above[1] ^ heights.above[2]),
                second_is_lone = ~(heights.above[0] ^ heights.above[2]);
    const auto vector = [&](std::size_t k) {
      return choice(first_is_lone, x[k], choice(second_is_lone, x[(k + 1) % 3], x[(k + 2) % 3]));
    };
    const auto number = [&](const std::array<Double4, 3>& of, std::size_t k) -> Double4 {
      return first_is_lone ? of[k] : second_is_lone ? of[(k + 1) % 3] : of[(k + 2) % 3];
    };
    corner = vector(0);
    for (std::size_t i = 0; i < 2; ++i) {
      side[i] = vector(i + 1) - corner;
      higher[i] = number(heights.value, i + 1) - number(heights.value, 0);
      nearest[i] = least(number(heights.surely, i + 1), number(heights.surely, 0));
    }
  }
};

/// How far the numbers between 0 and `e`, and those between s and s + `f`, are apart.
inline Double4 gap_between(const Double4& e, const Double4& s, const Double4& f) {
  const Double4 zero = four(0), end = s + f;
  return greatest(least(s, end) - greatest(zero, e), least(zero, e) - greatest(s, end));
}

PairsLookedAt look_at_pairs(const PairLanes& lanes) {
  const std::array<Vector4, 3> e{load(lanes.e[0]), load(lanes.e[1]), load(lanes.e[2])};
  const std::array<Vector4, 3> f{load(lanes.f[0]), load(lanes.f[1]), load(lanes.f[2])};
  const std::array<Vector4, 2> side_e{e[1] - e[0], e[2] - e[0]}, side_f{f[1] - f[0], f[2] - f[0]};
  const Vector4 first_apart = f[0] - e[0];
  const Vector4 N_E = cross(side_e[0], side_e[1]), N_F = cross(side_f[0], side_f[1]);
  const Double4 beta = norm_1(side_e[0]) + norm_1(side_e[1]), zeta = norm_1(side_f[0]) + norm_1(side_f[1]);
  const Double4 gamma = norm_1(first_apart) + beta + zeta;
  const Double4 of_E = four(kVolumeRoundings) * (beta * beta), of_F = four(kVolumeRoundings) * (zeta * zeta),
                of_both = four(kVolumeRoundings) * (beta * zeta);

  const Heights e_over_F(N_F, {e[0] - f[0], e[1] - f[0], e[2] - f[0]}, of_F * gamma);
  const Heights f_over_E(N_E, {first_apart, f[1] - e[0], f[2] - e[0]}, of_E * gamma);
  const SidesFromLoneCorner lone_e(e, e_over_F), lone_f(f, f_over_E);
  const Vector4 x = lone_f.corner - lone_e.corner;

  std::array<std::array<Double4, 2>, 2> s;
  std::array<std::array<Vector4, 2>, 2> across;
  const SquaredDistances none{four(0), four(1)}, any{four(1), four(0)};
  // Of the lines along a side of e and one of f: by side of e, by side of f. And what parts the faces.
  std::array<SquaredDistances, 2> line_of_e{any, any}, line_of_f{any, any};
  SquaredDistances apart = greatest(SquaredDistances(e_over_F.on_one_side ? e_over_F.nearest : four(0), N_F, of_F),
                                    SquaredDistances(f_over_E.on_one_side ? f_over_E.nearest : four(0), N_E, of_E));
  Double4 nearest_line = four(__builtin_inf());
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      across[i][j] = cross(lone_e.side[i], lone_f.side[j]);
      s[i][j] = dot(across[i][j], x);
      const Double4 surely_apart = surely(s[i][j], of_both * gamma);
      nearest_line = least(nearest_line, surely_apart);
      const SquaredDistances lines(surely_apart, across[i][j], of_both);
      line_of_e[i] = least(line_of_e[i], lines);
      line_of_f[j] = least(line_of_f[j], lines);
      const Double4 gap = gap_between(i == 0 ? -lone_f.higher[j] : lone_f.higher[j], s[i][j],
                                      j == 0 ? lone_e.higher[i] : -lone_e.higher[i]);
      const Double4 gap_surely = surely(greatest(gap, four(0)), (of_E + of_F + of_both) * gamma);
      apart = greatest(apart, {gap_surely * gap_surely, lines.denominator});
    }
  }
  const auto with_third_side = [&](const SquaredDistances& so_far, const Double4& volume, const Double4& of_plane,
                                   const Vector4& normal, const Double4& to_ends, const Vector4& plane_normal) {
    const SquaredDistances third(surely(volume, (of_both + of_plane) * gamma), normal, of_both);
    return least(least(so_far, third), SquaredDistances(to_ends, plane_normal, of_plane));
  };
  for (std::size_t k = 0; k < 2; ++k) {
    line_of_e[k] = with_third_side(line_of_e[k], s[k][1] - s[k][0] - lone_e.higher[k], of_F,
                                   across[k][1] - across[k][0], lone_e.nearest[k], N_F);
    line_of_f[k] = with_third_side(line_of_f[k], s[1][k] - s[0][k] - lone_f.higher[k], of_E,
                                   across[1][k] - across[0][k], lone_f.nearest[k], N_E);
  }

  const Long4 parted_by_plane = e_over_F.on_one_side | f_over_E.on_one_side;
  const Long4 sure = parted_by_plane | (e_over_F.sure() & f_over_E.sure() & (nearest_line > four(0)));
  const auto above = [&s](std::size_t i, std::size_t j) -> Long4 { return s[i][j] > four(0); };
  const std::array<Long4, 4> passes{above(0, 0) ^ above(0, 1), above(1, 0) ^ above(1, 1), above(0, 0) ^ above(1, 0),
                                    above(0, 1) ^ above(1, 1)};
  const auto bit = [](unsigned number) { return std::int64_t{1} << number; };
  Long4 signs{}, some_pass{};
  SquaredDistances crossing = any;
  for (unsigned edge = 0; edge < 4; ++edge) {
    const Long4 pass = passes[edge] & ~parted_by_plane;
    crossing = choice(pass, least(crossing, edge < 2 ? line_of_e[edge] : line_of_f[edge - 2]), crossing);
    signs |= pass & bit(SureSigns::kPassing + edge);
    some_pass |= pass;
  }
  for (unsigned corner = 0; corner < 3; ++corner) {
    signs |= e_over_F.above[corner] & bit(SureSigns::kAboveOfE + corner);
    signs |= f_over_E.above[corner] & bit(SureSigns::kAboveOfF + corner);
  }

  PairsLookedAt found;
  found.sure = lanes_of(sure);
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) found.signs[lane] = static_cast<std::uint32_t>(signs[lane]);
  store(choice(some_pass, crossing, choice(sure, apart, none)).roots(), found.margin);
  return found;
}

}  // namespace

}  // namespace pcm::fast
