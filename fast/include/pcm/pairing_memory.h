// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "pcm/engine.h"

namespace pcm::fast {

/// A pairing, and what was found of it where it was asked last. Asked about the same pose, bit for bit, with another
/// velocity, as difference quotients for a Jacobian do, it applies the law to the elements that it knows. Asked about a
/// pose near by, as integrators do, it looks again only at what may have changed, where points of F have moved by less
/// than 1/32 of a usual edge (Savings::coherence). The answer is that of `fast::evaluate`, to the last bit, whatever
/// was asked before. It belongs to whoever has the pairing: any workspace will do, and may be used for anything in
/// between.
///
/// Its memory grows to what the poses need; then no more is allocated. For one caller at a time. One that was moved
/// from can only be assigned to or destroyed.
class PairingMemory {
 public:
  explicit PairingMemory(Pairing pairing);
  ~PairingMemory();
  PairingMemory(PairingMemory&&) noexcept;
  PairingMemory& operator=(PairingMemory&&) noexcept;

  /// The answer lives until the next call with this object or with this workspace. Throws as `fast::evaluate` does,
  /// and then knows no pose or the one that it knew before. More than the law is asked, and `WorkCounters::law_only` is
  /// 0, where
  /// - the pose differs from that of the last answer it kept in any bit, the sign of a zero included, or `wanted` does;
  /// - a bound is wanted, or a tangent in the clipped scheme: these depend on more than the elements, and such answers
  ///   are not kept;
  /// - `savings` has `known_poses` or `only_wanted` switched off: likewise.
  const Contact& evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted, Workspace& workspace,
                          const Savings& savings = {});

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace pcm::fast
