// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/strata.h"
#include "compare/tally.h"
#include "compare/verdict.h"
#include "fast/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {

/// A pairing with both sides ready to answer. Immutable but for the stratum nested's ball; `hold` may be called from
/// any number of threads, each with a workspace of its own.
class Scene {
 public:
  /// Throws BadInput where a mesh is unfit for contact.
  Scene(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode,
        Scheme scheme = Scheme::barycentric);
  /// For the stratum nested.
  Scene(NestedMeshes meshes, const ContactLaw& law, Mode mode, Scheme scheme = Scheme::barycentric);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const FeaturePair& features() const { return features_; }
  const ContactLaw& law() const { return law_; }
  Mode mode() const { return mode_; }
  Question question(const Pose& pose, const Velocity& velocity) const {
    return {features_.E, features_.F, law_, mode_, scheme_, pose, velocity};
  }

  /// Asks both sides about one pose and compares. What either side throws becomes a disagreement of kind `failure`.
  PoseOutcome hold(const Pose& pose, const Velocity& velocity, fast::Workspace& workspace) const;

  const fast::Pairing& engine() const { return engine_; }
  const reference::Oracle& oracle() const { return oracle_; }

 private:
  TriangleMesh mesh_E_;
  TriangleMesh mesh_F_;
  FeaturePair features_;
  ContactLaw law_;
  Mode mode_;
  Scheme scheme_;
  fast::Pairing engine_;
  reference::Oracle oracle_;
};

}  // namespace pcm::compare
