// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <mutex>
#include <utility>

#include "fast/base/same_bits.h"
#include "pcm/scene.h"
#include "pcm/simbody.h"

namespace pcm::simbody {
namespace {

Eigen::Vector3d to_eigen(const SimTK::Vec3& v) {
  return {v[0], v[1], v[2]};
}

SimTK::Vec3 to_simtk(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

using Answers = std::vector<PairingAnswer>;

/// Nothing but force and torque: what the equations of motion need.
constexpr Wanted kLoad{false, false, true, false, false, false};
/// Elements, for their energy.
constexpr Wanted kElements{false, false, true, true, false, false};

}  // namespace

class ContactForces::Implementation : public SimTK::Force::Custom::Implementation {
 public:
  Implementation(const SimTK::GeneralForceSubsystem& forces, const SimTK::SimbodyMatterSubsystem& matter)
      : forces_(forces), matter_(matter) {}

  // Of Simbody.
  void realizeTopology(SimTK::State& state) const override {
    cache_ = forces_.allocateLazyCacheEntry(state, SimTK::Stage::Velocity, new SimTK::Value<Answers>());
  }
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override { return elastic_energy(state); }

  Index add_surface(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BS, const fast::Surface& surface);
  Index add_pairing(Index surface_E, Index surface_F, const ContactLaw& law, Mode mode, Scheme scheme);
  const fast::Scene& scene() const { return scene_; }

  const Answers& answers(const SimTK::State& state) const;
  Pose surface_pose(const SimTK::State& state, Index surface) const;
  Pose relative_pose(const SimTK::State& state, Index pairing) const;
  Velocity relative_velocity(const SimTK::State& state, Index pairing) const;
  fast::Contact contact(const SimTK::State& state, Index pairing, const Wanted& wanted) const;
  void visit_elements(const SimTK::State& state, const Visit& visit) const;
  double elastic_energy(const SimTK::State& state) const;
  void remember(const SimTK::State& state) const;
  void forget() const;
  ContactCounters counters() const;

 private:
  struct Carrier {
    SimTK::MobilizedBodyIndex body;
    SimTK::Transform X_BS;
    fast::Surface surface;
  };
  struct Ends {
    Index E, F;
  };

  const Carrier& carrier(Index surface) const { return carriers_[static_cast<std::size_t>(surface)]; }
  const SimTK::MobilizedBody& body(Index surface) const { return matter_.getMobilizedBody(carrier(surface).body); }
  SimTK::Transform surface_in_ground(const SimTK::State& state, Index surface) const {
    return body(surface).getBodyTransform(state) * carrier(surface).X_BS;
  }
  fast::BodyState body_state(const SimTK::State& state, Index surface, bool moving) const;
  void move_scene(fast::Scene& scene, const SimTK::State& state, bool moving) const;
  PairingAnswer answer(const SimTK::State& state, Index pairing) const;
  bool is_remembered(Index pairing) const;
  bool is_unmoved() const;
  Answers compute(const SimTK::State& state) const;

  const SimTK::GeneralForceSubsystem& forces_;
  const SimTK::SimbodyMatterSubsystem& matter_;
  std::vector<Carrier> carriers_;
  std::vector<Ends> ends_;
  mutable SimTK::CacheEntryIndex cache_;

  // Scratch memory: no answer depends on what was asked before.
  mutable std::mutex asking_;
  mutable fast::Scene scene_;           ///< loads alone
  mutable fast::Scene elements_scene_;  ///< the same bodies and pairings, elements too
  mutable fast::Workspace workspace_;
  mutable std::vector<fast::BodyState> states_;
  mutable std::vector<fast::BodyState> remembered_states_;
  mutable Answers remembered_answers_;
  mutable ContactCounters counters_;
};

Index ContactForces::Implementation::add_surface(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BS,
                                                 const fast::Surface& surface) {
  const Index index = scene_.add_body(surface);
  elements_scene_.add_body(surface);
  carriers_.push_back({body.getMobilizedBodyIndex(), X_BS, surface});
  return index;
}

Index ContactForces::Implementation::add_pairing(Index surface_E, Index surface_F, const ContactLaw& law, Mode mode,
                                                 Scheme scheme) {
  const Index index = scene_.add_pairing(surface_E, surface_F, law, mode, scheme, kLoad);
  elements_scene_.add_pairing(surface_E, surface_F, law, mode, scheme, kElements);
  ends_.push_back({surface_E, surface_F});
  return index;
}

Pose ContactForces::Implementation::surface_pose(const SimTK::State& state, Index surface) const {
  const SimTK::Transform X = surface_in_ground(state, surface);
  Pose pose;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) pose.A(row, column) = X.R().asMat33()(row, column);
  pose.r = to_eigen(X.p());
  return pose;
}

fast::BodyState ContactForces::Implementation::body_state(const SimTK::State& state, Index surface, bool moving) const {
  const SimTK::MobilizedBody& carrying = body(surface);
  fast::BodyState result;
  result.pose = surface_pose(state, surface);
  if (moving) {
    result.velocity.v = to_eigen(carrying.findStationVelocityInGround(state, carrier(surface).X_BS.p()));
    result.velocity.w = to_eigen(carrying.getBodyAngularVelocity(state));
  }
  return result;
}

void ContactForces::Implementation::move_scene(fast::Scene& scene, const SimTK::State& state, bool moving) const {
  states_.clear();
  for (Index surface = 0; surface < scene_.bodies(); ++surface) states_.push_back(body_state(state, surface, moving));
  scene.move(states_);
}

PairingAnswer ContactForces::Implementation::answer(const SimTK::State& state, Index pairing) const {
  const Ends& ends = ends_[static_cast<std::size_t>(pairing)];
  const fast::Contact& contact = scene_.evaluate(pairing, workspace_);
  const SimTK::Transform X_GE = surface_in_ground(state, ends.E);
  PairingAnswer result;
  result.touching = contact.touching;
  result.nested = contact.nested;
  result.ambiguous = contact.ambiguous;
  result.penetration_exceeded = contact.penetration_exceeded;
  result.too_deep = contact.too_deep;
  result.elements = contact.element_count;
  result.max_penetration = contact.max_penetration;
  result.force_G = X_GE.R() * to_simtk(contact.force_Me);
  result.torque_G = X_GE.R() * to_simtk(contact.torque_Me);
  result.origin_of_F_G = surface_in_ground(state, ends.F).p();
  return result;
}

/// Of the two surfaces of a pairing, by their states: whether both are where they were, and moving as they did.
bool ContactForces::Implementation::is_remembered(Index pairing) const {
  if (static_cast<std::size_t>(pairing) >= remembered_answers_.size()) return false;
  const Ends& ends = ends_[static_cast<std::size_t>(pairing)];
  const auto as_before = [&](Index surface) {
    const auto i = static_cast<std::size_t>(surface);
    return fast::same_bits(states_[i].pose, remembered_states_[i].pose) &&
           fast::same_bits(states_[i].velocity, remembered_states_[i].velocity);
  };
  return as_before(ends.E) && as_before(ends.F);
}

/// Whether all surfaces are where they were at the remembered state.
bool ContactForces::Implementation::is_unmoved() const {
  const auto in_place = [](const fast::BodyState& a, const fast::BodyState& b) {
    return fast::same_bits(a.pose, b.pose);
  };
  return !remembered_states_.empty() &&
         std::equal(states_.begin(), states_.end(), remembered_states_.begin(), remembered_states_.end(), in_place);
}

Answers ContactForces::Implementation::compute(const SimTK::State& state) const {
  move_scene(scene_, state, true);
  ++counters_.states;
  counters_.unmoved += is_unmoved();
  Answers result;
  for (Index p = 0; p < scene_.pairings(); ++p) {
    const bool known = is_remembered(p);
    result.push_back(known ? remembered_answers_[static_cast<std::size_t>(p)] : answer(state, p));
    ++(known ? counters_.recalled : counters_.evaluated);
  }
  counters_.law_only += scene_.counters().work.law_only;
  return result;
}

const Answers& ContactForces::Implementation::answers(const SimTK::State& state) const {
  if (!forces_.isCacheValueRealized(state, cache_)) {
    const std::lock_guard<std::mutex> lock(asking_);
    SimTK::Value<Answers>::updDowncast(forces_.updCacheEntry(state, cache_)).upd() = compute(state);
    forces_.markCacheValueRealized(state, cache_);
  }
  return SimTK::Value<Answers>::downcast(forces_.getCacheEntry(state, cache_)).get();
}

void ContactForces::Implementation::calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                                              SimTK::Vector_<SimTK::Vec3>& /*particle_forces*/,
                                              SimTK::Vector& /*mobility_forces*/) const {
  const Answers& all = answers(state);
  for (std::size_t p = 0; p < all.size(); ++p) {
    const PairingAnswer& a = all[p];
    if (!a.touching && !a.nested) continue;
    // On each body, about its own origin.
    const auto apply = [&](Index surface, double sign) {
      const SimTK::Vec3 arm_G = a.origin_of_F_G - body(surface).getBodyOriginLocation(state);
      body_forces[carrier(surface).body] += sign * SimTK::SpatialVec(a.torque_G + arm_G % a.force_G, a.force_G);
    };
    apply(ends_[p].E, 1);
    apply(ends_[p].F, -1);
  }
}

Pose ContactForces::Implementation::relative_pose(const SimTK::State& state, Index pairing) const {
  const std::lock_guard<std::mutex> lock(asking_);
  move_scene(scene_, state, false);
  return scene_.relative_pose(pairing);
}

Velocity ContactForces::Implementation::relative_velocity(const SimTK::State& state, Index pairing) const {
  const std::lock_guard<std::mutex> lock(asking_);
  move_scene(scene_, state, true);
  return scene_.relative_velocity(pairing);
}

fast::Contact ContactForces::Implementation::contact(const SimTK::State& state, Index pairing,
                                                     const Wanted& wanted) const {
  const std::lock_guard<std::mutex> lock(asking_);
  move_scene(scene_, state, true);
  return fast::evaluate(scene_.pairing(pairing), scene_.relative_pose(pairing), scene_.relative_velocity(pairing),
                        wanted, workspace_);
}

void ContactForces::Implementation::visit_elements(const SimTK::State& state, const Visit& visit) const {
  const std::lock_guard<std::mutex> lock(asking_);
  move_scene(elements_scene_, state, true);
  for (Index p = 0; p < elements_scene_.pairings(); ++p) {
    const fast::Contact& contact = elements_scene_.evaluate(p, workspace_);
    if (!contact.touching && !contact.nested) continue;
    visit(p, elements_scene_.relative_pose(p), elements_scene_.relative_velocity(p), contact);
  }
}

double ContactForces::Implementation::elastic_energy(const SimTK::State& state) const {
  const std::lock_guard<std::mutex> lock(asking_);
  move_scene(elements_scene_, state, false);
  double sum = 0;
  for (Index p = 0; p < elements_scene_.pairings(); ++p)
    sum += simbody::elastic_energy(elements_scene_.pairing(p), elements_scene_.relative_pose(p),
                                   elements_scene_.evaluate(p, workspace_));
  return sum;
}

void ContactForces::Implementation::remember(const SimTK::State& state) const {
  {
    const std::lock_guard<std::mutex> lock(asking_);
    move_scene(scene_, state, false);
    scene_.remember_poses();
  }
  const Answers& now = answers(state);
  const std::lock_guard<std::mutex> lock(asking_);
  remembered_answers_ = now;
  move_scene(scene_, state, true);
  remembered_states_ = states_;
}

void ContactForces::Implementation::forget() const {
  const std::lock_guard<std::mutex> lock(asking_);
  remembered_answers_.clear();
  remembered_states_.clear();
}

ContactCounters ContactForces::Implementation::counters() const {
  const std::lock_guard<std::mutex> lock(asking_);
  return counters_;
}

ContactForces::ContactForces(SimTK::GeneralForceSubsystem& forces, const SimTK::SimbodyMatterSubsystem& matter)
    : SimTK::Force::Custom(forces, new Implementation(forces, matter)) {}

const ContactForces::Implementation& ContactForces::implementation() const {
  return static_cast<const Implementation&>(getImplementation());
}

ContactForces::Implementation& ContactForces::implementation() {
  return static_cast<Implementation&>(updImplementation());
}

Index ContactForces::add_surface(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BS,
                                 const fast::Surface& surface) {
  return implementation().add_surface(body, X_BS, surface);
}

Index ContactForces::add_pairing(Index surface_E, Index surface_F, const ContactLaw& law, Mode mode, Scheme scheme) {
  return implementation().add_pairing(surface_E, surface_F, law, mode, scheme);
}

Index ContactForces::surfaces() const {
  return implementation().scene().bodies();
}

Index ContactForces::pairings() const {
  return implementation().scene().pairings();
}

const fast::Pairing& ContactForces::pairing(Index pairing) const {
  return implementation().scene().pairing(pairing);
}

const std::vector<PairingAnswer>& ContactForces::answers(const SimTK::State& state) const {
  return implementation().answers(state);
}

Pose ContactForces::surface_pose(const SimTK::State& state, Index surface) const {
  return implementation().surface_pose(state, surface);
}

Pose ContactForces::relative_pose(const SimTK::State& state, Index pairing) const {
  return implementation().relative_pose(state, pairing);
}

Velocity ContactForces::relative_velocity(const SimTK::State& state, Index pairing) const {
  return implementation().relative_velocity(state, pairing);
}

fast::Contact ContactForces::contact(const SimTK::State& state, Index pairing, const Wanted& wanted) const {
  return implementation().contact(state, pairing, wanted);
}

void ContactForces::visit_elements(const SimTK::State& state, const Visit& visit) const {
  implementation().visit_elements(state, visit);
}

double ContactForces::elastic_energy(const SimTK::State& state) const {
  return implementation().elastic_energy(state);
}

void ContactForces::remember(const SimTK::State& state) const {
  implementation().remember(state);
}

void ContactForces::forget() const {
  implementation().forget();
}

ContactCounters ContactForces::counters() const {
  return implementation().counters();
}

}  // namespace pcm::simbody
