// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/contact_force.h"

#include <cmath>
#include <utility>

#include "reference/ball.h"

namespace pcm::reference {
namespace {

constexpr mpfr_prec_t kFirstPrecision = 120;
constexpr mpfr_prec_t kLastPrecision = 1280;

template <class T>
Vec3<T> lifted(const Eigen::Vector3d& v, const Field<T>& field) {
  return {field(v[0]), field(v[1]), field(v[2])};
}

/// The rational part of an element: everything that needs no unit vector.
template <class T>
struct Geometry {
  Vec3<T> N;           ///< doubled normal of the master face
  Vec3<T> slave_N;     ///< and of the slave face
  Vec3<T> barycentre;  ///< C_e (8)
  T q;                 ///< u_k = q |N| before clamping (11)
};

template <class T>
Geometry<T> geometry_of(const ExactPose& pose, const ElementPair& element, const Field<T>& field) {
  const auto p = pose.corners<T>(element.master, element.master_face, field);
  const auto f = pose.corners<T>(other(element.master), element.slave_face, field);
  Geometry<T> g{doubled_normal(p[0], p[1], p[2]), doubled_normal(f[0], f[1], f[2]),
                T(field(1.0) / field(3.0)) * (p[0] + p[1] + p[2]), field(0.0)};
  g.q = dot(g.barycentre - f[0], g.slave_N) / dot(g.N, g.slave_N);
  return g;
}

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

/// C_k = C_e + share * u_k n_k (13), with u_k n_k = -q N.
template <class T>
Vec3<T> position_of(const Geometry<T>& g, const T& q, const T& share) {
  return g.barycentre - T(share * q) * g.N;
}

/// v_k (17), seen from the master: v + w x (C_k - r) for master E, the opposite for master F.
template <class T>
Vec3<T> relative_velocity(const Velocity& velocity, const Vec3<T>& arm, Side master, const Field<T>& field) {
  const Vec3<T> v = lifted(velocity.v, field) + cross(lifted(velocity.w, field), arm);
  return master == Side::E ? v : field(-1.0) * v;
}

/// v_k - v_n n_k without any square root.
template <class T>
Vec3<T> tangential_part(const Vec3<T>& v, const Vec3<T>& N) {
  return v - T(dot(v, N) / dot(N, N)) * N;
}

/// Decisions of the law that enclosures cannot make, made with rational numbers once.
struct Decisions {
  bool exceeded = false;  ///< u_k > max_penetration
  bool slips = true;      ///< v_t > 0; unknown, so taken as true, where the penetration is clamped
};

Decisions decide(const ExactPose& pose, const ElementPair& element, const ContactLaw& law, const Velocity& velocity) {
  const Field<Rational> field;
  const bool bounded = std::isfinite(law.max_penetration);
  const bool dry = law.friction > 0 && law.slip_velocity == 0;
  Decisions decisions;
  if (!bounded && !dry) return decisions;
  const Geometry<Rational> g = geometry_of(pose, element, field);
  if (bounded) {
    const Rational bound(law.max_penetration);
    decisions.exceeded = g.q * g.q * dot(g.N, g.N) > bound * bound;
  }
  if (dry && !decisions.exceeded) {
    const Vec3<Rational> position = position_of(g, g.q, layers_of(law, element.master, field).slave_share);
    const Vec3<Rational> v =
        relative_velocity(velocity, position - lifted(pose.pose().r, field), element.master, field);
    const Vec3<Rational> tangential = tangential_part(v, g.N);
    decisions.slips = dot(tangential, tangential) != 0;
  }
  return decisions;
}

/// All that is reported of an element.
struct ElementValues {
  Ball area, penetration, unclamped, cosine;
  Vec3<Ball> position, force_on_E, torque_on_E;
};

/// F_t / v_t (20), friction coefficient apart: (2 - v_t / v_eps) / v_eps below v_eps, 1 / v_t above; they meet at
/// v_eps.
Ball friction_slope(const Ball& v_t, double slip_velocity, bool slips, const Field<Ball>& field) {
  if (!slips) return field(0.0);
  const Ball one = field(1.0), v_eps = field(slip_velocity);
  if (slip_velocity == 0) return v_t.sign() == 0 ? field(0.0) : one / v_t;
  const std::optional<int> regime = (v_t - v_eps).sign();
  const Ball regularised = (field(2.0) - v_t / v_eps) / v_eps;
  if (regime && *regime <= 0) return regularised;
  return regime ? one / v_t : hull(regularised, one / v_t);
}

ElementValues evaluate(const ExactPose& pose, const ElementPair& element, const ContactLaw& law,
                       const Velocity& velocity, const Decisions& decisions, const Field<Ball>& field) {
  const Geometry<Ball> g = geometry_of(pose, element, field);
  const Layers<Ball> layers = layers_of(law, element.master, field);
  const Ball length = sqrt(dot(g.N, g.N)), zero = field(0.0);
  const Ball q = decisions.exceeded ? field(law.max_penetration) / length : g.q;

  const Ball A_k = length / field(2.0);                          // (6)
  const Ball u_k = q * length;                                   // (11)
  const Vec3<Ball> n_k = Ball(field(-1.0) / length) * g.N;       // (7)
  const Vec3<Ball> C_k = position_of(g, q, layers.slave_share);  // (13)
  const Vec3<Ball> arm = C_k - lifted(pose.pose().r, field);
  const Vec3<Ball> v_k = relative_velocity(velocity, arm, element.master, field);  // (17)
  const Ball v_n = dot(n_k, v_k);                                                  // (16)

  const Ball elastic = layers.stiffness * A_k * u_k;  // (14)
  const double u_d = law.transition_depth;
  const Ball fade = u_d > 0 ? min(u_k / field(u_d), field(1.0)) : field(1.0);
  const Ball damping = field(law.damping) * A_k * v_n * fade;  // (15)
  Ball F_n = elastic + (law.damping_mode == DampingMode::compression ? max(damping, zero) : damping);
  if (law.damping_mode == DampingMode::no_tension) F_n = max(F_n, zero);  // (18)

  Vec3<Ball> F_k = F_n * n_k;
  if (law.friction > 0) {
    const Vec3<Ball> tangential = tangential_part(v_k, g.N);
    const Ball v_t = sqrt(max(dot(tangential, tangential), zero));  // (19)
    const Ball slope = friction_slope(v_t, law.slip_velocity, decisions.slips, field);
    F_k = F_k + Ball(field(law.friction) * max(F_n, zero) * slope) * tangential;  // (20), (21)
  }
  const Vec3<Ball> force_on_E = element.master == Side::E ? F_k : field(-1.0) * F_k;
  const Ball slave_length = sqrt(dot(g.slave_N, g.slave_N));
  return {A_k, u_k,        g.q * length,          dot(g.N, g.slave_N) / (length * slave_length),
          C_k, force_on_E, cross(arm, force_on_E)};  // (22)
}

Ball length_of(const Vec3<Ball>& v) {
  return sqrt(dot(v, v));
}

bool settle(const Ball& value, bool last, double& target) {
  const std::optional<double> rounded = value.rounded();
  if (rounded)
    target = *rounded;
  else if (last)
    target = value.middle();
  return rounded.has_value();
}

bool settle(const Vec3<Ball>& value, bool last, Eigen::Vector3d& target) {
  bool all = true;
  for (int i = 0; i < 3; ++i) all = settle(value[i], last, target[i]) && all;
  return all;
}

/// True once every number of the element is settled.
bool settle(const ElementValues& values, bool last, Element& element) {
  return settle(values.area, last, element.area) & settle(values.penetration, last, element.penetration) &
         settle(values.cosine, last, element.cosine) & settle(values.position, last, element.position_Me) &
         settle(values.force_on_E, last, element.force_Me);
}

bool settle_totals(const std::vector<ElementValues>& elements, const Vec3<Ball>& r, Mode mode, const Field<Ball>& field,
                   bool last, Answer& answer) {
  const Ball zero = field(0.0);
  Vec3<Ball> force{zero, zero, zero}, torque{zero, zero, zero};  // (23), (24)
  Ball force_scale = zero, torque_scale = zero, greatest = zero;
  for (const ElementValues& values : elements) {
    force = force + values.force_on_E;
    torque = torque + values.torque_on_E;
    const Ball size = length_of(values.force_on_E);
    force_scale = force_scale + size;
    torque_scale = torque_scale + length_of(values.position - r) * size;
    greatest = max(greatest, values.unclamped);
  }
  const Ball factor = field(mode == Mode::both ? 0.5 : 1.0);
  return settle(factor * force, last, answer.force_Me) & settle(factor * torque, last, answer.torque_Me) &
         settle(factor * force_scale, last, answer.force_scale) &
         settle(factor * torque_scale, last, answer.torque_scale) & settle(greatest, last, answer.max_penetration);
}

}  // namespace

void report_force(const ExactPose& pose, const std::vector<ElementPair>& elements, const ContactLaw& law, Mode mode,
                  const Velocity& velocity, const Wanted& wanted, Answer& answer) {
  std::vector<Decisions> decisions;
  for (const ElementPair& element : elements) {
    decisions.push_back(decide(pose, element, law, velocity));
    answer.penetration_exceeded = answer.penetration_exceeded || decisions.back().exceeded;
  }
  std::vector<Element> settled(elements.size());
  bool all = false;
  for (mpfr_prec_t precision = kFirstPrecision; !all && precision <= kLastPrecision; precision *= 2) {
    const Field<Ball> field{precision};
    const bool last = 2 * precision > kLastPrecision;
    std::vector<ElementValues> values;
    for (std::size_t i = 0; i < elements.size(); ++i)
      values.push_back(evaluate(pose, elements[i], law, velocity, decisions[i], field));
    all = settle_totals(values, lifted(pose.pose().r, field), mode, field, last, answer);
    if (!wanted.elements) continue;
    for (std::size_t i = 0; i < elements.size(); ++i) all = settle(values[i], last, settled[i]) && all;
  }
  if (!wanted.elements) return;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    settled[i].master = elements[i].master;
    settled[i].master_face = elements[i].master_face;
    settled[i].slave_face = elements[i].slave_face;
  }
  answer.elements = std::move(settled);
}

}  // namespace pcm::reference
