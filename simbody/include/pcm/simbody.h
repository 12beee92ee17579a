// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Simbody.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "pcm/contact.h"
#include "pcm/engine.h"
#include "pcm/inputs.h"
#include "pcm/load_tangent.h"

/// Contact between triangle meshes as a force element of Simbody (3.7): surfaces on mobilized bodies, pairings among
/// them.
///
///     pcm::simbody::ContactForces contact(forces, matter);
///     const auto plate = contact.add_surface(matter.Ground(), SimTK::Transform(), plate_surface);
///     const auto ball = contact.add_surface(ball_body, SimTK::Transform(), ball_surface);
///     contact.add_pairing(plate, ball, law);
///
/// Frames: G is Ground, B a mobilized body, S a surface's own frame, in which its vertices are given.
namespace pcm::simbody {

/// What one pairing does at a state.
struct PairingAnswer {
  bool touching = false;
  bool nested = false;     ///< a part of one lies in the other uncrossed: no force, unless open or about a cavity
  bool ambiguous = false;  ///< an open surface labels faces both ways
  /// The depth exceeds max_penetration of the law: depths are clamped, and the elastic energy is too small.
  bool penetration_exceeded = false;
  Index too_deep = 0;                          ///< faces without a force: the body is thinner there than the depth
  Index elements = 0;                          ///< contact elements
  double max_penetration = 0;                  ///< m
  SimTK::Vec3 force_G = SimTK::Vec3(0);        ///< on the body of E, N
  SimTK::Vec3 torque_G = SimTK::Vec3(0);       ///< on the body of E about the origin of F's surface, N m
  SimTK::Vec3 origin_of_F_G = SimTK::Vec3(0);  ///< that origin, m
};

/// The sum over the contact's elements of the integral of c_l u^2 / 2 over the element, J; in mode `both` half of it.
///
/// Barycentric scheme: u is u_k all over the face. Clipped scheme: u is linear over an element, and the element's
/// position gives the centroid x of u, so that the integral of u^2 is that of u, A_k u_k, times u(x): for linear u =
/// a + g . x, it is a (integral of u) + g . (integral of u x) = (a + g . x_u) (integral of u). Where any
/// depth of the contact is clamped (`penetration_exceeded`), A_k u_k^2 stands for every element, which is no more
/// (Cauchy-Schwarz) than the integral of the clamped depth's square: as the first point passes max_penetration, the
/// energy falls by a finite amount.
///
/// `contact` is the pairing's at `pose`, with its elements.
double elastic_energy(const fast::Pairing& pairing, const Pose& pose, const fast::Contact& contact);

/// The elastic share of an element's normal force, F_c = c_l A_k u_k (14), N.
double elastic_force(const fast::Pairing& pairing, const fast::Element& element);

/// How pairings were answered so far, over all states.
struct ContactCounters {
  std::int64_t states = 0;     ///< at which forces were computed
  std::int64_t evaluated = 0;  ///< pairings asked of the engine (which may find their boxes apart)
  std::int64_t recalled = 0;   ///< pairings whose answer was that of the remembered state, see `remember`
  std::int64_t law_only = 0;   ///< of those asked: where the remembered pose was known, by the law alone
  /// Of the states: every surface was where it was at the remembered one, and at most velocities differed.
  std::int64_t unmoved = 0;
};

/// The loads of all pairings to first order about one state.
struct ContactTangents {
  /// Of each pairing; none where it does not touch there, which then has no load wherever it moves.
  std::vector<std::optional<LoadTangent>> pairings;
  /// False where a pairing is nested or deeper than max_penetration of its law.
  bool complete = true;
  bool any() const;  ///< a pairing touches, so that the engine was asked
};

/// Contact forces among any number of surfaces. Like every Simbody force it belongs to the subsystem that it is added
/// to; this object is a handle, and copies mean the same forces.
///
/// Forces are a function of the State alone, bit for bit: the order in which states are asked does not matter. A State
/// may hold tangents (`linearise`), and its forces are theirs. Several threads may ask about different States; they
/// wait for one another.
class ContactForces : public SimTK::Force::Custom {
 public:
  /// `forces` and `matter`, these very objects and not only what they are handles of, must outlive the last use of
  /// these contact forces.
  ContactForces(SimTK::GeneralForceSubsystem& forces, const SimTK::SimbodyMatterSubsystem& matter);

  /// A surface fixed on a body; both are numbered from 0 in the order they are added. A surface may be on many bodies.
  /// As of every change of a Simbody model, States made before it are of no use: realizeTopology gives a new one.
  /// Throws BadInput where the body is of another matter subsystem.
  Index add_surface(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BS, const fast::Surface& surface);
  /// States made before it are of no use, as above. Throws BadInput where there is no such surface, both are the same,
  /// or a parameter of the law is out of its range; then nothing has changed.
  Index add_pairing(Index surface_E, Index surface_F, const ContactLaw& law = {}, Mode mode = Mode::E,
                    Scheme scheme = Scheme::barycentric);

  Index surfaces() const;
  Index pairings() const;
  // Here and below a pairing or surface that there is not throws BadInput.
  /// The reference lives until the next `add_pairing`.
  const fast::Pairing& pairing(Index pairing) const;

  /// Of every pairing, in their order, by the engine. `state` must be realized to Stage::Velocity, as everywhere below.
  /// Computed once for each state. Throws BadInput, as fast::Scene::move and fast::evaluate do, where the state is out
  /// of all bounds.
  const std::vector<PairingAnswer>& answers(const SimTK::State& state) const;

  /// Where a surface is in Ground; Stage::Position is enough.
  Pose surface_pose(const SimTK::State& state, Index surface) const;
  /// Where F's surface is, seen from E's, and how it moves: what the engine is asked about.
  Pose relative_pose(const SimTK::State& state, Index pairing) const;
  Velocity relative_velocity(const SimTK::State& state, Index pairing) const;
  /// All that the engine knows of one pairing there, elements and polygons if wanted.
  fast::Contact contact(const SimTK::State& state, Index pairing, const Wanted& wanted = {}) const;
  /// Called with the pairings that touch or are nested, in their order, and their elements. Neither may be kept, and
  /// these contact forces must not be asked anything before it returns: it is called under their lock.
  using Visit =
      std::function<void(Index pairing, const Pose& pose, const Velocity& velocity, const fast::Contact& contact)>;
  void visit_elements(const SimTK::State& state, const Visit& visit) const;

  /// Of all pairings, J; Stage::Position is enough. Simbody counts it as potential energy. In the strict sense it is no
  /// potential of the force: docs/energy_and_jumps.md.
  double elastic_energy(const SimTK::State& state) const;

  /// Keeps the answers at this state until the next call, for difference quotients. Pairings whose bodies are where
  /// they were, and move as they did, are answered from memory; where they only move otherwise, the engine applies the
  /// law to what it found there. Call it before anything else is asked about the state: else what was found was not
  /// kept, and is found once more. No bit of any answer changes.
  void remember(const SimTK::State& state) const;
  /// From here on answers are computed. Where poses are those of the remembered state the engine may still know what it
  /// found there (`law_only`).
  void forget() const;

  /// Of all pairings at this state, for Jacobians: one evaluation of those that touch, however many coordinates the
  /// model has. Incomplete ones must not be used.
  ContactTangents tangents(const SimTK::State& state) const;
  /// From here on the forces at this State, and at copies of it, are by these tangents: the engine is not asked for
  /// them. Each load is that to first order in the pose and velocity of the pairing there, turned with the frame of its
  /// E. All else (answers, energies) is the engine's as before. With nullptr they are the engine's again. Invalidates
  /// Stage::Dynamics. Throws BadInput where they are tangents of more or fewer pairings than there are.
  void linearise(SimTK::State& state, std::shared_ptr<const ContactTangents> tangents) const;

  ContactCounters counters() const;

 private:
  class Implementation;
  const Implementation& implementation() const;
  Implementation& implementation();
};

}  // namespace pcm::simbody
