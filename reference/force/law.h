// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "pcm/inputs.h"
#include "reference/elements/element_geometry.h"
#include "reference/pose/moved_state.h"

/// The force law (PCM section 7) in numbers of kind T: DoubleDouble or Ball, which enclose, Duals of these, or
/// Quadratic, which is exact. With L = |N| all of it lies in Q(L), but for the speed v_t, a root of such a number.
namespace pcm::reference {

/// F_t / v_t = constant + linear v_t (20).
template <class T>
struct Friction {
  T constant;
  T linear;
};

/// What the law makes of one element.
template <class T>
struct ElementLoad {
  T area;                  ///< A_k (6)
  T penetration;           ///< u_k (11), after clamping
  T greatest_penetration;  ///< before clamping
  Vec3<T> normal;          ///< n_k (7)
  Vec3<T> position;        ///< C_k (13)
  Vec3<T> arm;             ///< C_k - r
  T normal_velocity;       ///< v_n (16)
  T speed_squared;         ///< v_t^2 (19)
  T normal_force;          ///< F_n (18)
  Friction<T> friction;    ///< of which F_t (20) is made
  Vec3<T> force;           ///< the force on body E (21) is force + v_t drag
  Vec3<T> drag;
};

/// What the law needs of both bodies' layers.
template <class T>
struct Layers {
  T stiffness;    ///< c_l (12)
  T slave_share;  ///< c_slave / (c_E + c_F): how far C_k lies from the master face, in units of u_k (13)
};

template <class T>
Layers<T> layers_of(const ContactLaw& law, Side master, const Field<T>& field) {
  if (!law.layers) return {field(law.stiffness), field(0.5)};
  const double c_master = master == Side::E ? law.layers->c_E : law.layers->c_F;
  const double c_slave = master == Side::E ? law.layers->c_F : law.layers->c_E;
  if (std::isinf(c_master)) return {field(c_slave), field(0.0)};
  if (std::isinf(c_slave)) return {field(c_master), field(1.0)};
  const T sum = field(c_master) + field(c_slave);
  return {field(c_master) * field(c_slave) / sum, field(c_slave) / sum};
}

/// F_t / (mu F_n v_t) (20): (2 - v_t / v_eps) / v_eps below v_eps, 1 / v_t = v_t / v_t^2 from there on, 0 at rest.
/// Where T cannot tell, both are enclosed.
template <class T>
Friction<T> friction_slope(const T& speed_squared, double slip_velocity, const Field<T>& field) {
  const T zero = field(0.0), one = field(1.0), v_eps = field(slip_velocity);
  const Friction<T> slides{zero, speed_squared.sign() == 0 ? zero : one / speed_squared};
  if (slip_velocity == 0) return slides;
  const Friction<T> sticks{field(2.0) / v_eps, field(-1.0) / (v_eps * v_eps)};
  const T excess = speed_squared - v_eps * v_eps;
  return {where_negative(excess, sticks.constant, slides.constant),
          where_negative(excess, sticks.linear, slides.linear)};
}

template <class T>
ElementLoad<T> load_of(const ElementGeometry<T>& g, Side master, const ContactLaw& law, const State<T>& state,
                       const Field<T>& field) {
  const Layers<T> layers = layers_of(law, master, field);
  const T zero = field(0.0), one = field(1.0), minus_one = field(-1.0);
  const T NN = dot(g.N, g.N), length = sqrt(NN);
  // The clipped scheme's q is no greater: a mean of what is clamped point by point.
  const T q = std::isinf(law.max_penetration) ? g.q : min(g.q, T(field(law.max_penetration) / length));

  const T A_k = g.alpha * length;                                // (6)
  const T u_k = q * length;                                      // (11)
  const Vec3<T> n_k = T(minus_one / length) * g.N;               // (7)
  const Vec3<T> C_k = g.foot - T(layers.slave_share * q) * g.N;  // (13), u_k n_k = -q N
  const Vec3<T> arm = C_k - state.r;
  Vec3<T> v_k = state.v + cross(state.w, arm);  // (17)
  if (master == Side::F) v_k = minus_one * v_k;
  const T v_n = dot(n_k, v_k);  // (16)

  const T elastic = layers.stiffness * A_k * u_k;  // (14)
  const T fade = law.transition_depth > 0 ? min(T(u_k / field(law.transition_depth)), one) : one;
  const T damping = field(law.damping) * A_k * v_n * fade;  // (15)
  T F_n = elastic + (law.damping_mode == DampingMode::compression ? max(damping, zero) : damping);
  if (law.damping_mode == DampingMode::no_tension) F_n = max(F_n, zero);  // (18)

  const T to_E = master == Side::E ? one : minus_one;
  const Vec3<T> tangential = v_k - T(dot(v_k, g.N) / NN) * g.N;       // v_k - v_n n_k
  const T speed_squared = max(T(dot(tangential, tangential)), zero);  // (19)
  ElementLoad<T> load{A_k,
                      u_k,
                      g.q_greatest * length,
                      n_k,
                      C_k,
                      arm,
                      v_n,
                      speed_squared,
                      F_n,
                      {zero, zero},
                      T(to_E * F_n) * n_k,
                      {zero, zero, zero}};
  if (law.friction > 0) {
    const Friction<T> slope = friction_slope(speed_squared, law.slip_velocity, field);
    const T limit = field(law.friction) * max(F_n, zero);
    load.friction = {limit * slope.constant, limit * slope.linear};           // (20)
    load.force = load.force + T(to_E * load.friction.constant) * tangential;  // (21)
    load.drag = T(to_E * load.friction.linear) * tangential;
  }
  return load;
}

}  // namespace pcm::reference
