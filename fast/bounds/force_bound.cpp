// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/force_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/base/depth.h"
#include "fast/bounds/certain_activity.h"
#include "fast/bounds/certain_line.h"
#include "fast/bounds/element_error.h"
#include "fast/bounds/force_error.h"
#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

/// What is no number came of an overflow and promises nothing.
Eigen::Vector3d number_or_infinity(const Eigen::Vector3d& bound) {
  return bound.unaryExpr([](double x) { return x >= 0 ? x : std::numeric_limits<double>::infinity(); });
}

}  // namespace

MasterBound::MasterBound(const Intersection& intersection, Side master, const ForceProblem& problem,
                         BoundScratch& scratch)
    : intersection_(intersection),
      posed_(intersection.posed),
      scratch_(scratch),
      problem_(problem),
      master_(master),
      rounding_Me_(greatest_vertex_rounding(posed_.surface(Side::F), problem.pose)) {
  find_undecided_faces(intersection, master, rounding_Me_, scratch.undecided);
}

Eigen::Vector3d MasterBound::rounding_of(Side side, Index face) const {
  if (side == Side::E) return Eigen::Vector3d::Zero();
  return face_rounding(posed_.surface(side), problem_.pose, face);
}

LineTrace* MasterBound::begin_face(Index face, const FaceGeometry& geometry) {
  face_ = FaceError(geometry, rounding_of(master_, face));
  // The exact line, and the slave's faces, both within their own rounding.
  scratch_.line_trace.radius = 2 * tube_radius(posed_, face_, rounding_Me_);
  return &scratch_.line_trace;
}

void MasterBound::add_element(const FaceGeometry& geometry, const Element& element, const MasterForce& total) {
  using Finding = CertainLine::Finding;
  ElementError error;
  error.area = face_.area;
  error.normal = face_.normal;
  error.foot_Me = face_.barycentre_Me;
  const Side slave = opposite(master_);
  // Of both faces, one is F's.
  const Eigen::Vector3d rounding_Me =
      rounding_of(master_, element.master_face) + rounding_of(slave, element.slave_face);
  error.penetration = depth_error(geometry, face_, posed_.face_Me(slave, element.slave_face), rounding_Me);
  const CertainLine line = follow_certainly(posed_, master_, element.master_face, geometry, face_, element.slave_face,
                                            scratch_.line_trace, rounding_Me_, scratch_.open);
  const double depth = DepthBelow(geometry, posed_.face_Me(slave, element.slave_face)).value();
  const bool decided = line.finding == Finding::element &&
                       !scratch_.undecided.is_undecided.contains(element.master_face) &&
                       element.penetration > 2 * error.penetration;
  if (decided) {
    note_depth(depth - kBoundMargin * error.penetration, depth + kBoundMargin * error.penetration);
    const ElementForceError bound = force_error(problem_, element, error);
    sum_.force_Me += bound.force_Me;
    sum_.torque_Me += bound.torque_Me;
  } else {
    add_whole_force(element);
    add_possible_element(element.area + error.area, line.greatest_depth, geometry, error.foot_Me);
  }
  sum_.force_Me += kUnitRoundoff * total.force_Me.cwiseAbs();
  sum_.torque_Me += kUnitRoundoff * total.torque_Me.cwiseAbs();
}

void MasterBound::add_no_element(Index face, const FaceGeometry& geometry, Index first_met) {
  const CertainLine line = follow_certainly(posed_, master_, face, geometry, face_, first_met, scratch_.line_trace,
                                            rounding_Me_, scratch_.open);
  if (line.finding == CertainLine::Finding::no_element) return;
  add_possible_element(geometry.area + face_.area, line.greatest_depth, geometry, face_.barycentre_Me);
}

void MasterBound::add_inactive_faces() {
  for (const Index face : scratch_.undecided.faces) {
    if (intersection_.is_active(master_, face)) continue;
    const FaceGeometry geometry(posed_.face_Me(master_, face));
    begin_face(face, geometry)->clear();
    add_no_element(face, geometry, -1);
  }
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
  sum_.torque_Me += Eigen::Vector3d::Constant(kBoundMargin * lever.lpNorm<1>() * element.force_Me.lpNorm<1>());
}

void MasterBound::add_possible_element(double area, double depth, const FaceGeometry& geometry,
                                       const Eigen::Vector3d& foot_error) {
  const GreatestForce greatest = greatest_force(problem_, area, depth, geometry.barycentre_Me(), foot_error);
  sum_.flipped = true;
  note_depth(0, kBoundMargin * depth);
  sum_.force_Me += Eigen::Vector3d::Constant(greatest.force());
  sum_.torque_Me += Eigen::Vector3d::Constant(greatest.torque);
}

void MasterBound::begin_clipped_face(Index face, const FaceGeometry& geometry) {
  own_rounding_Me_ = posed_[master_].sharp_face_rounding_Me(face);
  face_ = FaceError(geometry, own_rounding_Me_);
  undecided_ = scratch_.undecided.is_undecided.contains(face);
  passing_ = PassingError();
}

double MasterBound::slack() const {
  return tube_radius(posed_, face_, rounding_Me_);
}

void MasterBound::add_clipped_element(const Element& element, const ElementError* error, const MasterForce& total) {
  if (error != nullptr) {
    ElementForceError passed;
    ElementError all = *error;
    // The element surely exists.
    if (!undecided_ && element.area > kBoundMargin * (all.area + all.passed_area))
      note_depth(element.penetration - kBoundMargin * all.penetration, 0);
    passing_.add(problem_, element, all, passed);
    const ElementForceError bound = force_error(problem_, element, all);
    sum_.force_Me += passed.force_Me + PassingError::kGrowth * bound.force_Me;
    sum_.torque_Me += passed.torque_Me + PassingError::kGrowth * bound.torque_Me;
  }
  if (error == nullptr || undecided_) add_whole_force(element);
  sum_.force_Me += kUnitRoundoff * total.force_Me.cwiseAbs();
  sum_.torque_Me += kUnitRoundoff * total.torque_Me.cwiseAbs();
}

void MasterBound::end_clipped_face(const FaceGeometry& geometry, const SightError* sight) {
  const double twice_area = 2 * (geometry.area + face_.area);
  const auto& p = geometry.points_Me;
  const Eigen::Vector3d anywhere = (p[1] - p[0]).cwiseAbs() + (p[2] - p[0]).cwiseAbs();
  if (sight == nullptr || !sight->known()) {
    add_possible_element(0.5 * twice_area, span(posed_), geometry, face_.barycentre_Me + anywhere);
    return;
  }
  sum_.flipped = sum_.flipped || sight->flush();
  note_depth(0, kBoundMargin * sight->greatest_depth());
  const SightError::Beside beside = sight->beside();
  passing_.add_elsewhere(twice_area * beside.passed_area, twice_area * beside.passed_volume);
  ElementForceError passed;
  passing_.finish(passed);
  sum_.force_Me += passed.force_Me;
  sum_.torque_Me += passed.torque_Me;
  if (!(beside.area > 0)) return;
  // An element's force grows with its volume, and with its area where it is damped.
  const Eigen::Vector3d foot_error = face_.barycentre_Me + anywhere + Eigen::Vector3d::Constant(beside.depth);
  const GreatestForce greatest = greatest_force(problem_, twice_area * beside.area, beside.volume / beside.area,
                                                geometry.barycentre_Me(), foot_error);
  sum_.force_Me += greatest.normal * geometry.n_Me.cwiseAbs() +
                   Eigen::Vector3d::Constant(greatest.normal * face_.normal + greatest.friction);
  sum_.torque_Me += Eigen::Vector3d::Constant(greatest.torque);
}

ForceBound MasterBound::result() const {
  return {number_or_infinity(kBoundMargin * sum_.force_Me), number_or_infinity(kBoundMargin * sum_.torque_Me),
          sum_.flipped, (1 - 4 * kUnitRoundoff) * sum_.penetration_at_least,
          (1 + 4 * kUnitRoundoff) * sum_.penetration_at_most};
}

MasterForce sum_bounded_barycentric_elements(const Intersection& intersection, const ForceProblem& problem,
                                             LineNodes& open, MasterBound& bound, ElementRecord& record) {
  const Side master = bound.master();
  PosedPair& posed = intersection.posed;
  ElementSum sum(problem, record, posed.work);
  for_each_active_face(intersection, master, [&](Index face) {
    const FaceGeometry geometry(posed.face_Me(master, face));
    const Penetration penetration =
        find_penetration(posed, master, face, geometry, open, bound.begin_face(face, geometry));
    if (penetration.outcome == Penetration::Outcome::too_deep) ++record.too_deep;
    if (penetration.outcome != Penetration::Outcome::element) {
      bound.add_no_element(face, geometry, penetration.first_met);
      return;
    }
    Element element = barycentric_element(master, face, geometry, penetration, problem.law);
    sum.add(penetration.depth, geometry.barycentre_Me(), element);
    bound.add_element(geometry, element, sum.total());
  });
  bound.add_inactive_faces();
  return sum.total();
}

ForceBound mean_bound(const ForceBound& E, const ForceBound& F, const MasterForce& mean) {
  return {number_or_infinity(0.5 * (E.force_Me + F.force_Me) +
                             kBoundMargin * kUnitRoundoff * (mean.force_Me.cwiseAbs() + E.force_Me + F.force_Me)),
          number_or_infinity(0.5 * (E.torque_Me + F.torque_Me) +
                             kBoundMargin * kUnitRoundoff * (mean.torque_Me.cwiseAbs() + E.torque_Me + F.torque_Me)),
          E.flipped || F.flipped, std::max(E.penetration_at_least, F.penetration_at_least),
          std::max(E.penetration_at_most, F.penetration_at_most)};
}

}  // namespace pcm::fast
