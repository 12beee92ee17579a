// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <mutex>
#include <string>
#include <utility>

#include "fast/base/same_bits.h"
#include "pcm/bad_input.h"
#include "pcm/scene.h"
#include "pcm/simbody.h"
#include "simbody/load_of_contact.h"
#include "simbody/placed_surfaces.h"

namespace pcm::simbody {
namespace {

using Answers = std::vector<PairingAnswer>;
/// What a State may hold; empty: the forces are the engine's.
using KeptTangents = std::shared_ptr<const ContactTangents>;

/// Elements, for their energy.
constexpr Wanted kElements{false, false, true, true, false, false};

}  // namespace

class ContactForces::Implementation : public SimTK::Force::Custom::Implementation {
 public:
  Implementation(const SimTK::GeneralForceSubsystem& forces, const SimTK::SimbodyMatterSubsystem& matter)
      : forces_(forces), surfaces_(matter) {}

  // Of Simbody.
  void realizeTopology(SimTK::State& state) const override {
    cache_ = forces_.allocateLazyCacheEntry(state, SimTK::Stage::Velocity, new SimTK::Value<Answers>());
    tangents_ = forces_.allocateDiscreteVariable(state, SimTK::Stage::Dynamics, new SimTK::Value<KeptTangents>());
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
  ContactTangents tangents(const SimTK::State& state) const;
  void linearise(SimTK::State& state, KeptTangents tangents) const;
  ContactCounters counters() const;

 private:
  struct Ends {
    Index E, F;
  };

  void move_scene(fast::Scene& scene, const SimTK::State& state, bool moving) const;
  const Ends& ends(Index pairing) const { return ends_[static_cast<std::size_t>(pairing)]; }
  PairingAnswer answer(const SimTK::State& state, Index pairing) const;
  bool is_remembered(Index pairing) const;
  bool is_unmoved() const;
  Answers compute(const SimTK::State& state) const;
  Answers by_tangents(const SimTK::State& state, const ContactTangents& tangents) const;
  void add_loads(const SimTK::State& state, const Answers& all, SimTK::Vector_<SimTK::SpatialVec>& body_forces) const;
  void set_load(const SimTK::State& state, Index pairing, const Load& load_Me, PairingAnswer& answer) const;

  const SimTK::GeneralForceSubsystem& forces_;
  PlacedSurfaces surfaces_;
  std::vector<Ends> ends_;
  mutable SimTK::CacheEntryIndex cache_;
  mutable SimTK::DiscreteVariableIndex tangents_;

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
  if (!surfaces_.matter().isSameSubsystem(body.getMatterSubsystem()))
    throw BadInput("contact forces: the body is of another matter subsystem than the one they were made with");
  forces_.invalidateSubsystemTopologyCache();
  const Index index = scene_.add_body(surface);
  elements_scene_.add_body(surface);
  surfaces_.add(body, X_BS);
  return index;
}

Index ContactForces::Implementation::add_pairing(Index surface_E, Index surface_F, const ContactLaw& law, Mode mode,
                                                 Scheme scheme) {
  const Index index = scene_.add_pairing(surface_E, surface_F, law, mode, scheme, kLoadAlone);
  forces_.invalidateSubsystemTopologyCache();
  elements_scene_.add_pairing(surface_E, surface_F, law, mode, scheme, kElements);
  ends_.push_back({surface_E, surface_F});
  return index;
}

void ContactForces::Implementation::move_scene(fast::Scene& scene, const SimTK::State& state, bool moving) const {
  surfaces_.body_states(state, moving, states_);
  scene.move(states_);
}

/// Turned with E's frame from Me into Ground, about where Mf is now.
void ContactForces::Implementation::set_load(const SimTK::State& state, Index pairing, const Load& load_Me,
                                             PairingAnswer& answer) const {
  const SimTK::Rotation R_GE = surfaces_.in_ground(state, ends(pairing).E).R();
  answer.force_G = R_GE * to_simtk(load_Me.head<3>());
  answer.torque_G = R_GE * to_simtk(load_Me.tail<3>());
  answer.origin_of_F_G = surfaces_.in_ground(state, ends(pairing).F).p();
}

PairingAnswer ContactForces::Implementation::answer(const SimTK::State& state, Index pairing) const {
  const fast::Contact& contact = scene_.evaluate(pairing, workspace_);
  PairingAnswer result;
  result.touching = contact.touching;
  result.nested = contact.nested;
  result.ambiguous = contact.ambiguous;
  result.penetration_exceeded = contact.penetration_exceeded;
  result.too_deep = contact.too_deep;
  result.elements = contact.element_count;
  result.max_penetration = contact.max_penetration;
  set_load(state, pairing, load_of(contact), result);
  return result;
}

/// Of the two surfaces of a pairing, by their states: whether both are where they were, and moving as they did.
bool ContactForces::Implementation::is_remembered(Index pairing) const {
  if (static_cast<std::size_t>(pairing) >= remembered_answers_.size()) return false;
  const auto as_before = [&](Index surface) {
    const auto i = static_cast<std::size_t>(surface);
    return fast::same_bits(states_[i].pose, remembered_states_[i].pose) &&
           fast::same_bits(states_[i].velocity, remembered_states_[i].velocity);
  };
  return as_before(ends(pairing).E) && as_before(ends(pairing).F);
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

Answers ContactForces::Implementation::by_tangents(const SimTK::State& state, const ContactTangents& tangents) const {
  const std::lock_guard<std::mutex> lock(asking_);
  move_scene(scene_, state, true);
  Answers result(tangents.pairings.size());
  for (Index p = 0; p < scene_.pairings(); ++p) {
    const std::optional<LoadTangent>& tangent = tangents.pairings[static_cast<std::size_t>(p)];
    if (!tangent) continue;
    PairingAnswer& answer = result[static_cast<std::size_t>(p)];
    answer.touching = true;
    set_load(state, p, tangent->at(scene_.relative_pose(p), scene_.relative_velocity(p)), answer);
  }
  return result;
}

void ContactForces::Implementation::calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                                              SimTK::Vector_<SimTK::Vec3>& /*particle_forces*/,
                                              SimTK::Vector& /*mobility_forces*/) const {
  const auto& tangents = SimTK::Value<KeptTangents>::downcast(forces_.getDiscreteVariable(state, tangents_)).get();
  if (tangents) {
    add_loads(state, by_tangents(state, *tangents), body_forces);
  } else {
    add_loads(state, answers(state), body_forces);
  }
}

void ContactForces::Implementation::add_loads(const SimTK::State& state, const Answers& all,
                                              SimTK::Vector_<SimTK::SpatialVec>& body_forces) const {
  for (Index p = 0; p < scene_.pairings(); ++p) {
    const PairingAnswer& a = all[static_cast<std::size_t>(p)];
    if (!a.touching && !a.nested) continue;
    // On each body, about its own origin.
    const auto apply = [&](Index surface, double sign) {
      const SimTK::Vec3 arm_G = a.origin_of_F_G - surfaces_.body(surface).getBodyOriginLocation(state);
      body_forces[surfaces_.body_index(surface)] += sign * SimTK::SpatialVec(a.torque_G + arm_G % a.force_G, a.force_G);
    };
    apply(ends(p).E, 1);
    apply(ends(p).F, -1);
  }
}

Pose ContactForces::Implementation::surface_pose(const SimTK::State& state, Index surface) const {
  if (surface < 0 || surface >= scene_.bodies())
    throw BadInput("contact forces: there is no surface " + std::to_string(surface) + ", they have " +
                   std::to_string(scene_.bodies()));
  return surfaces_.pose(state, surface);
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

ContactTangents ContactForces::Implementation::tangents(const SimTK::State& state) const {
  const Answers& here = answers(state);
  const std::lock_guard<std::mutex> lock(asking_);
  move_scene(scene_, state, true);
  ContactTangents result;
  for (Index p = 0; p < scene_.pairings(); ++p) {
    const PairingAnswer& at_p = here[static_cast<std::size_t>(p)];
    result.complete = !at_p.nested && !at_p.penetration_exceeded;
    if (!result.complete) return result;
    result.pairings.emplace_back();
    if (!at_p.touching) continue;
    result.pairings.back() =
        load_tangent(scene_.pairing(p), scene_.relative_pose(p), scene_.relative_velocity(p), workspace_);
    ++counters_.evaluated;
  }
  return result;
}

void ContactForces::Implementation::linearise(SimTK::State& state, KeptTangents tangents) const {
  if (tangents && tangents->pairings.size() != static_cast<std::size_t>(scene_.pairings()))
    throw BadInput("contact forces: tangents of " + std::to_string(tangents->pairings.size()) + " pairings for " +
                   std::to_string(scene_.pairings()));
  SimTK::Value<KeptTangents>::updDowncast(forces_.updDiscreteVariable(state, tangents_)).upd() = std::move(tangents);
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

bool ContactTangents::any() const {
  return std::any_of(pairings.begin(), pairings.end(), [](const auto& tangent) { return tangent.has_value(); });
}

ContactTangents ContactForces::tangents(const SimTK::State& state) const {
  return implementation().tangents(state);
}

void ContactForces::linearise(SimTK::State& state, std::shared_ptr<const ContactTangents> tangents) const {
  implementation().linearise(state, std::move(tangents));
}

ContactCounters ContactForces::counters() const {
  return implementation().counters();
}

}  // namespace pcm::simbody
