// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/master_prism.h"

#include <cmath>

#include "fast/number_vector.h"
#include "fast/orientation.h"

namespace pcm::fast {

namespace {

/// The terms of N = (p1 - p0) x (p2 - p0) taken absolutely.
Eigen::Vector3d magnitude_of_normal(const std::array<Eigen::Vector3d, 3>& p) {
  const Eigen::Vector3d a = (p[1] - p[0]).cwiseAbs(), b = (p[2] - p[0]).cwiseAbs();
  return {a[1] * b[2] + a[2] * b[1] + kFilterUnderflow, a[2] * b[0] + a[0] * b[2] + kFilterUnderflow,
          a[0] * b[1] + a[1] * b[0] + kFilterUnderflow};
}

/// N . (x - p0) to a few ulps of itself, 0 only where it is 0: exact but for the last step. `size` is a length of the
/// face, so that scaling everything by 2^k scales the result exactly: the exact numbers' limbs have 64 bits.
double exact_height(const std::array<Eigen::Vector3d, 3>& p, const Eigen::Vector3d& x, double size) {
  const int exponent = std::ilogb(size) % 64;
  const double unit = std::ldexp(1, exponent < 0 ? -exponent : 64 - exponent);
  const auto from_p0 = [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d to = unit * point, from = unit * p[0];
    return difference<Dyadic>(to.data(), from.data());
  };
  return dot(cross(from_p0(p[1]), from_p0(p[2])), from_p0(x)).approximate() / (unit * unit * unit);
}

/// N . (x - p0), exactly where its sign would not be sure. It is the determinant of orient3d(p0, p1, p2, x), term by
/// term, and so is the bound of its error.
double height_along(const Eigen::Vector3d& N, const Eigen::Vector3d& N_magnitude,
                    const std::array<Eigen::Vector3d, 3>& p, const Eigen::Vector3d& x, WorkCounters& work) {
  const Eigen::Vector3d from_p0 = x - p[0];
  const double height = N.dot(from_p0);
  const double magnitude = N_magnitude.dot(from_p0.cwiseAbs());
  ++work.predicates;
  if (std::abs(height) > kFilterRelative * (magnitude + kFilterUnderflow)) return height;
  ++work.exact_predicates;
  return exact_height(p, x, (p[1] - p[0]).cwiseAbs().maxCoeff());
}

}  // namespace

MasterPrism::MasterPrism(const FaceGeometry& face)
    : face_(face),
      edge_s_Me_(face.points_Me[1] - face.points_Me[0]),
      edge_t_Me_(face.points_Me[2] - face.points_Me[0]),
      inverse_twice_area_(1 / (2 * face.area)) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d side = face.points_Me[(k + 1) % 3] - face.points_Me[k];
    inward_Me_[k] = inverse_twice_area_ * face.n_Me.cross(side);
  }
  N_magnitude_ = magnitude_of_normal(face.points_Me);
}

PrismPoint MasterPrism::see(const Eigen::Vector3d& x_Me, WorkCounters& work) const {
  const auto& p = face_.points_Me;
  const Eigen::Vector3d from_p0 = x_Me - p[0];
  const double height = height_along(face_.N_Me, N_magnitude_, p, x_Me, work);
  return {inward_Me_[1].dot(x_Me - p[1]), inward_Me_[2].dot(x_Me - p[2]), inward_Me_[0].dot(from_p0),
          -height * inverse_twice_area_};
}

TreePrism::TreePrism(const MasterPrism& prism, double slack)
    : down_(-prism.face().n_Me), top_(down_.dot(prism.p0_Me())), slack_(slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    inward_[k] = prism.inward_Me(k) / length(prism.inward_Me(k));
    offset_[k] = inward_[k].dot(prism.face().points_Me[k]);
  }
}

TreePrism::TreePrism(const MasterPrism& prism, double slack, const Eigen::Matrix3d& A, const Eigen::Vector3d& r_Me)
    : TreePrism(prism, slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    offset_[k] = inward_[k].dot(prism.face().points_Me[k] - r_Me);
    inward_[k] = A.transpose() * inward_[k];
  }
  top_ = down_.dot(prism.p0_Me() - r_Me);
  down_ = A.transpose() * down_;
}

double height_over(const std::array<Eigen::Vector3d, 3>& f, const Eigen::Vector3d& x, WorkCounters& work) {
  return height_along((f[1] - f[0]).cross(f[2] - f[0]), magnitude_of_normal(f), f, x, work);
}

}  // namespace pcm::fast
