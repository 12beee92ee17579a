// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/barycentric_bound.h"

#include "fast/barycentric/barycentric_elements.h"
#include "fast/base/depth.h"
#include "fast/bounds/element_error.h"
#include "fast/bounds/force_error.h"
#include "fast/bounds/verified_line.h"
#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

Eigen::Vector3d rounding_of(const PosedPair& posed, const Pose& pose, Side side, Index face) {
  if (side == Side::E) return Eigen::Vector3d::Zero();
  return face_rounding(posed.surface(side), pose, face);
}

/// Adds what one master face does to the bound.
class FaceBound {
 public:
  FaceBound(PosedPair& posed, const ForceProblem& problem, Index face, const FaceGeometry& geometry,
            BarycentricBoundScratch& scratch, MasterBound& bound)
      : posed_(posed),
        problem_(problem),
        face_(face),
        geometry_(geometry),
        error_(geometry, rounding_of(posed, problem.pose, bound.master(), face)),
        scratch_(scratch),
        bound_(bound) {
    // The exact line, and the slave's faces, both within their own rounding.
    scratch.line_trace.radius = 2 * tube_radius(posed, error_, bound.rounding_Me());
  }

  /// The face's element, as it was added to the sum; `total` is the sum after it.
  void add_element(const Element& element, const MasterForce& total) {
    const Side slave = opposite(bound_.master());
    ElementError error;
    error.area = error_.area;
    error.normal = error_.normal;
    error.foot_Me = error_.barycentre_Me;
    // Of both faces, one is F's.
    const Eigen::Vector3d rounding_Me = rounding_of(posed_, problem_.pose, bound_.master(), face_) +
                                        rounding_of(posed_, problem_.pose, slave, element.slave_face);
    const double off = depth_error(geometry_, error_, posed_.face_Me(slave, element.slave_face), rounding_Me);
    const VerifiedLine line = follow(element.slave_face);
    const double depth = DepthBelow(geometry_, posed_.face_Me(slave, element.slave_face)).value();
    const bool decided = line.finding == VerifiedLine::Finding::element &&
                         !bound_.undecided().is_undecided.contains(face_) && depth > 2 * off;
    // Where the depth is surely clamped, u_k is max_penetration, in both problems.
    error.penetration = depth - 2 * off > problem_.law.max_penetration ? 0 : off;
    if (decided) {
      bound_.note_depth(depth - kSafetyFactor * off, depth + kSafetyFactor * off);
      bound_.add(force_error(problem_, element, error));
    } else {
      bound_.add_whole_force(element);
      bound_.add_possible_element(element.area + error.area, line.greatest_depth, geometry_, error.foot_Me);
    }
    bound_.add_rounding_of(total);
  }

  /// Or that it has none; `first_met` as find_penetration has it.
  void add_no_element(Index first_met) {
    const VerifiedLine line = follow(first_met);
    if (line.finding == VerifiedLine::Finding::no_element) return;
    bound_.add_possible_element(geometry_.area + error_.area, line.greatest_depth, geometry_, error_.barycentre_Me);
  }

 private:
  VerifiedLine follow(Index first_met) {
    return follow_certainly(posed_, bound_.master(), face_, geometry_, error_, first_met, scratch_.line_trace,
                            bound_.rounding_Me(), scratch_.open);
  }

  PosedPair& posed_;
  const ForceProblem& problem_;
  Index face_;
  const FaceGeometry& geometry_;
  FaceError error_;
  BarycentricBoundScratch& scratch_;
  MasterBound& bound_;
};

}  // namespace

MasterForce sum_bounded_barycentric_elements(const Intersection& intersection, const ForceProblem& problem,
                                             BarycentricBoundScratch& scratch, MasterBound& bound,
                                             ElementRecord& record) {
  const Side master = bound.master();
  PosedPair& posed = intersection.posed;
  ElementSum sum(problem, record, posed.work);
  for_each_active_face(intersection, master, [&](Index face) {
    const FaceGeometry geometry(posed.face_Me(master, face));
    FaceBound face_bound(posed, problem, face, geometry, scratch, bound);
    const Penetration penetration =
        find_penetration(posed, master, face, geometry, scratch.line_open, &scratch.line_trace);
    if (penetration.outcome == Penetration::Outcome::too_deep) ++record.too_deep;
    if (penetration.outcome != Penetration::Outcome::element) {
      face_bound.add_no_element(penetration.first_met);
      return;
    }
    Element element = barycentric_element(master, face, geometry, penetration, problem.law);
    sum.add(penetration.depth, geometry.barycentre_Me(), element);
    face_bound.add_element(element, sum.total());
  });
  for (const Index face : bound.undecided().faces) {
    if (intersection.is_active(master, face)) continue;
    const FaceGeometry geometry(posed.face_Me(master, face));
    scratch.line_trace.clear();
    FaceBound(posed, problem, face, geometry, scratch, bound).add_no_element(-1);
  }
  return sum.total();
}

}  // namespace pcm::fast
