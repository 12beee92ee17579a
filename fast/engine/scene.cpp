// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/scene.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "fast/base/geometry.h"
#include "fast/base/thread_team.h"
#include "fast/engine/scene_pairing.h"
#include "fast/engine/workspace.h"
#include "fast/force/law_parameters.h"
#include "fast/surface/prepared_surface.h"
#include "meshes/base/floating_point_environment.h"
#include "pcm/bad_input.h"

namespace pcm::fast {

namespace {

[[noreturn]] void refuse(std::size_t body, const std::string& why) {
  throw BadInput("body " + std::to_string(body) + ": " + why);
}

void require_valid_state(std::size_t body, const BodyState& state) {
  double skew = 0;
  try {
    skew = require_valid(state.pose, state.velocity);
  } catch (const BadInput& error) {
    refuse(body, error.what());
  }
  if (skew > kBodySkew) {
    refuse(body, "pose: A is no rotation to 1e-10 (max |A^T A - I|); normalise it");
  }
  const auto in_range = [](const Eigen::Vector3d& v) { return v.cwiseAbs().maxCoeff() <= kGreatestCoordinate; };
  if (!in_range(state.velocity.v) || !in_range(state.velocity.w)) {
    refuse(body, "velocity: a component exceeds 2^300; choose other units");
  }
}

}  // namespace

struct Scene::Data {
  explicit Data(const Savings& s) : savings(s) {}

  Savings savings;
  std::vector<SceneBody> bodies;
  std::vector<ScenePairing> pairings;
  // Of evaluate_all:
  std::vector<Workspace> workspaces;        ///< one a thread
  std::vector<std::size_t> first_pairings;  ///< taken one by one
  Workspace shared_workspace;               ///< of a pairing that all threads take part in
  int shared_workspace_threads = 1;
  ThreadTeam team;

  ScenePairing& at(Index pairing) {
    const auto i = static_cast<std::size_t>(pairing);
    if (pairing < 0 || i >= pairings.size()) {
      throw BadInput("scene: there is no pairing " + std::to_string(pairing) + ", it has " +
                     std::to_string(pairings.size()));
    }
    return pairings[i];
  }
  const SceneBody& body(Index index) const { return bodies[static_cast<std::size_t>(index)]; }
  const SceneBody& body_E(const ScenePairing& pairing) const { return body(pairing.body_E); }
  const SceneBody& body_F(const ScenePairing& pairing) const { return body(pairing.body_F); }

  /// For evaluate_all.
  void answer_and_keep_load(std::size_t i, Workspace& workspace, const Visit& visit) {
    ScenePairing& pairing = pairings[i];
    fast::answer_and_keep_load(pairing, static_cast<Index>(i), body_E(pairing), body_F(pairing), savings, workspace,
                               visit);
  }
  void list_first_pairings();
  /// Whether the first pairing is the only one that goes first, and worth all threads.
  bool is_first_for_threads(int threads) const {
    return threads > 1 && first_pairings.size() == 1 && pairings[first_pairings.front()].for_threads;
  }
};

void Scene::Data::list_first_pairings() {
  first_pairings.clear();
  for (std::size_t i = 0; i < pairings.size(); ++i) {
    ScenePairing& pairing = pairings[i];
    pairing.goes_first = pairing.large;
    pairing.failure = nullptr;
    if (pairing.goes_first) first_pairings.push_back(i);
  }
}

Scene::Scene(Savings savings) : data_(std::make_unique<Data>(savings)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Index Scene::add_body(Surface surface) {
  const DefaultFloatingPoint environment;
  SceneBody body{std::move(surface), {}, {}};
  body.box = WorldBox(body.surface.data(), body.state.pose);
  data_->bodies.push_back(std::move(body));
  return bodies() - 1;
}

Index Scene::add_pairing(Index body_E, Index body_F, ContactLaw law, Mode mode, Scheme scheme, Wanted wanted) {
  for (const Index body : {body_E, body_F}) {
    if (body < 0 || body >= bodies()) {
      throw BadInput("pairing: there is no body " + std::to_string(body) + ", the scene has " +
                     std::to_string(bodies()));
    }
  }
  if (body_E == body_F) throw BadInput("pairing: body " + std::to_string(body_E) + " with itself");
  const DefaultFloatingPoint environment;
  const Surface& F = data_->body(body_F).surface;
  ScenePairing pairing{body_E, body_F, Pairing(data_->body(body_E).surface, F, std::move(law), mode, scheme), wanted,
                       BoundingBall(F.data())};
  data_->pairings.push_back(std::move(pairing));
  return pairings() - 1;
}

Index Scene::bodies() const {
  return static_cast<Index>(data_->bodies.size());
}

Index Scene::pairings() const {
  return static_cast<Index>(data_->pairings.size());
}

const Pairing& Scene::pairing(Index index) const {
  return data_->at(index).pairing;
}

void Scene::move(const std::vector<BodyState>& states) {
  if (states.size() != data_->bodies.size()) {
    throw BadInput("scene: " + std::to_string(states.size()) + " states for " + std::to_string(data_->bodies.size()) +
                   " bodies");
  }
  const DefaultFloatingPoint environment;
  for (std::size_t b = 0; b < states.size(); ++b) require_valid_state(b, states[b]);
  for (std::size_t b = 0; b < states.size(); ++b) {
    SceneBody& body = data_->bodies[b];
    body.state = states[b];
    body.box = WorldBox(body.surface.data(), body.state.pose);
  }
  for (ScenePairing& pairing : data_->pairings) {
    pairing.outcome = PairingOutcome::not_asked;
    pairing.sought = false;
    pairing.work = {};
  }
}

void Scene::remember_poses() {
  const DefaultFloatingPoint environment;
  for (ScenePairing& pairing : data_->pairings) {
    if (!pairing.remembered) pairing.remembered = std::make_unique<RememberedPose>();
    pairing.remembered->pose = fast::relative_pose(data_->body_E(pairing), data_->body_F(pairing));
  }
}

Pose Scene::relative_pose(Index pairing) const {
  const DefaultFloatingPoint environment;
  const ScenePairing& asked = data_->at(pairing);
  return fast::relative_pose(data_->body_E(asked), data_->body_F(asked));
}

Velocity Scene::relative_velocity(Index pairing) const {
  const DefaultFloatingPoint environment;
  const ScenePairing& asked = data_->at(pairing);
  return fast::relative_velocity(data_->body_E(asked), data_->body_F(asked));
}

const Contact& Scene::evaluate(Index pairing, Workspace& workspace) {
  const DefaultFloatingPoint environment;
  ScenePairing& asked = data_->at(pairing);
  const Contact* const contact = answer(asked, data_->body_E(asked), data_->body_F(asked), data_->savings, workspace);
  if (contact != nullptr) return *contact;
  // The only things said of what is apart.
  Contact& apart = workspace.data().apart;
  apart.has_volume = asked.wanted.areas && asked.pairing.surface_E().closed() && asked.pairing.surface_F().closed();
  apart.tangent.reset();
  if (asked.wanted.tangent) apart.tangent = Tangent::Zero();
  return apart;
}

void Scene::evaluate_all(int threads, const Visit& visit) {
  if (threads < 1) throw BadInput("scene: evaluate_all needs at least 1 thread, not " + std::to_string(threads));
  const auto members = static_cast<std::size_t>(threads);
  if (data_->workspaces.size() < members) data_->workspaces.resize(members);
  data_->list_first_pairings();
  std::vector<ScenePairing>& all = data_->pairings;
  const std::vector<std::size_t>& first_pairings = data_->first_pairings;
  const bool for_threads = data_->is_first_for_threads(threads);
  if (for_threads) {
    const DefaultFloatingPoint environment;
    if (data_->shared_workspace_threads != threads) {
      data_->shared_workspace = Workspace(threads);
      data_->shared_workspace_threads = threads;
    }
    data_->answer_and_keep_load(first_pairings.front(), data_->shared_workspace, visit);
  }
  // Few enough to share the work evenly, enough that sharing costs nothing beside pairings that are apart.
  const std::size_t chunk = std::clamp<std::size_t>(all.size() / (4 * members), 1, 16);
  // The next of the first pairings, and then the next chunk of all, without these.
  std::atomic<std::size_t> next = for_threads ? 1 : 0;
  const auto take_part = [&](std::size_t member) {
    const DefaultFloatingPoint environment;
    Workspace& workspace = data_->workspaces[member];
    for (std::size_t number = next++;; number = next++) {
      if (number < first_pairings.size()) {
        data_->answer_and_keep_load(first_pairings[number], workspace, visit);
        continue;
      }
      const std::size_t begin = (number - first_pairings.size()) * chunk;
      if (begin >= all.size()) return;
      for (std::size_t i = begin; i < std::min(begin + chunk, all.size()); ++i) {
        if (!all[i].goes_first) data_->answer_and_keep_load(i, workspace, visit);
      }
    }
  };
  // By reference, so that no copy is allocated.
  data_->team.run(members, std::cref(take_part));
  for (const ScenePairing& pairing : all) {
    if (pairing.failure) std::rethrow_exception(pairing.failure);
  }
}

const PairingLoad& Scene::load(Index pairing) const {
  return data_->at(pairing).load;
}

std::vector<BodyLoad> Scene::body_loads() const {
  const DefaultFloatingPoint environment;
  std::vector<BodyLoad> loads(data_->bodies.size());
  for (const ScenePairing& pairing : data_->pairings) {
    if (!pairing.load.touching && !pairing.load.nested) continue;
    const auto add = [&](Index body, const BodyLoad& load) {
      loads[static_cast<std::size_t>(body)].force_W += load.force_W;
      loads[static_cast<std::size_t>(body)].torque_W += load.torque_W;
    };
    add(pairing.body_E, pairing.on_E);
    add(pairing.body_F, pairing.on_F);
  }
  return loads;
}

SceneCounters Scene::counters() const {
  SceneCounters sum;
  for (const ScenePairing& pairing : data_->pairings) {
    sum.apart_by_boxes += pairing.outcome == PairingOutcome::apart_by_boxes;
    sum.apart_by_certificate += pairing.outcome == PairingOutcome::apart_by_certificate;
    sum.evaluated += pairing.outcome == PairingOutcome::evaluated;
    sum.certificates_sought += pairing.sought;
    sum.work += pairing.work;
  }
  return sum;
}

}  // namespace pcm::fast
