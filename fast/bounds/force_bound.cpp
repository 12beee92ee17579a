// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/force_bound.h"

#include <algorithm>
#include <limits>

#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

/// What is no number came of an overflow and promises nothing.
Eigen::Vector3d number_or_infinity(const Eigen::Vector3d& bound) {
  return bound.unaryExpr([](double x) { return x >= 0 ? x : std::numeric_limits<double>::infinity(); });
}

}  // namespace

MasterBound::MasterBound(const Intersection& intersection, Side master, const ForceProblem& problem,
                         UndecidedFaces& undecided)
    : problem_(problem),
      master_(master),
      undecided_(undecided),
      rounding_Me_(greatest_vertex_rounding(intersection.posed.surface(Side::F), problem.pose)) {
  find_undecided_faces(intersection, master, rounding_Me_, undecided);
}

void MasterBound::add(const ElementForceError& error) {
  sum_.force_Me += error.force_Me;
  sum_.torque_Me += error.torque_Me;
}

void MasterBound::add_rounding_of(const MasterForce& total) {
  sum_.force_Me += kUnitRoundoff * total.force_Me.cwiseAbs();
  sum_.torque_Me += kUnitRoundoff * total.torque_Me.cwiseAbs();
}

void MasterBound::note_depth(double at_least, double at_most) {
  sum_.penetration_at_least = std::max(sum_.penetration_at_least, at_least);
  sum_.penetration_at_most = at_most >= 0 || at_most < 0 ? std::max(sum_.penetration_at_most, at_most)
                                                         : std::numeric_limits<double>::infinity();
}

void MasterBound::add_whole_force(const Element& element) {
  const Eigen::Vector3d lever = element.position_Me - problem_.pose.r;
  sum_.flipped = true;
  sum_.force_Me += element.force_Me.cwiseAbs();
  sum_.torque_Me += Eigen::Vector3d::Constant(kSafetyFactor * lever.lpNorm<1>() * element.force_Me.lpNorm<1>());
}

void MasterBound::add_possible_element(double area, double depth, const FaceGeometry& geometry,
                                       const Eigen::Vector3d& foot_error) {
  const GreatestForce greatest = greatest_force(problem_, area, depth, geometry.barycentre_Me(), foot_error);
  sum_.flipped = true;
  note_depth(0, kSafetyFactor * depth);
  sum_.force_Me += Eigen::Vector3d::Constant(greatest.force());
  sum_.torque_Me += Eigen::Vector3d::Constant(greatest.torque);
}

ForceBound MasterBound::result() const {
  return {number_or_infinity(kSafetyFactor * sum_.force_Me), number_or_infinity(kSafetyFactor * sum_.torque_Me),
          sum_.flipped, (1 - 4 * kUnitRoundoff) * sum_.penetration_at_least,
          (1 + 4 * kUnitRoundoff) * sum_.penetration_at_most};
}

ForceBound mean_bound(const ForceBound& E, const ForceBound& F, const MasterForce& mean) {
  return {number_or_infinity(0.5 * (E.force_Me + F.force_Me) +
                             kSafetyFactor * kUnitRoundoff * (mean.force_Me.cwiseAbs() + E.force_Me + F.force_Me)),
          number_or_infinity(0.5 * (E.torque_Me + F.torque_Me) +
                             kSafetyFactor * kUnitRoundoff * (mean.torque_Me.cwiseAbs() + E.torque_Me + F.torque_Me)),
          E.flipped || F.flipped, std::max(E.penetration_at_least, F.penetration_at_least),
          std::max(E.penetration_at_most, F.penetration_at_most)};
}

}  // namespace pcm::fast
