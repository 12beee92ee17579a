// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/tangent_bounds.h"

#include <array>
#include <cstddef>
#include <optional>

#include "compare/verify/bounds/clipped_bounds.h"
#include "compare/verify/bounds/element_law.h"
#include "compare/verify/bounds/part_motion.h"
#include "compare/verify/bounds/rounded_faces.h"
#include "compare/verify/bounds/rounding_bounds.h"
#include "compare/verify/bounds/sliver_slopes.h"
#include "compare/verify/bounds/uncertain_number.h"
#include "reference/numbers/vector3.h"

namespace pcm::compare {
namespace {

using Number = UncertainNumber;
using Vector = reference::Vec3<Number>;

Vector exactly(const Eigen::Vector3d& x) {
  return {Number(x[0]), Number(x[1]), Number(x[2])};
}
Vector within(const Eigen::Vector3d& x, double error) {
  return {Number(x[0], error), Number(x[1], error), Number(x[2], error)};
}
/// Of a unit vector or a null vector, whatever was said of it.
Vector as_direction(const Vector& v) {
  const auto component = [](const Number& x) { return x.error <= 1 ? x : Number(0, 1); };
  return {component(v.x), component(v.y), component(v.z)};
}

/// A state's change, in twelve coordinates; the first six move the elements.
constexpr std::size_t kCoordinates = 12, kPlaces = 6;

/// Of the coordinate's own three.
Vector unit(std::size_t k) {
  return exactly(Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k % 3)));
}

/// How an element's geometry changes with one coordinate, as its master sees it.
struct GeometrySlope {
  Number area, depth;
  Vector position;
};

/// How its integrals do, where the master sees it as a part of a face: of the depth, and of the depth times the way
/// from the oracle's centre of pressure.
struct IntegralSlope {
  Number area, volume;
  Vector moment;
};

/// How an element's load changes.
struct LoadSlope {
  Vector force, torque;
};

/// Of what is the same seen from the master: by r the arm to an element of E changes, by a turn all of F turns.
LoadSlope with_motion_of_frames(LoadSlope slope, std::size_t k, bool on_E, const Vector& lever, const Vector& force) {
  if (on_E && k / 3 == 0) slope.torque = slope.torque - cross(unit(k), force);
  if (!on_E && k / 3 == 1) {
    slope.force = slope.force + cross(unit(k), force);
    slope.torque = slope.torque + cross(unit(k), cross(lever, force));
  }
  return slope;
}

/// One master's element and how its load changes with one coordinate: every quantity of PCM section 7 with its
/// derivative.
class MovingElement {
 public:
  MovingElement(const Question& question, const reference::Element& e, const ElementBounds& bounds)
      : question_(question),
        on_E_(e.master == Side::E),
        n_(as_direction(within(e.normal_Me, bounds.normal))),
        area_(e.area, bounds.area),
        lever_(within(e.position_Me, bounds.position) - exactly(question.pose.r)),
        v_n_(e.normal_velocity, bounds.normal_velocity),
        v_t_(e.tangential_velocity, bounds.tangential_velocity),
        force_(within(e.force_Me, bounds.force)),
        slopes_(law_slopes(question.law, area_, Number(e.penetration, bounds.penetration), v_n_, v_t_)) {
    const Vector v_F = exactly(question.velocity.v) + cross(exactly(question.velocity.w), lever_);
    const Vector v_k = on_E_ ? v_F : Number(-1) * v_F;
    slip_direction_ = v_t_.is_zero() ? Vector{} : as_direction(direction_of(v_k - v_n_ * n_));
  }

  /// By coordinate number k, of r, a turn about Mf, v, w, with which the geometry changes so.
  LoadSlope by(std::size_t k, const GeometrySlope& geometry) const {
    const Vector along = unit(k), none{}, dr = k / 3 == 0 ? along : none, turn = k / 3 == 1 ? along : none;
    const Vector w = exactly(question_.velocity.w);
    Vector dv = k / 3 == 2 ? along : none, dw = k / 3 == 3 ? along : none;
    if (on_E_) {
      dv = dv - cross(w, dr);
    } else {
      dv = dv - cross(turn, exactly(question_.velocity.v));
      dw = dw - cross(turn, w);
    }
    const Vector dv_F = dv + cross(dw, lever_) + cross(w, geometry.position);
    const Vector on_master = d_force_on_master(geometry, on_E_ ? dv_F : Number(-1) * dv_F);
    LoadSlope slope;
    slope.force = on_E_ ? on_master : Number(-1) * on_master;
    slope.torque = cross(geometry.position, force_) + cross(lever_, slope.force);
    return with_motion_of_frames(slope, k, on_E_, lever_, force_);
  }

 private:
  Vector direction_of(const Vector& slip) const { return {slip.x / v_t_, slip.y / v_t_, slip.z / v_t_}; }

  /// (21), with the derivative of v_k.
  Vector d_force_on_master(const GeometrySlope& geometry, const Vector& dv_k) const {
    const Vector& t = slip_direction_;
    const Number dv_n = dot(n_, dv_k), dv_t = dot(t, dv_k);
    const Number d_normal = slopes_.normal_by_depth * geometry.depth + slopes_.normal_by_approach * dv_n;
    const Number d_tangential = slopes_.tangential_by_depth * geometry.depth + slopes_.tangential_by_approach * dv_n +
                                (slopes_.tangential_by_slip - slopes_.tangential_over_slip) * dv_t;
    const Vector by_law = d_normal * n_ + d_tangential * t + slopes_.tangential_over_slip * (dv_k - dv_n * n_);
    // All forces grow with the area.
    const Number growth = on_E_ ? geometry.area / area_ : -(geometry.area / area_);
    return by_law + growth * force_;
  }

  const Question& question_;
  bool on_E_;
  Vector n_;
  Number area_;
  Vector lever_;
  Number v_n_, v_t_;
  Vector force_;  ///< on E
  LawSlopes slopes_;
  Vector slip_direction_;
};

Number shift_of(const Question& question, const reference::Element& e) {
  return Number(share_of_penetration(question.law, e.master), 4 * kRoundoff);
}

/// One master's element where nothing damps or rubs, or nothing moves: its load is c_l n times the integrals, so that
/// no quotient by its area is taken, however small that is. Where along n it acts does not matter.
class ElasticElement {
 public:
  ElasticElement(const Question& question, const reference::Element& e, const ElementBounds& bounds)
      : on_E_(e.master == Side::E),
        n_(as_direction(within(e.normal_Me, bounds.normal))),
        lever_(exactly(e.position_Me) - (shift_of(question, e) * Number(e.penetration)) * exactly(e.normal_Me) -
               exactly(question.pose.r)),
        lever_of_force_(within(e.position_Me, bounds.position) - exactly(question.pose.r)),
        force_(within(e.force_Me, bounds.force)) {
    const double c_l = series_stiffness(question.law);
    pressure_on_E_ = (on_E_ ? Number(1) : Number(-1)) * Number(c_l, 4 * kRoundoff * c_l) * n_;
  }

  LoadSlope by(std::size_t k, const IntegralSlope& slope) const {
    const Vector force = slope.volume * pressure_on_E_;
    return with_motion_of_frames({force, cross(slope.moment, pressure_on_E_) + cross(lever_, force)}, k, on_E_,
                                 lever_of_force_, force_);
  }

 private:
  bool on_E_;
  Vector n_;
  Vector lever_;           ///< of the oracle's centre of pressure, on the master
  Vector lever_of_force_;  ///< of a right engine's element
  Vector force_;           ///< on E
  Vector pressure_on_E_;   ///< by depth
};

/// A whole face stays as its master sees it; only the slave face comes nearer.
class BarycentricGeometry {
 public:
  BarycentricGeometry(const Question& question, const RoundedFaces& faces, const reference::Element& e,
                      const ElementBounds& bounds)
      : on_E_(e.master == Side::E),
        n_(as_direction(within(e.normal_Me, bounds.normal))),
        shift_(shift_of(question, e)) {
    const auto corner = [&](Side side, Index face, std::size_t k) { return exactly(faces.corner(side, face, k)); };
    const Side slave = opposite(e.master);
    const Vector f0 = corner(slave, e.slave_face, 0);
    const Vector N_f = cross(corner(slave, e.slave_face, 1) - f0, corner(slave, e.slave_face, 2) - f0);
    const Number slope = dot(n_, N_f);
    const Number share =
        where_below(Number(e.greatest_penetration, bounds.depth), question.law.max_penetration, Number(1), Number(0));
    gradient_ = {share * (N_f.x / slope), share * (N_f.y / slope), share * (N_f.z / slope)};
    const Vector foot =
        Number(1.0 / 3, kRoundoff) *
        (corner(e.master, e.master_face, 0) + corner(e.master, e.master_face, 1) + corner(e.master, e.master_face, 2));
    met_ = foot + Number(e.penetration, bounds.penetration) * n_ - exactly(question.pose.r);
  }

  GeometrySlope by(std::size_t k) const {
    if (k >= kPlaces) return {};
    const Vector along = unit(k);
    // The slave seen from the master, or the master from the slave: either way the gap closes by this.
    const Number closing = dot(gradient_, k / 3 == 0 ? along : cross(along, met_));
    const Number d_depth = on_E_ ? closing : -closing;
    return {Number(), d_depth, (shift_ * d_depth) * n_};
  }

 private:
  bool on_E_;
  Vector n_;
  Number shift_;
  Vector gradient_, met_;
};

/// The part that a master face sees moves as the oracle's does, within the errors of its integrals' derivatives.
class ClippedGeometry {
 public:
  ClippedGeometry(const Question& question, const reference::Element& e, const ElementBounds& bounds,
                  const reference::ElementMotion& motion, const PartMotionError& error)
      : n_(as_direction(within(e.normal_Me, bounds.normal))),
        area_(e.area, bounds.area),
        depth_(e.penetration, bounds.penetration),
        foot_error_(bounds.position),
        shift_(shift_of(question, e)),
        motion_(motion),
        error_(error) {}

  IntegralSlope integrals(std::size_t k) const {
    const auto column = static_cast<Eigen::Index>(k);
    const auto oracle = [&](Eigen::Index row) {
      return Number(motion_.slope(row, column), motion_.error(row, column));
    };
    const Number true_area = oracle(0), true_depth = oracle(1);
    IntegralSlope slope;
    slope.area = wider(true_area, error_.area[column]);
    slope.volume = wider(Number(area_.value) * true_depth + Number(depth_.value) * true_area, error_.volume[column]);
    for (int axis = 0; axis < 3; ++axis) {
      const Number true_foot = oracle(2 + axis) - (shift_ * true_depth) * n_[axis];
      set(slope.moment, axis, wider(Number(area_.value) * (Number(depth_.value) * true_foot), error_.moment[column]));
    }
    return slope;
  }

  GeometrySlope by(std::size_t k) const {
    if (k >= kPlaces) return {};
    const auto [d_area, d_volume, d_moment] = integrals(k);
    GeometrySlope slope;
    slope.area = d_area;
    slope.depth = (d_volume - depth_ * d_area) / area_;
    // About the oracle's centre of pressure, that of a right engine is elsewhere by no more than its error.
    const Number all = area_ * depth_, off(0, foot_error_);
    for (int axis = 0; axis < 3; ++axis)
      set(slope.position, axis, (d_moment[axis] - off * d_volume) / all + (shift_ * slope.depth) * n_[axis]);
    return slope;
  }

 private:
  static Number wider(const Number& x, double error) { return Number(x.value, x.error + error); }
  static void set(Vector& v, int axis, const Number& x) { (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = x; }

  Vector n_;
  Number area_, depth_;
  double foot_error_;  ///< m
  Number shift_;
  const reference::ElementMotion& motion_;
  const PartMotionError& error_;
};

/// Of all elements.
class SlopeSum {
 public:
  template <class Geometry>
  void add(const MovingElement& element, const Geometry& geometry) {
    for (std::size_t k = 0; k < kCoordinates; ++k) add(k, element.by(k, geometry.by(k)));
  }

  /// Of one whose load is linear in its integrals.
  void add(const ElasticElement& at_its_place, const MovingElement& at_its_speed, const ClippedGeometry& geometry) {
    for (std::size_t k = 0; k < kPlaces; ++k) add(k, at_its_place.by(k, geometry.integrals(k)));
    for (std::size_t k = kPlaces; k < kCoordinates; ++k) add(k, at_its_speed.by(k, {}));
  }

  /// Of an element that either side may lack: neither side has it change faster.
  void add(const GreatestSlopes& greatest) {
    const auto up_to = [](double most) { return Vector{Number(0, most), Number(0, most), Number(0, most)}; };
    for (std::size_t k = 0; k < kCoordinates; ++k) {
      sums_[k].force = sums_[k].force + up_to(greatest.force[k]);
      sums_[k].torque = sums_[k].torque + up_to(greatest.torque[k]);
    }
  }

  fast::Tangent errors(Mode mode) const {
    // Both sides are within the error of one number.
    const double share = mode == Mode::both ? 1 : 2;
    fast::Tangent result;
    for (std::size_t k = 0; k < kCoordinates; ++k)
      for (int axis = 0; axis < 3; ++axis) {
        result(axis, static_cast<Eigen::Index>(k)) = share * sums_[k].force[axis].error;
        result(3 + axis, static_cast<Eigen::Index>(k)) = share * sums_[k].torque[axis].error;
      }
    return result;
  }

 private:
  void add(std::size_t k, const LoadSlope& slope) {
    sums_[k].force = sums_[k].force + slope.force;
    sums_[k].torque = sums_[k].torque + slope.torque;
  }

  std::array<LoadSlope, kCoordinates> sums_;
};

fast::Tangent barycentric_bounds(const Question& question, const reference::Answer& true_rounded) {
  const RoundedFaces faces(question);
  const ForceBounds bounds = RoundingBounds(question, true_rounded).force();
  SlopeSum sum;
  for (std::size_t i = 0; i < true_rounded.elements.size(); ++i) {
    const reference::Element& e = true_rounded.elements[i];
    sum.add(MovingElement(question, e, bounds.elements[i]),
            BarycentricGeometry(question, faces, e, bounds.elements[i]));
  }
  return sum.errors(question.mode);
}

/// Whether force and torque are sums of what is linear in the elements' integrals, and so are their derivatives by r
/// and a turn: nothing damps or rubs, or nothing moves.
bool loads_are_linear(const Question& question) {
  const ContactLaw& law = question.law;
  return (law.damping == 0 && law.friction == 0) || (question.velocity.v.isZero(0) && question.velocity.w.isZero(0));
}

fast::Tangent clipped_bounds(const Question& question, const reference::Answer& true_rounded,
                             const std::vector<reference::ElementMotion>& motions) {
  const ClippedBounds bounds(question, true_rounded);
  std::optional<MasterView> view;
  SlopeSum sum;
  const ErrorOf of = loads_are_linear(question) ? ErrorOf::linear_sums : ErrorOf::each;
  for (std::size_t i = 0; i < true_rounded.elements.size(); ++i) {
    const reference::Element& e = true_rounded.elements[i];
    const ClippedBounds::OfElement& bound = bounds.elements()[i];
    if (!view || view->master() != e.master || view->master_face() != e.master_face)
      view.emplace(bounds.faces(), e.master, e.master_face);
    if (bound.sliver) {
      // What underflows is lost to whatever ends beside it.
      const ErrorOf of_sliver = bound.may_underflow ? ErrorOf::each : of;
      sum.add(
          greatest_slopes_of_sliver(question, e, bound, greatest_part_growth(question, e, bound, *view, of_sliver)));
      continue;
    }
    const PartMotionError error = part_motion_error(question, e, bound, *view, of);
    const MovingElement moving(question, e, bound.bounds);
    const ClippedGeometry geometry(question, e, bound.bounds, motions[i], error);
    if (of == ErrorOf::linear_sums) {
      sum.add(ElasticElement(question, e, bound.bounds), moving, geometry);
    } else {
      sum.add(moving, geometry);
    }
  }
  return sum.errors(question.mode);
}

}  // namespace

fast::Tangent tangent_bounds(const Question& question, const reference::Answer& true_rounded,
                             const std::vector<reference::ElementMotion>& motions) {
  return question.scheme == Scheme::clipped ? clipped_bounds(question, true_rounded, motions)
                                            : barycentric_bounds(question, true_rounded);
}

}  // namespace pcm::compare
