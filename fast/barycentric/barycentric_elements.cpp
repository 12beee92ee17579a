// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/barycentric/barycentric_elements.h"

#include <algorithm>
#include <array>
#include <bit>

namespace pcm::fast {

namespace {

/// The elements of active faces, formed kElementLanes at a time and summed in face-index order.
class ElementBatch {
 public:
  ElementBatch(const Intersection& intersection, Side master, const ForceProblem& problem, BarycentricScratch& scratch,
               LineMemory* memory, ElementRecord& record)
      : posed_(intersection.posed),
        master_(master),
        problem_(problem),
        scratch_(scratch),
        memory_(memory),
        record_(record),
        queue_(problem, master, record, posed_.work, scratch.lanes) {
    scratch.walks.start(posed_, intersection.crossings, master);
  }

  void add(Index face) {
    faces_[count_++] = face;
    if (count_ == kElementLanes) form_elements();
  }
  /// After the last face.
  MasterForce total() {
    if (count_ > 0) form_elements();
    return queue_.total();
  }

 private:
  void form_elements() {
    ElementLanes& lanes = scratch_.lanes;
    find_geometry(posed_, master_, faces_, count_, lanes);
    std::array<Penetration, kElementLanes> found;
    find_penetrations(posed_, master_, faces_, count_, lanes, scratch_.walks, memory_, found);
    LaneBits elements = 0;
    for (std::size_t lane = 0; lane < count_; ++lane) {
      if (found[lane].outcome == Penetration::Outcome::too_deep) ++record_.too_deep;
      if (found[lane].outcome == Penetration::Outcome::element) elements |= 1U << lane;
      lanes.depth.value[lane] = std::min(found[lane].depth, problem_.law.max_penetration);
      queue_.set_faces(lane, faces_[lane], found[lane].slave_face, found[lane].depth);
    }
    if (problem_.with_tangent && elements != 0) find_gradients(found, elements);
    queue_.add_lanes(elements);
    count_ = 0;
  }

  void find_gradients(const std::array<Penetration, kElementLanes>& found, LaneBits elements) {
    ElementLanes& lanes = scratch_.lanes;
    const auto some = static_cast<std::size_t>(std::countr_zero(elements));
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const std::size_t from = has_lane(elements, lane) ? lane : some;
      enter_corners(posed_, opposite(master_), found[from].slave_face, lanes.slave_corners, lane);
    }
    fastest_wide_elements().gradient(lanes);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const bool clamped = found[lane].depth >= problem_.law.max_penetration;
      if (has_lane(elements, lane) && clamped) lanes.depth_gradient_Me.set(lane, Eigen::Vector3d::Zero());
    }
  }

  PosedPair& posed_;
  Side master_;
  const ForceProblem& problem_;
  BarycentricScratch& scratch_;
  LineMemory* memory_;
  ElementRecord& record_;
  ElementQueue queue_;
  FaceBatch faces_{};
  std::size_t count_ = 0;
};

}  // namespace

MasterForce sum_barycentric_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                     BarycentricScratch& scratch, LineMemory* memory, ElementRecord& record) {
  ElementBatch batch(intersection, master, problem, scratch, memory, record);
  for_each_active_face(intersection, master, [&batch](Index face) { batch.add(face); });
  return batch.total();
}

}  // namespace pcm::fast
