// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fast/force/force_problem.h"
#include "fast/force/found_elements.h"
#include "fast/force/statistics_sum.h"
#include "fast/force/tangent_sum.h"
#include "fast/simd/elements.h"
#include "pcm/contact.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// Force and torque of the elements of one master, resolved in Me.
struct MasterForce {
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on body E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on body E about Mf, N m
  std::optional<Tangent> tangent;                       ///< where the problem has one
};

/// What is told of the elements of all masters beside their force and torque: see Contact.
struct ElementRecord {
  std::vector<Element> elements;  ///< where they are kept
  Index element_count = 0;
  Index too_deep = 0;
  double max_penetration = 0;  ///< m
  bool penetration_exceeded = false;
  StatisticsSum statistics;  ///< where asked for
  FoundElements found;       ///< where the problem keeps them

  /// Enters the greatest penetration of an element, or of a part that underflow keeps from being one, m.
  void note_depth(double greatest_penetration, const ContactLaw& law);
  /// Adds what a record without lists, statistics and found elements tells of other faces.
  void add(const ElementRecord& other);
  /// Empties it and keeps its memory.
  void clear();
  /// Takes back the list that an answer got from report_elements where it has grown more than its own: to be called
  /// before the next elements are recorded.
  void take_back_list(Contact& contact);
};

/// Of the elements of both masters.
MasterForce mean(const MasterForce& on_E, const MasterForce& on_F);

/// Throws BadInput where the force, its torque or the tangent overflowed.
void require_finite(const MasterForce& total);

/// Writes force and torque, elements and statistics, all that velocities change, into the answer, which gets the list
/// of elements and leaves its own in exchange. Throws BadInput where the summary over the elements overflowed.
void report_forces(const ForceProblem& problem, const MasterForce& total, ElementRecord& record, Contact& contact);
/// The same, and what else the record has.
void report_elements(const ForceProblem& problem, const MasterForce& total, ElementRecord& record, Contact& contact);

/// Sums the elements of one master, in the order they come, and records them.
class ElementSum {
 public:
  ElementSum(const ForceProblem& problem, ElementRecord& record, WorkCounters& work)
      : problem_(problem), record_(record), work_(work) {}

  /// Computes the element's force (21)-(24) and adds it. `element` brings its faces, area, normal and penetration,
  /// clamped; `greatest_penetration` is that of any of its points, before clamping; `foot_Me` is C_e (8) or the centre
  /// of pressure.
  void add(double greatest_penetration, const Eigen::Vector3d& foot_Me, Element& element);
  /// The same in two steps, for an element whose force was computed elsewhere; `torque_Me` about Mf.
  void count(double greatest_penetration);
  void add_forced(const Element& element, const Eigen::Vector3d& torque_Me);
  /// Of one that was counted elsewhere, and that nothing else is told of.
  void add_load(const Eigen::Vector3d& force_Me, const Eigen::Vector3d& torque_Me) {
    total_.force_Me += force_Me;
    total_.torque_Me += torque_Me;
  }

  const MasterForce& total() const { return total_; }

 private:
  const ForceProblem& problem_;
  ElementRecord& record_;
  WorkCounters& work_;
  MasterForce total_;
};

/// Forces and torques of up to four elements, all that their sum takes.
struct LoadLanes {
  VectorLanes force_Me, torque_Me;
  LaneBits which = 0;  ///< lanes that hold one
};

/// Whether the answer takes no more than loads and counts.
inline bool wants_loads_alone(const ForceProblem& problem) {
  return !problem.keep_elements && !problem.with_statistics && !problem.with_tangent && !problem.keep_found;
}

/// The law, for elements whose areas, normals, feet and penetrations are in the lanes.
class LawForLanes {
 public:
  LawForLanes(const ForceProblem& problem, Side master);

  /// Fills the lanes' forces.
  void apply(const std::array<ElementFaces, kElementLanes>& faces, LaneBits which, ElementLanes& lanes) const;
  const ForceLimits& limits() const { return limits_; }
  /// The element of a lane, with its force.
  Element element(const ElementFaces& faces, const ElementLanes& lanes, std::size_t lane) const;

 private:
  Element unforced(const ElementFaces& faces, const ElementLanes& lanes, std::size_t lane) const;

  const ForceProblem& problem_;
  Side master_;
  ForceLimits limits_;
};

/// The same, with forces computed kElementLanes at a time, to the same bits; and their derivatives where the problem
/// has a tangent, which needs the elements' depth_gradient_Me, or their motions.
class ElementQueue {
 public:
  /// `lanes`: scratch, or where `add_lanes` finds elements.
  ElementQueue(const ForceProblem& problem, Side master, ElementRecord& record, WorkCounters& work,
               ElementLanes& lanes);

  /// See ElementSum::add; `n_Me` is the master face's outward normal, opposite to the element's; `motion` is given
  /// where the problem has a tangent.
  void add(const ElementFaces& faces, double area, double penetration, const Eigen::Vector3d& n_Me,
           const Eigen::Vector3d& foot_Me, const ElementMotion* motion);
  /// Elements whose areas, normals, feet and penetrations are in the lanes already; none may wait.
  void add_lanes(LaneBits which);
  /// Loads of elements that were counted elsewhere, where loads alone are wanted.
  void add_loads(const LoadLanes& loads) {
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      if (has_lane(loads.which, lane)) sum_.add_load(loads.force_Me[lane], loads.torque_Me[lane]);
    }
  }
  /// Elements that such a queue kept at this pose.
  void add_kept(const KeptLanes& kept) {
    static_cast<FoundLanes&>(lanes_) = kept;
    faces_ = kept.faces;
    add_lanes(kept.which);
  }
  /// Those of the lanes, for `add_lanes`.
  std::array<ElementFaces, kElementLanes>& faces() { return faces_; }
  /// After the last element.
  MasterForce total();

 private:
  void form_waiting();

  LawForLanes law_;
  bool loads_alone_;
  ElementLanes& lanes_;
  std::array<ElementFaces, kElementLanes> faces_{};
  std::vector<KeptLanes>* kept_;  ///< null where the problem keeps none
  std::size_t waiting_ = 0;
  ElementSum sum_;
  std::optional<TangentSum> tangent_;  ///< where the problem has one
};

}  // namespace pcm::fast
