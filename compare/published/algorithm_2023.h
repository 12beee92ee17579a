// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "compare/published/workspace.h"
#include "fast/force/element_sum.h"

namespace pcm::compare::published {

/// The variant that the algorithm's author published in 2023 (PCM section 9), written from its description, with the
/// engine's force law: no polygons, no active areas, no adjacency. A tree holds the master's penetration lines, from
/// each barycentre inward to a given greatest depth, another one the slave's faces; both are walked together, and a
/// line that leaves the slave through the first face it meets makes an element.
///
/// It knows elements and force alone; `touching` says whether there is an element.
class Algorithm2023 {
 public:
  /// `greatest_depth`: how long the lines are, m > 0; what lies deeper is lost. By default half the size of the smaller
  /// body (greatest extent along an axis of its frame). Throws BadInput where a parameter of the law is out of its
  /// range. The meshes must be fit for contact.
  Algorithm2023(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode,
                std::optional<double> greatest_depth = {});

  /// The answer lives in `workspace` until its next use. Throws BadInput where the question or the force is not finite.
  const fast::Contact& evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                Workspace& workspace) const;

 private:
  fast::MasterForce sum_elements(Side master, const fast::ForceProblem& problem, Workspace& workspace) const;

  Surface E_, F_;
  double greatest_depth_;
  BoxTree lines_E_, lines_F_;  ///< of the sides that are masters
  ContactLaw law_;
  Mode mode_;
};

}  // namespace pcm::compare::published
