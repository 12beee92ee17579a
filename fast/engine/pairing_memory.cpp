// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/pairing_memory.h"

#include <utility>

#include "fast/base/same_bits.h"
#include "fast/engine/engine.h"
#include "fast/engine/workspace.h"
#include "fast/force/law_parameters.h"
#include "meshes/base/floating_point_environment.h"

namespace pcm::fast {

namespace {

bool is_same(const Wanted& a, const Wanted& b) {
  static_assert(sizeof(Wanted) == 7, "all fields have to be compared");
  return a.polygons == b.polygons && a.areas == b.areas && a.force == b.force && a.elements == b.elements &&
         a.bound == b.bound && a.statistics == b.statistics && a.tangent == b.tangent;
}

}  // namespace

struct PairingMemory::Data {
  Pairing pairing;
  // What is known, if anything is.
  bool known = false;
  Pose pose;
  Wanted wanted;
  FoundElements found;
  Contact contact;  ///< at the velocity asked for last
  Tracking tracking;

  explicit Data(Pairing p) : pairing(std::move(p)), tracking(pairing.surface_E().data(), pairing.surface_F().data()) {}

  /// Whether all that velocities change depends on the elements alone.
  bool can_repeat(const Wanted& asked) const { return !(asked.tangent && pairing.scheme() == Scheme::clipped); }
  const Contact& answer(const Pose& asked_pose, const Velocity& velocity, const Wanted& asked, Workspace& workspace,
                        const Savings& savings);
  void find(const Pose& asked_pose, const Velocity& velocity, const Wanted& asked, Workspace& workspace,
            const Savings& savings);
  void apply_law(const Velocity& velocity, const Savings& savings, Workspace::Data& scratch);
};

[[gnu::noinline]] const Contact& PairingMemory::Data::answer(const Pose& asked_pose, const Velocity& velocity,
                                                             const Wanted& asked, Workspace& workspace,
                                                             const Savings& savings) {
  const bool may_keep = savings.known_poses && savings.only_wanted && !asked.bound;
  if (!may_keep) return fast::evaluate(pairing, asked_pose, velocity, asked, workspace, savings);
  if (!can_repeat(asked)) {
    const Kept kept{false, may_track(asked, savings) ? &tracking : nullptr};
    return evaluate_and_keep(pairing, asked_pose, velocity, asked, workspace, savings, kept);
  }
  if (known && same_bits(asked_pose, pose) && is_same(asked, wanted)) {
    apply_law(velocity, savings, workspace.data());
  } else {
    find(asked_pose, velocity, asked, workspace, savings);
  }
  return contact;
}

void PairingMemory::Data::find(const Pose& asked_pose, const Velocity& velocity, const Wanted& asked,
                               Workspace& workspace, const Savings& savings) {
  known = false;
  const Kept kept{true, may_track(asked, savings) ? &tracking : nullptr};
  std::swap(contact, evaluate_and_keep(pairing, asked_pose, velocity, asked, workspace, savings, kept));
  std::swap(found, workspace.data().elements.found);
  pose = asked_pose;
  wanted = asked;
  known = true;
}

void PairingMemory::Data::apply_law(const Velocity& velocity, const Savings& savings, Workspace::Data& scratch) {
  require_valid(velocity);
  WorkCounters work;
  work.law_only = 1;
  if (wants_force(wanted)) {
    const ForceProblem problem = force_problem(pairing, pose, velocity, wanted, savings);
    scratch.elements.take_back_list(contact);
    const MasterForce total =
        repeat_force(found, pairing.mode(), problem, scratch.force_scratch, scratch.elements, work);
    report_forces(problem, total, scratch.elements, contact);
  }
  contact.work = work;
}

PairingMemory::PairingMemory(Pairing pairing) {
  const DefaultFloatingPoint environment;
  data_ = std::make_unique<Data>(std::move(pairing));
}
PairingMemory::~PairingMemory() = default;
PairingMemory::PairingMemory(PairingMemory&&) noexcept = default;
PairingMemory& PairingMemory::operator=(PairingMemory&&) noexcept = default;

const Contact& PairingMemory::evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                       Workspace& workspace, const Savings& savings) {
  const DefaultFloatingPoint environment;
  return data_->answer(pose, velocity, wanted, workspace, savings);
}

}  // namespace pcm::fast
