// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/active/intersection.h"
#include "fast/barycentric/barycentric_elements.h"
#include "fast/barycentric/penetration.h"
#include "fast/base/geometry.h"
#include "fast/bounds/certain_activity.h"
#include "fast/bounds/clipped_error.h"
#include "fast/bounds/element_error.h"
#include "fast/bounds/passing_error.h"
#include "fast/force/element_sum.h"

namespace pcm::fast {

/// Scratch memory of MasterBound.
struct BoundScratch {
  LineTrace line_trace;      ///< of the line at hand
  UndecidedFaces undecided;  ///< of the master at hand
  SightScratch sight;
  std::vector<Index> open;
};

/// Gathers a rigorous bound on the errors of one master's force and torque against the exact problem (PCM section 1),
/// while its elements are being summed.
///
/// Barycentric scheme: a face whose decisions (is it active, which slave face does its line meet first, is q > 0, does
/// no other face of the master come before) are the same for all positions of F's vertices within their rounding adds
/// the error of its element, a running error analysis: fast/bounds/element_error.h, fast/bounds/force_error.h. Any
/// other face may carry an element in one problem and none, or another one, in the other: it adds what it has and what
/// it might have at most, and `flipped` is set. The rounding of the sums comes on top.
///
/// Clipped scheme: the integrals of an element are off by what fast/bounds/clipped_error.h says, its force by what
/// fast/bounds/force_error.h makes of that, and the same for what the exact problem may have beside the computed
/// elements. A face of the master that is active in one problem only adds all it has and might have; `flipped` is set
/// where that is an element, where a face is seen flush, or where the master face's own normal is not known.
///
/// All bounds are finite but where the element's own numbers come near the end of the range of doubles.
class MasterBound {
 public:
  /// The candidate pairs must have been kept. `scratch` is one master's at a time.
  MasterBound(const Intersection& intersection, Side master, const ForceProblem& problem, BoundScratch& scratch);

  /// To be called for each active face before its line is followed, and traced into what is returned.
  LineTrace* begin_face(Index face, const FaceGeometry& geometry);
  /// The face's element, as it was added to the sum; `total` is the sum after it.
  void add_element(const FaceGeometry& geometry, const Element& element, const MasterForce& total);
  /// Or that it has none; `first_met` as find_penetration has it.
  void add_no_element(Index face, const FaceGeometry& geometry, Index first_met);
  /// The faces that are not active in the rounded problem, but may be in the exact one.
  void add_inactive_faces();

  /// The clipped scheme's: before a face's elements, active or undecided.
  void begin_clipped_face(Index face, const FaceGeometry& geometry);
  /// An element as it was added to the sum, `total`; none of an undecided face that is not active. `error`: none where
  /// nothing is known.
  void add_clipped_element(const Element& element, const ElementError* error, const MasterForce& total);
  /// What else the face may carry. `sight`: none where nothing is known.
  void end_clipped_face(const FaceGeometry& geometry, const SightError* sight);

  Side master() const { return master_; }
  const UndecidedFaces& undecided() const { return scratch_.undecided; }
  SightScratch& sight_scratch() const { return scratch_.sight; }
  const Eigen::Vector3d& rounding_Me() const { return rounding_Me_; }          ///< of any vertex of F
  const Eigen::Vector3d& own_rounding_Me() const { return own_rounding_Me_; }  ///< of the vertices of the face begun
  const FaceError& face_error() const { return face_; }                        ///< of the face begun
  double slack() const;  ///< how far off the face's lines may be wherever any surface reaches, m

  ForceBound result() const;

 private:
  Eigen::Vector3d rounding_of(Side side, Index face) const;
  void add_whole_force(const Element& element);
  /// The exact problem has a point at least as deep as the one, and none of this element or face deeper than the other.
  void note_depth(double at_least, double at_most);
  void add_possible_element(double area, double depth, const FaceGeometry& geometry, const Eigen::Vector3d& foot_error);

  const Intersection& intersection_;
  PosedPair& posed_;
  BoundScratch& scratch_;
  const ForceProblem& problem_;
  Side master_;
  Eigen::Vector3d rounding_Me_;                                ///< of any vertex of F
  Eigen::Vector3d own_rounding_Me_ = Eigen::Vector3d::Zero();  ///< clipped scheme: of the face's vertices
  FaceError face_;                                             ///< of the face begun
  bool undecided_ = false;                                     ///< whether it is active
  PassingError passing_;                                       ///< between its elements
  ForceBound sum_;
};

/// Forms the contact elements of the bound's master in the barycentric scheme, as sum_barycentric_elements does and to
/// the same bits, each with its bound. `open` is scratch.
MasterForce sum_bounded_barycentric_elements(const Intersection& intersection, const ForceProblem& problem,
                                             LineNodes& open, MasterBound& bound, ElementRecord& record);

/// The bound of mode `both`: of the mean of what both masters' bounds are for.
ForceBound mean_bound(const ForceBound& E, const ForceBound& F, const MasterForce& mean);

}  // namespace pcm::fast
