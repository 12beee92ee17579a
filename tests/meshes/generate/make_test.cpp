// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/make.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "meshes/generate/round.h"
#include "tests/meshes/generate/generator_expectations.h"

namespace pcm {
namespace {

TEST(Make, EveryShapeIsMadeWithItsDefaults) {
  std::set<std::string> names;
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    EXPECT_TRUE(names.insert(shape.name).second);
    EXPECT_FALSE(shape.description.empty());
    const TriangleMesh mesh = make(shape.name);
    EXPECT_EQ(mesh.name, "make " + shape.name);
    EXPECT_EQ(test::flaw(mesh), "");
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      for (const double x : vertex) EXPECT_FALSE(x == 0 && std::signbit(x)) << "a negative zero";
    }
    const bool open = shape.name == "pyramid" || shape.name == "rectangle";
    EXPECT_EQ(test::border_edges(mesh) > 0, open);
    EXPECT_TRUE(open || test::signed_volume(mesh) > 0);
  }
  EXPECT_EQ(names.size(), 33u);
}

TEST(Make, EveryParameterIsUsedAndCheckedByName) {
  for (const Shape& shape : shapes()) {
    for (const ShapeParameter& parameter : shape.parameters) {
      SCOPED_TRACE(shape.name + " " + parameter.name);
      // Larger values, but within what the shape allows; a level is counted one by one.
      const double other = parameter.unit == "count" ? parameter.default_value + 1 : parameter.default_value * 1.25;
      const TriangleMesh original = make(shape.name), changed = make(shape.name, {{parameter.name, other}});
      EXPECT_TRUE(original.vertices != changed.vertices || original.faces != changed.faces);
      test::expect_refused([&] { make(shape.name, {{parameter.name, -1.0}}); }, parameter.name);
      test::expect_refused(
          [&] {
            make(shape.name, {{parameter.name, std::numeric_limits<double>::quiet_NaN()}});
          },
          parameter.name);
      if (parameter.unit == "count") {
        test::expect_refused([&] { make(shape.name, {{parameter.name, 4.5}}); }, "whole number");
        test::expect_refused([&] { make(shape.name, {{parameter.name, 1e30}}); }, parameter.name);
      }
    }
  }
}

TEST(Make, GivesTheGeneratorsMeshUnderTheNameOfTheCall) {
  const TriangleMesh mesh = make("uv-sphere", {{"radius", 0.1}, {"segments", 8}, {"bands", 5}});
  const TriangleMesh expected = generate::uv_sphere(0.1, 8, 5);
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.faces, expected.faces);
  EXPECT_EQ(mesh.name, "make uv_sphere --bands 5 --radius 0.1 --segments 8");
  EXPECT_EQ(make("torus", {{"tube-radius", 0.1}}).name, "make torus --tube_radius 0.1");
}

TEST(Make, UnknownNamesAreRefusedWithTheKnownOnes) {
  test::expect_refused([] { make("teapot"); }, "teapot");
  test::expect_refused([] { make("teapot"); }, "box, gridded_box");
  test::expect_refused([] { make("torus", {{"colour", 1.0}}); }, "colour");
  test::expect_refused([] { make("torus", {{"colour", 1.0}}); }, "ring_radius, tube_radius");
}

}  // namespace
}  // namespace pcm
