// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "fast/law.h"
#include "fast/statistics_sum.h"
#include "fast/workspace.h"

namespace pcm::fast {

/// What turns elements into forces: the scheme, the law, the motion and where Mf is.
struct ForceProblem {
  Scheme scheme;
  const ContactLaw& law;
  SeriesStiffness stiffness;
  const Pose& pose;
  const Velocity& velocity;
  bool with_velocities = false;         ///< some result depends on them
  bool keep_elements = false;           ///< in the answer
  bool with_bound = false;              ///< fill Contact::bound
  StatisticsSum* statistics = nullptr;  ///< gathers the elements, where given
};

/// Force and torque of the elements of one master, resolved in Me.
struct MasterForce {
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on body E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on body E about Mf, N m
};

class MasterBound;

/// Sums the elements of one master as they come, their forces computed kElementLanes at a time. Where no bounds are
/// wanted: these need each element's error beside it.
class ElementQueue {
 public:
  ElementQueue(Workspace::Data& workspace, Side master, const ForceProblem& problem);

  /// See `add_element`.
  void add(const Element& element, double greatest_penetration, const Eigen::Vector3d& foot_Me);
  /// Elements whose areas, normals, feet and penetrations are in the lanes already; none may wait.
  void add_lanes(LaneBits which);
  /// The faces of a lane for `add_lanes`.
  void set_faces(std::size_t lane, Index master_face, Index slave_face, double greatest_penetration) {
    faces_[lane] = {master_face, slave_face, greatest_penetration};
  }
  /// After the last element.
  const MasterForce& total() {
    form_waiting();
    return total_;
  }

 private:
  struct Faces {
    Index master, slave;
    double greatest_penetration;
  };
  void form_waiting();
  void add_lane(std::size_t lane, bool forced);

  Workspace::Data& workspace_;
  Side master_;
  const ForceProblem& problem_;
  ForceLimits limits_;
  std::array<Faces, kElementLanes> faces_{};
  std::size_t waiting_ = 0;
  MasterForce total_;
};

/// Whether a face is active: intersected or inner.
inline bool is_active(const SideState& side, Index face) {
  return side.is_intersected.contains(static_cast<std::size_t>(face)) ||
         std::binary_search(side.inner.begin(), side.inner.end(), face);
}

/// Calls `visit(face)` for the active faces of a side, intersected and inner, in face-index order.
template <class Visit>
void for_each_active_face(const SideState& side, const Visit& visit) {
  std::size_t i = 0, j = 0;
  while (i < side.intersected.size() || j < side.inner.size()) {
    const bool inner = i == side.intersected.size() || (j < side.inner.size() && side.inner[j] < side.intersected[i]);
    visit(inner ? side.inner[j++] : side.intersected[i++]);
  }
}

/// Enters an element into the answer and its force into the total (21)-(24). `element` brings its faces, area, normal
/// and penetration, clamped; `greatest_penetration` is that of any of its points, before clamping; `foot_Me` is C_e (8)
/// or the centre of pressure.
void add_element(Contact& contact, const ForceProblem& problem, double greatest_penetration,
                 const Eigen::Vector3d& foot_Me, Element& element, MasterForce& total);

/// Forms the contact elements of a master (PCM section 6), in face-index order; counts them and the faces that are too
/// deep, and sums their forces (21)-(24). Barycentric scheme: one element for each active face whose penetration line
/// leaves the slave at u > 0. Clipped scheme: see fast/clipped_elements.h. Needs that side's active area. `bound`,
/// where given, gathers what the errors of the elements may be.
MasterForce sum_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem,
                         MasterBound* bound = nullptr);

}  // namespace pcm::fast
