// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/surface/thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fast/predicates/penetration_predicates.h"
#include "fast/surface/prepare_surface.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "tests/fast/exact_mesh.h"

/// How deep beneath each face the prism under it is free of other faces, exactly, against rational numbers.
namespace pcm::fast::thickness_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point as a face sees it: three weights and the depth in units of |N|.
using Seen = std::array<mpq_class, 4>;

class ExactPrism {
 public:
  explicit ExactPrism(const std::array<Eigen::Vector3d, 3>& p) : p0_(rational(p[0])) {
    a_ = minus(rational(p[1]), p0_);
    b_ = minus(rational(p[2]), p0_);
    N_ = cross(a_, b_);
    square_ = dot(N_, N_);
  }
  double normal_length() const { return mpf_class(sqrt(mpf_class(square_, 200))).get_d(); }
  Seen see(const Eigen::Vector3d& x) const {
    const RationalVector d = minus(rational(x), p0_);
    const mpq_class s = dot(cross(d, b_), N_) / square_, t = dot(cross(a_, d), N_) / square_;
    return {1 - s - t, s, t, -dot(d, N_) / square_};
  }

 private:
  RationalVector p0_, a_, b_, N_;
  mpq_class square_;
};

/// Where the polygon begins strictly within the prism, and not above the face: the least depth there, if anywhere.
std::optional<mpq_class> begins_at(std::vector<Seen> polygon) {
  const auto depth_less = [](const Seen& x, const Seen& y) { return x[3] < y[3]; };
  // What only touches the plane from above is not beneath the face.
  if (std::max_element(polygon.begin(), polygon.end(), depth_less)->at(3) <= 0 &&
      std::min_element(polygon.begin(), polygon.end(), depth_less)->at(3) < 0) {
    return {};
  }
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Seen> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Seen& x = polygon[i];
      const Seen& y = polygon[(i + 1) % polygon.size()];
      if (x[k] >= 0) kept.push_back(x);
      if (sgn(x[k]) * sgn(y[k]) >= 0) continue;
      const mpq_class share = x[k] / (x[k] - y[k]);
      Seen between;
      for (std::size_t c = 0; c < 4; ++c) between[c] = x[c] + share * (y[c] - x[c]);
      kept.push_back(between);
    }
    polygon = kept;
    if (polygon.empty()) return {};
  }
  // A mean of all corners lies strictly within if anything does.
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::all_of(polygon.begin(), polygon.end(), [k](const Seen& x) { return x[k] == 0; })) return {};
  }
  return std::min_element(polygon.begin(), polygon.end(), depth_less)->at(3);
}

double exact_thickness(const PreparedSurface& surface, Index face) {
  const ExactPrism prism(surface.points_of(face));
  std::optional<mpq_class> least;
  for (Index other = 0; other < static_cast<Index>(surface.mesh.faces.size()); ++other) {
    if (other == face) continue;
    const auto g = surface.points_of(other);
    const std::optional<mpq_class> depth = begins_at({prism.see(g[0]), prism.see(g[1]), prism.see(g[2])});
    if (depth && !(least && *least <= *depth)) least = depth;
  }
  return least ? least->get_d() * prism.normal_length() : kInfinity;
}

struct Count {
  int faces = 0, sharp = 0, known = 0;

  void operator+=(const Count& other) {
    faces += other.faces;
    sharp += other.sharp;
    known += other.known;
  }
  void print() const { std::printf("  of %d faces %d have a thickness, %d bounds are sharp\n", faces, known, sharp); }
};

/// Whether no vertex is there twice and no face has area 0.
bool is_fit(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (mesh.vertices[i] == mesh.vertices[j]) return false;
    }
  }
  return no_face_has_area_0(mesh);
}

/// No bound above the exact thickness; counts those that are nearly it.
Count expect_no_greater(const TriangleMesh& mesh) {
  const PreparedSurface surface = prepare_surface(mesh);
  Count count;
  for (Index face = 0; face < static_cast<Index>(mesh.faces.size()); ++face) {
    const double bound = thickness_everywhere(surface, face).exact, truth = exact_thickness(surface, face);
    EXPECT_LE(bound, truth * (1 + 1e-14)) << mesh.name << ", face " << face;
    ++count.faces;
    count.known += truth > 0 ? 1 : 0;
    count.sharp += bound == truth || (truth > 0 && bound >= truth * (1 - 1e-6)) ? 1 : 0;
  }
  return count;
}

TriangleMesh turned(TriangleMesh mesh, const Eigen::Vector3d& by) {
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(0.7, by.normalized()).toRotationMatrix();
  for (Eigen::Vector3d& x : mesh.vertices) x = Q * x + by;
  return mesh;
}

/// An open surface of single triangles.
TriangleMesh sheets(const std::vector<std::array<Eigen::Vector3d, 3>>& triangles) {
  TriangleMesh mesh;
  for (const auto& triangle : triangles) {
    const auto first = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), triangle.begin(), triangle.end());
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(ThicknessEverywhere, OfBodiesIsNoMoreThanItIsExactlyAndNotFarBelow) {
  std::vector<TriangleMesh> meshes{generate::box({1, 2, 0.1}),
                                   generate::gridded_box({1, 0.7, 0.3}, {2, 3, 2}),
                                   generate::wedge(17, 1, 0.3),
                                   generate::plate(1, 1, 0.01, 2, 2),
                                   generate::icosphere(1, 1),
                                   generate::cylinder(0.3, 1, 7),
                                   generate::cone(0.3, 1, 6),
                                   generate::tube(0.2, 0.3, 1, 6),
                                   generate::torus(1, 0.3, 6, 5),
                                   generate::socket(1, 0.5, 6, 3),
                                   generate::pyramid()};
  const std::size_t as_made = meshes.size();
  for (std::size_t i = 0; i < as_made; ++i) meshes.push_back(turned(meshes[i], {0.3, -2, 1}));
  Count all;
  for (const TriangleMesh& mesh : meshes) {
    all += expect_no_greater(mesh);
  }
  all.print();
  EXPECT_GE(all.sharp, all.faces / 2);
}

TEST(ThicknessEverywhere, OfFansOfSmallIntegersIsNoMoreThanItIsExactly) {
  // Faces about one vertex on a small lattice: flush, upright, folding back, beneath each other; some closed.
  Doubles random(31);
  Count all;
  for (int trial = 0; trial < 1000; ++trial) {
    TriangleMesh mesh;
    mesh.name = "fan " + std::to_string(trial);
    const auto lattice = [&random] { return Doubles::point([&random] { return random.small_integer(2); }); };
    mesh.vertices.push_back(lattice());
    const Index steps = static_cast<Index>(random.integer(2, 6));
    const bool closed = steps > 2 && trial % 2 == 0;
    for (Index i = 1; i <= steps + 1; ++i) mesh.vertices.push_back(lattice());
    for (Index i = 1; i <= steps; ++i) mesh.faces.push_back({0, i, i == steps && closed ? 1 : i + 1});
    if (closed) mesh.vertices.pop_back();
    if (!is_fit(mesh)) continue;
    all += expect_no_greater(mesh);
  }
  all.print();
  EXPECT_GE(all.faces, 1000);
  EXPECT_GE(all.known, all.faces / 4);
  EXPECT_GE(all.sharp, all.faces / 2);
}

TEST(ThicknessEverywhere, OfLatticeTrianglesIsNoMoreThanItIsExactly) {
  Doubles random(32);
  Count all;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<std::array<Eigen::Vector3d, 3>> triangles(5);
    for (auto& triangle : triangles) {
      for (Eigen::Vector3d& x : triangle) {
        x = Doubles::point([&random] { return random.small_integer(3); });
        x[0] = random.nudged(x[0], trial % 2);
      }
    }
    const TriangleMesh mesh = sheets(triangles);
    if (is_fit(mesh)) all += expect_no_greater(mesh);
  }
  all.print();
  EXPECT_GE(all.sharp, all.faces / 3);
}

TEST(ThicknessEverywhere, UprightWallsOfABoxDoNotCount) {
  // Exactly upright: planes of a grid have one coordinate, whatever it is rounded to.
  for (const double scale : {1.0, 0.1, 1e-3, 1e6}) {
    for (const double shift : {0.0, 0.3, -7.7}) {
      TriangleMesh plain = generate::box(Eigen::Vector3d(scale, 2 * scale, 3 * scale));
      TriangleMesh gridded = generate::gridded_box({scale, 2 * scale, 3 * scale}, {3, 2, 2});
      for (TriangleMesh* const mesh : {&plain, &gridded}) {
        for (Eigen::Vector3d& x : mesh->vertices) x += Eigen::Vector3d::Constant(shift * scale);
        const PreparedSurface surface = prepare_surface(*mesh);
        for (Index face = 0; face < static_cast<Index>(mesh->faces.size()); ++face) {
          const auto p = surface.points_of(face);
          const Eigen::Vector3d n = (p[1] - p[0]).cross(p[2] - p[0]).cwiseAbs().normalized();
          const double width = n.dot(scale * Eigen::Vector3d(1, 2, 3));
          const double bound = thickness_everywhere(surface, face).exact;
          EXPECT_GE(bound, width * (1 - 1e-6));
          EXPECT_LE(bound, width * (1 + 1e-14));
        }
      }
    }
  }
}

/// Of a face that looks up, beside whose prism's side x = 1 a wall stands from `wall_top` down to `x_wall`, over a
/// floor.
double thickness_over_wall(double x_wall, double wall_top) {
  const TriangleMesh mesh = sheets({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}},
                                    {{{1, -1, wall_top}, {1, 2, wall_top}, {x_wall, 0.5, -2}}},
                                    {{{-5, -5, -3}, {-5, 9, -3}, {9, -5, -3}}}});
  const PreparedSurface surface = prepare_surface(mesh);
  return thickness_everywhere(surface, 0).exact;
}

TEST(ThicknessEverywhere, SheetsWhoseVerticesAreNumbered192ApartAreToldApart) {
  // OwnSights keeps them in the same place. Whichever of the two sheets is looked at first: the near one counts.
  for (const double down : {1.0, -1.0}) {
    for (const auto& [first, last] : {std::pair(1.0, 3.0), std::pair(3.0, 1.0)}) {
      const auto sheet = [down](double depth) {
        const double z = -down * depth;
        return std::array<Eigen::Vector3d, 3>{{{-5, -5, z}, {-5, 9, z}, {9, -5, z}}};
      };
      std::vector<std::array<Eigen::Vector3d, 3>> triangles{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, sheet(first)};
      if (down < 0) std::swap(triangles[0][1], triangles[0][2]);
      for (int i = 0; i < 63; ++i) triangles.push_back({{{100.0 + i, 0, 0}, {100.5 + i, 0, 0}, {100.5 + i, 0.5, 0}}});
      triangles.push_back(sheet(last));
      const PreparedSurface surface = prepare_surface(sheets(triangles));
      EXPECT_NEAR(thickness_everywhere(surface, 0).exact, 1, 1e-6) << down << ' ' << first;
    }
  }
}

TEST(ThicknessEverywhere, AFarWallFlushWithThePrismCountsOnlyWhereItLeansInward) {
  for (const double top : {0.0, -1.0}) {
    EXPECT_NEAR(thickness_over_wall(1, top), 3, 1e-6);
    EXPECT_NEAR(thickness_over_wall(std::nextafter(1.0, 2.0), top), 3, 1e-6);
    EXPECT_NEAR(thickness_over_wall(std::nextafter(1.0, 0.0), top), -top, 1e-6);
  }
}

TEST(ThicknessEverywhere, WallsOfABoxThatLeanInwardByAnUlpCount) {
  for (const bool inward : {true, false}) {
    TriangleMesh box = generate::box({0, 0, 0}, {1, 1, 1});
    for (Eigen::Vector3d& x : box.vertices) {
      if (x[2] == 0 && x[0] == 1) x[0] = std::nextafter(1.0, inward ? 0.0 : 2.0);
    }
    const PreparedSurface surface = prepare_surface(box);
    int leant_over = 0, whole = 0;
    for (Index face = 0; face < static_cast<Index>(box.faces.size()); ++face) {
      const auto p = surface.points_of(face);
      if (!(p[0][2] == 1 && p[1][2] == 1 && p[2][2] == 1)) continue;
      const double bound = thickness_everywhere(surface, face).exact;
      EXPECT_LE(bound, exact_thickness(surface, face) * (1 + 1e-14));
      leant_over += bound == 0 ? 1 : 0;
      whole += std::abs(bound - 1) < 1e-6 ? 1 : 0;
    }
    // One of the two triangles has that side. Where the wall leans outward, its neighbour's corner may reach over.
    EXPECT_GE(inward ? leant_over : whole, 1);
  }
}

TEST(ThicknessEverywhere, NeighbourThatFoldsBackLeavesNothing) {
  // About the side from (0, 0, 0) to (0, 1, 0): beneath the face, flush with it, upright, and beyond.
  const auto folded = [](double x, double z) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {x, 0.5, z}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    const PreparedSurface surface = prepare_surface(mesh);
    return thickness_everywhere(surface, 0).exact;
  };
  EXPECT_EQ(folded(0.5, -0.5), 0);
  EXPECT_EQ(folded(0x1p-50, -0.5), 0);
  EXPECT_EQ(folded(0.5, 0), 0);
  EXPECT_EQ(folded(0, -0.5), kInfinity);
  EXPECT_EQ(folded(-0.5, -0.5), kInfinity);
  EXPECT_EQ(folded(-0.5, 0), kInfinity);
  EXPECT_EQ(folded(0.5, 0.5), kInfinity);
}

TEST(ThicknessEverywhere, SheetInTheFacesPlaneLiesAtDepthZeroUnlessBesideIt) {
  const auto beside = [](double x) {
    const TriangleMesh mesh =
        sheets({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {{{x, 0.25, 0}, {x + 1, 0.25, 0}, {x, 0.75, 0}}}});
    return thickness_everywhere(prepare_surface(mesh), 0).exact;
  };
  EXPECT_EQ(beside(0.5), 0);
  EXPECT_EQ(beside(std::nextafter(1.0, 0.0)), 0);
  EXPECT_EQ(beside(1), kInfinity);
}

TEST(ThicknessEverywhere, OfFacesOverWhichVolumesUnderflowIsNoMoreThanItIsExactly) {
  Count count;
  for (int exponent = -100; exponent <= -20; exponent += 2) {
    const double width = std::ldexp(1.0, exponent);
    for (TriangleMesh mesh : {generate::box({width, width, 1}), generate::box({width, 1, 2 * width}),
                              generate::plate(width, width, 1, 2, 2)}) {
      for (Eigen::Vector3d& x : mesh.vertices) {
        if (exponent >= -40) x.x() += 0.125 * x.z();
        x *= 0x1p-299;
      }
      count += expect_no_greater(mesh);
    }
  }
  count.print();
  EXPECT_GT(count.sharp, 0);
}

TEST(SideOfPrism, IsTheSignOfTheExactWeight) {
  Doubles random(33);
  WorkCounters work;
  int on_side = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const int kind = trial % 3;
    const auto draw = [&] {
      return kind == 0 ? random.unit() : kind == 1 ? random.small_integer(5) : random.scaled(40);
    };
    FacePoints master;
    for (Eigen::Vector3d& p : master) p = Doubles::point(draw);
    const std::size_t k = static_cast<std::size_t>(trial) % 3, next = (k + 1) % 3;
    Eigen::Vector3d x = Doubles::point(draw);
    if (trial % 2 == 0) {
      // On the side, or as near to it as can be: under or over it by a multiple of the normal.
      const Eigen::Vector3d edge = master[next] - master[k];
      const Eigen::Vector3d N = (master[1] - master[0]).cross(master[2] - master[0]);
      x = master[k] + random.small_integer(3) * edge - random.small_integer(3) * N;
      if (trial % 4 == 0) x[0] = random.nudged(x[0], 1);
    }
    const RationalVector p0 = rational(master[0]), edge = minus(rational(master[next]), rational(master[k]));
    const RationalVector N = cross(minus(rational(master[1]), p0), minus(rational(master[2]), p0));
    const int truth = sgn(dot(N, cross(edge, minus(rational(x), rational(master[k])))));
    ASSERT_EQ(side_of_prism(master, k, x, work), truth) << trial;
    on_side += truth == 0 ? 1 : 0;
  }
  EXPECT_GE(on_side, 500);
}

}  // namespace
}  // namespace pcm::fast::thickness_test
