// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/bounds/prism_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>

#include "tests/fast/exact_numbers.h"

/// A master face's coordinates of a point against rational numbers, in regimes that each make another term of their
/// error the greatest: without it, the error is out of bounds there.
namespace pcm::fast {
namespace {

struct Regime {
  const char* name;
  double width;               ///< of the master face: the least is a needle
  double depth;               ///< of the points beneath it
  double stir_E, stir_F;      ///< rounding of the vertices of master and point
  double far;                 ///< how far off the points are on which the vertices' own error is tried
  double least_weight_ratio;  ///< the bounds are no looser than that
  double least_depth_ratio;
};

void PrintTo(const Regime& regime, std::ostream* out) {
  *out << regime.name;
}

RationalVector stirred(const Eigen::Vector3d& x, double stir, Doubles& random) {
  RationalVector result = rational(x);
  for (mpq_class& c : result) c += mpq_class(random.integer(0, 1) == 0 ? stir : -stir);
  return result;
}

struct ExactPoint {
  double s_error, t_error, depth_error;
};

/// How far coordinates of x are from those of the true point over the true face.
ExactPoint error_of(const std::array<mpq_class, 2>& weights, const mpq_class& seen_depth,
                    const std::array<RationalVector, 3>& p, const RationalVector& x) {
  const RationalVector a = minus(p[1], p[0]), b = minus(p[2], p[0]), d = minus(x, p[0]), N = cross(a, b);
  const mpq_class square = dot(N, N);
  const mpq_class s = dot(cross(d, b), N) / square, t = dot(cross(a, d), N) / square;
  const mpf_class depth = -mpf_class(dot(d, N), 400) / sqrt(mpf_class(square, 400));
  return {mpq_class(s - weights[0]).get_d(), mpq_class(t - weights[1]).get_d(),
          mpf_class(depth - mpf_class(seen_depth, 400)).get_d()};
}

/// The affine map with the prism's computed gradients, free of roundings.
struct ExactMap {
  std::array<mpq_class, 2> weights;
  mpq_class depth;

  ExactMap(const MasterPrism& prism, const RationalVector& x) {
    const FaceGeometry& face = prism.face();
    weights[0] = dot(rational(prism.inward_Me(2)), minus(x, rational(face.points_Me[2])));
    weights[1] = dot(rational(prism.inward_Me(0)), minus(x, rational(face.points_Me[0])));
    depth = -dot(rational(face.N_Me), minus(x, rational(face.points_Me[0]))) / (2 * mpq_class(face.area));
  }
};

struct Ratios {
  double weight = 0, depth = 0;

  void expect(const ExactPoint& off, const PrismPositionError& bound) {
    EXPECT_LE(std::abs(off.s_error), bound.s);
    EXPECT_LE(std::abs(off.t_error), bound.t);
    EXPECT_LE(std::abs(off.depth_error), bound.depth);
    weight = std::max({weight, std::abs(off.s_error) / bound.s, std::abs(off.t_error) / bound.t});
    depth = std::max(depth, std::abs(off.depth_error) / bound.depth);
  }
};

class PrismErrorOf : public testing::TestWithParam<Regime> {};

TEST_P(PrismErrorOf, HoldsAndIsNotLoose) {
  const Regime& regime = GetParam();
  const Side master = regime.stir_E > 0 ? Side::F : Side::E;  // The one that moves is F's.
  Doubles random(84);
  WorkCounters work;
  Ratios together, of_vertices, of_frame;
  double function_ratio = 0, third_ratio = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Matrix3d Q =
        Eigen::Quaterniond(random.unit(), random.unit(), random.unit(), 1).normalized().toRotationMatrix();
    const Eigen::Vector3d about = Doubles::point([&] { return random.unit(); });
    std::array<Eigen::Vector3d, 3> p;
    const double phase = 3 * random.unit();
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = phase + 2.1 * static_cast<double>(k);
      p[k] = about + Q * Eigen::Vector3d(std::cos(angle), regime.width * std::sin(angle), 0);
    }
    const FaceGeometry geometry(p);
    const MasterPrism prism(geometry);
    double s = 0.5 * (1 + random.unit()), t = 0.5 * (1 + random.unit());
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    const Eigen::Vector3d x = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]) - regime.depth * geometry.n_Me;
    const PrismPoint seen = prism.see(x, work);

    const Eigen::Vector3d rounding_E = Eigen::Vector3d::Constant(regime.stir_E);
    const Eigen::Vector3d rounding_F = Eigen::Vector3d::Constant(regime.stir_F);
    const FaceError face(geometry, rounding_E);
    const PrismError error(prism, face, master, rounding_E, rounding_E.cwiseMax(rounding_F));
    const PrismPositionError vertices =
        error.of_vertices(error.rounding({x, x, x}, {seen, seen, seen}, {}), rounding_F);
    const PrismPositionError frame = error.of_frame(regime.depth);
    const std::array<RationalVector, 3> true_p{stirred(p[0], regime.stir_E, random),
                                               stirred(p[1], regime.stir_E, random),
                                               stirred(p[2], regime.stir_E, random)};
    const RationalVector true_x = stirred(x, regime.stir_F, random);
    const ExactPoint off =
        error_of({mpq_class(seen[kS]), mpq_class(seen[kT])}, mpq_class(seen[kDepth]), true_p, true_x);
    together.expect(off, {vertices.s + frame.s, vertices.t + frame.t, vertices.depth + frame.depth});
    // Any linear function of the three, as depths and sides of steep faces are.
    const PrismFunction function{random.unit(), random.unit(), trial % 2 == 0 ? 0 : regime.width * random.unit()};
    const double function_off =
        std::abs(function.per_s * off.s_error + function.per_t * off.t_error + function.per_depth * off.depth_error);
    const double function_bound =
        error.of_function(function, regime.depth, error.rounding({x, x, x}, {seen, seen, seen}, {}), rounding_F);
    EXPECT_LE(function_off, function_bound * (1 + 1e-12));
    function_ratio = std::max(function_ratio, function_off / function_bound);
    const double third_off = std::abs(mpq_class(mpq_class(seen[0]) + seen[kS] + seen[kT] - 1).get_d());
    const double third_bound = error.of_third_weight(regime.depth, error.rounding({x, x, x}, {seen, seen, seen}, {}));
    EXPECT_LE(third_off, third_bound);
    third_ratio = std::max(third_ratio, third_off / third_bound);
    // The second step alone, and the first alone, for which x may be anywhere.
    const ExactMap map(prism, true_x);
    of_frame.expect(error_of(map.weights, map.depth, true_p, true_x), frame);
    const Eigen::Vector3d far = x + regime.far * Q * Doubles::point([&] { return random.unit(); });
    const PrismPoint far_seen = prism.see(far, work);
    const ExactMap far_map(prism, stirred(far, regime.stir_F, random));
    of_vertices.expect(
        {mpq_class(far_map.weights[0] - far_seen[kS]).get_d(), mpq_class(far_map.weights[1] - far_seen[kT]).get_d(),
         mpq_class(far_map.depth - far_seen[kDepth]).get_d()},
        error.of_vertices(error.rounding({far, far, far}, {far_seen, far_seen, far_seen}, {}), rounding_F));
  }
  std::printf(
      "  %s: greatest error over its bound, weights and depth: both %.3f %.3f, vertices %.3f %.3f, frame %.3f %.3f\n",
      regime.name, together.weight, together.depth, of_vertices.weight, of_vertices.depth, of_frame.weight,
      of_frame.depth);
  std::printf("  %s: functions %.3f, third weight %.3f\n", regime.name, function_ratio, third_ratio);
  EXPECT_GE(function_ratio, regime.least_weight_ratio);
  EXPECT_GE(third_ratio, 0.01);
  EXPECT_GE(together.weight, regime.least_weight_ratio);
  EXPECT_GE(together.depth, regime.least_depth_ratio);
}

INSTANTIATE_TEST_SUITE_P(Regimes, PrismErrorOf,
                         testing::Values(Regime{"Roundings", 1, 0.1, 0, 0, 10, 0.02, 0.02},
                                         Regime{"RoundingsOfANeedle", 1e-5, 0.1, 0, 0, 1, 0.02, 0.02},
                                         Regime{"RoundingsDeepBeneathANeedle", 1e-5, 10, 0, 0, 1, 0.01, 0.01},
                                         Regime{"InThePlaneOfANeedle", 1e-3, 1e-18, 0, 0, 0, 0.02, 0},
                                         Regime{"MovedSlave", 1, 0.1, 0, 1e-9, 0, 0.5, 0.5},
                                         Regime{"MovedMaster", 1, 1e-3, 1e-9, 0, 0, 0.3, 0.3},
                                         Regime{"TurnedMaster", 1e-2, 10, 1e-9, 0, 0, 0.1, 0.0}),
                         [](const testing::TestParamInfo<Regime>& test) { return std::string(test.param.name); });

/// But for the order in which a sum of three is taken.
void expect_alike(double a, double b) {
  EXPECT_NEAR(a, b, 0.15 * b);
}

void expect_alike(const PrismPositionError& a, const PrismPositionError& b) {
  expect_alike(a.s, b.s);
  expect_alike(a.t, b.t);
  expect_alike(a.depth, b.depth);
}

TEST(PrismError, IsTheSameWhateverTheAxesAreCalled) {
  Doubles random(85);
  WorkCounters work;
  // Faces in coordinate planes and points of few digits: hardly anything is rounded, and each product stands alone.
  const auto integer = [&](int low, int high) { return static_cast<int>(random.integer(low, high)); };
  const auto power = [&] { return std::ldexp(integer(0, 1) == 0 ? 1.0 : -1.0, integer(-3, 3)); };
  const auto dyadic = [&] { return 0x1p-4 * integer(-32, 32); };
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(trial);
    const Eigen::Vector3d p0 = Doubles::point(dyadic), a(power(), 0, 0), b(integer(0, 1) * a[0], power(), 0);
    const std::array<Eigen::Vector3d, 3> p{p0, p0 + a, p0 + b};
    const Eigen::Vector3d x = Doubles::point(dyadic);
    const Eigen::Vector3d rounding_E = 0x1p-50 * Doubles::point([&] { return 2 + random.unit(); });
    const PrismFunction function{random.unit(), random.unit(), random.unit()};
    const Side master = trial % 2 == 0 ? Side::E : Side::F;
    const auto errors_of = [&](std::array<Eigen::Index, 3> axes) {
      const auto renamed = [&](const Eigen::Vector3d& v) {
        return Eigen::Vector3d(v[axes[0]], v[axes[1]], v[axes[2]]);
      };
      const FaceGeometry face({renamed(p[0]), renamed(p[1]), renamed(p[2])});
      const MasterPrism prism(face);
      const PrismError error(prism, FaceError(face, renamed(rounding_E)), master, renamed(rounding_E),
                             renamed(2 * rounding_E));
      const PrismPoint seen = prism.see(renamed(x), work);
      const PrismRounding rounding = error.rounding({renamed(x), renamed(x), renamed(x)}, {seen, seen, seen}, {});
      const Eigen::Vector3d of_point = error.of_point_in_master();
      Eigen::Vector3d of_point_back;
      for (std::size_t k = 0; k < 3; ++k) of_point_back[axes[k]] = of_point[static_cast<Eigen::Index>(k)];
      return std::tuple(error.of_vertices(rounding, renamed(2 * rounding_E)), error.greatest_rounding(3),
                        error.of_frame(0.5), error.of_third_weight(0.5, rounding),
                        error.of_function(function, 0.5, rounding, renamed(2 * rounding_E)), of_point_back);
    };
    const auto [vertices, greatest, frame, third, of_function, point] = errors_of({0, 1, 2});
    EXPECT_GT(greatest.depth, 0);
    for (const auto& axes : {std::array<Eigen::Index, 3>{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {2, 1, 0}, {0, 2, 1}}) {
      const auto [vertices_2, greatest_2, frame_2, third_2, of_function_2, point_2] = errors_of(axes);
      expect_alike(vertices_2, vertices);
      expect_alike(greatest_2, greatest);
      expect_alike(frame_2, frame);
      expect_alike(third_2, third);
      expect_alike(of_function_2, of_function);
      EXPECT_EQ(point_2, point);
    }
  }
}

TEST(FaceWithSureNormal, IsExactForANeedleWhoseCrossProductLosesItsDigits) {
  // Three points nearly on a line: the normal is that of the integers they are multiples of.
  const double ulp = 0x1p-52;
  const std::array<Eigen::Vector3d, 3> p = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1 + ulp, 0x1p-3),
                                            Eigen::Vector3d(1 + ulp, 1 + 2 * ulp, 0x1p-3)};
  // (1, 1 + d, 1/8) x (1 + d, 1 + 2 d, 1/8) = (-d/8, d/8, (1 + 2 d) - (1 + d)^2 = -d^2).
  const FaceGeometry face = face_with_sure_normal(p);
  EXPECT_EQ(face.N_Me, Eigen::Vector3d(-ulp / 8, ulp / 8, -ulp * ulp));
  EXPECT_NE(FaceGeometry(p).N_Me, face.N_Me);
  EXPECT_LT(MasterPrism(face).tilt(), 0x1p-32);
}

TEST(FaceWithSureNormal, IsThePlainOneOtherwise) {
  const std::array<Eigen::Vector3d, 3> p = {Eigen::Vector3d(0.1, 0.2, 0.3), Eigen::Vector3d(1.1, 0.7, 0.4),
                                            Eigen::Vector3d(0.2, 1.3, 0.9)};
  EXPECT_EQ(face_with_sure_normal(p).N_Me, FaceGeometry(p).N_Me);
  EXPECT_LT(MasterPrism(FaceGeometry(p)).tilt(), 0x1p-45);
}

}  // namespace
}  // namespace pcm::fast
