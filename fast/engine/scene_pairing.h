// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// A pairing of a scene: what it costs to find that it is apart, and what is kept of it from move to move.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>

#include "fast/engine/separation.h"
#include "fast/engine/tracking.h"
#include "fast/posed/motion.h"
#include "pcm/body_state.h"
#include "pcm/engine.h"
#include "pcm/pairing_memory.h"
#include "pcm/savings.h"

namespace pcm::fast {

/// A relative pose A_E^T A_F is a rotation to 1e-9 where both poses are rotations to this: with A^T A = I + D and no
/// |entry| of D above d, A A^T - I has no singular value above 3 d, so A_F^T (A_E A_E^T) A_F - I no entry above 4 d and
/// what two roundings of a product of rotations add.
inline constexpr double kBodySkew = 1e-10;

/// The box of a body in W, made wider by what it may be off.
struct WorldBox {
  Eigen::Array3d low, high;  ///< m

  WorldBox() = default;
  WorldBox(const PreparedSurface& surface, const Pose& pose);

  bool apart_from(const WorldBox& other) const { return (low > other.high).any() || (other.low > high).any(); }
};

struct SceneBody {
  Surface surface;
  BodyState state;
  WorldBox box;
};

Pose relative_pose(const SceneBody& E, const SceneBody& F);
Velocity relative_velocity(const SceneBody& E, const SceneBody& F);

enum class PairingOutcome : std::uint8_t { not_asked, apart_by_boxes, apart_by_certificate, evaluated };

/// When to look for a certificate. A search costs more than to find out that nothing touches, so where certificates
/// don't last, for a step or because there is hardly a gap, more and more evaluations go by before the next one.
class Patience {
 public:
  bool may_search() {
    if (waiting_ == 0) return true;
    --waiting_;
    return false;
  }
  void found_valid() { uses_ = std::min(uses_ + 1, kWorthIt); }
  /// Before a search.
  void judge_last() {
    wait_ = uses_ >= kWorthIt ? 0 : std::min(2 * wait_ + 1, kLongest);
    waiting_ = wait_;
    uses_ = 0;
  }

 private:
  static constexpr int kWorthIt = 8, kLongest = 64;
  int uses_ = kWorthIt;  ///< of the last certificate, up to kWorthIt; the first one is worth its search
  int wait_ = 0, waiting_ = 0;
};

/// Where a pairing was when poses were to be remembered, and what was found of it there once it was asked about.
struct RememberedPose {
  Pose pose;
  std::optional<PairingMemory> memory;
};

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
  PairingOutcome outcome = PairingOutcome::not_asked;
  bool sought = false;
  WorkCounters work{};
  PairingLoad load{};
  BodyLoad on_E{}, on_F{};  ///< where its bodies were then
  std::exception_ptr failure{};
};

/// Evaluates the pairing of these two bodies where they may be in contact; nullptr where they surely are apart.
const Contact* answer(ScenePairing& pairing, const SceneBody& E, const SceneBody& F, const Savings& savings,
                      Workspace& workspace);
/// The same, and what the pairing's load is on its bodies. What is thrown is kept as its `failure`. `visit` of the
/// answer where they are in contact.
void answer_and_keep_load(ScenePairing& pairing, Index number, const SceneBody& E, const SceneBody& F,
                          const Savings& savings, Workspace& workspace,
                          const std::function<void(Index pairing, const Contact& contact)>& visit);

}  // namespace pcm::fast
