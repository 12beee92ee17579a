// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/force/law_parameters.h"
#include "fast/simd/elements.h"
#include "pcm/contact.h"

namespace pcm::fast {

/// What turns elements into forces, law, motion and where Mf is, and what is asked of them.
struct ForceProblem {
  const ContactLaw& law;
  SeriesStiffness stiffness;
  const Pose& pose;
  const Velocity& velocity;
  bool with_velocities = false;  ///< some result depends on them
  bool keep_elements = false;    ///< in the answer
  bool with_statistics = false;
  bool with_tangent = false;
  bool keep_found = false;  ///< elements before the law, in the record, for another velocity

  /// The problem that answers what is wanted, and no more. All that is given must outlive it.
  ForceProblem(const ContactLaw& contact_law, const Pose& pose_F, const Velocity& velocity_F, const Wanted& wanted);
};

/// Fills an element's position (13), velocities (16), (17), (19) and forces (14), (15), (18), (20), (21). `element`
/// brings its master, area, penetration and normal; `foot_Me` is C_e or the centre of pressure. Velocities stay 0 where
/// the problem needs none.
void apply_force(const ForceProblem& problem, const Eigen::Vector3d& foot_Me, Element& element);

/// The same for WideElements::force.
ForceLimits force_limits(const ForceProblem& problem, Side master);

}  // namespace pcm::fast
