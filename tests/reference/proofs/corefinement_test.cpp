// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A third witness: CGAL's corefinement over its exact kernel, on surfaces too large for the brute-force twin. Generic
// poses of the rounded problem only: corefinement has no tie rule. The one file that compiles corefinement.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "pcm/read_mesh.h"
#include "reference/oracle.h"
#include "tests/reference/brute_force/scene.h"
#include "tests/reference/brute_force/trials.h"

namespace pcm {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

TriangleMesh moved(TriangleMesh mesh, const Pose& pose) {
  for (Eigen::Vector3d& x : mesh.vertices) x = brute_force::rounded_point(x, pose);
  return mesh;
}

Mesh cgal_mesh(const TriangleMesh& mesh) {
  Mesh result;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Eigen::Vector3d& x : mesh.vertices) vertices.push_back(result.add_vertex({x[0], x[1], x[2]}));
  for (const Triangle& t : mesh.faces) result.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return result;
}

double to_double(const Kernel::FT& x) {
  return CGAL::to_double(CGAL::exact(x));
}

struct Area {
  double area = 0;
  std::array<double, 3> vector_area{};
};

/// Of the parts of a corefined surface that lie inside the other: one face of each part between polygons is located.
Area area_inside(Mesh& corefined, const Mesh& other) {
  auto constrained = corefined.property_map<Mesh::Edge_index, bool>("e:polygon").first;
  auto part = corefined.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  PMP::connected_components(corefined, part, CGAL::parameters::edge_is_constrained_map(constrained));
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side_of_other(other);
  std::map<std::size_t, bool> inside;
  std::array<Kernel::FT, 3> vector_area{0, 0, 0};
  Area result;
  for (const Mesh::Face_index face : corefined.faces()) {
    const auto h = corefined.halfedge(face);
    const Kernel::Point_3& a = corefined.point(corefined.source(h));
    const Kernel::Point_3& b = corefined.point(corefined.target(h));
    const Kernel::Point_3& c = corefined.point(corefined.target(corefined.next(h)));
    if (!inside.contains(part[face]))
      inside[part[face]] = side_of_other(CGAL::centroid(a, b, c)) == CGAL::ON_BOUNDED_SIDE;
    if (!inside[part[face]]) continue;
    const Kernel::Vector_3 normal = CGAL::cross_product(b - a, c - a);
    result.area += std::sqrt(to_double(normal.squared_length())) / 2;
    for (int i = 0; i < 3; ++i) vector_area[i] += normal[i] / 2;
  }
  for (int i = 0; i < 3; ++i) result.vector_area[i] = to_double(vector_area[i]);
  return result;
}

/// CGAL's areas are sums of n positive terms in doubles, each with a few roundings, the oracle's are correctly rounded.
void expect_same_area(const Area& expected, const reference::ActiveArea& found, std::size_t terms) {
  const double bound = static_cast<double>(terms + 8) * std::numeric_limits<double>::epsilon() * found.area;
  EXPECT_NEAR(expected.area, found.area, bound);
  for (int i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(expected.vector_area[i], found.vector_area_Me[i]);
}

/// Whether the surfaces meet.
bool compare_on(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  const reference::Answer answer =
      reference::Oracle(E, F).answer(reference::Problem::rounded, pose, {}, {true, true, false, false});
  const Mesh mesh_E = cgal_mesh(E);
  const Mesh mesh_F = cgal_mesh(moved(F, pose));

  std::vector<std::vector<Kernel::Point_3>> polylines;
  PMP::surface_intersection(mesh_E, mesh_F, std::back_inserter(polylines));
  EXPECT_EQ(polylines.size(), answer.polygons.size());
  for (const auto& polyline : polylines) EXPECT_EQ(polyline.front(), polyline.back());
  for (const reference::Polygon& polygon : answer.polygons) EXPECT_TRUE(polygon.closed);

  Mesh corefined_E = mesh_E;
  Mesh corefined_F = mesh_F;
  auto on_E = corefined_E.add_property_map<Mesh::Edge_index, bool>("e:polygon", false).first;
  auto on_F = corefined_F.add_property_map<Mesh::Edge_index, bool>("e:polygon", false).first;
  PMP::corefine(corefined_E, corefined_F, CGAL::parameters::edge_is_constrained_map(on_E),
                CGAL::parameters::edge_is_constrained_map(on_F));
  expect_same_area(area_inside(corefined_E, mesh_F), answer.E, corefined_E.number_of_faces());
  expect_same_area(area_inside(corefined_F, mesh_E), answer.F, corefined_F.number_of_faces());

  Mesh first = mesh_E;
  Mesh second = mesh_F;
  Mesh intersection;
  EXPECT_TRUE(PMP::corefine_and_compute_intersection(first, second, intersection));
  EXPECT_DOUBLE_EQ(to_double(PMP::volume(intersection)), answer.volume.value_or(-1));
  return answer.touching;
}

/// Rotations and shifts of the twin's generic trials, in units of the surfaces' size.
Pose generic_pose(int number, double size) {
  Pose pose = brute_force::draw_trial(brute_force::Kind::generic, 31, number).pose;
  pose.r *= size;
  return pose;
}

double radius(const TriangleMesh& mesh) {
  double result = 0;
  for (const Eigen::Vector3d& x : mesh.vertices) result = std::max(result, x.norm());
  return result;
}

void compare_all_pairs(const std::vector<TriangleMesh>& meshes, int poses) {
  int touching = 0;
  int number = 0;
  for (const TriangleMesh& E : meshes) {
    for (const TriangleMesh& F : meshes) {
      for (int i = 0; i < poses; ++i) {
        SCOPED_TRACE(E.name + " against " + F.name + ", generic pose " + std::to_string(number));
        const Pose pose = generic_pose(number++, 0.4 * (radius(E) + radius(F)));
        if (compare_on(E, F, pose)) ++touching;
      }
    }
  }
  EXPECT_GE(2 * touching, number);
}

TEST(Corefinement, AgreesOnGeneratedSurfaces) {
  compare_all_pairs({generate::icosphere(0.5, 2), generate::bubble(1.0), generate::torus(0.5, 0.2, 16, 8),
                     generate::box(Eigen::Vector3d(0.9, 0.7, 0.5)), generate::knotted_tube(0.4, 0.1, 60, 5)},
                    1);
}

/// A surface about the centre of its bounding box, so that poses overlap.
TriangleMesh centred(TriangleMesh mesh) {
  Eigen::Vector3d low = mesh.vertices.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& x : mesh.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  for (Eigen::Vector3d& x : mesh.vertices) x -= (low + high) / 2;
  return mesh;
}

TEST(Corefinement, AgreesOnRealSurfaces) {
  const std::filesystem::path folder = PCM_REAL_SURFACES_DIR;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no real surfaces in " << folder << ": ./run fetches them";
  for (const char* name : {"star", "part", "double-torus-example", "oblong", "rotor", "spool"}) {
    const TriangleMesh mesh = centred(read_mesh(folder / (std::string(name) + ".off")));
    compare_all_pairs({mesh}, 3);
    compare_on(mesh, generate::icosphere(0.6 * radius(mesh), 2), generic_pose(100, 0.3 * radius(mesh)));
  }
}

}  // namespace
}  // namespace pcm
