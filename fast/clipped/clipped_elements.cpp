// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/clipped_elements.h"

namespace pcm::fast {

MasterForce sum_clipped_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                 ClippedScratch& scratch, ElementRecord& record) {
  PosedPair& posed = intersection.posed;
  ElementQueue queue(problem, master, record, posed.work, scratch.lanes);
  for_each_active_face(intersection, master, [&](Index face) {
    const ClippedFace seen = clip_face(posed, master, face, problem.law, scratch.face);
    record_beside_elements(seen, problem.law, record);
    for (const VisiblePart& part : seen.parts) {
      if (part.is_element()) queue.add(seen.element(part), part.moments.greatest, seen.foot_Me(part));
    }
  });
  return queue.total();
}

}  // namespace pcm::fast
