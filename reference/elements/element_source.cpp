// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/elements/element_source.h"

namespace pcm::reference {
namespace {

template <class T>
ElementGeometry<T> geometry_of(ConvertedPose<T>& pose, const ElementPair& element) {
  const auto p = pose.corners(element.master, element.master_face);
  const auto f = pose.corners(other(element.master), element.slave_face);
  const Vec3<T> N = doubled_normal(p[0], p[1], p[2]), slave_N = doubled_normal(f[0], f[1], f[2]);
  const Vec3<T> barycentre = T(pose.number(1.0) / pose.number(3.0)) * (p[0] + p[1] + p[2]);  // (8)
  const T q = dot(barycentre - f[0], slave_N) / dot(N, slave_N);                             // (11)
  return {N, slave_N, pose.number(0.5), q, q, barycentre};
}

}  // namespace

ElementGeometry<DoubleDouble> BarycentricElements::geometry(std::size_t i, ConvertedPose<DoubleDouble>& pose) const {
  return geometry_of(pose, pairs_[i]);
}

ElementGeometry<Ball> BarycentricElements::geometry(std::size_t i, ConvertedPose<Ball>& pose) const {
  return geometry_of(pose, pairs_[i]);
}

ElementGeometry<Dual<DoubleDouble>> BarycentricElements::geometry(std::size_t i,
                                                                  ConvertedPose<Dual<DoubleDouble>>& pose) const {
  return geometry_of(pose, pairs_[i]);
}

ElementGeometry<Dual<Ball>> BarycentricElements::geometry(std::size_t i, ConvertedPose<Dual<Ball>>& pose) const {
  return geometry_of(pose, pairs_[i]);
}

ElementGeometry<Quadratic> BarycentricElements::geometry(std::size_t i, ConvertedPose<Rational>& pose) const {
  return converted(geometry_of(pose, pairs_[i]));
}

}  // namespace pcm::reference
