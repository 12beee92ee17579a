// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/contact_force.h"

#include <cmath>
#include <utility>

#include "reference/settle.h"

namespace pcm::reference {
namespace {

constexpr mpfr_prec_t kFirstPrecision = 120;
constexpr mpfr_prec_t kLastPrecision = 1280;

/// What the law needs of both bodies' layers.
template <class T>
struct Layers {
  T stiffness;    ///< c_l (12)
  T slave_share;  ///< c_slave / (c_E + c_F): how far C_k lies from the master face, in units of u_k (13)
};

template <class T>
Layers<T> layers_of(const ContactLaw& law, Side master, const LiftedPose<T>& pose) {
  if (!law.layers) return {pose.number(law.stiffness), pose.number(0.5)};
  const double c_master = master == Side::E ? law.layers->c_E : law.layers->c_F;
  const double c_slave = master == Side::E ? law.layers->c_F : law.layers->c_E;
  if (std::isinf(c_master)) return {pose.number(c_slave), pose.number(0.0)};
  if (std::isinf(c_slave)) return {pose.number(c_master), pose.number(1.0)};
  const T sum = pose.number(c_master) + pose.number(c_slave);
  return {pose.number(c_master) * pose.number(c_slave) / sum, pose.number(c_slave) / sum};
}

/// C_k = foot + share * u_k n_k (13), with u_k n_k = -q N.
template <class T>
Vec3<T> position_of(const ElementGeometry<T>& g, const T& q, const T& share) {
  return g.foot - T(share * q) * g.N;
}

/// v_k (17), seen from the master: v + w x (C_k - r) for master E, the opposite for master F.
template <class T>
Vec3<T> relative_velocity(const Velocity& velocity, const Vec3<T>& arm, Side master, const LiftedPose<T>& pose) {
  const Vec3<T> v = pose.vector(velocity.v) + cross(pose.vector(velocity.w), arm);
  return master == Side::E ? v : pose.number(-1.0) * v;
}

/// v_k - v_n n_k without any square root.
template <class T>
Vec3<T> tangential_part(const Vec3<T>& v, const Vec3<T>& N) {
  return v - T(dot(v, N) / dot(N, N)) * N;
}

/// Decisions of the law that enclosures cannot make, made with rational numbers once.
struct Decisions {
  bool exceeded = false;  ///< the greatest u is deeper than max_penetration
  bool clamped = false;   ///< u_k is
  bool slips = true;      ///< v_t > 0; unknown, so taken as true, where the penetration is clamped
};

Decisions decide(LiftedPose<Rational>& pose, const ElementSource& elements, std::size_t i, const ContactLaw& law,
                 const Velocity& velocity) {
  const bool bounded = std::isfinite(law.max_penetration);
  const bool dry = law.friction > 0 && law.slip_velocity == 0;
  Decisions decisions;
  if (!bounded && !dry) return decisions;
  const ElementGeometry<Rational> g = elements.geometry(i, pose);
  const Side master = elements.pair(i).master;
  if (bounded) {
    const Rational bound(law.max_penetration);
    const auto deeper = [&](const Rational& q) { return q * q * dot(g.N, g.N) > bound * bound; };
    decisions.exceeded = deeper(g.q_greatest);
    decisions.clamped = deeper(g.q);
  }
  if (dry && !decisions.clamped) {
    const Vec3<Rational> position = position_of(g, g.q, layers_of(law, master, pose).slave_share);
    const Vec3<Rational> arm = position - pose.vector(pose.pose().pose().r);
    const Vec3<Rational> tangential = tangential_part(relative_velocity(velocity, arm, master, pose), g.N);
    decisions.slips = dot(tangential, tangential) != 0;
  }
  return decisions;
}

/// All that is reported of an element.
struct ElementValues {
  Ball area, penetration, greatest, cosine;
  Vec3<Ball> position, force_on_E, torque_on_E;
};

/// F_t / v_t (20), friction coefficient apart: (2 - v_t / v_eps) / v_eps below v_eps, 1 / v_t above; they meet at
/// v_eps.
Ball friction_slope(const Ball& v_t, double slip_velocity, bool slips, const LiftedPose<Ball>& pose) {
  if (!slips) return pose.number(0.0);
  const Ball one = pose.number(1.0), v_eps = pose.number(slip_velocity);
  if (slip_velocity == 0) return v_t.sign() == 0 ? pose.number(0.0) : one / v_t;
  const std::optional<int> regime = (v_t - v_eps).sign();
  const Ball regularised = (pose.number(2.0) - v_t / v_eps) / v_eps;
  if (regime && *regime <= 0) return regularised;
  return regime ? one / v_t : hull(regularised, one / v_t);
}

ElementValues evaluate(const ElementGeometry<Ball>& g, Side master, const LiftedPose<Ball>& pose, const ContactLaw& law,
                       const Velocity& velocity, const Decisions& decisions) {
  const Layers<Ball> layers = layers_of(law, master, pose);
  const Ball length = sqrt(dot(g.N, g.N)), zero = pose.number(0.0);
  const Ball q = decisions.clamped ? pose.number(law.max_penetration) / length : g.q;

  const Ball A_k = g.alpha * length;                              // (6)
  const Ball u_k = q * length;                                    // (11)
  const Vec3<Ball> n_k = Ball(pose.number(-1.0) / length) * g.N;  // (7)
  const Vec3<Ball> C_k = position_of(g, q, layers.slave_share);   // (13)
  const Vec3<Ball> arm = C_k - pose.vector(pose.pose().pose().r);
  const Vec3<Ball> v_k = relative_velocity(velocity, arm, master, pose);  // (17)
  const Ball v_n = dot(n_k, v_k);                                         // (16)

  const Ball elastic = layers.stiffness * A_k * u_k;  // (14)
  const double u_d = law.transition_depth;
  const Ball fade = u_d > 0 ? min(u_k / pose.number(u_d), pose.number(1.0)) : pose.number(1.0);
  const Ball damping = pose.number(law.damping) * A_k * v_n * fade;  // (15)
  Ball F_n = elastic + (law.damping_mode == DampingMode::compression ? max(damping, zero) : damping);
  if (law.damping_mode == DampingMode::no_tension) F_n = max(F_n, zero);  // (18)

  Vec3<Ball> F_k = F_n * n_k;
  if (law.friction > 0) {
    const Vec3<Ball> tangential = tangential_part(v_k, g.N);
    const Ball v_t = sqrt(max(dot(tangential, tangential), zero));  // (19)
    const Ball slope = friction_slope(v_t, law.slip_velocity, decisions.slips, pose);
    F_k = F_k + Ball(pose.number(law.friction) * max(F_n, zero) * slope) * tangential;  // (20), (21)
  }
  const Vec3<Ball> force_on_E = master == Side::E ? F_k : pose.number(-1.0) * F_k;
  const Ball slave_length = sqrt(dot(g.slave_N, g.slave_N));
  return {A_k, u_k,        g.q_greatest * length, dot(g.N, g.slave_N) / (length * slave_length),
          C_k, force_on_E, cross(arm, force_on_E)};  // (22)
}

Ball length_of(const Vec3<Ball>& v) {
  return sqrt(dot(v, v));
}

void settle_element(const ElementValues& values, Settler& settle, Element& element) {
  settle(values.area, element.area);
  settle(values.penetration, element.penetration);
  settle(values.cosine, element.cosine);
  settle(values.position, element.position_Me);
  settle(values.force_on_E, element.force_Me);
}

void settle_totals(const std::vector<ElementValues>& elements, Mode mode, const LiftedPose<Ball>& pose, Settler& settle,
                   Answer& answer) {
  const Vec3<Ball> r = pose.vector(pose.pose().pose().r);
  Vec3<Ball> force = pose.zero(), torque = pose.zero();
  Ball force_scale = pose.number(0.0), torque_scale = force_scale, greatest = force_scale;
  for (const ElementValues& values : elements) {
    force = force + values.force_on_E;     // (23)
    torque = torque + values.torque_on_E;  // (24)
    const Ball size = length_of(values.force_on_E);
    force_scale = force_scale + size;
    torque_scale = torque_scale + length_of(values.position - r) * size;
    greatest = max(greatest, values.greatest);
  }
  const Ball factor = pose.number(mode == Mode::both ? 0.5 : 1.0);
  settle(factor * force, answer.force_Me);
  settle(factor * torque, answer.torque_Me);
  settle(factor * force_scale, answer.force_scale);
  settle(factor * torque_scale, answer.torque_scale);
  settle(greatest, answer.max_penetration);
}

}  // namespace

void report_force(const ExactPose& pose, const ElementSource& elements, const ContactLaw& law, Mode mode,
                  const Velocity& velocity, const Wanted& wanted, Answer& answer) {
  LiftedPose<Rational> rationals(pose);
  std::vector<Decisions> decisions;
  std::vector<Element> settled(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    decisions.push_back(decide(rationals, elements, i, law, velocity));
    answer.penetration_exceeded = answer.penetration_exceeded || decisions.back().exceeded;
    const ElementPair pair = elements.pair(i);
    settled[i].master = pair.master;
    settled[i].master_face = pair.master_face;
    settled[i].slave_face = pair.slave_face;
  }
  for (mpfr_prec_t precision = kFirstPrecision; precision <= kLastPrecision; precision *= 2) {
    LiftedPose<Ball> enclosures(pose, Field<Ball>{precision});
    Settler settle(2 * precision > kLastPrecision);
    std::vector<ElementValues> values;
    for (std::size_t i = 0; i < elements.size(); ++i)
      values.push_back(
          evaluate(elements.geometry(i, enclosures), elements.pair(i).master, enclosures, law, velocity, decisions[i]));
    settle_totals(values, mode, enclosures, settle, answer);
    if (wanted.elements)
      for (std::size_t i = 0; i < elements.size(); ++i) settle_element(values[i], settle, settled[i]);
    if (settle.all()) break;
  }
  if (wanted.elements) answer.elements = std::move(settled);
}

}  // namespace pcm::reference
