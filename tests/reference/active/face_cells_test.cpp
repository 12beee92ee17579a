// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/active/face_cells.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "reference/active/face_paths.h"
#include "reference/active/face_points.h"
#include "reference/combinatorics/combinatorics.h"
#include "tests/reference/poses.h"
#include "tests/reference/problems.h"

namespace pcm::reference {
namespace {

/// Segments by the face of one side that they lie on.
std::map<Index, std::vector<FaceSegment>> segments_on(Side side, const Crossings& crossings) {
  std::map<Index, std::vector<FaceSegment>> segments;
  for (const Segment& s : crossings.segments)
    segments[side == Side::E ? s.face_E : s.face_F].push_back(
        {side == Side::E ? s.face_F : s.face_E, {crossings.ids[s.start], crossings.ids[s.end]}});
  return segments;
}

Rational area_of(const std::vector<FaceCell>& cells, const FaceLines& lines, Side side, Index face,
                 const ExactPose& exact_pose) {
  InsidePart part;
  part.face = face;
  part.apex = lines.apex();
  part.planes = lines.faces();
  part.crossings = lines.crossings();
  for (const FaceCell& cell : cells) part.cells.push_back({1, cell.corners});
  ConvertedPose<Rational> pose(exact_pose);
  Rational sum = 0;
  using Point = FacePoint<Rational>;
  for_each_triangle(pose, side, part, [&](int, const Point& a, const Point& b, const Point& c) {
    const Rational share = share_of(a, b, c, Rational(1, 2));
    EXPECT_GT(share, 0);
    sum += share;
  });
  return sum;
}

/// The first corner that surely lies in no plane of a segment; the first of all where there is none.
int expected_apex(const FaceLines& lines) {
  for (int corner = 0; corner < 3; ++corner) {
    bool in_none = true;
    for (Index segment = 0; segment < lines.segment_count(); ++segment)
      in_none &= certain_sign(lines.line(lines.line_of(segment))[corner]) != 0;
    if (in_none) return corner;
  }
  return 0;
}

/// How many cells there were.
int expect_fit_cells(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Problem problem, const Pose& pose) {
  const Surface E = make_surface(mesh_E), F = make_surface(mesh_F);
  const ExactPose exact_pose(problem, E, F, pose);
  const Combinatorics found = find_combinatorics(exact_pose);
  const Orientation orientation(exact_pose);
  int count = 0;
  for (const Side side : {Side::E, Side::F})
    for (const auto& [face, segments] : segments_on(side, found.crossings)) {
      const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
      FaceLines lines(exact_pose, side, face, segments);
      EXPECT_EQ(lines.apex(), expected_apex(lines));
      const std::vector<FaceCell> cells = cut_into_cells(orientation, side, face, lines);
      const std::vector<int>& winding = (side == Side::E ? found.E : found.F).winding;
      const Triangle& t = exact_pose.face(side, face);
      for (const FaceCell& cell : cells) {
        FacePaths paths(orientation, side, face, lines, cell.corners);
        for (int corner = 0; corner < 3; ++corner)
          EXPECT_EQ(winding[t[corner]] + paths.change(corner), winding[t[lines.apex()]] + cell.change);
      }
      EXPECT_EQ(area_of(cells, lines, side, face, exact_pose), Rational(1, 2));
      count += static_cast<int>(cells.size());
    }
  return count;
}

TEST(FaceCells, MakeUpTheFaceAndWindAlikeFromAllCornersInRandomPoses) {
  const std::uint64_t seed = 20261122;
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const TriangleMesh shapes[] = {generate::gridded_box(1.0, 2), generate::icosphere(0.6, 1),
                                 generate::torus(0.5, 0.25, 8, 6), generate::cone(0.5, 1, 9)};
  int cells = 0;
  for (int i = 0; i < 24; ++i) {
    const TriangleMesh &E = shapes[random() % 4], &F = shapes[random() % 4];
    const Pose pose = random_pose(random, 0.7);
    for (const Problem problem : kProblems) cells += expect_fit_cells(E, F, problem, pose);
  }
  EXPECT_GE(cells, 2000);
}

TEST(FaceCells, MakeUpTheFaceWhereManyCrossingsLieOnOneRay) {
  // Twenty posts pass through the top, all touching one line through its first corner from the same side.
  TriangleMesh body;
  body.vertices = {{0, 0, 0}, {64, 0, 0}, {0, 64, 0}, {0, 0, -64}};
  body.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  TriangleMesh posts;
  for (int k = 1; k <= 20; ++k)
    posts = degenerate::joined(std::move(posts), generate::box({2 * k - 0.5, 1.0 * k, -1}, {2.0 * k, k + 0.5, 1}));
  for (const Problem problem : kProblems) EXPECT_GE(expect_fit_cells(body, posts, problem, shifted(0, 0, 0)), 60);
}

TEST(FaceCells, MakeUpTheFaceAndWindAlikeFromAllCornersWhereGridsLieUponEachOther) {
  std::mt19937_64 random(7);
  const TriangleMesh grid = generate::gridded_box(2.0, 2), cone = generate::cone(0.5, 1, 4);
  int cells = 0;
  for (int i = 0; i < 12; ++i) {
    const auto half_cells = [&random] { return static_cast<double>(random() % 5) / 2 - 1; };
    Pose pose = shifted(half_cells(), half_cells(), half_cells());
    if (random() % 2 == 0) pose.A << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    cells += expect_fit_cells(grid, grid, Problem::rounded, pose);
    cells += expect_fit_cells(grid, cone, Problem::exact, pose);
  }
  EXPECT_GE(cells, 500);
}

}  // namespace
}  // namespace pcm::reference
