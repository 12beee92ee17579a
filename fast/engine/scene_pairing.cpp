// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/engine/scene_pairing.h"

#include "fast/base/same_bits.h"
#include "fast/engine/engine.h"
#include "fast/engine/workspace.h"
#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

namespace {

/// How far, relative to the greatest coordinates of a body, a box in W may be off what the pairing's relative pose has:
/// A_E^T stands for the inverse of A_E (3 kBodySkew), and the roundings of relative poses, of vertices and of the box
/// itself, all below 64 u of the greatest sum of absolute coordinates.
constexpr double kBodyError = 4 * kBodySkew;
constexpr double kRoundingError = 64 * 0x1p-53;

/// Crossing pairs and elements from which on a pairing is handed out before others, some 0.5 ms.
constexpr std::int64_t kLargeWork = 4000;
/// From which on all threads gain something within the barycentric scheme, which waits for memory.
constexpr std::int64_t kEnoughBarycentricWork = 8000;

/// Whether one surface winds about faces of the other a negative number of times: neither touching nor nested, these
/// have an area all the same. Not asked, and not known, where only touch is wanted.
bool has_pockets(const ActiveAreas& areas, const Wanted& wanted) {
  if (wants_only_touch(wanted)) return false;
  return !areas.of(Side::E).pockets.empty() || !areas.of(Side::F).pockets.empty();
}

const Contact& evaluate_at(const Pose& pose, const Velocity& velocity, ScenePairing& pairing, const Savings& savings,
                           Workspace& workspace) {
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

/// What the pairing's load is on its bodies.
void find_body_loads(const Pose& E, const Pose& F, ScenePairing& pairing) {
  // The torque is about Mf, the origin of body F.
  const Eigen::Vector3d force_W = E.A * pairing.load.force_Me;
  const Eigen::Vector3d torque_W = E.A * pairing.load.torque_Me;
  pairing.on_E = {force_W, torque_W + (F.r - E.r).cross(force_W)};
  pairing.on_F = {-force_W, -torque_W};
}

}  // namespace

WorldBox::WorldBox(const PreparedSurface& surface, const Pose& pose) {
  const Box& box = surface.tree.root().box;
  const double coordinate_sum = surface.max_coordinates.sum();
  const double position_error =
      kBodyError * coordinate_sum + kRoundingError * (coordinate_sum + pose.r.cwiseAbs().sum());
  const Eigen::Array3d centre = pose.A * box.centre + pose.r;
  const Eigen::Array3d half = (pose.A.cwiseAbs() * box.half).array() + position_error;
  low = centre - half;
  high = centre + half;
}

[[gnu::noinline]] Pose relative_pose(const SceneBody& body_E, const SceneBody& body_F) {
  const Pose &E = body_E.state.pose, &F = body_F.state.pose;
  return {E.A.transpose() * F.A, E.A.transpose() * (F.r - E.r)};
}

[[gnu::noinline]] Velocity relative_velocity(const SceneBody& body_E, const SceneBody& body_F) {
  const BodyState &E = body_E.state, &F = body_F.state;
  const Eigen::Matrix3d to_Me = E.pose.A.transpose();
  const Eigen::Vector3d carried_W = E.velocity.w.cross(F.pose.r - E.pose.r);
  return {to_Me * (F.velocity.v - E.velocity.v - carried_W), to_Me * (F.velocity.w - E.velocity.w)};
}

const Contact* answer(ScenePairing& pairing, const SceneBody& E, const SceneBody& F, const Savings& savings,
                      Workspace& workspace) {
  pairing.work = {};
  pairing.sought = false;
  // Bounds tell of what is about to touch too, by boxes that overlap: they are not foreseen here.
  const bool may_skip = !pairing.wanted.bound;
  if (savings.broad_phase && may_skip && E.box.apart_from(F.box)) {
    pairing.outcome = PairingOutcome::apart_by_boxes;
    return nullptr;
  }
  const Pose pose = relative_pose(E, F);
  if (savings.certificates && may_skip && pairing.certificate.holds(pose, pairing.ball_F)) {
    pairing.outcome = PairingOutcome::apart_by_certificate;
    pairing.patience.found_valid();
    return nullptr;
  }
  pairing.outcome = PairingOutcome::evaluated;
  const Contact& contact = evaluate_at(pose, relative_velocity(E, F), pairing, savings, workspace);
  pairing.work = contact.work;
  const std::int64_t work = contact.work.crossing_pairs + contact.work.elements;
  pairing.large = work >= kLargeWork;
  const bool follows = pairing.tracking && pairing.tracking->known() != Tracking::Known::nothing;
  const bool is_clipped = pairing.pairing.scheme() == Scheme::clipped;
  pairing.for_threads = pairing.large && !pairing.wanted.bound && contact.work.law_only == 0 &&
                        (is_clipped || (work >= kEnoughBarycentricWork && !follows));
  // Then the workspace holds nothing of this pairing; where it is apart, that was looked into when it was found.
  if (contact.work.law_only != 0) return &contact;
  const bool apart = !contact.touching && !contact.nested && !has_pockets(workspace.data().active, pairing.wanted);
  if (savings.certificates && may_skip && apart && pairing.patience.may_search()) {
    pairing.sought = true;
    pairing.patience.judge_last();
    const double gap = distance_lower_bound(E.surface.data(), F.surface.data(), workspace.data().posed.placement,
                                            workspace.data().gaps, pairing.work);
    pairing.certificate = SeparationCertificate(pose, gap);
  }
  return &contact;
}

void answer_and_keep_load(ScenePairing& pairing, Index number, const SceneBody& E, const SceneBody& F,
                          const Savings& savings, Workspace& workspace,
                          const std::function<void(Index pairing, const Contact& contact)>& visit) {
  pairing.load = {};
  pairing.on_E = pairing.on_F = {};
  try {
    const Contact* contact = answer(pairing, E, F, savings, workspace);
    if (contact == nullptr || !(contact->touching || contact->nested)) return;
    pairing.load = {contact->touching, contact->nested, contact->force_Me, contact->torque_Me};
    find_body_loads(E.state.pose, F.state.pose, pairing);
    if (visit) visit(number, *contact);
  } catch (...) {
    pairing.failure = std::current_exception();
  }
}

}  // namespace pcm::fast
