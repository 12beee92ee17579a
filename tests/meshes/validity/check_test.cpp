// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "meshes/generate/degenerate/bodies.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/transformed_meshes.h"
#include "tests/meshes/validity/check_test_meshes.h"

namespace pcm {
namespace {

using degenerate::inverted;
using degenerate::joined;
using Faces = std::vector<Index>;

/// Expects exactly these kinds of issues, and the text that require_fit throws where one is an error.
void expect_issues(const TriangleMesh& mesh, const std::vector<MeshIssueKind>& kinds, const std::string& message = "") {
  const MeshReport report = check(mesh);
  std::vector<MeshIssueKind> found;
  for (const MeshIssue& issue : report.issues()) {
    found.push_back(issue.kind);
    EXPECT_NE(report.summary().find(issue.text), std::string::npos);
  }
  EXPECT_EQ(found, kinds) << report.summary();
  EXPECT_EQ(report.fit(), message.empty()) << report.summary();
  if (message.empty()) {
    EXPECT_NO_THROW(require_fit(mesh));
  } else {
    expect_bad_input([&] { require_fit(mesh); }, message);
  }
}

TEST(Check, CubeIsFitAndClosed) {
  const MeshReport report = check(cube());
  EXPECT_TRUE(report.fit());
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.issues().empty());
  EXPECT_EQ(report.component_count, 1);
  EXPECT_EQ(report.closed_component_count, 1);
  EXPECT_EQ(report.summary(), "cube: fit for contact, closed\n  8 vertices, 12 faces, 1 component (1 closed)");
}

TEST(Check, OpenSurfaceIsFitWithItsBorderNoted) {
  TriangleMesh mesh = cube();
  const Triangle removed = mesh.faces.back();
  mesh.faces.pop_back();
  expect_issues(mesh, {MeshIssueKind::border_edges});
  const MeshReport report = check(mesh);
  EXPECT_FALSE(report.closed());
  EXPECT_EQ(report.closed_component_count, 0);
  ASSERT_EQ(report.border_edges.size(), 3u);
  // A border edge runs as its face does, against the face that was taken away.
  for (const auto& [from, to] : report.border_edges) {
    const auto at = std::find(removed.begin(), removed.end(), to) - removed.begin();
    EXPECT_EQ(removed[static_cast<std::size_t>(at + 1) % 3], from);
  }
}

TEST(Check, SurfaceWithoutFaceIsUnfit) {
  TriangleMesh mesh = cube();
  mesh.faces.clear();
  expect_issues(mesh, {MeshIssueKind::no_faces, MeshIssueKind::unused_vertices},
                "cube: not fit for contact: the surface has no face; export it with its faces");
  EXPECT_FALSE(check(mesh).closed());
  expect_issues({}, {MeshIssueKind::no_faces}, "the surface: not fit for contact: the surface has no face");
}

TEST(Check, CoordinatesThatAreNotFiniteAreFound) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = cube();
    mesh.vertices[2].y() = value;
    expect_issues(mesh, {MeshIssueKind::non_finite_vertices}, "1 vertex with a coordinate that is not finite: 3;");
    EXPECT_EQ(check(mesh).non_finite_vertices, (Faces{2}));
  }
}

TEST(Check, IndicesOutOfRangeAreFound) {
  TriangleMesh mesh = cube();
  mesh.faces[4][1] = 8;
  mesh.faces[7][0] = -1;
  expect_issues(mesh, {MeshIssueKind::indices_out_of_range, MeshIssueKind::border_edges},
                "2 faces that refer to a vertex that doesn't exist: 5, 8;");
  EXPECT_EQ(check(mesh).out_of_range_faces, (Faces{4, 7}));
  EXPECT_EQ(check(mesh).component_of_face[4], -1);
}

TEST(Check, RepeatedVertexInAFaceIsFound) {
  TriangleMesh mesh = cube();
  mesh.faces.push_back({1, 5, 1});
  expect_issues(mesh, {MeshIssueKind::repeated_vertices}, "1 face that has the same vertex twice: 13; remove");
  EXPECT_EQ(check(mesh).repeated_vertex_faces, (Faces{12}));
  EXPECT_FALSE(check(mesh).closed());
}

TEST(Check, DuplicateVerticesAreFoundAndNegativeZeroEqualsZero) {
  TriangleMesh mesh = cube();
  mesh.vertices.push_back({-0.0, 0.0, -0.0});
  ASSERT_EQ(mesh.vertices[0], Eigen::Vector3d::Zero());
  for (Index& v : mesh.faces[0])
    if (v == 0) v = 8;
  expect_issues(mesh, {MeshIssueKind::duplicate_vertices, MeshIssueKind::border_edges},
                "1 duplicate vertex: 9 (as 1); merge vertices of equal coordinates");
  EXPECT_EQ(check(mesh).duplicate_vertices, (std::vector<std::array<Index, 2>>{{0, 8}}));
}

TEST(Check, VerticesOneUlpApartAreNotDuplicates) {
  TriangleMesh mesh = cube();
  mesh.vertices.push_back({std::nextafter(1.0, 2.0), 0, 0});
  expect_issues(mesh, {MeshIssueKind::unused_vertices});
}

TEST(Check, TwoCubesSharingAnEdgeAreNonManifold) {
  // Second cube diagonally beside the first: they share the edge x = y = 1.
  const TriangleMesh mesh = weld(joined(cube(), translated(cube(), {1, 1, 0})));
  ASSERT_EQ(mesh.vertices.size(), 14u);
  expect_issues(mesh, {MeshIssueKind::non_manifold_edges}, "1 edge of more than two faces: ");
  const MeshReport report = check(mesh);
  EXPECT_EQ(report.non_manifold_edges[0].faces.size(), 4u);
  EXPECT_EQ(report.component_count, 1);
  EXPECT_EQ(report.closed_component_count, 0);
}

TEST(Check, TwoCubesSharingAVertexArePinched) {
  const TriangleMesh mesh = weld(joined(cube(), translated(cube(), {1, 1, 1})));
  ASSERT_EQ(mesh.vertices.size(), 15u);
  expect_issues(mesh, {MeshIssueKind::pinched_vertices}, "1 vertex in which parts of the surface touch: ");
  const MeshReport report = check(mesh);
  EXPECT_EQ(mesh.vertices[report.pinched_vertices[0]], Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(report.component_count, 2);
  EXPECT_TRUE(report.closed());
}

TEST(Check, BowTieOfTwoTrianglesIsPinched) {
  const TriangleMesh mesh{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}, "bow tie"};
  expect_issues(mesh, {MeshIssueKind::pinched_vertices, MeshIssueKind::border_edges}, "1 vertex in which parts");
}

TEST(Check, FlippedFaceIsInconsistent) {
  TriangleMesh mesh = cube();
  std::swap(mesh.faces[3][0], mesh.faces[3][1]);
  expect_issues(mesh, {MeshIssueKind::inconsistent_orientation}, "3 edges between faces of opposite orientation: ");
  for (const EdgeFaces& edge : check(mesh).flipped_edges)
    EXPECT_NE(std::find(edge.faces.begin(), edge.faces.end(), 3), edge.faces.end());
  EXPECT_FALSE(check(mesh).closed());
}

TEST(Check, MoebiusStripIsInconsistentHoweverItsFacesTurn) {
  const TriangleMesh mesh = moebius_strip();
  expect_issues(mesh, {MeshIssueKind::inconsistent_orientation, MeshIssueKind::border_edges},
                "1 edge between faces of opposite orientation");
}

TEST(Check, ZeroAreaFacesAreFoundExactly) {
  // The third point of the first face is exactly between the others, that of the second face one ulp beside it.
  const double above = std::nextafter(0.2, 1.0);
  const TriangleMesh mesh{{{0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}, {0.2, 0.2, 0.2}, {0.2, 0.2, above}, {1, 0, 0}},
                          {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}},
                          "sliver"};
  const MeshReport report = check(mesh);
  // 0.1, 0.2, 0.3 as doubles are collinear on the diagonal whatever their spacing.
  EXPECT_EQ(report.zero_area_faces, (Faces{0}));
  expect_bad_input([&] { require_fit(report); }, "1 face of zero area: 1; move one of the three vertices");
}

TEST(Check, DenormalAndHugeFacesHaveAreas) {
  for (const double size : {5e-324, 1e-200, 1e160, 1e308}) {
    EXPECT_TRUE(check(scaled(cube(), size)).fit()) << size;
    EXPECT_FALSE(check(scaled(inverted(cube()), size)).fit()) << size;
  }
}

TEST(Check, InsideOutCubeIsFound) {
  expect_issues(inverted(cube()), {MeshIssueKind::inside_out_components},
                "1 closed component that is inside out: the one of face 1 (12 faces); reverse the order");
  EXPECT_TRUE(check(inverted(cube())).closed());
}

TEST(Check, FarFlatBodyIsOrientedExactly) {
  // One ulp thick at 2^40 sizes from the origin: the volume vanishes in floating point.
  const double ulp = std::ldexp(1.0, -12);
  TriangleMesh mesh = cube();
  for (Eigen::Vector3d& p : mesh.vertices)
    p = Eigen::Vector3d(p.x(), p.y(), p.z() * ulp) + Eigen::Vector3d::Constant(0x1p40);
  EXPECT_TRUE(check(mesh).fit()) << check(mesh).summary();
  EXPECT_FALSE(check(inverted(mesh)).fit());
}

TEST(Check, ClosedPartThatEnclosesNothingIsUnfit) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, "pillow"};
  expect_issues(mesh, {MeshIssueKind::inside_out_components}, "(2 faces, encloses no volume)");
}

TEST(Check, SpokeWhoseEndsLieInTheRimIsNotEnclosedByIt) {
  // A square rim, outer +-3, inner +-2, and a bar through its hole: all corners of the bar lie within the rim.
  TriangleMesh rim;
  for (const double z : {0.0, 1.0})
    for (const double r : {3.0, 2.0})
      for (const Eigen::Vector2d& q : {Eigen::Vector2d(-r, -r), {r, -r}, {r, r}, {-r, r}})
        rim.vertices.emplace_back(q.x(), q.y(), z);
  const auto add_quad = [&rim](Index a, Index b, Index c, Index d) {
    rim.faces.push_back({a, b, c});
    rim.faces.push_back({a, c, d});
  };
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    add_quad(8 + i, 8 + j, 12 + j, 12 + i);
    add_quad(j, i, 4 + i, 4 + j);
    add_quad(i, j, 8 + j, 8 + i);
    add_quad(4 + j, 4 + i, 12 + i, 12 + j);
  }
  TriangleMesh spoke = cube();
  for (Eigen::Vector3d& p : spoke.vertices) p = {5 * p.x() - 2.5, 0.4 * p.y() - 0.2, 0.5 * p.z() + 0.25};
  expect_issues(rim, {});
  expect_issues(joined(rim, spoke), {});
  expect_issues(joined(spoke, rim), {});
  expect_issues(joined(rim, inverted(spoke)), {MeshIssueKind::inside_out_components},
                "the one of face 33 (12 faces); reverse");
}

TEST(Check, CavityLooksInwardAndABodyInsideItOutward) {
  const TriangleMesh outer = scaled(cube(), 8);
  const TriangleMesh cavity = translated(scaled(cube(), 4), {2, 2, 2});
  const TriangleMesh body = translated(cube(), {3, 3, 3});
  expect_issues(joined(outer, inverted(cavity)), {});
  expect_issues(joined(inverted(cavity), outer), {});
  expect_issues(joined(joined(body, inverted(cavity)), outer), {});
  expect_issues(joined(outer, cavity), {MeshIssueKind::inside_out_components},
                "the one of face 13 (12 faces, enclosed by 1 other)");
  expect_issues(joined(joined(inverted(body), inverted(cavity)), outer), {MeshIssueKind::inside_out_components},
                "the one of face 1 (12 faces, enclosed by 2 others)");
  expect_issues(joined(inverted(outer), cavity), {MeshIssueKind::inside_out_components}, "2 closed components");
}

TEST(Check, BodiesThatTouchOrCrossAreNotNested) {
  // On top of one another, inside touching from within on faces, edges and corners, and crossing.
  expect_issues(joined(scaled(cube(), 2), translated(cube(), {0.5, 0.5, 2})), {});
  expect_issues(joined(scaled(cube(), 4), translated(scaled(cube(), 2), {1, 1, 3})), {});
  expect_issues(joined(scaled(cube(), 4), inverted(translated(scaled(cube(), 2), {1, 1, 2}))), {});
  expect_issues(joined(scaled(cube(), 4), inverted(translated(scaled(cube(), 2), {2, 1, 2}))), {});
  expect_issues(joined(scaled(cube(), 4), translated(cube(), {-2, 1, 1})), {});
}

TEST(Check, CubesSpreadOverAGridAreAllOutside) {
  TriangleMesh mesh;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 5; ++k) mesh = joined(mesh, translated(cube(), {1.5 * i, 1.5 * j, 1.5 * k}));
  const MeshReport report = check(mesh);
  EXPECT_TRUE(report.fit()) << report.summary();
  EXPECT_EQ(report.component_count, 125);
  EXPECT_EQ(report.closed_component_count, 125);
}

TEST(Check, InwardPartIsAnErrorBesideAnOpenOneAndAWarningWithinIt) {
  const TriangleMesh plate{{{-9, -9, -9}, {9, -9, 9}, {9, 9, 9}}, {{0, 1, 2}}, ""};
  expect_issues(joined(plate, inverted(cube())), {MeshIssueKind::possible_cavities, MeshIssueKind::border_edges});
  expect_issues(joined(plate, inverted(translated(cube(), {20, 0, 0}))),
                {MeshIssueKind::inside_out_components, MeshIssueKind::border_edges}, "is inside out");
}

TEST(Check, UnusedVertexIsAWarning) {
  TriangleMesh mesh = cube();
  mesh.vertices.insert(mesh.vertices.begin(), Eigen::Vector3d(7, 7, 7));
  for (Triangle& face : mesh.faces)
    for (Index& v : face) ++v;
  expect_issues(mesh, {MeshIssueKind::unused_vertices});
  EXPECT_EQ(check(mesh).unused_vertices, (Faces{0}));
  EXPECT_EQ(check(mesh).issues()[0].severity, Severity::warning);
}

TEST(Check, OnlyTheFirstFewElementsAreListed) {
  const std::string text = check(joined(cube(), cube())).issues()[0].text;
  EXPECT_TRUE(text.starts_with("8 duplicate vertices: 9 (as 1), ")) << text;
  EXPECT_NE(text.find(" and 3 more; merge"), std::string::npos) << text;
}

TEST(Check, AMillionFacesAreChecked) {
  // A closed gridded slab with a cavity of the same fineness: 1,003,520 faces.
  const TriangleMesh slab = slab_on_a_grid(352);
  const TriangleMesh mesh = joined(slab, inverted(translated(scaled(slab, 0.5), {88, 88, 0.25})));
  ASSERT_GT(mesh.faces.size(), 990'000u);
  const MeshReport report = check(mesh);
  EXPECT_TRUE(report.fit()) << report.summary();
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.component_count, 2);
}

}  // namespace
}  // namespace pcm
