// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/force/contact_force.h"

#include <cmath>
#include <optional>
#include <utility>

#include "reference/force/exact_sums.h"
#include "reference/numbers/correct_rounding.h"
#include "reference/numbers/double_double.h"

namespace pcm::reference {
namespace {

/// An element's load with what only enclosures need.
template <class T>
struct EnclosedLoad {
  ElementLoad<T> load;
  T cosine;
  T tangential_velocity;
  T tangential_force;
  Vec3<T> force_on_E;
};

template <class T>
T length_of(const Vec3<T>& v) {
  return sqrt(dot(v, v));
}

/// Whether every number that totals are made of is bounded.
template <class T>
bool bounded(const ElementLoad<T>& load) {
  const auto number = [](const T& x) { return std::isfinite(x.nearby().error); };
  const auto vector = [&](const Vec3<T>& v) { return number(v[0]) && number(v[1]) && number(v[2]); };
  return number(load.greatest_penetration) && number(load.speed_squared) && vector(load.arm) && vector(load.force) &&
         vector(load.drag);
}

/// All loads enclosed in one kind of numbers, each when first asked for. Where exact numbers are given, they tell what
/// an enclosure leaves unbounded: of quotients whose divisor may be zero, and of friction where all may be at rest.
template <class T>
class EnclosedLoads {
 public:
  EnclosedLoads(const ForceQuestion& question, const Field<T>& field, ExactSums* exact = nullptr)
      : question_(question),
        field_(field),
        pose_(question.pose, field_),
        state_(state_of(question.pose.pose(), question.velocity, field_)),
        exact_(exact) {}

  const Field<T>& field() const { return field_; }
  std::size_t size() const { return question_.elements.size(); }
  const EnclosedLoad<T>& at(std::size_t i) {
    if (known_.empty()) known_.resize(size());
    if (!known_[i]) known_[i] = enclose(i);
    return *known_[i];
  }
  T perimeter(std::size_t i) { return question_.elements.perimeter(i, pose_); }

 private:
  EnclosedLoad<T> enclose(std::size_t i) {
    const ElementGeometry<T> g = question_.elements.geometry(i, pose_);
    ElementLoad<T> load = load_of(g, question_.elements.pair(i).master, question_.law, state_, field_);
    if (exact_ != nullptr && !bounded(load)) load = enclosed(exact_->load(i), field_);
    const T v_t = sqrt(load.speed_squared);
    return {load, dot(g.N, g.slave_N) / sqrt(dot(g.N, g.N) * dot(g.slave_N, g.slave_N)), v_t,
            v_t * load.friction.constant + load.speed_squared * load.friction.linear, load.force + v_t * load.drag};
  }

  ForceQuestion question_;
  Field<T> field_;
  ConvertedPose<T> pose_;
  State<T> state_;
  ExactSums* exact_;
  std::vector<std::optional<EnclosedLoad<T>>> known_;
};

/// Rounds values by their enclosures, and what these leave by exact numbers where such are given.
template <class ExactNumbers>
class BackedRounder {
 public:
  explicit BackedRounder(ExactNumbers* exact) : exact_(exact) {}

  template <class T, class Exactly>
  void operator()(const T& value, double& target, const Exactly& exactly) {
    CorrectRounder round;
    round(value, target);
    if (!round.all()) fall_back(target, exactly);
  }
  template <class T, class Exactly>
  void operator()(const Vec3<T>& value, Eigen::Vector3d& target, const Exactly& exactly) {
    for (int axis = 0; axis < 3; ++axis)
      (*this)(value[axis], target[axis], [&](ExactNumbers& exact) { return exactly(exact, axis); });
  }
  /// Whether the value exceeds the bound.
  template <class T, class Exactly>
  void exceeds(const T& value, const T& bound, bool& target, const Exactly& exactly) {
    if (const std::optional<int> sign = (value - bound).sign())
      target = *sign > 0;
    else
      fall_back(target, exactly);
  }

  bool all() const { return all_; }

 private:
  template <class Target, class Exactly>
  void fall_back(Target& target, const Exactly& exactly) {
    if (exact_ != nullptr)
      target = exactly(*exact_);
    else
      all_ = false;
  }

  ExactNumbers* exact_;
  bool all_ = true;
};

/// False where not all is rounded.
template <class T>
bool round_element(EnclosedLoads<T>& loads, std::size_t i, BackedRounder<ExactSums> round, Element& target) {
  const EnclosedLoad<T>& element = loads.at(i);
  const ElementLoad<T>& load = element.load;
  round(load.area, target.area, [i](ExactSums& exact) { return exact.area(i); });
  round(load.penetration, target.penetration, [i](ExactSums& exact) { return exact.penetration(i); });
  round(load.greatest_penetration, target.greatest_penetration,
        [i](ExactSums& exact) { return exact.greatest_penetration(i); });
  round(loads.perimeter(i), target.perimeter, [i](ExactSums& exact) { return exact.perimeter(i); });
  round(element.cosine, target.cosine, [i](ExactSums& exact) { return exact.cosine(i); });
  round(load.normal_velocity, target.normal_velocity, [i](ExactSums& exact) { return exact.normal_velocity(i); });
  round(element.tangential_velocity, target.tangential_velocity,
        [i](ExactSums& exact) { return exact.tangential_velocity(i); });
  round(load.normal_force, target.normal_force, [i](ExactSums& exact) { return exact.normal_force(i); });
  round(element.tangential_force, target.tangential_force, [i](ExactSums& exact) { return exact.tangential_force(i); });
  round(load.normal, target.normal_Me, [i](ExactSums& exact, int axis) { return exact.normal(i, axis); });
  round(load.position, target.position_Me, [i](ExactSums& exact, int axis) { return exact.position(i, axis); });
  round(element.force_on_E, target.force_Me, [i](ExactSums& exact, int axis) { return exact.force(i, axis); });
  return round.all();
}

/// The same for the totals over masters.
template <class T>
bool round_totals(const std::vector<EnclosedLoads<T>*>& masters, double share, double greatest_allowed,
                  BackedRounder<ExactTotals> round, Answer& answer) {
  const Field<T>& field = masters.front()->field();
  const T zero = field(0.0);
  Vec3<T> force{zero, zero, zero}, torque = force;
  T force_scale = zero, torque_scale = zero, greatest = zero;
  for (EnclosedLoads<T>* const master : masters)
    for (std::size_t i = 0; i < master->size(); ++i) {
      const EnclosedLoad<T>& element = master->at(i);
      force = force + element.force_on_E;                             // (23)
      torque = torque + cross(element.load.arm, element.force_on_E);  // (22), (24)
      const T size = length_of(element.force_on_E);
      force_scale = force_scale + size;
      torque_scale = torque_scale + length_of(element.load.arm) * size;
      greatest = max(greatest, element.load.greatest_penetration);
    }
  const T of_sum = field(share);
  round(of_sum * force, answer.force_Me, [](ExactTotals& exact, int axis) { return exact.force(axis); });
  round(of_sum * torque, answer.torque_Me, [](ExactTotals& exact, int axis) { return exact.torque(axis); });
  round(T(of_sum * force_scale), answer.force_scale, [](ExactTotals& exact) { return exact.force_scale(); });
  round(T(of_sum * torque_scale), answer.torque_scale, [](ExactTotals& exact) { return exact.torque_scale(); });
  round(greatest, answer.max_penetration, [](ExactTotals& exact) { return exact.greatest_penetration(); });
  if (!std::isinf(greatest_allowed))
    round.exceeds(greatest, T(field(greatest_allowed)), answer.penetration_exceeded,
                  [=](ExactTotals& exact) { return exact.greatest_exceeds(greatest_allowed); });
  return round.all();
}

}  // namespace

struct MasterLoads::Data {
  explicit Data(const ForceQuestion& asked)
      : question(asked),
        shortly(asked, Field<DoubleDouble>{}),
        exact(asked),
        finely(asked, Field<Ball>{kRoundingPrecision}, &exact) {}

  ForceQuestion question;
  EnclosedLoads<DoubleDouble> shortly;
  ExactSums exact;
  EnclosedLoads<Ball> finely;
  std::optional<std::vector<Element>> elements;
};

MasterLoads::MasterLoads(const ForceQuestion& question) : data_(std::make_unique<Data>(question)) {}

MasterLoads::~MasterLoads() = default;

std::vector<Element> MasterLoads::elements() {
  if (data_->elements) return *data_->elements;
  std::vector<Element> rounded(data_->question.elements.size());
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    const ElementPair pair = data_->question.elements.pair(i);
    rounded[i].master = pair.master;
    rounded[i].master_face = pair.master_face;
    rounded[i].slave_face = pair.slave_face;
    if (!round_element(data_->shortly, i, BackedRounder<ExactSums>(nullptr), rounded[i]))
      round_element(data_->finely, i, BackedRounder<ExactSums>(&data_->exact), rounded[i]);
  }
  data_->elements = std::move(rounded);
  return *data_->elements;
}

void report_force(const std::vector<MasterLoads*>& masters, const Wanted& wanted, Answer& answer) {
  const double share = masters.size() == 2 ? 0.5 : 1.0;
  const double greatest_allowed = masters.front()->data_->question.law.max_penetration;
  std::vector<EnclosedLoads<DoubleDouble>*> shortly;
  std::vector<EnclosedLoads<Ball>*> finely;
  std::vector<ExactSums*> exact_loads;
  for (MasterLoads* master : masters) {
    shortly.push_back(&master->data_->shortly);
    finely.push_back(&master->data_->finely);
    exact_loads.push_back(&master->data_->exact);
  }
  if (!round_totals(shortly, share, greatest_allowed, BackedRounder<ExactTotals>(nullptr), answer)) {
    ExactTotals exactly(std::move(exact_loads), share);
    round_totals(finely, share, greatest_allowed, BackedRounder<ExactTotals>(&exactly), answer);
  }
  if (!wanted.elements) return;
  for (MasterLoads* master : masters)
    for (Element& element : master->elements()) answer.elements.push_back(element);
}

}  // namespace pcm::reference
