// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/base/floating_point_environment.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <sstream>
#include <string>
#include <utility>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "meshes/files/parse_number.h"
#include "meshes/files/read_obj.h"
#include "meshes/files/read_off.h"
#include "meshes/generate/make.h"
#include "pcm/check.h"

/// Surfaces are read, made and checked alike whatever environment a host has set up, and leave it as it was.
namespace pcm {
namespace {

/// What `function` gives while the host rounds as given.
template <class Function>
auto rounded_by_host(int rounding, const Function& function) {
  const int before = std::fegetround();
  EXPECT_EQ(std::fesetround(rounding), 0);
  auto result = function();
  EXPECT_EQ(std::fegetround(), rounding);
  std::fesetround(before);
  return result;
}

/// A torus of quadrilaterals as text, in decimals that few doubles are.
std::string decimals(bool off) {
  constexpr int n = 12;
  std::ostringstream vertices, faces;
  const auto index = [](int i, int k) { return (i % n) * n + k % n; };
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      vertices << (off ? "" : "v ") << i << ".1 0." << 7919 * k + i << "3 -1." << 104729 * i * k << "e-3\n";
      faces << (off ? "4" : "f");
      for (const int corner : {index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1)})
        faces << ' ' << corner + (off ? 0 : 1);
      faces << '\n';
    }
  }
  std::ostringstream text;
  if (off) text << "OFF\n" << n * n << ' ' << n * n << " 0\n";
  text << vertices.str() << faces.str();
  return text.str();
}

void expect_equal(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(a.faces, b.faces);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i], b.vertices[i]) << i;
}

class HostRounds : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Modes, HostRounds, testing::Values(FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO));

TEST_P(HostRounds, NumbersAreReadToNearest) {
  for (const char* const text : {"0.1", "1e23", "3.3", "7.2057594037927933e16", "-2.7"}) {
    EXPECT_EQ(rounded_by_host(GetParam(), [&] { return *parse_number(text); }), *parse_number(text)) << text;
  }
}

TEST_P(HostRounds, SurfacesAreReadAlike) {
  const std::string obj = decimals(false), off = decimals(true);
  expect_equal(rounded_by_host(GetParam(), [&] { return parse_obj(obj, "obj"); }), parse_obj(obj, "obj"));
  expect_equal(rounded_by_host(GetParam(), [&] { return parse_off(off, "off"); }), parse_off(off, "off"));
}

TEST_P(HostRounds, SurfacesAreMadeAlike) {
  for (const char* const shape : {"torus", "icosphere", "bubble"})
    expect_equal(rounded_by_host(GetParam(), [&] { return make(shape); }), make(shape));
}

void expect_equal(const MeshReport& a, const MeshReport& b) {
  EXPECT_EQ(a.summary(), b.summary());
  EXPECT_EQ(a.zero_area_faces, b.zero_area_faces);
  EXPECT_EQ(a.duplicate_vertices, b.duplicate_vertices);
  ASSERT_EQ(a.inside_out.size(), b.inside_out.size());
}

TEST_P(HostRounds, SurfacesAreCheckedAlike) {
  for (TriangleMesh mesh : {make("torus"), make("bubble")}) {
    expect_equal(rounded_by_host(GetParam(), [&] { return check(mesh); }), check(mesh));
    for (Triangle& face : mesh.faces) std::swap(face[1], face[2]);
    expect_equal(rounded_by_host(GetParam(), [&] { return check(mesh); }), check(mesh));
  }
}

#if defined(__SSE2__)
// All coordinates are denormals: taken for zero, all vertices would lie at one place.
TEST(HostFlushesDenormals, SurfacesAreCheckedAlike) {
  TriangleMesh tiny = make("icosphere");
  for (Eigen::Vector3d& x : tiny.vertices) x *= 0x1p-1040;
  const MeshReport expected = check(tiny);
  EXPECT_TRUE(expected.fit()) << expected.summary();
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040U);
  const unsigned entered = _mm_getcsr();
  const MeshReport found = check(tiny);
  const unsigned left = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(left, entered);
  expect_equal(found, expected);
}
#endif

}  // namespace
}  // namespace pcm
