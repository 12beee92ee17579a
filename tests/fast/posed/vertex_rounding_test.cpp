// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/posed/vertex_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "fast/posed/transform.h"
#include "fast/surface/prepare_surface.h"
#include "tests/fast/exact_numbers.h"

/// How far a computed vertex of F is from the exact problem's, against rational numbers.
namespace pcm::fast {
namespace {

enum class Kind {
  generic,
  magnitudes,  ///< terms of all sizes
  cancelling,  ///< what is left of the sum is about a rounding
  ties,        ///< roundings of half a unit that cancel, and a far smaller one
  underflow,   ///< products beneath the least normal number
};

struct Example {
  const char* name;
  Kind kind;
  double median_ratio;  ///< at least: how much of the sharp bound is error
};

void PrintTo(const Example& example, std::ostream* out) {
  *out << example.name;
}

struct Vertex {
  Pose pose;
  Eigen::Vector3d x_Mf;
};

/// An odd integer of `bits` bits.
double odd(Doubles& random, int bits) {
  return static_cast<double>(random.integer(std::int64_t{1} << (bits - 2), (std::int64_t{1} << (bits - 1)) - 1) * 2 +
                             1);
}

Vertex draw(Kind kind, Doubles& random) {
  Vertex v;
  v.x_Mf = Doubles::point([&] { return random.unit(); });
  v.pose.r = Doubles::point([&] { return random.unit(); });
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) v.pose.A(i, j) = random.unit();
  }
  switch (kind) {
    case Kind::generic:
      break;
    case Kind::magnitudes:
      for (int i = 0; i < 3; ++i) {
        v.pose.r[i] = random.scaled(60);
        for (int j = 0; j < 3; ++j) v.pose.A(i, j) = random.scaled(60);
      }
      break;
    case Kind::cancelling:
      for (int i = 0; i < 3; ++i) {
        const double sum = (v.pose.A(i, 0) * v.x_Mf[0] + v.pose.A(i, 1) * v.x_Mf[1]) + v.pose.A(i, 2) * v.x_Mf[2];
        v.pose.r[i] = random.nudged(-sum, 2);
      }
      break;
    case Kind::ties:
      // A product of 54 bits, halfway between two doubles; an odd integer that rounds halfway as well; and what is
      // lost beside them.
      v.x_Mf = {odd(random, 27), 1, odd(random, 53)};
      v.pose.r = Eigen::Vector3d::Zero();
      for (int i = 0; i < 3; ++i) {
        v.pose.A(i, 0) = odd(random, 27);
        v.pose.A(i, 1) = std::ldexp(random.unit(), -static_cast<int>(random.integer(50, 60)));
        v.pose.A(i, 2) = 1;
      }
      break;
    case Kind::underflow:
      v.x_Mf *= 0x1p-500;
      v.pose.A *= 0x1p-560;
      v.pose.r *= 0x1p-1060;
      break;
  }
  return v;
}

class VertexRoundingOf : public testing::TestWithParam<Example> {};

TEST_P(VertexRoundingOf, HoldsAndTheSharpOneIsNotLoose) {
  const Example& example = GetParam();
  Doubles random(23);
  std::vector<double> ratios;
  int within_tiny_bounds = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Vertex v = draw(example.kind, random);
    const Eigen::Vector3d x_Me = rounded_transform(v.pose, v.x_Mf);
    const Eigen::Vector3d sharp = sharp_vertex_rounding(v.pose, v.x_Mf), plain = vertex_rounding(v.pose, v.x_Mf);
    for (int i = 0; i < 3; ++i) {
      mpq_class off = v.pose.r[i];
      for (int j = 0; j < 3; ++j) off += mpq_class(v.pose.A(i, j)) * mpq_class(v.x_Mf[j]);
      off = abs(mpq_class(off - mpq_class(x_Me[i])));
      ASSERT_LE(off, mpq_class(sharp[i])) << trial << " " << i;
      ASSERT_LE(off, mpq_class(plain[i])) << trial << " " << i;
      ASSERT_LE(sharp[i], plain[i] * (1 + 0x1p-18)) << trial << " " << i;
      ratios.push_back(mpq_class(off / mpq_class(sharp[i])).get_d());
      within_tiny_bounds += sharp[i] < 0x1p-8 * plain[i] ? 1 : 0;
    }
  }
  std::sort(ratios.begin(), ratios.end());
  std::printf("  %s: error over its sharp bound: median %.4f, greatest %.6f; %d far below the plain one\n",
              example.name, ratios[ratios.size() / 2], ratios.back(), within_tiny_bounds);
  EXPECT_GE(ratios[ratios.size() / 2], example.median_ratio);
  if (example.median_ratio > 0) {
    EXPECT_GE(ratios.back(), 0.999);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, VertexRoundingOf,
                         testing::Values(Example{"Generic", Kind::generic, 0.999},
                                         Example{"Magnitudes", Kind::magnitudes, 0.999},
                                         Example{"Cancelling", Kind::cancelling, 0.999},
                                         Example{"Ties", Kind::ties, 0.9}, Example{"Underflow", Kind::underflow, 0}),
                         [](const testing::TestParamInfo<Example>& test) { return std::string(test.param.name); });

TEST(FaceRounding, IsNoLessThanThoseOfItsVerticesAndNoMoreThanTheSurfaces) {
  Doubles random(24);
  TriangleMesh mesh;
  mesh.faces = {{0, 1, 2}};
  for (int trial = 0; trial < 500; ++trial) {
    mesh.vertices.clear();
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(Doubles::point([&] { return random.scaled(20); }));
    const PreparedSurface surface = prepare_surface(mesh);
    const Pose pose = draw(Kind::magnitudes, random).pose;
    const Eigen::Vector3d of_face = face_rounding(surface, pose, 0), of_all = greatest_vertex_rounding(surface, pose);
    for (const Eigen::Vector3d& x : mesh.vertices) {
      const Eigen::Vector3d of_one = vertex_rounding(pose, x);
      for (int i = 0; i < 3; ++i) {
        ASSERT_LE(of_one[i], of_face[i]);
        ASSERT_LE(of_face[i], of_all[i] * (1 + 0x1p-18));
      }
    }
  }
}

}  // namespace
}  // namespace pcm::fast
