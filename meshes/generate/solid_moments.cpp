// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/solid_moments.h"

#include <array>

namespace pcm::generate {

SolidMoments solid_moments(const TriangleMesh& mesh) {
  // Integrals over the tetrahedron (0, a, b, c) of determinant d = a . (b x c): 1 gives d / 6, x gives d / 24 times the
  // sum of its corners, x x^T gives d / 120 times (the sum of the corners' products + that of the sum with itself).
  double sum_1 = 0;
  std::array<double, 3> sum_x{};
  std::array<std::array<double, 3>, 3> sum_xx{};
  for (const auto& [i, j, k] : mesh.faces) {
    const Eigen::Vector3d &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    const double determinant = a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
                               a.z() * (b.x() * c.y() - b.y() * c.x());
    sum_1 += determinant;
    for (int row = 0; row < 3; ++row) {
      const double sum_row = a[row] + b[row] + c[row];
      sum_x[row] += determinant * sum_row;
      for (int column = row; column < 3; ++column) {
        const double sum_column = a[column] + b[column] + c[column];
        sum_xx[row][column] +=
            determinant * (a[row] * a[column] + b[row] * b[column] + c[row] * c[column] + sum_row * sum_column);
      }
    }
  }

  SolidMoments solid;
  solid.volume = sum_1 / 6;
  for (int row = 0; row < 3; ++row) solid.centroid[row] = sum_x[row] / (4 * sum_1);
  const auto covariance = [&](int row, int column) {
    return sum_xx[row][column] / (20 * sum_1) - solid.centroid[row] * solid.centroid[column];
  };
  const double xx = covariance(0, 0), yy = covariance(1, 1), zz = covariance(2, 2);
  const double xy = covariance(0, 1), xz = covariance(0, 2), yz = covariance(1, 2);
  solid.unit_inertia << yy + zz, -xy, -xz,  //
      -xy, xx + zz, -yz,                    //
      -xz, -yz, xx + yy;
  return solid;
}

}  // namespace pcm::generate
