// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/rounded_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/poses/exact_arithmetic.h"
#include "compare/random/random.h"

namespace pcm::compare {

std::vector<Eigen::Vector3d> rounded_vertices(const TriangleMesh& mesh_F, const Pose& pose) {
  std::vector<Eigen::Vector3d> vertices_Me;
  vertices_Me.reserve(mesh_F.vertices.size());
  for (const Eigen::Vector3d& x_Mf : mesh_F.vertices) vertices_Me.push_back(ordered_product(pose.A, x_Mf) + pose.r);
  return vertices_Me;
}

double backward_error_ulps(const TriangleMesh& mesh_F, const Pose& pose) {
  double greatest = 0;
  for (const Eigen::Vector3d& x_Mf : mesh_F.vertices) {
    for (int i = 0; i < 3; ++i) {
      double error = 0;
      double scale = std::abs(pose.r[i]);
      Eigen::Vector3d product;
      for (int j = 0; j < 3; ++j) {
        product[j] = pose.A(i, j) * x_Mf[j];
        error += std::fma(pose.A(i, j), x_Mf[j], -product[j]);
        scale = std::max(scale, std::abs(product[j]));
      }
      const TwoSum first(product[0], product[1]);
      const TwoSum second(first.sum, product[2]);
      const TwoSum third(second.sum, pose.r[i]);
      error += first.error + second.error + third.error;
      scale = std::max(scale, std::abs(third.sum));
      if (error == 0) continue;
      // One ulp of a number in [2^k, 2^(k+1)) is 2^(k-52).
      greatest = std::max(greatest, std::ldexp(std::abs(error), 52 - std::ilogb(scale)));
    }
  }
  return greatest;
}

double ulp_of(double x) {
  const double magnitude = std::abs(x);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

double coordinate_scale(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose) {
  double scale = pose.r.cwiseAbs().maxCoeff();
  for (const Eigen::Vector3d& x : mesh_E.vertices) scale = std::max(scale, x.cwiseAbs().maxCoeff());
  for (const Eigen::Vector3d& x : mesh_F.vertices) {
    scale = std::max(scale, x.cwiseAbs().maxCoeff());
    scale = std::max(scale, ordered_product(pose.A, x).cwiseAbs().maxCoeff());
  }
  return scale;
}

}  // namespace pcm::compare
