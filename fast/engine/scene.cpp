// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "fast/base/geometry.h"
#include "fast/base/same_bits.h"
#include "fast/base/thread_team.h"
#include "fast/engine/engine.h"
#include "fast/engine/separation.h"
#include "fast/engine/tracking.h"
#include "fast/engine/workspace.h"
#include "fast/force/law_parameters.h"
#include "fast/surface/prepared_surface.h"
#include "meshes/base/floating_point_environment.h"
#include "pcm/bad_input.h"
#include "pcm/pairing_memory.h"

namespace pcm::fast {

namespace {

/// A relative pose A_E^T A_F is a rotation to 1e-9 where both poses are rotations to this: with A^T A = I + D and no
/// |entry| of D above d, A A^T - I has no singular value above 3 d, so A_F^T (A_E A_E^T) A_F - I no entry above 4 d and
/// what two roundings of a product of rotations add.
constexpr double kBodySkew = 1e-10;

/// How far, relative to the greatest coordinates of a body, a box in W may be off what the pairing's relative pose has:
/// A_E^T stands for the inverse of A_E (3 kBodySkew), and the roundings of relative poses, of vertices and of the box
/// itself, all below 64 u of the greatest sum of absolute coordinates.
constexpr double kBodyError = 4 * kBodySkew;
constexpr double kRoundingError = 64 * 0x1p-53;

/// Whether one surface winds about faces of the other a negative number of times: neither touching nor nested, these
/// have an area all the same. Not asked, and not known, where only touch is wanted.
bool has_pockets(const Workspace::Data& data, const Wanted& wanted) {
  if (wants_only_touch(wanted)) return false;
  return !data.active.of(Side::E).pockets.empty() || !data.active.of(Side::F).pockets.empty();
}

struct WorldBox {
  Eigen::Array3d low, high;  ///< m

  WorldBox() = default;
  WorldBox(const PreparedSurface& surface, const Pose& pose) {
    const Box& box = surface.tree.root().box;
    const double coordinate_sum = surface.max_coordinates.sum();
    const double position_error =
        kBodyError * coordinate_sum + kRoundingError * (coordinate_sum + pose.r.cwiseAbs().sum());
    const Eigen::Array3d centre = pose.A * box.centre + pose.r;
    const Eigen::Array3d half = (pose.A.cwiseAbs() * box.half).array() + position_error;
    low = centre - half;
    high = centre + half;
  }

  bool apart_from(const WorldBox& other) const { return (low > other.high).any() || (other.low > high).any(); }
};

struct Body {
  Surface surface;
  BodyState state;
  WorldBox box;
};

enum class Outcome : std::uint8_t { not_asked, apart_by_boxes, apart_by_certificate, evaluated };

/// When to look for a certificate. A search costs more than to find out that nothing touches, so where certificates
/// don't last, for a step or because there is hardly a gap, more and more evaluations go by before the next one.
class Patience {
 public:
  bool may_search() {
    if (waiting_ == 0) return true;
    --waiting_;
    return false;
  }
  void found_valid() { ++uses_; }
  /// Before a search.
  void judge_last() {
    constexpr int kWorthIt = 8, kLongest = 64;
    wait_ = uses_ >= kWorthIt ? 0 : std::min(2 * wait_ + 1, kLongest);
    waiting_ = wait_;
    uses_ = 0;
  }

 private:
  int uses_ = kAtFirst;  ///< of the last certificate
  int wait_ = 0, waiting_ = 0;
  static constexpr int kAtFirst = 8;
};

/// Where a pairing was when poses were to be remembered, and what was found of it there once it was asked about.
struct RememberedPose {
  Pose pose;
  std::optional<PairingMemory> memory;
};

/// Crossing pairs and elements from which on a pairing is handed out before others, some 0.5 ms.
constexpr std::int64_t kLargeWork = 4000;
/// From which on all threads gain something within the barycentric scheme, which waits for memory.
constexpr std::int64_t kEnoughBarycentricWork = 8000;

struct ScenePairing {
  Index body_E, body_F;
  Pairing pairing;
  Wanted wanted;
  BoundingBall ball_F;
  SeparationCertificate certificate{};
  Patience patience{};
  std::unique_ptr<RememberedPose> remembered{};
  std::unique_ptr<Tracking> tracking{};  ///< once it was looked at
  // When it was last evaluated:
  bool large = false;
  bool for_threads = false;  ///< threads within an evaluation had something to do
  // In the last evaluate_all, or the one at hand:
  bool goes_first = false;
  // Since the last move, written by the one thread that has the pairing.
  Outcome outcome = Outcome::not_asked;
  bool sought = false;
  WorkCounters work{};
  PairingLoad load{};
  BodyLoad on_E{}, on_F{};  ///< where its bodies were then
  std::exception_ptr failure{};
};

[[noreturn]] void refuse(std::size_t body, const std::string& why) {
  throw BadInput("body " + std::to_string(body) + ": " + why);
}

void require_valid_state(std::size_t body, const BodyState& state) {
  try {
    require_valid(state.pose, state.velocity);
  } catch (const BadInput& error) {
    refuse(body, error.what());
  }
  if (orthogonality_error(state.pose.A) > kBodySkew) {
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
  std::vector<Body> bodies;
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
  const Body& body(Index index) const { return bodies[static_cast<std::size_t>(index)]; }
  Pose relative_pose(const ScenePairing& pairing) const;
  Velocity relative_velocity(const ScenePairing& pairing) const;

  /// Evaluates the pairing where it may be in contact; nullptr where it surely is apart.
  const Contact* answer(ScenePairing& pairing, Workspace& workspace) const;
  /// What the pairing's load is on its bodies.
  void find_body_loads(ScenePairing& pairing) const;
  /// The same, for evaluate_all.
  void answer_and_keep_load(std::size_t pairing, Workspace& workspace, const Visit& visit);
  const Contact& evaluate_at(const Pose& pose, ScenePairing& pairing, Workspace& workspace) const;
  void list_first_pairings();
  /// Whether the first pairing is the only one that goes first, and worth all threads.
  bool is_first_for_threads(int threads) const {
    return threads > 1 && first_pairings.size() == 1 && pairings[first_pairings.front()].for_threads;
  }
};

[[gnu::noinline]] Pose Scene::Data::relative_pose(const ScenePairing& pairing) const {
  const Pose& E = body(pairing.body_E).state.pose;
  const Pose& F = body(pairing.body_F).state.pose;
  return {E.A.transpose() * F.A, E.A.transpose() * (F.r - E.r)};
}

[[gnu::noinline]] Velocity Scene::Data::relative_velocity(const ScenePairing& pairing) const {
  const BodyState& E = body(pairing.body_E).state;
  const BodyState& F = body(pairing.body_F).state;
  const Eigen::Matrix3d to_Me = E.pose.A.transpose();
  const Eigen::Vector3d carried_W = E.velocity.w.cross(F.pose.r - E.pose.r);
  return {to_Me * (F.velocity.v - E.velocity.v - carried_W), to_Me * (F.velocity.w - E.velocity.w)};
}

const Contact& Scene::Data::evaluate_at(const Pose& pose, ScenePairing& pairing, Workspace& workspace) const {
  const Velocity velocity = relative_velocity(pairing);
  RememberedPose* remembered = pairing.remembered.get();
  if (remembered == nullptr || !same_bits(pose, remembered->pose)) {
    const bool track = may_track(pairing.wanted, savings);
    if (track && !pairing.tracking)
      pairing.tracking =
          std::make_unique<Tracking>(pairing.pairing.surface_E().data(), pairing.pairing.surface_F().data());
    return evaluate_and_keep(pairing.pairing, pose, velocity, pairing.wanted, workspace, savings,
                             {false, track ? pairing.tracking.get() : nullptr});
  }
  if (!remembered->memory) remembered->memory.emplace(pairing.pairing);
  return remembered->memory->evaluate(pose, velocity, pairing.wanted, workspace, savings);
}

const Contact* Scene::Data::answer(ScenePairing& pairing, Workspace& workspace) const {
  pairing.work = {};
  pairing.sought = false;
  // Bounds tell of what is about to touch too, by boxes that overlap: they are not foreseen here.
  const bool may_skip = !pairing.wanted.bound;
  if (savings.broad_phase && may_skip && body(pairing.body_E).box.apart_from(body(pairing.body_F).box)) {
    pairing.outcome = Outcome::apart_by_boxes;
    return nullptr;
  }
  const Pose pose = relative_pose(pairing);
  if (savings.certificates && may_skip && pairing.certificate.holds(pose, pairing.ball_F)) {
    pairing.outcome = Outcome::apart_by_certificate;
    pairing.patience.found_valid();
    return nullptr;
  }
  pairing.outcome = Outcome::evaluated;
  const Contact& contact = evaluate_at(pose, pairing, workspace);
  pairing.work = contact.work;
  const std::int64_t work = contact.work.crossing_pairs + contact.work.elements;
  pairing.large = work >= kLargeWork;
  const bool follows = pairing.tracking && pairing.tracking->known() != Tracking::Known::nothing;
  const bool is_clipped = pairing.pairing.scheme() == Scheme::clipped;
  pairing.for_threads = pairing.large && !pairing.wanted.bound && contact.work.law_only == 0 &&
                        (is_clipped || (work >= kEnoughBarycentricWork && !follows));
  // Then the workspace holds nothing of this pairing; where it is apart, that was looked into when it was found.
  if (contact.work.law_only != 0) return &contact;
  const bool apart =
      !contact.touching && !contact.nested && !contact.ambiguous && !has_pockets(workspace.data(), pairing.wanted);
  if (savings.certificates && may_skip && apart && pairing.patience.may_search()) {
    pairing.sought = true;
    pairing.patience.judge_last();
    const PreparedSurface& E = pairing.pairing.surface_E().data();
    const PreparedSurface& F = pairing.pairing.surface_F().data();
    const double gap =
        distance_lower_bound(E, F, workspace.data().posed.placement, workspace.data().gaps, pairing.work);
    pairing.certificate = SeparationCertificate(pose, gap);
  }
  return &contact;
}

void Scene::Data::answer_and_keep_load(std::size_t index, Workspace& workspace, const Visit& visit) {
  ScenePairing& pairing = pairings[index];
  pairing.load = {};
  pairing.on_E = pairing.on_F = {};
  try {
    const Contact* contact = answer(pairing, workspace);
    if (contact == nullptr || !(contact->touching || contact->nested)) return;
    pairing.load = {contact->touching, contact->nested, contact->force_Me, contact->torque_Me};
    find_body_loads(pairing);
    if (visit) visit(static_cast<Index>(index), *contact);
  } catch (...) {
    pairing.failure = std::current_exception();
  }
}

void Scene::Data::find_body_loads(ScenePairing& pairing) const {
  const Pose& E = body(pairing.body_E).state.pose;
  const Pose& F = body(pairing.body_F).state.pose;
  // The torque is about Mf, the origin of body F.
  const Eigen::Vector3d force_W = E.A * pairing.load.force_Me;
  const Eigen::Vector3d torque_W = E.A * pairing.load.torque_Me;
  pairing.on_E = {force_W, torque_W + (F.r - E.r).cross(force_W)};
  pairing.on_F = {-force_W, -torque_W};
}

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
  Body body{std::move(surface), {}, {}};
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
    Body& body = data_->bodies[b];
    body.state = states[b];
    body.box = WorldBox(body.surface.data(), body.state.pose);
  }
  for (ScenePairing& pairing : data_->pairings) {
    pairing.outcome = Outcome::not_asked;
    pairing.sought = false;
    pairing.work = {};
  }
}

void Scene::remember_poses() {
  const DefaultFloatingPoint environment;
  for (ScenePairing& pairing : data_->pairings) {
    if (!pairing.remembered) pairing.remembered = std::make_unique<RememberedPose>();
    pairing.remembered->pose = data_->relative_pose(pairing);
  }
}

Pose Scene::relative_pose(Index pairing) const {
  const DefaultFloatingPoint environment;
  return data_->relative_pose(data_->at(pairing));
}

Velocity Scene::relative_velocity(Index pairing) const {
  const DefaultFloatingPoint environment;
  return data_->relative_velocity(data_->at(pairing));
}

const Contact& Scene::evaluate(Index pairing, Workspace& workspace) {
  const DefaultFloatingPoint environment;
  ScenePairing& asked = data_->at(pairing);
  if (const Contact* contact = data_->answer(asked, workspace)) return *contact;
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
    sum.apart_by_boxes += pairing.outcome == Outcome::apart_by_boxes;
    sum.apart_by_certificate += pairing.outcome == Outcome::apart_by_certificate;
    sum.evaluated += pairing.outcome == Outcome::evaluated;
    sum.certificates_sought += pairing.sought;
    sum.work += pairing.work;
  }
  return sum;
}

}  // namespace pcm::fast
