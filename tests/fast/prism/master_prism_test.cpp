// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/prism/master_prism.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "tests/fast/exact_numbers.h"

namespace pcm::fast {
namespace {

using FacePoints = std::array<Eigen::Vector3d, 3>;

mpq_class exact_height(const FacePoints& f, const Eigen::Vector3d& x) {
  const RationalVector f0 = rational(f[0]);
  return dot(cross(minus(rational(f[1]), f0), minus(rational(f[2]), f0)), minus(rational(x), f0));
}

/// |computed / exact - 1|; both may be 0.
double relative_error(double computed, const mpq_class& exact) {
  if (exact == 0) return computed == 0 ? 0 : std::numeric_limits<double>::infinity();
  return std::abs(mpq_class(mpq_class(computed) / exact - 1).get_d());
}

FacePoints draw_face(Doubles& random) {
  FacePoints f;
  do {
    for (Eigen::Vector3d& corner : f) corner = Doubles::point([&] { return random.unit(); });
  } while ((f[1] - f[0]).cross(f[2] - f[0]).norm() < 0.1);
  return f;
}

/// A point about the face whose distance from the plane is some 2^-k of that from the corners.
Eigen::Vector3d draw_point_near(const FacePoints& f, int k, Doubles& random) {
  const Eigen::Vector3d N = (f[1] - f[0]).cross(f[2] - f[0]).normalized();
  const double s = random.unit(), t = random.unit();
  return f[0] + s * (f[1] - f[0]) + t * (f[2] - f[0]) + std::ldexp(random.unit(), -k) * N;
}

TEST(HeightOver, IsSureToKHeightErrorOfItselfHoweverNearThePlane) {
  Doubles random(151);
  WorkCounters work;
  for (int k = 0; k <= 60; ++k) {
    for (int trial = 0; trial < 300; ++trial) {
      const FacePoints f = draw_face(random);
      const Eigen::Vector3d x = draw_point_near(f, k, random);
      const mpq_class exact = exact_height(f, x);
      EXPECT_LE(relative_error(SurePlane(f).height(x, work), exact), kHeightError + 0x1p-50) << "2^-" << k;
      // The depth's factor 1 / |N| is off by some ulps as well.
      const MasterPrism prism(face_with_sure_normal(f));
      const double doubled_area = 2 * prism.face().area;
      EXPECT_LE(relative_error(-prism.see(x, work)[kDepth] * doubled_area, exact), kHeightError + 0x1p-50) << k;
    }
  }
}

TEST(HeightOver, ScalesBitForBitWithPowersOfTwo) {
  Doubles random(154);
  WorkCounters work;
  for (int trial = 0; trial < 2000; ++trial) {
    const FacePoints f = draw_face(random);
    const Eigen::Vector3d x = draw_point_near(f, static_cast<int>(random.integer(0, 60)), random);
    const double height = SurePlane(f).height(x, work);
    for (const int k : {-100, -64, -33, -1, 1, 31, 63, 100}) {
      const double scale = std::ldexp(1, k);
      EXPECT_EQ(SurePlane(FacePoints{scale * f[0], scale * f[1], scale * f[2]}).height(scale * x, work),
                std::ldexp(height, 3 * k));
    }
  }
}

TEST(HeightOver, IsZeroExactlyInThePlane) {
  Doubles random(152);
  WorkCounters work;
  int in_plane = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    FacePoints f;
    for (Eigen::Vector3d& corner : f) corner = Doubles::point([&] { return random.small_integer(2); }) / 3;
    const Eigen::Vector3d x = Doubles::point([&] { return random.small_integer(2); }) / 3;
    const mpq_class exact = exact_height(f, x);
    EXPECT_EQ(SurePlane(f).height(x, work) == 0, exact == 0);
    in_plane += exact == 0 ? 1 : 0;
  }
  EXPECT_GE(in_plane, 1000);
}

TEST(HeightOver, IsRarelyComputedExactlyForPointsInNoSpecialPlace) {
  Doubles random(153);
  WorkCounters work;
  for (int trial = 0; trial < 200000; ++trial) {
    const FacePoints f = draw_face(random);
    SurePlane(f).height(Doubles::point([&] { return random.unit(); }), work);
  }
  std::printf("  %lld exact of %lld\n", static_cast<long long>(work.exact_predicates),
              static_cast<long long>(work.predicates));
  EXPECT_LE(static_cast<double>(work.exact_predicates), 4 * kExactHeight * static_cast<double>(work.predicates));
}

TEST(HeightOver, KeepsItsSignWhereItUnderflows) {
  Doubles random(155);
  WorkCounters work;
  int underflown = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    FacePoints f = draw_face(random);
    for (Eigen::Vector3d& corner : f) corner *= 0x1p-350;
    const Eigen::Vector3d x =
        f[0] + Doubles::point([&] { return std::ldexp(random.small_integer(3), -trial % 700 - 350); });
    const mpq_class exact = exact_height(f, x);
    const double height = SurePlane(f).height(x, work);
    ASSERT_EQ((height > 0) - (height < 0), sgn(exact)) << trial;
    const double depth = MasterPrism(face_with_sure_normal(f)).see(x, work)[kDepth];
    ASSERT_EQ((depth < 0) - (depth > 0), sgn(exact)) << trial;
    underflown += std::abs(height) == std::numeric_limits<double>::denorm_min();
  }
  EXPECT_GE(underflown, 50);
}

TEST(MasterPrism, DepthsThatUnderflowAreScaledSoThatTheirRatiosAreSure) {
  Doubles random(156);
  WorkCounters work;
  int scaled = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    // In a plane through the origin, so that points next to it are told apart by denormals, and by parts of them.
    FacePoints f = draw_face(random);
    const double size = std::ldexp(1, trial % 600 - 300);
    for (Eigen::Vector3d& corner : f) corner = {size * corner.x(), size * corner.y(), 16 * size * corner.x()};
    if ((f[1] - f[0]).cross(f[2] - f[0]).isZero(0)) continue;
    const MasterPrism prism(face_with_sure_normal(f));
    const int exponent = -1074 + static_cast<int>(random.integer(0, 300));
    FacePoints x;
    for (Eigen::Vector3d& point : x) {
      const double along = size * random.unit();
      point = {0, along, std::ldexp(random.small_integer(9), exponent)};
    }
    std::array<PrismPoint, 3> corners{prism.see(x[0], work), prism.see(x[1], work), prism.see(x[2], work)};
    if (!prism.depths_underflow(corners)) continue;
    ++scaled;
    const std::array<PrismPoint, 3> plain = corners;
    const int depth_exponent = prism.scale_depths(x, corners);
    EXPECT_LE(depth_exponent, 0);
    std::size_t deepest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(corners[k][kDepth]) > std::abs(corners[deepest][kDepth])) deepest = k;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class ratio = exact_height(f, x[k]) / exact_height(f, x[deepest]);
      ASSERT_LE(relative_error(corners[k][kDepth] / corners[deepest][kDepth], ratio), 0x1p-50) << trial;
      // Scaled back it is what was seen, but for some ulps, or some denormals.
      const double depth = std::ldexp(corners[k][kDepth], depth_exponent);
      ASSERT_NEAR(depth, plain[k][kDepth], 0x1p-48 * std::abs(depth) + 0x1p-1072 * std::max(1.0, 1 / prism.face().area))
          << trial;
      ASSERT_EQ((plain[k][kDepth] < 0) - (plain[k][kDepth] > 0), sgn(exact_height(f, x[k])));
      ASSERT_EQ(corners[k].head<3>(), plain[k].head<3>());
    }
  }
  EXPECT_GE(scaled, 1000);
}

// It keeps what is exact of its plane.
TEST(MasterPrism, SeesEachPointAsIfItHadSeenNoOther) {
  Doubles random(157);
  WorkCounters work;
  for (int trial = 0; trial < 50; ++trial) {
    const FacePoints f = draw_face(random);
    const MasterPrism prism(face_with_sure_normal(f));
    for (int k = 0; k <= 60; ++k) {
      const Eigen::Vector3d x = draw_point_near(f, k, random);
      ASSERT_EQ(prism.see(x, work), MasterPrism(prism.face()).see(x, work)) << "2^-" << k;
    }
    const FacePoints points{draw_point_near(f, 40, random), draw_point_near(f, 50, random), f[2]};
    std::array<PrismPoint, 3> corners, alone;
    ASSERT_EQ(prism.scale_depths(points, corners), MasterPrism(prism.face()).scale_depths(points, alone));
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(corners[k][kDepth], alone[k][kDepth]);
  }
  EXPECT_GE(work.exact_predicates, 1000);
}

// What compare/verify/bounds/master_view.h's bounds rest on, and fast/clipped/visible_parts.h's.
TEST(MasterPrism, SeesPointsTo24RoundingsOfTheirDistanceTimesTheSkewOfTheFaceHoweverNarrowItIs) {
  Doubles random(154);
  WorkCounters work;
  constexpr double u = 0x1p-53;
  for (const double thinness : {1.0, 8.0, 64.0, 0x1p10, 0x1p15}) {
    double worst = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const Eigen::Vector3d along = Doubles::point([&] { return random.unit(); }).normalized();
      const Eigen::Vector3d across = along.unitOrthogonal(), p0 = Doubles::point([&] { return random.unit(); });
      const MasterPrism prism(face_with_sure_normal({p0, p0 + along, p0 + along + across / thinness}));
      const FacePoints& p = prism.face().points_Me;
      const Eigen::Vector3d x = p0 + 30 * random.unit() * along + 30 * random.unit() * across -
                                std::ldexp(random.unit(), -13) * prism.face().n_Me;
      const PrismPoint seen = prism.see(x, work);

      const RationalVector a = minus(rational(p[1]), rational(p[0])), b = minus(rational(p[2]), rational(p[0]));
      const RationalVector N = cross(a, b), from_p0 = minus(rational(x), rational(p[0]));
      // All weights have a factor in common, by the error of |N|, that moves no line on which one of them is 0.
      const mpf_class factor = sqrt(mpf_class(dot(N, N), 256)) / (2 * prism.face().area);
      const auto off = [&](double weight, const mpq_class& exact) {
        return std::abs(mpf_class(weight - factor * mpf_class(exact, 256)).get_d());
      };
      const double s = off(seen[kS], dot(cross(from_p0, b), N) / dot(N, N));
      const double t = off(seen[kT], dot(cross(a, from_p0), N) / dot(N, N));
      const double length_s = prism.edge_s_Me().norm(), length_t = prism.edge_t_Me().norm();
      const double skew = length_s * length_t / (2 * prism.face().area);
      const double distance = std::max(length_s, length_t) + (x - p0).norm();
      const double allowed = skew * (24 * u * distance + 2 * prism.tilt() * std::abs(seen[kDepth]));
      worst = std::max(worst, (s * length_s + t * length_t) / allowed);
    }
    std::printf("  longest side over height %g: at most %.2f of what is allowed\n", thinness, worst);
    EXPECT_LE(worst, 1) << thinness;
  }
}

// What lets a face count as certain without its own uncertainty.
TEST(MasterPrism, GreatestUncertaintyIsAnUpperBoundForEveryFace) {
  Doubles random(153);
  WorkCounters work;
  int below = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const MasterPrism prism(face_with_sure_normal(draw_face(random)));
    std::array<PrismPoint, 3> corners;
    const double far = std::ldexp(1, trial % 40 - 20);
    for (PrismPoint& corner : corners) {
      const Eigen::Vector3d x = Doubles::point([&] { return far * random.unit(); });
      corner = prism.see(x, work);
    }
    for (const double max_coordinate : {0x1p-10, 1.0, 0x1p20}) {
      const Uncertainty own = prism.uncertainty(corners, max_coordinate);
      const Uncertainty greatest = prism.greatest_uncertainty(max_coordinate);
      ASSERT_GE(greatest.s, own.s) << trial;
      ASSERT_GE(greatest.t, own.t) << trial;
      below += own.s < greatest.s;
    }
  }
  EXPECT_GT(below, 1000);
}

}  // namespace
}  // namespace pcm::fast
