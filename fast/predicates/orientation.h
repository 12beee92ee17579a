// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "meshes/base/floating_point_policy.h"
#include "pcm/work_counters.h"

/// On which side of the plane of three vertices a fourth one lies, orient3d: the one predicate that crossings, polygons
/// and active areas depend on (PCM section 4). Three stages: floating-point filter, exact arithmetic, tie rule. Most
/// signs of crossings are decided before, eight at a time in single precision (SureSigns, fast/simd/overlap.h). The
/// clipped scheme needs heights, not only signs, and no tie rule: fast/prism/master_prism.h takes the same determinant.
/// All finite doubles are welcome; results do not change when all lengths are multiplied by 2^k.
namespace pcm::fast {

/// A view of a vertex. `rank` is its position in the order of the tie rule: E's vertices in file order, then F's.
struct RankedPoint {
  const double* x_Me;  ///< three coordinates in Me, m
  std::int64_t rank;
};

/// The error bound of the filter relative to the sum of the absolute values of the determinant's six terms.
///
/// With u = 2^-53 each term of the computed determinant carries at most 8 roundings: three differences of coordinates,
/// the product of two of them, the difference of two such products, the product with the third, two sums. So the error
/// is at most gamma_8 times the exact sum of absolute values, gamma_n = n u / (1 - n u), and that sum, computed with at
/// most 10 roundings (the two additions below join), is at most 1 / (1 - 10 u) times the computed one. The excess of 9
/// u over that also pays for rounding the bound itself.
///
/// Underflow: an underflowing product errs by at most 2^-1075. Adding kFilterUnderflow = 2^-960 to each product's
/// absolute value adds more than u * 2^-960 = 2^-1013 to the bound on its error, and that grows with it as it is
/// multiplied on. Overflow: no intermediate value of the determinant exceeds its counterpart in the bound, so where
/// anything overflows the bound is infinite or NaN and every comparison with it fails.
inline constexpr double kFilterRelative = 9 * 0x1p-53;
inline constexpr double kFilterUnderflow = 0x1p-960;
static_assert(9 * (1 - 0x1p-53) * (1 - 8 * 0x1p-53) * (1 - 10 * 0x1p-53) > 8, "9 u covers eight roundings");
static_assert(0x1p-53 * kFilterUnderflow >= 0x1p-1022, "the bound itself never underflows");

/// The sign of ((b - a) x (c - a)) . (d - a) where floating point is sure of it, else 0.
inline int filtered_orientation(const double* a, const double* b, const double* c, const double* d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double bxcy = bx * cy, bycx = by * cx;
  const double bycz = by * cz, bzcy = bz * cy;
  const double bzcx = bz * cx, bxcz = bx * cz;
  const double determinant = (bycz - bzcy) * dx + (bzcx - bxcz) * dy + (bxcy - bycx) * dz;
  const double magnitude = (std::abs(bycz) + std::abs(bzcy) + kFilterUnderflow) * std::abs(dx) +
                           (std::abs(bzcx) + std::abs(bxcz) + kFilterUnderflow) * std::abs(dy) +
                           (std::abs(bxcy) + std::abs(bycx) + kFilterUnderflow) * std::abs(dz) + kFilterUnderflow;
  const double bound = kFilterRelative * magnitude;
  return (determinant > bound) - (determinant < -bound);
}

/// The same bound for all points no two of which are farther apart than `extent` along any axis, or whose greatest
/// distances along the three axes have no greater product: each of the six terms is at most extent^3. A part in 2^40
/// pays for the roundings of the bound itself.
inline double sure_determinant(double extent) {
  const double product = extent * extent + kFilterUnderflow;
  return kFilterRelative * (1 + 0x1p-40) * (6 * product * extent + kFilterUnderflow);
}

/// In place of `sure_determinant`: every sign is found by exact arithmetic.
inline constexpr double kNeverSure = std::numeric_limits<double>::quiet_NaN();

/// The exact sign of ((b - a) x (c - a)) . (d - a), 0 where the four points lie in one plane. About a microsecond.
int exact_orientation(const double* a, const double* b, const double* c, const double* d);

/// The tie rule's sign for four points whose exact_orientation is 0; never 0. Ranks must differ.
int tie_rule_orientation(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, const RankedPoint& d);

/// What `orientation` does where the filter can't tell.
int unfiltered_orientation(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, const RankedPoint& d,
                           WorkCounters& work);

/// +1 where d is above the plane of (a, b, c), on the side (b - a) x (c - a) points to, -1 where it is below. Never 0:
/// ties are decided by simulation of simplicity (Edelsbrunner and Muecke 1990), coordinate j = 1, 2, 3 of vertex i
/// moved by eps^(2^(3 i - j)), i from 1, eps -> 0+: z moves most, and earlier vertices more. Ranks must differ.
///
/// Exchanging two points, with their ranks, negates it; only the order of the ranks matters. Points that coincide, lie
/// on a line or in a plane are welcome. Not promised: the same sign of a tie after moving or turning both bodies,
/// reordering vertices, or exchanging E and F.
inline int orientation(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, const RankedPoint& d,
                       WorkCounters& work) {
  ++work.predicates;
  const int sign = filtered_orientation(a.x_Me, b.x_Me, c.x_Me, d.x_Me);
  return sign != 0 ? sign : unfiltered_orientation(a, b, c, d, work);
}

/// `orientation` of several points against one plane (a, b, c). What only depends on the plane is computed once, and
/// one bound for all points, `sure_determinant`, decides most signs. The points must outlive this.
class OrientedPlane {
 public:
  OrientedPlane(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, double sure)
      : a_(a), b_(b), c_(c), sure_(sure) {
    const double bx = b.x_Me[0] - a.x_Me[0], by = b.x_Me[1] - a.x_Me[1], bz = b.x_Me[2] - a.x_Me[2];
    const double cx = c.x_Me[0] - a.x_Me[0], cy = c.x_Me[1] - a.x_Me[1], cz = c.x_Me[2] - a.x_Me[2];
    N_ = {by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx};
  }

  /// Whether orientation(a, b, c, d) is +1.
  bool above(const RankedPoint& d, WorkCounters& work) const {
    const double determinant =
        N_[0] * (d.x_Me[0] - a_.x_Me[0]) + N_[1] * (d.x_Me[1] - a_.x_Me[1]) + N_[2] * (d.x_Me[2] - a_.x_Me[2]);
    if (!(std::abs(determinant) > sure_)) return not_sure(d, work) > 0;
    ++work.predicates;
    return determinant > 0;
  }

 private:
  int not_sure(const RankedPoint& d, WorkCounters& work) const {
    if (!std::isnan(sure_)) return orientation(a_, b_, c_, d, work);
    ++work.predicates;
    return unfiltered_orientation(a_, b_, c_, d, work);
  }

  const RankedPoint& a_;
  const RankedPoint& b_;
  const RankedPoint& c_;
  double sure_;
  std::array<double, 3> N_;
};

}  // namespace pcm::fast
