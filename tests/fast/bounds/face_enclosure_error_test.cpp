// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "fast/bounds/face_over_piece.h"
#include "fast/bounds/prism_error.h"
#include "fast/bounds/uncertain_strips.h"
#include "fast/prism/master_prism.h"
#include "tests/fast/exact_numbers.h"

/// What is said of a face that a master face sees, against the face that the exact problem has there: rational numbers,
/// vertices off by their rounding, and positions at which a little decides whether anything is seen.
namespace pcm::fast::face_enclosure_error_test {
namespace {

/// Three weights and the depth in units of |N|.
using Seen = std::array<mpq_class, 4>;
using SeenPolygon = std::vector<Seen>;

class ExactPrism {
 public:
  explicit ExactPrism(const std::array<RationalVector, 3>& p) : p0_(p[0]) {
    a_ = minus(p[1], p0_);
    b_ = minus(p[2], p0_);
    N_ = cross(a_, b_);
    square_ = dot(N_, N_);
  }
  mpf_class normal_length() const { return sqrt(mpf_class(square_, 300)); }
  Seen see(const RationalVector& x) const {
    const RationalVector d = minus(x, p0_);
    const mpq_class s = dot(cross(d, b_), N_) / square_, t = dot(cross(a_, d), N_) / square_;
    return {1 - s - t, s, t, -dot(d, N_) / square_};
  }

 private:
  RationalVector p0_, a_, b_, N_;
  mpq_class square_;
};

template <class Height>
SeenPolygon kept(const SeenPolygon& polygon, Height&& height) {
  SeenPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Seen& x = polygon[i];
    const Seen& y = polygon[(i + 1) % polygon.size()];
    const mpq_class at_x = height(x), at_y = height(y);
    if (at_x >= 0) result.push_back(x);
    if (sgn(at_x) * sgn(at_y) >= 0) continue;
    const mpq_class share = at_x / (at_x - at_y);
    Seen between;
    for (std::size_t c = 0; c < 4; ++c) between[c] = x[c] + share * (y[c] - x[c]);
    result.push_back(between);
  }
  return result;
}

SeenPolygon where_not_negative(SeenPolygon polygon, std::size_t coordinates) {
  for (std::size_t k = 0; k < coordinates && !polygon.empty(); ++k)
    polygon = kept(polygon, [k](const Seen& x) { return x[k]; });
  return polygon;
}

/// What lies over the master face, or above it.
SeenPolygon over_or_above_master(const SeenPolygon& polygon) {
  return where_not_negative(polygon, 3);
}

/// What lies over the master face and not above it.
SeenPolygon over_master(const SeenPolygon& polygon) {
  return where_not_negative(polygon, 4);
}

mpq_class cross_of(const Seen& a, const Seen& b, const Seen& c) {
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

mpq_class area_of(const SeenPolygon& polygon) {
  mpq_class sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += cross_of(polygon[0], polygon[i], polygon[i + 1]);
  return abs(sum) / 2;
}

Seen as_exact(const PrismPoint& x) {
  return {mpq_class(x[0]), mpq_class(x[kS]), mpq_class(x[kT]), mpq_class(x[kDepth])};
}

/// The depth of a plane through three points.
mpq_class depth_at(const std::array<Seen, 3>& f, const mpq_class& s, const mpq_class& t) {
  const Seen x{0, s, t, 0};
  const mpq_class whole = cross_of(f[0], f[1], f[2]);
  return (cross_of(x, f[1], f[2]) * f[0][3] + cross_of(f[0], x, f[2]) * f[1][3] + cross_of(f[0], f[1], x) * f[2][3]) /
         whole;
}

enum class Place {
  anywhere,
  at_a_side,  ///< beyond a side of the master but for what shifts make
  at_plane,   ///< above it but for that
  upright,    ///< seen edgewise but for that
  vast,       ///< far larger than the master
  hanging,    ///< from one or two of the master's corners
};

struct Regime {
  const char* name;
  Place place;
  Side master;
  bool own;
  double stir;  ///< of F's vertices, m; 0: roundings alone
  double width, depth;
  int trials = 300;
};

void PrintTo(const Regime& regime, std::ostream* out) {
  *out << regime.name;
}

struct Ratios {
  double shift = 0, side = 0, depth = 0, field = 0, line = 0, area = 0;
  int found = 0, seen = 0, edgewise = 0, unseen = 0;
  int hangs = 0, hangs_from_above = 0, leaves_alone = 0;
};

double ratio(const mpq_class& off, double bound) {
  return bound > 0 ? mpq_class(abs(off) / mpq_class(bound)).get_d() : off == 0 ? 0.0 : HUGE_VAL;
}

bool is_corner(const Seen& x) {
  return x[0] * x[1] == 0 && x[1] * x[2] == 0 && x[0] * x[2] == 0;
}

/// Holds what is said of a face that has corners of the master: linear functions are positive where they are at the
/// corners of a polygon.
void hold_hanging(const FaceEnclosure& f, const std::array<Seen, 3>& true_seen, Ratios& ratios) {
  if (f.only_hangs) {
    const SeenPolygon beneath = over_or_above_master({true_seen[0], true_seen[1], true_seen[2]});
    for (const Seen& x : beneath) ASSERT_TRUE(x[3] > 0 || (x[3] == 0 && is_corner(x)));
    ++ratios.hangs;
    const auto is_above = [](const Seen& x) { return x[3] < 0; };
    ratios.hangs_from_above += std::any_of(true_seen.begin(), true_seen.end(), is_above) && !beneath.empty();
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (f.fixed[k] == f.fixed[next] || !leaves_master_alone(f, k)) continue;
    for (const Seen& x : over_or_above_master({true_seen[k], true_seen[next]})) ASSERT_TRUE(is_corner(x));
    ++ratios.leaves_alone;
  }
}

class FootprintOf : public testing::TestWithParam<Regime> {};

RationalVector stirred(const Eigen::Vector3d& x, double stir, Doubles& random) {
  RationalVector result = rational(x);
  for (mpq_class& c : result) c += mpq_class(random.integer(0, 1) == 0 ? stir : -stir);
  return result;
}

/// Where the corners are drawn, as the master sees them.
std::array<PrismPoint, 3> drawn_corners(const Regime& regime, Doubles& random, double little) {
  std::array<PrismPoint, 3> corners;
  for (PrismPoint& c : corners) {
    const double s = random.unit() + 0.3, t = random.unit() + 0.3;
    c = {1 - s - t, s, t, regime.depth * (0.5 + random.unit())};
  }
  const auto weight = static_cast<int>(random.integer(0, 2));
  switch (regime.place) {
    case Place::anywhere:
    case Place::hanging:
      break;
    case Place::vast:
      for (std::size_t k = 0; k < 3; ++k) {
        const double angle = 2.1 * static_cast<double>(k) + random.unit(), size = 0x1p20 * (1.5 + random.unit());
        const double s = size * std::cos(angle), t = size * std::sin(angle);
        corners[k] = {1 - s - t, s, t, 0.3 * (s * random.unit() + 1)};
      }
      break;
    case Place::at_a_side:
      for (std::size_t k = 0; k < 3; ++k) {
        const double off = k < 2 ? little * 3 * random.unit() : -0.5 - 0.4 * random.unit();
        PrismPoint& c = corners[k];
        const double along = random.unit();
        if (weight == 0) c = {off, 0.5 - 0.5 * off + along, 0.5 - 0.5 * off - along, c[kDepth]};
        if (weight == 1) c = {1 - off - along, off, along, c[kDepth]};
        if (weight == 2) c = {1 - off - along, along, off, c[kDepth]};
        if (random.integer(0, 1) == 0) c[kDepth] = std::abs(c[kDepth]);
      }
      break;
    case Place::at_plane:
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k][kDepth] = k < 2 ? regime.width * little * 3 * random.unit() : -0.3 + 0.2 * random.unit();
      }
      break;
    case Place::upright: {
      PrismPoint& c = corners[2];
      const double share = random.unit();
      const double s = corners[0][kS] + share * (corners[1][kS] - corners[0][kS]) + 40 * little * random.unit();
      const double t = corners[0][kT] + share * (corners[1][kT] - corners[0][kT]) + 40 * little * random.unit();
      c = {1 - s - t, s, t, regime.depth * (0.5 + random.unit())};
      break;
    }
  }
  return corners;
}

TEST_P(FootprintOf, HoldsTheFaceOfTheExactProblem) {
  const Regime& regime = GetParam();
  Doubles random(61);
  WorkCounters work;
  Ratios greatest;
  for (int trial = 0; trial < regime.trials; ++trial) {
    const Eigen::Matrix3d Q =
        Eigen::Quaterniond(random.unit(), random.unit(), random.unit(), 1).normalized().toRotationMatrix();
    const Eigen::Vector3d about = Doubles::point([&] { return random.unit(); });
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = 0.3 + 2.1 * static_cast<double>(k);
      p[k] = about + regime.width * (Q * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
    }
    const FaceGeometry geometry(p);
    const MasterPrism prism(geometry);

    // The face, and the exact problem's.
    const double little = (regime.stir > 0 ? 3 * regime.stir : 0x1p-51 * (1 + regime.depth)) / regime.width;
    const std::array<PrismPoint, 3> drawn = drawn_corners(regime, random, little);
    std::array<Eigen::Vector3d, 3> x = p;
    std::array<PrismPoint, 3> corners;
    std::array<bool, 3> shared{};
    std::array<RationalVector, 3> true_p, true_x;
    const double stir_master = regime.master == Side::F ? regime.stir : 0;
    const double stir_face = (regime.master == Side::F) == regime.own ? regime.stir : 0;
    for (std::size_t k = 0; k < 3; ++k) true_p[k] = stirred(p[k], stir_master, random);
    const auto hanging = static_cast<std::size_t>(regime.place == Place::hanging ? random.integer(1, 2) : 0);
    const auto first = static_cast<std::size_t>(random.integer(0, 2));
    for (std::size_t k = 0; k < 3; ++k) {
      if (k < hanging) {
        const std::size_t corner = (first + k) % 3;
        shared[k] = true;
        corners[k] = MasterPrism::corner(static_cast<int>(corner));
        true_x[k] = true_p[corner];
        continue;
      }
      PrismPoint c = drawn[k];
      if (regime.place == Place::hanging && random.integer(0, 2) > 0) {
        // Nearly upright beneath the sides at that corner.
        const double along = random.unit(), off = 40 * little * random.unit();
        const std::size_t from = first, to = (first + 1) % 3;
        c = PrismPoint::Zero();
        c[static_cast<int>(from)] = 1 - along - 0.5 * off;
        c[static_cast<int>(to)] = along - 0.5 * off;
        c[static_cast<int>((first + 2) % 3)] = off;
        c[kDepth] = drawn[k][kDepth];
      }
      if (regime.place == Place::hanging && hanging == 1 && k == 1 && random.integer(0, 1) == 0) {
        // Far beyond a side through that corner, or hardly, and about the master's plane, or above it.
        const double scale = random.integer(0, 1) == 0 ? 1 : 40 * little;
        const auto beyond = static_cast<int>((first + 1) % 3), along = static_cast<int>((first + 2) % 3);
        c[beyond] = scale * random.unit();
        c[along] = random.unit();
        c[static_cast<int>(first)] = 1 - c[beyond] - c[along];
        c[kDepth] = regime.width * (random.integer(0, 1) == 0 ? 3 * little : 0.3) * random.unit();
      }
      x[k] = p[0] + c[kS] * (p[1] - p[0]) + c[kT] * (p[2] - p[0]) - c[kDepth] * geometry.n_Me;
      corners[k] = prism.see(x[k], work);
      true_x[k] = stirred(x[k], stir_face, random);
    }
    const Eigen::Vector3d own_rounding = Eigen::Vector3d::Constant(stir_master);
    const Eigen::Vector3d rounding = Eigen::Vector3d::Constant(stir_face);
    const PrismError error(prism, FaceError(geometry, own_rounding), regime.master, own_rounding,
                           Eigen::Vector3d::Constant(regime.stir));
    const bool unseen = surely_unseen(error, regime.own, corners);
    FaceEnclosure f;
    const bool found = find_face_enclosure(error, {0, regime.own, {0, 1, 2}, x, corners, shared, rounding}, f);

    const ExactPrism exact(true_p);
    const mpf_class length_N = exact.normal_length();
    const auto metres = [&length_N](const mpq_class& q) { return mpq_class(mpf_class(q, 300) * length_N); };
    std::array<Seen, 3> true_seen{exact.see(true_x[0]), exact.see(true_x[1]), exact.see(true_x[2])};
    for (Seen& c : true_seen) c[3] = metres(c[3]);
    const SeenPolygon part = over_master({true_seen[0], true_seen[1], true_seen[2]});
    const mpq_class area = area_of(part);
    greatest.unseen += unseen || !found ? 1 : 0;
    if (area > 0) {
      ASSERT_FALSE(unseen) << trial;
      ASSERT_TRUE(found) << trial;
    }
    if (!found) continue;
    ++greatest.found;
    greatest.seen += area > 0 ? 1 : 0;
    for (const Seen& c : part) {
      if (!(area > 0)) break;
      ASSERT_LE(mpq_class(f.box.low_s), c[1]) << trial;
      ASSERT_GE(mpq_class(f.box.high_s), c[1]) << trial;
      ASSERT_LE(mpq_class(f.box.low_t), c[2]) << trial;
      ASSERT_GE(mpq_class(f.box.high_t), c[2]) << trial;
      ASSERT_LE(c[3], mpq_class(f.greatest)) << trial;
    }
    find_side_errors(error, f);
    if (f.facing == 0) {
      ++greatest.edgewise;
      FaceEnclosure carrier = f;
      for (const double share : {1.0, 0.5, 0.2, 0.01}) {
        const double depth = share * std::max(f.greatest, 0.0);
        const mpq_class down_to =
            area_of(kept(part, [depth](const Seen& c) { return mpq_class(mpq_class(depth) - c[3]); }));
        const double bound = sliver(f, carrier, depth, f.box).area;
        ASSERT_LE(down_to, mpq_class(bound * (1 + 1e-12))) << trial << " " << share;
        greatest.area = std::max(greatest.area, ratio(down_to, bound));
      }
      continue;
    }
    const int facing = sgn(cross_of(true_seen[0], true_seen[1], true_seen[2]));
    ASSERT_EQ(facing, f.facing) << trial;
    // Counterclockwise, as the enclosure has it.
    if (facing < 0) std::swap(true_seen[1], true_seen[2]);
    hold_hanging(f, true_seen, greatest);
    if (HasFatalFailure()) FAIL() << trial;
    const std::array<Seen, 3> computed{as_exact(f.corners[0]), as_exact(f.corners[1]), as_exact(f.corners[2])};
    for (const Seen& c : part) {
      if (!(area > 0)) break;
      const mpq_class plane = mpq_class(f.depth.value) + mpq_class(f.depth.per_s) * (c[1] - mpq_class(f.depth.s_0)) +
                              mpq_class(f.depth.per_t) * (c[2] - mpq_class(f.depth.t_0));
      ASSERT_LE(abs(mpq_class(plane - c[3])), mpq_class(f.depth_error)) << trial;
      greatest.depth = std::max(greatest.depth, ratio(plane - c[3], f.depth_error));
      const mpq_class field = depth_at(computed, c[1], c[2]) - c[3];
      ASSERT_LE(abs(field), mpq_class(f.field_error)) << trial;
      greatest.field = std::max(greatest.field, ratio(field, f.field_error));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      // A stretch of the exact side, as a polygon of two corners.
      SeenPolygon side = over_master({true_seen[k], true_seen[next]});
      const mpq_class side_s = computed[next][1] - computed[k][1], side_t = computed[next][2] - computed[k][2];
      for (const Seen& c : side) {
        const mpq_class off = side_s * (c[2] - computed[k][2]) - side_t * (c[1] - computed[k][1]);
        ASSERT_LE(abs(off), mpq_class(f.side_error[k] * (1 + 1e-12))) << trial;
        const double by_position_error =
            mpq_class(abs(side_s) * mpq_class(f.position_error.t) + abs(side_t) * mpq_class(f.position_error.s))
                .get_d();
        ASSERT_LE(abs(off), mpq_class(by_position_error * (1 + 1e-12))) << trial;
        greatest.side = std::max(greatest.side, ratio(off, f.side_error[k]));
        greatest.shift = std::max(greatest.shift, ratio(off, by_position_error));
      }
    }
    // What is computed of it.
    ProjectedFace projected;
    if (!project_face({0, 1, 2}, corners, projected)) continue;
    for (int i = 0; i < projected.seen.count; ++i) {
      const PrismPoint& c = projected.seen[i];
      ASSERT_GE(c[kS], -f.cut_error.s) << trial;
      ASSERT_GE(c[kT], -f.cut_error.t) << trial;
      // A polygon cut out of a triangle lies within it.
      for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class inward = cross_of(computed[k], computed[(k + 1) % 3], as_exact(c));
        ASSERT_GE(inward, mpq_class(-f.side_cuts[k])) << trial << " " << i;
      }
      ASSERT_GE(1 - c[kS] - c[kT], -(f.third_side_error + f.cut_error.s + f.cut_error.t)) << trial;
      // Where the exact face is not, nothing is said of its plane.
      const Seen here = as_exact(c);
      bool covered = true;
      for (std::size_t k = 0; k < 3; ++k)
        covered = covered && cross_of(true_seen[k], true_seen[(k + 1) % 3], here) >= 0;
      if (!covered) continue;
      const mpq_class off = depth_at(true_seen, mpq_class(c[kS]), mpq_class(c[kT])) - mpq_class(c[kDepth]);
      const double bound = c[kDepth] > 0 ? f.field_error : f.line_error;
      ASSERT_LE(abs(off), mpq_class(bound)) << trial << " " << i << " " << c[kDepth];
      greatest.line = std::max(greatest.line, ratio(off, bound));
    }
  }
  std::printf("  %s: %d found, %d seen, %d edgewise, %d surely unseen\n", regime.name, greatest.found, greatest.seen,
              greatest.edgewise, greatest.unseen);
  std::printf("  greatest over bound: shift %.3f side %.3f depth %.3f field %.3f computed %.3f sliver %.3f\n",
              greatest.shift, greatest.side, greatest.depth, greatest.field, greatest.line, greatest.area);
  EXPECT_GE(greatest.found, regime.trials / 4);
  if (regime.place != Place::hanging) return;
  std::printf("  %d only hang, %d of them from above; %d sides leave the master alone\n", greatest.hangs,
              greatest.hangs_from_above, greatest.leaves_alone);
  EXPECT_GE(greatest.hangs_from_above, 10);
  EXPECT_GE(greatest.leaves_alone, 10);
}

INSTANTIATE_TEST_SUITE_P(
    Regimes, FootprintOf,
    testing::Values(Regime{"Roundings", Place::anywhere, Side::E, false, 0, 1, 1},
                    Regime{"RoundingsFarBeneath", Place::anywhere, Side::E, false, 0, 1e-3, 1},
                    Regime{"MovedSlave", Place::anywhere, Side::E, false, 1e-9, 1, 1},
                    Regime{"MovedMaster", Place::anywhere, Side::F, false, 1e-9, 1, 1},
                    Regime{"MovedMasterFarBeneath", Place::anywhere, Side::F, false, 1e-9, 1e-2, 1},
                    Regime{"RoundingsAtASide", Place::at_a_side, Side::E, false, 0, 1e-2, 1},
                    Regime{"MovedSlaveAtASide", Place::at_a_side, Side::E, false, 1e-9, 1, 1, 800},
                    Regime{"MovedMasterAtASide", Place::at_a_side, Side::F, false, 1e-9, 1, 1, 800},
                    Regime{"TurnedMasterAtASide", Place::at_a_side, Side::F, false, 1e-9, 1e-2, 1},
                    Regime{"RoundingsAtThePlane", Place::at_plane, Side::E, false, 0, 1, 1},
                    Regime{"MovedSlaveAtThePlane", Place::at_plane, Side::E, false, 1e-9, 1, 1},
                    Regime{"MovedMasterAtThePlane", Place::at_plane, Side::F, false, 1e-9, 1, 1},
                    Regime{"RoundingsUpright", Place::upright, Side::E, false, 0, 1e-2, 1},
                    Regime{"MovedSlaveUpright", Place::upright, Side::E, false, 1e-9, 1, 1, 1000},
                    Regime{"TurnedMasterUpright", Place::upright, Side::F, false, 1e-9, 1e-2, 1},
                    Regime{"RoundingsVast", Place::vast, Side::E, false, 0, 1, 1, 1000},
                    Regime{"MovedOwnHanging", Place::hanging, Side::F, true, 1e-9, 1e-2, 1, 1000},
                    Regime{"RoundingsHanging", Place::hanging, Side::E, true, 0, 1e-2, 1}),
    [](const testing::TestParamInfo<Regime>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pcm::fast::face_enclosure_error_test
