// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/write_obj.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>

#include "meshes/files/read_obj.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm {
namespace {

TriangleMesh random_mesh(std::uint64_t seed, std::size_t vertex_count) {
  std::mt19937_64 random(seed);
  TriangleMesh mesh;
  mesh.name = "random bits";
  const auto any_double = [&random] {
    double x = std::bit_cast<double>(random());
    while (!std::isfinite(x)) x = std::bit_cast<double>(random());
    return x;
  };
  for (std::size_t i = 0; i < vertex_count; ++i) {
    const double x = any_double();
    const double y = any_double();
    mesh.vertices.emplace_back(x, y, any_double());
  }
  mesh.vertices.emplace_back(-0.0, 0.0, std::numeric_limits<double>::denorm_min());
  mesh.vertices.emplace_back(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
                             std::numeric_limits<double>::min());
  for (std::size_t i = 0; i + 2 < mesh.vertices.size(); ++i)
    mesh.faces.push_back({static_cast<Index>(i), static_cast<Index>(i + 1), static_cast<Index>(i + 2)});
  return mesh;
}

void expect_same_bits(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(a.faces, b.faces);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.vertices[i][k]), std::bit_cast<std::uint64_t>(b.vertices[i][k]));
}

TEST(WriteObj, ReadsBackBitForBit) {
  constexpr std::uint64_t kSeed = 5;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  const TriangleMesh mesh = random_mesh(kSeed, 20000);
  const TemporaryFolder folder;
  write_obj(mesh, folder.path() / "random.obj");
  expect_same_bits(read_obj(folder.path() / "random.obj"), mesh);
}

TEST(WriteObj, TextIsTheShortestThatReadsBack) {
  TriangleMesh mesh;
  mesh.name = "three\npoints";
  mesh.vertices = {{0.1, -0.0, 1e300}, {1, 2, 3}, {0, 0, 1}};
  mesh.faces = {{0, 1, 2}};
  EXPECT_EQ(format_obj(mesh), "# three points\nv 0.1 -0 1e+300\nv 1 2 3\nv 0 0 1\nf 1 2 3\n");
}

TEST(WriteObj, NothingIsLeftBesideTheFile) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.obj", "old");
  const TriangleMesh mesh = random_mesh(1, 3);
  write_obj(mesh, path);
  expect_same_bits(read_obj(path), mesh);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteObj, WhatCannotBeWrittenIsRefusedAndLeavesNothing) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = random_mesh(1, 3);
  expect_bad_input([&] { write_obj(mesh, folder.path() / "no" / "a.obj"); }, "a.obj: the file can't be created");
  expect_bad_input([&] { write_obj(mesh, folder.path()); }, ": this is a folder");
  expect_bad_input([&] { write_obj(mesh, folder.write("plain", "x") / "a.obj"); }, "a.obj: the file can't be created");
  std::filesystem::remove(folder.path() / "plain");

  TriangleMesh bad = mesh;
  bad.vertices[1].y() = std::numeric_limits<double>::quiet_NaN();
  expect_bad_input([&] { write_obj(bad, folder.path() / "a.obj"); }, "random bits: vertex 2 is not finite");
  bad = mesh;
  bad.faces[1][2] = 5;
  expect_bad_input([&] { write_obj(bad, folder.path() / "a.obj"); }, "random bits: face 2 refers to vertex 6");
  bad = mesh;
  bad.faces.clear();
  expect_bad_input([&] { write_obj(bad, folder.path() / "a.obj"); }, "random bits: a surface without");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace pcm
