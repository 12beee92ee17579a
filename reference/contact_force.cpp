// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/contact_force.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "reference/exact_loads.h"
#include "reference/settle.h"

namespace pcm::reference {
namespace {

/// Precisions of the enclosures: enough for nearly all values, and enough for nearly all that are no ties.
constexpr std::array<mpfr_prec_t, 2> kPrecisions = {120, 240};

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

/// All loads enclosed at one precision, each when first asked for.
class EnclosedLoads {
 public:
  EnclosedLoads(const ForceQuestion& question, mpfr_prec_t precision)
      : question_(question), field_{precision}, pose_(question.pose, field_), known_(question.elements.size()) {}

  const Field<Ball>& field() const { return field_; }
  const EnclosedLoad& at(std::size_t i) {
    if (!known_[i]) known_[i] = enclose(question_, i, pose_, field_);
    return *known_[i];
  }

 private:
  ForceQuestion question_;
  Field<Ball> field_;
  LiftedPose<Ball> pose_;
  std::vector<std::optional<EnclosedLoad>> known_;
};

/// Settles values by their enclosures and, at the last precision, those that are not settled yet by exact numbers.
template <class ExactNumbers>
class LastSettler {
 public:
  LastSettler(ExactNumbers& exact, bool last) : exact_(exact), last_(last) {}

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
      (*this)(value[axis], target[axis], [&](ExactNumbers& exact) { return exactly(exact, axis); });
  }
  /// Whether the value exceeds the bound.
  template <class Exactly>
  void exceeds(const Ball& value, const Ball& bound, bool& target, const Exactly& exactly) {
    if (const std::optional<int> sign = (value - bound).sign())
      target = *sign > 0;
    else if (last_)
      target = exactly(exact_);
    else
      all_ = false;
  }

  bool all() const { return all_; }

 private:
  ExactNumbers& exact_;
  bool last_;
  bool all_ = true;
};

void settle_element(const EnclosedLoad& element, std::size_t i, LastSettler<ExactLoads>& settle, Element& target) {
  settle(element.load.area, target.area, [i](ExactLoads& exact) { return exact.area(i); });
  settle(element.load.penetration, target.penetration, [i](ExactLoads& exact) { return exact.penetration(i); });
  settle(element.cosine, target.cosine, [i](ExactLoads& exact) { return exact.cosine(i); });
  settle(element.load.position, target.position_Me,
         [i](ExactLoads& exact, int axis) { return exact.position(i, axis); });
  settle(element.force_on_E, target.force_Me, [i](ExactLoads& exact, int axis) { return exact.force(i, axis); });
}

}  // namespace

struct MasterLoads::Data {
  explicit Data(const ForceQuestion& asked)
      : question(asked),
        enclosed{EnclosedLoads(asked, kPrecisions[0]), EnclosedLoads(asked, kPrecisions[1])},
        exact(asked) {}

  ForceQuestion question;
  std::array<EnclosedLoads, kPrecisions.size()> enclosed;
  ExactLoads exact;
  std::optional<std::vector<Element>> elements;
};

MasterLoads::MasterLoads(const ForceQuestion& question) : data_(std::make_unique<Data>(question)) {}

MasterLoads::~MasterLoads() = default;

std::vector<Element> MasterLoads::elements() {
  if (data_->elements) return *data_->elements;
  std::vector<Element> settled(data_->question.elements.size());
  for (std::size_t i = 0; i < settled.size(); ++i) {
    const ElementPair pair = data_->question.elements.pair(i);
    settled[i].master = pair.master;
    settled[i].master_face = pair.master_face;
    settled[i].slave_face = pair.slave_face;
    for (std::size_t level = 0; level < kPrecisions.size(); ++level) {
      LastSettler<ExactLoads> settle(data_->exact, level + 1 == kPrecisions.size());
      settle_element(data_->enclosed[level].at(i), i, settle, settled[i]);
      if (settle.all()) break;
    }
  }
  data_->elements = std::move(settled);
  return *data_->elements;
}

void report_force(const std::vector<MasterLoads*>& masters, const Wanted& wanted, Answer& answer) {
  const double share = masters.size() == 2 ? 0.5 : 1.0;
  const double bound = masters.front()->data_->question.law.max_penetration;
  std::vector<ExactLoads*> exact_loads;
  for (MasterLoads* master : masters) exact_loads.push_back(&master->data_->exact);
  ExactTotals exactly(std::move(exact_loads), share);
  for (std::size_t level = 0; level < kPrecisions.size(); ++level) {
    const Field<Ball> field{kPrecisions[level]};
    const Ball zero = field(0.0);
    Vec3<Ball> force{zero, zero, zero}, torque = force;
    Ball force_scale = zero, torque_scale = zero, greatest = zero;
    for (MasterLoads* master : masters)
      for (std::size_t i = 0; i < master->data_->question.elements.size(); ++i) {
        const EnclosedLoad& element = master->data_->enclosed[level].at(i);
        force = force + element.force_on_E;                             // (23)
        torque = torque + cross(element.load.arm, element.force_on_E);  // (22), (24)
        const Ball size = length_of(element.force_on_E);
        force_scale = force_scale + size;
        torque_scale = torque_scale + length_of(element.load.arm) * size;
        greatest = max(greatest, element.load.greatest_penetration);
      }
    LastSettler<ExactTotals> settle(exactly, level + 1 == kPrecisions.size());
    const Ball of_sum = field(share);
    settle(of_sum * force, answer.force_Me, [](ExactTotals& exact, int axis) { return exact.force(axis); });
    settle(of_sum * torque, answer.torque_Me, [](ExactTotals& exact, int axis) { return exact.torque(axis); });
    settle(of_sum * force_scale, answer.force_scale, [](ExactTotals& exact) { return exact.force_scale(); });
    settle(of_sum * torque_scale, answer.torque_scale, [](ExactTotals& exact) { return exact.torque_scale(); });
    settle(greatest, answer.max_penetration, [](ExactTotals& exact) { return exact.greatest_penetration(); });
    if (!std::isinf(bound))
      settle.exceeds(greatest, field(bound), answer.penetration_exceeded,
                     [bound](ExactTotals& exact) { return exact.greatest_exceeds(bound); });
    if (settle.all()) break;
  }
  if (!wanted.elements) return;
  for (MasterLoads* master : masters)
    for (Element& element : master->elements()) answer.elements.push_back(element);
}

}  // namespace pcm::reference
