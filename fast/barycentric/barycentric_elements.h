// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/active/face_shares.h"
#include "fast/active/intersection.h"
#include "fast/barycentric/penetration_walks.h"
#include "fast/force/element_sum.h"

namespace pcm::fast {

/// Scratch memory of the search for elements.
struct BarycentricSearch {
  ElementLanes lanes;
  PenetrationWalks walks;
};

/// What one of several threads finds.
struct alignas(kApart) BarycentricOfThread {
  BarycentricSearch search;
  std::vector<LoadLanes> loads;  ///< where they alone are wanted
  std::vector<KeptLanes> found;  ///< elsewhere, before the law
  ElementRecord record;          ///< of what is not in these lists
};

/// Scratch memory of sum_barycentric_elements.
struct BarycentricScratch {
  BarycentricSearch search;
  FaceShares<BarycentricOfThread> shares;
};

/// Forms the contact elements of a master in the barycentric scheme (PCM section 6), in face-index order, records them
/// and sums their forces (21)-(24): one element for each active face whose penetration line leaves the slave at u > 0.
/// kElementLanes are formed at a time. `memory`: of the penetration lines at the last pose, or nullptr. Where there are
/// many faces, and no memory, all threads of the team follow lines, and apply the law where loads alone are wanted; one
/// sums.
MasterForce sum_barycentric_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                     PosedTeam& team, BarycentricScratch& scratch, LineMemory* memory,
                                     ElementRecord& record);

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
