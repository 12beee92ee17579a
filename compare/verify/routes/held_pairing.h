// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "compare/poses/strata.h"
#include "compare/verify/routes/engine_seam.h"
#include "compare/verify/verdict/tally.h"
#include "compare/verify/verdict/verdict.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {

/// A pairing with both sides ready to answer, in one mode or several. Immutable but for the stratum nested's ball;
/// `hold` may be called from any number of threads, each with a workspace of its own.
class HeldPairing {
 public:
  using Modes = std::vector<Mode>;

  /// Throws BadInput where a mesh is unfit for contact. `modes`: at least one.
  HeldPairing(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, const Modes& modes,
              Scheme scheme = Scheme::barycentric);
  HeldPairing(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode,
              Scheme scheme = Scheme::barycentric)
      : HeldPairing(std::move(mesh_E), std::move(mesh_F), law, Modes{mode}, scheme) {}
  /// For the stratum nested.
  HeldPairing(NestedMeshes meshes, const ContactLaw& law, const Modes& modes, Scheme scheme = Scheme::barycentric);
  HeldPairing(const HeldPairing&) = delete;
  HeldPairing& operator=(const HeldPairing&) = delete;

  const FeaturePair& features() const { return features_; }
  const ContactLaw& law() const { return law_; }
  /// In the first mode.
  Question question(const Pose& pose, const Velocity& velocity) const { return question(engine(), pose, velocity); }

  /// Asks both sides about one pose in every mode and compares: an outcome for each mode, in order. The engine is asked
  /// by every call route (asks.h), the oracle's geometry is worked out once for all. What either side throws
  /// becomes a disagreement of kind `failure`.
  std::vector<PoseOutcome> hold(const Pose& pose, const Velocity& velocity, fast::Workspace& workspace,
                                const EngineSeam& seam = EngineSeam::none()) const {
    return hold({pose, velocity, law_, engine().scheme(), {}}, workspace, seam);
  }

  /// A state, and law and scheme in place of those it was made with.
  struct State {
    Pose pose;
    Velocity velocity;
    ContactLaw law;
    Scheme scheme = Scheme::barycentric;
    std::vector<MovingPose> before{};  ///< how F came there: then a scene is led along that, too
  };
  std::vector<PoseOutcome> hold(const State& state, fast::Workspace& workspace,
                                const EngineSeam& seam = EngineSeam::none()) const;

  /// Of mode number k.
  const fast::Pairing& engine(std::size_t k = 0) const { return engines_[k]; }
  /// Of the same surfaces, under another law, mode and scheme.
  fast::Pairing engine_under(const ContactLaw& law, Mode mode, Scheme scheme) const {
    return {engine().surface_E(), engine().surface_F(), law, mode, scheme};
  }
  /// Of the first mode.
  const reference::Oracle& oracle() const { return oracle_; }

 private:
  Question question(const fast::Pairing& engine, const Pose& pose, const Velocity& velocity) const {
    return {features_.E, features_.F, law_, engine.mode(), engine.scheme(), pose, velocity};
  }
  PoseOutcome hold(const fast::Pairing& engine, reference::Inquiry& inquiry, const State& state,
                   fast::Workspace& workspace, const EngineSeam& seam) const;
  /// Where the engine refuses the tangent: holds what it answers under a weakened law (refused_tangent.h).
  Checks hold_weak_tangent(const fast::Pairing& engine, const State& state, fast::Workspace& workspace,
                           const EngineSeam& seam) const;

  TriangleMesh mesh_E_;
  TriangleMesh mesh_F_;
  FeaturePair features_;
  ContactLaw law_;
  std::vector<fast::Pairing> engines_;  ///< by mode; their surfaces are the same ones
  reference::Oracle oracle_;
};

}  // namespace pcm::compare
