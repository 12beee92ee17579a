// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "meshes/generate/degenerate/catalogue.h"
#include "tests/meshes/generate/generator_expectations.h"

namespace pcm {
namespace {

using degenerate::Case;

/// F in Me, moved in long double: exact for the catalogue's exactly representable poses.
std::vector<Eigen::Matrix<long double, 3, 1>> moved_exactly(const Case& pair) {
  std::vector<Eigen::Matrix<long double, 3, 1>> vertices;
  for (const Eigen::Vector3d& vertex : pair.F.vertices) {
    vertices.push_back(pair.A.cast<long double>() * vertex.cast<long double>() + pair.r.cast<long double>());
  }
  return vertices;
}

TriangleMesh F_in_Me(const Case& pair) {
  TriangleMesh mesh = pair.F;
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = pair.A * vertex + pair.r;
  return mesh;
}

/// Sum of the solid angles of the faces seen from the point over 4 pi: 1 inside a closed outward surface, 0 outside.
double winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double solid_angles = 0;
  for (const auto& [i, j, k] : mesh.faces) {
    const Eigen::Vector3d a = mesh.vertices[i] - point, b = mesh.vertices[j] - point, c = mesh.vertices[k] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    solid_angles += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return solid_angles / (4 * std::numbers::pi);
}

struct Extent {
  Eigen::Vector3d low, high;
};

Extent common_extent(const TriangleMesh& E, const TriangleMesh& F) {
  const auto extent_of = [](const TriangleMesh& mesh) {
    Extent extent{mesh.vertices[0], mesh.vertices[0]};
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      extent.low = extent.low.cwiseMin(vertex);
      extent.high = extent.high.cwiseMax(vertex);
    }
    return extent;
  };
  const Extent of_E = extent_of(E), of_F = extent_of(F);
  return {of_E.low.cwiseMax(of_F.low), of_E.high.cwiseMin(of_F.high)};
}

/// Part of the common bounding box that is inside both, by a Kronecker sequence: its points, multiples of the powers of
/// the inverse of the root of x^4 = x + 1, fill the box evenly and meet no plane of a body.
double estimated_common_volume(const TriangleMesh& E, const TriangleMesh& F) {
  const Extent extent = common_extent(E, F);
  const Eigen::Vector3d size = extent.high - extent.low;
  if (!(size.minCoeff() > 0)) return 0;
  constexpr int kSamples = 10000;
  constexpr double kStep = 0.8191725133961645;
  int inside = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const Eigen::Vector3d steps = i * Eigen::Vector3d(kStep, kStep * kStep, kStep * kStep * kStep);
    const Eigen::Vector3d point = extent.low + size.cwiseProduct(steps - steps.array().floor().matrix());
    inside += winding_number(E, point) > 0.5 && winding_number(F, point) > 0.5;
  }
  return size.prod() * inside / kSamples;
}

bool is_open(const TriangleMesh& mesh) {
  return test::border_edges(mesh) > 0;
}

TEST(DegenerateCatalogue, SurfacesAreSoundAndNamesUnique) {
  std::set<std::string> names;
  for (const Case& pair : degenerate::catalogue()) {
    SCOPED_TRACE(pair.name);
    EXPECT_TRUE(names.insert(pair.name).second);
    EXPECT_FALSE(pair.shows.empty());
    for (const TriangleMesh& mesh : {pair.E, pair.F}) {
      EXPECT_EQ(test::flaw(mesh), "");
      EXPECT_GE(test::border_edges(mesh), 0) << "consistently oriented";
      EXPECT_TRUE(is_open(mesh) || test::signed_volume(mesh) > 0);
    }
    EXPECT_EQ(pair.A.transpose() * pair.A, Eigen::Matrix3d::Identity());
    EXPECT_EQ(pair.A.determinant(), 1);
    EXPECT_FALSE(pair.volume && (is_open(pair.E) || is_open(pair.F)));
  }
  EXPECT_GE(names.size(), 53u);
}

TEST(DegenerateCatalogue, PosesRoundNothingWhereSaid) {
  for (const Case& pair : degenerate::catalogue()) {
    SCOPED_TRACE(pair.name);
    const auto exact = moved_exactly(pair);
    bool rounds = false;
    for (const auto& vertex : exact) {
      for (int axis = 0; axis < 3; ++axis) rounds = rounds || static_cast<double>(vertex[axis]) != vertex[axis];
    }
    EXPECT_EQ(rounds, !pair.exactly_representable);
  }
}

TEST(DegenerateCatalogue, VolumesWorkedOutByHandAgreeWithSampling) {
  for (const Case& pair : degenerate::catalogue()) {
    // Between the needle's sides there are two doubles: samples would lie on them.
    if (!pair.volume || pair.name == "needle") continue;
    SCOPED_TRACE(pair.name);
    // Samples of bodies 2^40 from the origin would lie on faces after rounding; E is brought back first.
    TriangleMesh E = pair.E, F = F_in_Me(pair);
    const Eigen::Vector3d origin = E.vertices[0];
    for (TriangleMesh* mesh : {&E, &F}) {
      for (Eigen::Vector3d& vertex : mesh->vertices) vertex -= origin;
    }
    const double estimate = estimated_common_volume(E, F);
    EXPECT_NEAR(estimate, *pair.volume, 0.03 * *pair.volume);
  }
}

/// Where features meet or faces are coplanar some vertex of one body lies in the plane of a face of the other, or two
/// edges are coplanar: four vertices, not all of one body, with a vanishing determinant.
TEST(DegenerateCatalogue, MeetingFeaturesAndCoplanarFacesHaveVanishingDeterminants) {
  auto cases = degenerate::meeting_features();
  for (Case& pair : degenerate::coplanar_faces()) cases.push_back(std::move(pair));
  for (const Case& pair : cases) {
    // These are hard for other reasons.
    if (!pair.exactly_representable || pair.name == "sliver" || pair.name == "needle" ||
        pair.name.starts_with("penetration_line"))
      continue;
    SCOPED_TRACE(pair.name);
    const TriangleMesh F = F_in_Me(pair);
    int vanishing = 0;
    const auto count_vertices_in_faces = [&vanishing](const TriangleMesh& of_vertices, const TriangleMesh& of_faces) {
      for (const Eigen::Vector3d& x : of_vertices.vertices) {
        for (const auto& [i, j, k] : of_faces.faces) {
          const Eigen::Vector3d p = of_faces.vertices[i];
          vanishing += (of_faces.vertices[j] - p).cross(of_faces.vertices[k] - p).dot(x - p) == 0;
        }
      }
    };
    count_vertices_in_faces(pair.E, F);
    count_vertices_in_faces(F, pair.E);
    if (pair.name == "edge_across_edge") {
      const auto& e = pair.E.vertices;
      vanishing += (e[1] - e[0]).cross(F.vertices[0] - e[0]).dot(F.vertices[1] - e[0]) == 0;
    }
    EXPECT_GT(vanishing, 0);
  }
}

TEST(DegenerateCatalogue, BubbleMeetsEachWallOfTheContainerApart) {
  const Case pair = degenerate::find_case("bubble_in_open_container");
  int below_wall[4] = {0, 0, 0, 0};
  for (const Eigen::Vector3d& x : F_in_Me(pair).vertices) {
    const double side = std::max(std::fabs(x.x()), std::fabs(x.y()));
    if (x.z() >= 0.6 * side) continue;
    ++below_wall[std::fabs(x.x()) > std::fabs(x.y()) ? (x.x() > 0 ? 0 : 1) : (x.y() > 0 ? 2 : 3)];
    EXPECT_LT(std::min(std::fabs(x.x()), std::fabs(x.y())), 0.7 * side) << "away from the container's edges";
  }
  for (const int vertices : below_wall) EXPECT_GT(vertices, 0);
}

TEST(DegenerateCatalogue, FindsACaseByNameAndListsNamesOtherwise) {
  EXPECT_EQ(degenerate::find_case("flush_flanks").volume, 4);
  test::expect_refused([] { degenerate::find_case("nothing"); }, "vertex_on_vertex, vertex_on_edge");
}

}  // namespace
}  // namespace pcm
