// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/tangent_bounds.h"

#include <array>
#include <cstddef>

#include "compare/verify/bounds/element_law.h"
#include "compare/verify/bounds/rounded_faces.h"
#include "compare/verify/bounds/rounding_bounds.h"
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

/// A state's change, in twelve coordinates.
constexpr std::size_t kCoordinates = 12;

/// One master's element and how it moves with one coordinate: every quantity of PCM section 7 with its derivative.
class ElementMotion {
 public:
  ElementMotion(const Question& question, const RoundedFaces& faces, const reference::Element& e,
                const ElementBounds& bounds)
      : question_(question),
        on_E_(e.master == Side::E),
        n_(as_direction(within(e.normal_Me, bounds.normal))),
        depth_(e.penetration, bounds.penetration),
        lever_(within(e.position_Me, bounds.position) - exactly(question.pose.r)),
        v_n_(e.normal_velocity, bounds.normal_velocity),
        v_t_(e.tangential_velocity, bounds.tangential_velocity),
        force_(within(e.force_Me, bounds.force)),
        shift_(share_of_penetration(question.law, e.master)),
        slopes_(law_slopes(question.law, Number(e.area, bounds.area), depth_, v_n_, v_t_)) {
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
    met_ = foot + depth_ * n_ - exactly(question.pose.r);
    const Vector v_F = exactly(question.velocity.v) + cross(exactly(question.velocity.w), lever_);
    const Vector v_k = on_E_ ? v_F : Number(-1) * v_F;
    slip_direction_ = v_t_.is_zero() ? Vector{} : as_direction(direction_of(v_k - v_n_ * n_));
  }

  struct Slope {
    Vector force, torque;
  };

  /// By coordinate number k: of r, a turn about Mf, v, w.
  Slope by(std::size_t k) const {
    const Vector along = exactly(Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k % 3)));
    const Vector none{}, dr = k / 3 == 0 ? along : none, turn = k / 3 == 1 ? along : none;
    const Vector w = exactly(question_.velocity.w);
    Vector dv = k / 3 == 2 ? along : none, dw = k / 3 == 3 ? along : none;
    // The slave seen from the master, or the master from the slave: either way the gap closes by this.
    const Number closing = dot(gradient_, dr + cross(turn, met_));
    const Number d_depth = on_E_ ? closing : -closing;
    const Vector d_position = (Number(shift_, 4 * kRoundoff) * d_depth) * n_;  // as the master sees it
    if (on_E_) {
      dv = dv - cross(w, dr);
    } else {
      dv = dv - cross(turn, exactly(question_.velocity.v));
      dw = dw - cross(turn, w);
    }
    const Vector dv_F = dv + cross(dw, lever_) + cross(w, d_position);
    const Vector on_master = d_force_on_master(d_depth, on_E_ ? dv_F : Number(-1) * dv_F);
    Slope slope;
    slope.force = on_E_ ? on_master : Number(-1) * on_master;
    slope.torque = cross(d_position, force_) + cross(lever_, slope.force);
    if (on_E_) {
      slope.torque = slope.torque - cross(dr, force_);
    } else {
      slope.force = slope.force + cross(turn, force_);
      slope.torque = slope.torque + cross(turn, cross(lever_, force_));
    }
    return slope;
  }

 private:
  Vector direction_of(const Vector& slip) const { return {slip.x / v_t_, slip.y / v_t_, slip.z / v_t_}; }

  /// (21), with the derivative of v_k.
  Vector d_force_on_master(const Number& d_depth, const Vector& dv_k) const {
    const Vector& t = slip_direction_;
    const Number dv_n = dot(n_, dv_k), dv_t = dot(t, dv_k);
    const Number d_normal = slopes_.normal_by_depth * d_depth + slopes_.normal_by_approach * dv_n;
    const Number d_tangential = slopes_.tangential_by_depth * d_depth + slopes_.tangential_by_approach * dv_n +
                                (slopes_.tangential_by_slip - slopes_.tangential_over_slip) * dv_t;
    return d_normal * n_ + d_tangential * t + slopes_.tangential_over_slip * (dv_k - dv_n * n_);
  }

  const Question& question_;
  bool on_E_;
  Vector n_;
  Number depth_;
  Vector lever_;
  Number v_n_, v_t_;
  Vector force_;  ///< on E
  double shift_;
  LawSlopes slopes_;
  Vector gradient_, met_, slip_direction_;
};

}  // namespace

fast::Tangent tangent_bounds(const Question& question, const reference::Answer& true_rounded) {
  const RoundedFaces faces(question);
  const ForceBounds bounds = RoundingBounds(question, true_rounded).force();
  std::array<ElementMotion::Slope, kCoordinates> sums;
  for (std::size_t i = 0; i < true_rounded.elements.size(); ++i) {
    const ElementMotion element(question, faces, true_rounded.elements[i], bounds.elements[i]);
    for (std::size_t k = 0; k < kCoordinates; ++k) {
      const ElementMotion::Slope slope = element.by(k);
      sums[k].force = sums[k].force + slope.force;
      sums[k].torque = sums[k].torque + slope.torque;
    }
  }
  // Both sides are within the error of one number.
  const double share = question.mode == Mode::both ? 1 : 2;
  fast::Tangent result;
  for (std::size_t k = 0; k < kCoordinates; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      result(axis, static_cast<Eigen::Index>(k)) = share * sums[k].force[axis].error;
      result(3 + axis, static_cast<Eigen::Index>(k)) = share * sums[k].torque[axis].error;
    }
  return result;
}

}  // namespace pcm::compare
