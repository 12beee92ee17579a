// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/active/intersection.h"
#include "fast/barycentric/penetration_walks.h"
#include "fast/force/element_sum.h"

namespace pcm::fast {

/// Scratch memory of sum_barycentric_elements.
struct BarycentricScratch {
  ElementLanes lanes;
  PenetrationWalks walks;
};

/// Forms the contact elements of a master in the barycentric scheme (PCM section 6), in face-index order, records them
/// and sums their forces (21)-(24): one element for each active face whose penetration line leaves the slave at u > 0.
/// kElementLanes are formed at a time. `memory`: of the penetration lines at the last pose, or nullptr.
MasterForce sum_barycentric_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                     BarycentricScratch& scratch, LineMemory* memory, ElementRecord& record);

/// One of them: a master face that was found to penetrate.
inline Element barycentric_element(Side master, Index face, const FaceGeometry& geometry,
                                   const Penetration& penetration, const ContactLaw& law) {
  Element element;
  element.master = master;
  element.master_face = face;
  element.slave_face = penetration.slave_face;
  element.area = geometry.area;
  element.penetration = std::min(penetration.depth, law.max_penetration);
  element.normal_Me = -geometry.n_Me;
  return element;
}

}  // namespace pcm::fast
