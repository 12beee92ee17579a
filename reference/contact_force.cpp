// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/contact_force.h"

#include <cmath>
#include <utility>
#include <vector>

#include "reference/exact_loads.h"
#include "reference/settle.h"

namespace pcm::reference {
namespace {

/// Precisions of the enclosures: enough for nearly all values, and enough for nearly all that are no ties.
constexpr mpfr_prec_t kFirstPrecision = 120;
constexpr mpfr_prec_t kLastPrecision = 240;

/// An element's load with what only enclosures need.
struct EnclosedLoad {
  ElementLoad<Ball> load;
  Ball cosine;
  Vec3<Ball> force_on_E;
};

EnclosedLoad enclose(const ForceQuestion& question, std::size_t i, LiftedPose<Ball>& pose, const Field<Ball>& field) {
  const ElementGeometry<Ball> g = question.elements.geometry(i, pose);
  const ElementLoad<Ball> load =
      load_of(g, question.elements.pair(i).master, question.law, question.pose.pose(), question.velocity, field);
  return {load, dot(g.N, g.slave_N) / sqrt(dot(g.N, g.N) * dot(g.slave_N, g.slave_N)),
          load.force + sqrt(load.speed_squared) * load.drag};
}

Ball length_of(const Vec3<Ball>& v) {
  return sqrt(dot(v, v));
}

/// Settles values by their enclosures and, at the last precision, those that are not settled yet by exact loads.
class LastSettler {
 public:
  LastSettler(ExactLoads& exact, bool last) : exact_(exact), last_(last) {}

  template <class Exactly>
  void operator()(const Ball& value, double& target, const Exactly& exactly) {
    Settler settle;
    settle(value, target);
    if (settle.all()) return;
    if (last_)
      target = exactly(exact_);
    else
      all_ = false;
  }
  template <class Exactly>
  void operator()(const Vec3<Ball>& value, Eigen::Vector3d& target, const Exactly& exactly) {
    for (int axis = 0; axis < 3; ++axis)
      (*this)(value[axis], target[axis], [&](ExactLoads& exact) { return exactly(exact, axis); });
  }

  void greatest_exceeds(const Ball& greatest, double bound, const Field<Ball>& field, bool& target) {
    if (std::isinf(bound)) return;
    if (const std::optional<int> sign = (greatest - field(bound)).sign())
      target = *sign > 0;
    else if (last_)
      target = exact_.greatest_exceeds(bound);
    else
      all_ = false;
  }

  bool all() const { return all_; }

 private:
  ExactLoads& exact_;
  bool last_;
  bool all_ = true;
};

void settle_element(const EnclosedLoad& element, std::size_t i, LastSettler& settle, Element& target) {
  settle(element.load.area, target.area, [i](ExactLoads& exact) { return exact.area(i); });
  settle(element.load.penetration, target.penetration, [i](ExactLoads& exact) { return exact.penetration(i); });
  settle(element.cosine, target.cosine, [i](ExactLoads& exact) { return exact.cosine(i); });
  settle(element.load.position, target.position_Me,
         [i](ExactLoads& exact, int axis) { return exact.position(i, axis); });
  settle(element.force_on_E, target.force_Me, [i](ExactLoads& exact, int axis) { return exact.force(i, axis); });
}

void settle_totals(const std::vector<EnclosedLoad>& elements, const ForceQuestion& question, const Field<Ball>& field,
                   LastSettler& settle, Answer& answer) {
  const Ball zero = field(0.0);
  Vec3<Ball> force{zero, zero, zero}, torque = force;
  Ball force_scale = zero, torque_scale = zero, greatest = zero;
  for (const EnclosedLoad& element : elements) {
    force = force + element.force_on_E;                             // (23)
    torque = torque + cross(element.load.arm, element.force_on_E);  // (22), (24)
    const Ball size = length_of(element.force_on_E);
    force_scale = force_scale + size;
    torque_scale = torque_scale + length_of(element.load.arm) * size;
    greatest = max(greatest, element.load.greatest_penetration);
  }
  const Ball share = field(question.share());
  settle(share * force, answer.force_Me, [](ExactLoads& exact, int axis) { return exact.total_force(axis); });
  settle(share * torque, answer.torque_Me, [](ExactLoads& exact, int axis) { return exact.total_torque(axis); });
  settle(share * force_scale, answer.force_scale, [](ExactLoads& exact) { return exact.force_scale(); });
  settle(share * torque_scale, answer.torque_scale, [](ExactLoads& exact) { return exact.torque_scale(); });
  settle(greatest, answer.max_penetration, [](ExactLoads& exact) { return exact.greatest_penetration(); });
  settle.greatest_exceeds(greatest, question.law.max_penetration, field, answer.penetration_exceeded);
}

}  // namespace

void report_force(const ForceQuestion& question, const Wanted& wanted, Answer& answer) {
  std::vector<Element> settled(question.elements.size());
  for (std::size_t i = 0; i < settled.size(); ++i) {
    const ElementPair pair = question.elements.pair(i);
    settled[i].master = pair.master;
    settled[i].master_face = pair.master_face;
    settled[i].slave_face = pair.slave_face;
  }
  ExactLoads exact(question);
  for (const mpfr_prec_t precision : {kFirstPrecision, kLastPrecision}) {
    const Field<Ball> field{precision};
    LiftedPose<Ball> pose(question.pose, field);
    LastSettler settle(exact, precision == kLastPrecision);
    std::vector<EnclosedLoad> loads;
    for (std::size_t i = 0; i < settled.size(); ++i) loads.push_back(enclose(question, i, pose, field));
    settle_totals(loads, question, field, settle, answer);
    if (wanted.elements)
      for (std::size_t i = 0; i < settled.size(); ++i) settle_element(loads[i], i, settle, settled[i]);
    if (settle.all()) break;
  }
  if (wanted.elements) answer.elements = std::move(settled);
}

}  // namespace pcm::reference
