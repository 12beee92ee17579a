// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/law.h"
#include "fast/workspace.h"

namespace pcm::fast {

/// What turns elements into forces: the law, the motion and where Mf is.
struct ForceProblem {
  const ContactLaw& law;
  SeriesStiffness stiffness;
  const Pose& pose;
  const Velocity& velocity;
  bool with_velocities;  ///< some result depends on them
  bool keep_elements;    ///< in the answer, with their statistics
  bool with_bound;       ///< fill Contact::bound
};

/// Force and torque of the elements of one master, resolved in Me.
struct MasterForce {
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on body E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on body E about Mf, N m
};

class MasterBound;

/// Forms the contact elements of a master (PCM section 6, barycentric scheme): one for each active face whose
/// penetration line leaves the slave at u > 0, in face-index order; counts them and those too deep, and sums their
/// forces (21)-(24). Needs that side's active area. `bound`, where given, gathers what their errors may be.
MasterForce sum_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem,
                         MasterBound* bound = nullptr);

}  // namespace pcm::fast
