// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// The elastic foundation of a convex polyhedron on a half space, in closed form.
namespace pcm::compare {

/// A convex mesh is pressed onto a horizontal plane and is master, K the stiffness, no damping. The penetration line of
/// a face with the normal n leaves through the plane after d / |n_z|, d the vertical depth of the point under it; so
/// the vertical force is K times the sum over the immersed faces of the integral of d dA (clipped scheme) or of A d(C)
/// (barycentric), and its integral over the depth is that of d^2 / 2. Holds while the plane is below every face that
/// looks upward. Independent of the engine: nothing but areas and depths of triangles. O(n) a call.
class PolyhedralFoundation {
 public:
  PolyhedralFoundation(const TriangleMesh& mesh, double stiffness, Scheme scheme);

  /// Vertical force, N, with the plane at the height z of the mesh's frame.
  double force(double plane) const;
  /// Work of pressing up to there, J.
  double work(double plane) const;
  /// Heights between which force and work are polynomials, ascending.
  const std::vector<double>& kinks() const { return kinks_; }

 private:
  struct Face {
    double area = 0;
    std::array<double, 3> heights{};  ///< ascending; barycentric scheme: thrice the barycentre's
  };
  std::vector<Face> faces_;  ///< those that look down
  double stiffness_ = 0;
  std::vector<double> kinks_;
};

}  // namespace pcm::compare
