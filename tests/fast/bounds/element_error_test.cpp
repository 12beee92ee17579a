// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/bounds/element_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "fast/base/depth.h"
#include "fast/posed/transform.h"
#include "fast/posed/vertex_rounding.h"
#include "pcm/engine.h"
#include "tests/fast/exact_numbers.h"

/// The error bounds of an element's geometry against rational numbers, in regimes that each make another term of the
/// analysis the greatest: without it, the error is out of bounds there.
namespace pcm::fast::element_error_test {
namespace {

mpf_class real(const mpq_class& x) {
  return mpf_class(x, 400);
}

mpf_class length_of(const RationalVector& x) {
  return sqrt(real(dot(x, x)));
}

double distance(const std::array<mpf_class, 3>& a, const Eigen::Vector3d& b) {
  mpf_class sum(0, 400);
  for (int k = 0; k < 3; ++k) {
    const mpf_class difference = a[static_cast<std::size_t>(k)] - b[k];
    sum += difference * difference;
  }
  return mpf_class(sqrt(sum)).get_d();
}

/// The exact values of a face and of its line.
struct ExactFace {
  RationalVector N, C;

  explicit ExactFace(const std::array<RationalVector, 3>& p) : N(cross(minus(p[1], p[0]), minus(p[2], p[0]))) {
    for (std::size_t k = 0; k < 3; ++k) C[k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
  }
  std::array<mpf_class, 3> unit_normal() const {
    const mpf_class length = length_of(N);
    return {real(N[0]) / length, real(N[1]) / length, real(N[2]) / length};
  }
};

/// Where the points would be without rounding: anywhere in their boxes, at the corners more often than not.
std::array<RationalVector, 3> stirred(const FacePoints& p, const Eigen::Vector3d& rounding, Doubles& random) {
  std::array<RationalVector, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double share = random.integer(0, 2) == 0 ? random.unit() : (random.integer(0, 1) == 0 ? 1.0 : -1.0);
      result[i][k] = mpq_class(p[i][static_cast<Eigen::Index>(k)]) +
                     mpq_class(share) * mpq_class(rounding[static_cast<Eigen::Index>(k)]);
    }
  }
  return result;
}

/// A face of size 1 about a point, squeezed in one direction; `tilt` turns it out of the plane z = 0.
FacePoints draw_face(Doubles& random, double width, double tilt, const Eigen::Vector3d& about) {
  FacePoints p;
  const double s = std::sqrt(1 - tilt * tilt);
  const double phase = 3 * random.unit();
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = phase + 2.1 * static_cast<double>(i) + 0.3 * random.unit();
    const double x = std::cos(angle), y = width * std::sin(angle);
    p[i] = about + Eigen::Vector3d(x * s, y, -x * tilt);
  }
  return p;
}

/// Greatest error over its bound.
struct Ratio {
  double greatest = 0;
  void expect(double error, double bound) {
    EXPECT_LE(error, bound);
    if (bound > 0) greatest = std::max(greatest, error / bound);
  }
};

TEST(VertexRounding, HoldsForEveryVertexOfTheSurface) {
  Doubles random(81);
  Ratio vertex;
  for (int trial = 0; trial < 300; ++trial) {
    Pose pose;
    pose.A = Eigen::AngleAxisd(3 * random.unit(), Eigen::Vector3d(random.unit(), random.unit(), 1).normalized())
                 .toRotationMatrix();
    pose.r = std::ldexp(1.0, static_cast<int>(random.integer(-20, 20))) * Doubles::point([&] { return random.unit(); });
    TriangleMesh mesh;
    for (int i = 0; i < 3; ++i) mesh.vertices.push_back(Doubles::point([&] { return random.unit(); }));
    mesh.faces = {{0, 1, 2}};
    const Surface surface(mesh);
    const Eigen::Vector3d everywhere = greatest_vertex_rounding(surface.data(), pose);
    for (const Eigen::Vector3d& x : mesh.vertices) {
      const Eigen::Vector3d bound = vertex_rounding(pose, x), rounded = rounded_transform(pose, x);
      for (int k = 0; k < 3; ++k) {
        mpq_class exact(pose.r[k]);
        for (int j = 0; j < 3; ++j) exact += mpq_class(pose.A(k, j)) * mpq_class(x[j]);
        const double error = std::abs(mpq_class(exact - rounded[k]).get_d());
        vertex.expect(error, bound[k]);
        EXPECT_LE(error, everywhere[k]);
      }
    }
  }
  EXPECT_GE(vertex.greatest, 0.3);
}

TEST(FaceError, HoldsForSliversFarFacesAndStirredVertices) {
  Doubles random(82);
  Ratio area, normal, barycentre;
  for (int trial = 0; trial < 4000; ++trial) {
    const double width = std::ldexp(1.0, -static_cast<int>(random.integer(0, 20)));
    const double far = random.integer(0, 1) == 0 ? 0 : std::ldexp(1.0, static_cast<int>(random.integer(0, 12)));
    const FacePoints p = draw_face(random, width, 0.6, far * Doubles::point([&] { return random.unit(); }));
    const double stir = random.integer(0, 1) == 0 ? 0 : std::ldexp(width, -static_cast<int>(random.integer(12, 50)));
    const Eigen::Vector3d rounding = stir * Eigen::Vector3d(1, random.integer(0, 1) == 0 ? 0 : 1, 0.5);
    const FaceGeometry geometry(p);
    const FaceError error(geometry, rounding);
    if (!error.normal_known) continue;
    const ExactFace exact(stirred(p, rounding, random));
    area.expect(std::abs(mpf_class(length_of(exact.N) / 2 - geometry.area).get_d()), error.area);
    normal.expect(distance(exact.unit_normal(), geometry.n_Me), error.normal);
    for (int k = 0; k < 3; ++k) {
      const mpq_class off = exact.C[static_cast<std::size_t>(k)] - geometry.barycentre_Me()[k];
      barycentre.expect(std::abs(off.get_d()), error.barycentre_Me[k]);
    }
  }
  std::printf("  greatest error over its bound: area %.3f normal %.3f barycentre %.3f\n", area.greatest,
              normal.greatest, barycentre.greatest);
  EXPECT_GE(area.greatest, 0.1);
  EXPECT_GE(normal.greatest, 0.1);
  EXPECT_GE(barycentre.greatest, 0.5);
}

/// What decides the depth's error.
struct Regime {
  const char* name;
  double master_width, slave_width;  ///< the least is a sliver
  double tilt;                       ///< of the slave face: sine of its angle
  double depth;
  double stir_master, stir_slave;  ///< rounding of the vertices
  double least_ratio;              ///< the bound is no looser than that
};

void PrintTo(const Regime& regime, std::ostream* out) {
  *out << regime.name;
}

// N's bound hides them where it is greater, as it is for nearly all faces.
TEST(FaceError, CountsTheRoundingsThatFollowThoseOfN) {
  const FaceGeometry face({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 5, 0)});
  const FaceError error(face, Eigen::Vector3d::Zero());
  // The length of N: its square's three roundings count half, the root one, and the half none.
  EXPECT_GE(error.area - 0.5 * error.N, 2.4 * kUnitRoundoff * face.area);
  // That length again, and the division.
  EXPECT_GE(error.normal - error.N / (2 * face.area), 3.4 * kUnitRoundoff);
}

class DepthErrorOf : public testing::TestWithParam<Regime> {};

TEST_P(DepthErrorOf, HoldsAndIsNotLoose) {
  const Regime& regime = GetParam();
  Doubles random(83);
  Ratio ratio;
  int met = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Matrix3d Q =
        Eigen::Quaterniond(random.unit(), random.unit(), random.unit(), 1).normalized().toRotationMatrix();
    FacePoints p = draw_face(random, regime.master_width, 0, Doubles::point([&] { return 0.1 * random.unit(); }));
    // Squeezed in the direction in which the slave face is tilted.
    for (Eigen::Vector3d& corner : p) corner = Q * Eigen::Vector3d(corner[1], corner[0], corner[2]);
    const FaceGeometry master(p);
    const Eigen::Vector3d hit = master.barycentre_Me() - regime.depth * (1 + 0.3 * random.unit()) * master.n_Me;
    const double along = 0.5 * random.unit(), across = 0.5 * regime.slave_width * random.unit();
    const Eigen::Vector3d shift(along * std::sqrt(1 - regime.tilt * regime.tilt), across, -along * regime.tilt);
    FacePoints f = draw_face(random, regime.slave_width, regime.tilt, shift);
    for (Eigen::Vector3d& corner : f) corner = Q * corner + hit;
    // The line leaves the slave there.
    if (master.n_Me.dot((f[1] - f[0]).cross(f[2] - f[0])) > 0) std::swap(f[0], f[1]);

    const Eigen::Vector3d about_master = Eigen::Vector3d::Constant(regime.stir_master);
    const Eigen::Vector3d about_slave = Eigen::Vector3d::Constant(regime.stir_slave);
    const double bound = depth_error(master, FaceError(master, about_master), f, about_master + about_slave);
    if (!std::isfinite(bound)) continue;

    const ExactFace line(stirred(p, about_master, random));
    const std::array<RationalVector, 3> g = stirred(f, about_slave, random);
    std::array<int, 3> sides;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = sgn(dot(line.N, cross(minus(g[k], line.C), minus(g[(k + 1) % 3], line.C))));
    }
    if (sides[0] != sides[1] || sides[1] != sides[2]) continue;
    ++met;
    const RationalVector N_g = ExactFace(g).N;
    const mpq_class q = dot(minus(line.C, g[0]), N_g) / dot(line.N, N_g);
    const mpf_class depth = real(q) * length_of(line.N);
    if (sgn(depth) < 0) continue;
    ratio.expect(std::abs(mpf_class(depth - DepthBelow(master, f).value()).get_d()), bound);
  }
  std::printf("  %s: %d lines, greatest error over its bound %.3f\n", regime.name, met, ratio.greatest);
  EXPECT_GE(met, 1000);
  EXPECT_GE(ratio.greatest, regime.least_ratio);
}

INSTANTIATE_TEST_SUITE_P(Regimes, DepthErrorOf,
                         testing::Values(Regime{"Shallow", 1, 1, 0.1, 1e-6, 0, 0, 0.1},          // height: corner - C
                                         Regime{"SliverSlave", 1, 1e-5, 0.1, 1e-6, 0, 0, 0.07},  // height: N_f
                                         Regime{"SliverMaster", 1e-6, 1, 0.99, 10, 0, 0, 0.1},   // slope: n
                                         Regime{"SteepAndDeep", 1, 1, 0.99999, 100, 0, 0,
                                                0.02},  // slope: its own roundings
                                         Regime{"StirredSlave", 1, 1, 0.3, 0.1, 0, 1e-9, 0.3},     // f moves
                                         Regime{"StirredMaster", 1, 1, 0.3, 1e-3, 1e-9, 0, 0.3},   // C moves
                                         Regime{"TurnedMaster", 1e-3, 1, 0.9, 10, 1e-9, 0, 0.2}),  // n turns
                         [](const testing::TestParamInfo<Regime>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pcm::fast::element_error_test
