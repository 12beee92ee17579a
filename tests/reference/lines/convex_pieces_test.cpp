// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/convex_pieces.h"

#include <CGAL/FPU.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "meshes/generate/boxes.h"
#include "tests/shifted_pose.h"

namespace pcm::reference {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners corners_of(const TriangleMesh& mesh, Index face, const Eigen::Vector3d& shift) {
  const Triangle& t = mesh.faces[face];
  return {mesh.vertices[t[0]] + shift, mesh.vertices[t[1]] + shift, mesh.vertices[t[2]] + shift};
}

Eigen::Vector3d doubled_normal(const Corners& c) {
  return (c[1] - c[0]).cross(c[2] - c[0]);
}

/// Whether both points lie strictly beyond one side of a face, seen along `normal`.
bool are_beyond_a_side(const Corners& face, const Eigen::Vector3d& normal, const Eigen::Vector3d& a,
                       const Eigen::Vector3d& b) {
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d &from = face[i], along = face[(i + 1) % 3] - from;
    const auto turn = [&](const Eigen::Vector3d& x) { return normal.dot(along.cross(x - from)); };
    const double inwards = turn(face[(i + 2) % 3]);
    if (turn(a) * inwards < 0 && turn(b) * inwards < 0) return true;
  }
  return false;
}

/// The same polygon, its sides counted from another one.
ConvexPiece counted_from(ConvexPiece piece, int first) {
  std::rotate(piece.sides.begin(), piece.sides.begin() + first, piece.sides.end());
  std::rotate(piece.corners.begin(), piece.corners.begin() + first, piece.corners.end());
  return piece;
}

TEST(ConvexPieces, ReachASideUnlessBothItsEndsLieBeyondOneLineWhicheverSideIsCountedFirst) {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  // Numbers so small and whole that enclosures are exact.
  const TriangleMesh mesh_E = generate::box({4, 4, 4}), mesh_F = generate::box({2, 2, 2});
  const Surface E = make_surface(mesh_E), F = make_surface(mesh_F);
  int reached = 0, not_reached = 0;
  for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 1, 1), Eigen::Vector3d(3, -1, 2)}) {
    const ExactPose pose(Problem::rounded, E, F, shifted(shift.x(), shift.y(), shift.z()));
    VisibilityPoints points(pose);
    for (Index master = 0; master < static_cast<Index>(mesh_E.faces.size()); ++master) {
      MasterPlane plane(points, {Side::E, master});
      const ConvexPiece whole = whole_face(plane, plane.see({Side::E, master}));
      const Corners e = corners_of(mesh_E, master, Eigen::Vector3d::Zero());
      for (Index g = 0; g < static_cast<Index>(mesh_F.faces.size()); ++g) {
        const SeenFace& seen = plane.see({Side::F, g});
        if (seen.facing == 0) continue;
        const std::vector<HalfPlane> bounds(seen.sides.begin(), seen.sides.end());
        const Corners slave = corners_of(mesh_F, g, shift);
        for (int side = 0; side < 3; ++side) {
          const bool expected = !are_beyond_a_side(slave, doubled_normal(e), e[side], e[(side + 1) % 3]);
          (expected ? reached : not_reached) += 1;
          for (int first = 0; first < 3; ++first)
            EXPECT_EQ(may_reach_side(plane, counted_from(whole, first), whole.sides[side], bounds), expected)
                << "master " << master << ", slave " << g << ", side " << side << " counted from " << first;
        }
      }
    }
  }
  EXPECT_GT(reached, 100);
  EXPECT_GT(not_reached, 100);
}

}  // namespace
}  // namespace pcm::reference
