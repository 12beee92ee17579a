// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/clipped_bound.h"

#include <cmath>
#include <optional>
#include <utility>

#include "fast/bounds/repartition_error.h"
#include "fast/bounds/verified_line.h"
#include "fast/clipped/face_view.h"
#include "fast/posed/vertex_rounding.h"
#include "fast/prism/depths_in_prism.h"
#include "fast/search/prism_search.h"

namespace pcm::fast {

namespace {

/// All of the element that a part makes, but its foot and what the law makes of it.
Element element_before_law(const ClippedFace& seen, const VisiblePart& part) {
  Element element;
  element.master = seen.master;
  element.master_face = seen.face;
  element.slave_face = part.slave_face;
  element.area = part.area;
  element.penetration = part.penetration;
  element.normal_Me = -seen.geometry.n_Me;
  return element;
}

/// Whether a face may be seen down to this depth. Of the listed faces it is asked, for which those are is left to
/// single precision.
bool may_be_seen(const TreePrism& prism, const TriangleMesh& mesh, Index face, double deepest) {
  return prism.may_meet(box_of_faces(mesh, &face, 1), deepest);
}

/// Finds those faces that lines were found to meet, in their order: the slave's, then the master's, ascending.
class ProjectedWalk {
 public:
  explicit ProjectedWalk(const std::vector<ProjectedFace>& faces) : next_(faces.begin()), end_(faces.end()) {}

  /// Null where no line was found to meet it.
  const ProjectedFace* at(bool of_master, Index face) {
    while (next_ != end_ && std::pair(next_->of_master, next_->face) < std::pair(of_master, face)) ++next_;
    return next_ != end_ && next_->of_master == of_master && next_->face == face ? &*next_ : nullptr;
  }

 private:
  std::vector<ProjectedFace>::const_iterator next_, end_;
};

/// What the errors of one master face's elements add to the bound.
class FaceBound {
 public:
  FaceBound(PosedPair& posed, const ForceProblem& problem, const ClippedFace& seen, ClippedBoundScratch& scratch,
            MasterBound& bound)
      : posed_(posed),
        problem_(problem),
        seen_(seen),
        bound_(bound),
        own_rounding_Me_(posed[seen.master].sharp_face_rounding_Me(seen.face)),
        error_(seen.geometry, own_rounding_Me_),
        undecided_(bound.undecided().is_undecided.contains(seen.face)) {
    if (seen.prism && error_.normal_known) find_sights(scratch);
  }
  FaceBound(const FaceBound&) = delete;
  FaceBound& operator=(const FaceBound&) = delete;

  /// An element as it was added to the sum, `total`; by slave face.
  void add_element(const VisiblePart& part, const Element& element, const MasterForce& total);
  /// What else the face may carry, once all its elements were added.
  void add_rest(VisibleDepthScratch& scratch);

 private:
  void find_sights(ClippedBoundScratch& scratch);
  void see_slave(double position_error, ProjectedWalk& projected, ClippedBoundScratch& scratch);
  void see_own(double position_error, ProjectedWalk& projected, ClippedBoundScratch& scratch);
  void note_visible_depth(VisibleDepthScratch& scratch);

  PosedPair& posed_;
  const ForceProblem& problem_;
  const ClippedFace& seen_;
  MasterBound& bound_;
  Eigen::Vector3d own_rounding_Me_;  ///< of the face's vertices
  FaceError error_;
  bool undecided_;  ///< whether the face is active
  std::optional<PrismError> prism_error_;
  std::optional<ViewError> sight_;  ///< none where nothing is known
  RepartitionError passing_;        ///< between the elements
};

void FaceBound::find_sights(ClippedBoundScratch& scratch) {
  const MasterPrism& prism = *seen_.prism;
  prism_error_.emplace(prism, error_, seen_.master, own_rounding_Me_, bound_.rounding_Me());
  sight_.emplace(scratch.sight, prism, *prism_error_, problem_.law);
  const double position_error = tube_radius(posed_, error_, bound_.rounding_Me());
  ProjectedWalk projected(seen_.view.faces);
  see_slave(position_error, projected, scratch);
  const bool knows_own = seen_.view.own_depth >= 0;
  bool needs_own = knows_own;
  if (sight_->greatest_depth() >= 0) {
    const OwnFacesBefore before =
        own_faces_before(posed_, seen_.master, seen_.geometry, seen_.face, sight_->greatest_depth());
    needs_own = needs_own || before == OwnFacesBefore::some;
    if (!knows_own && before == OwnFacesBefore::leaning) sight_->may_lean(posed_.placement.greatest_lean());
  }
  if (needs_own) see_own(position_error, projected, scratch);
  sight_->compare(posed_.surface(opposite(seen_.master)), posed_.surface(seen_.master));
  for (const VisiblePart& part : seen_.parts) {
    if (!part.is_element()) sight_->leave_out(part);
  }
}

void FaceBound::see_slave(double position_error, ProjectedWalk& projected, ClippedBoundScratch& scratch) {
  const double deepest = seen_.view.listed_to_depth;
  const bool leaves = std::isfinite(deepest);  // before the slave is met
  const Side slave = opposite(seen_.master);
  const PreparedSurface& surface = posed_.surface(slave);
  const FastClearArray<PrismPoint>& sights = seen_.view.slave_sights;
  const TreePrism prism = prism_in_tree(posed_, slave, *seen_.prism, position_error);
  const bool is_listed = position_error <= seen_.view.listed_wider_by;
  if (!is_listed) list_faces_in_prism(posed_, slave, prism, deepest, scratch.open, scratch.listed);
  for (const Index face : is_listed ? seen_.view.slave_listed : scratch.listed) {
    if (!may_be_seen(prism, surface.mesh, face, deepest)) continue;
    SeenCorners corners;
    const Triangle& vertices = surface.face(face);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = vertices[k];
      corners.points[k] = sights.contains(v) ? sights.at(v) : seen_.prism->see(posed_.vertex_Me(slave, v), posed_.work);
    }
    // Boxes of large faces say little of what lies before lines that have left the master.
    if (leaves && !may_be_met_before(deepest, *seen_.prism, corners.points, prism.box_error())) continue;
    sight_->see(posed_[slave], face, false, corners, projected.at(false, face), posed_.work);
  }
}

void FaceBound::see_own(double position_error, ProjectedWalk& projected, ClippedBoundScratch& scratch) {
  const double deepest = std::max(seen_.view.own_depth, sight_->greatest_depth());
  const TreePrism prism = prism_in_tree(posed_, seen_.master, *seen_.prism, position_error);
  list_faces_in_prism(posed_, seen_.master, prism, deepest, scratch.open, scratch.listed);
  PosedSurface& own = posed_[seen_.master];
  const PreparedSurface& surface = own.surface();
  OwnSights sights(*seen_.prism, surface.face(seen_.face));
  for (const Index face : scratch.listed) {
    if (face == seen_.face || !may_be_seen(prism, surface.mesh, face, deepest)) continue;
    const SeenCorners corners = own_corners(own, face, sights, posed_.work);
    sight_->see(own, face, true, corners, projected.at(true, face), posed_.work);
  }
}

void FaceBound::add_element(const VisiblePart& part, const Element& element, const MasterForce& total) {
  if (sight_) {
    ElementError error = sight_->of_element(part, error_);
    // The element surely exists.
    if (!undecided_ && element.area > kSafetyFactor * (error.area + error.passed_area))
      bound_.note_depth(element.penetration - kSafetyFactor * error.penetration, 0);
    ElementForceError passed;
    passing_.add(problem_, element, error, passed);
    const ElementForceError whole = force_error(problem_, element, error);
    bound_.add({passed.force_Me + RepartitionError::kGrowth * whole.force_Me,
                passed.torque_Me + RepartitionError::kGrowth * whole.torque_Me});
  }
  if (!sight_ || undecided_) bound_.add_whole_force(element);
  bound_.add_rounding_of(total);
}

void FaceBound::note_visible_depth(VisibleDepthScratch& scratch) {
  const double floor = bound_.depth_at_least();
  if (sight_->greatest_depth() <= floor) return;
  double computed = 0;
  for (const VisiblePart& part : seen_.parts) {
    if (part.is_element()) computed = std::max(computed, part.moments.greatest);
  }
  const DepthRange range = sight_->visible_depth(computed, floor, scratch);
  bound_.note_depth(undecided_ ? 0 : range.at_least, range.at_most);
}

void FaceBound::add_rest(VisibleDepthScratch& scratch) {
  const FaceGeometry& geometry = seen_.geometry;
  const double twice_area = 2 * (geometry.area + error_.area);
  const auto& p = geometry.points_Me;
  const Eigen::Vector3d anywhere = (p[1] - p[0]).cwiseAbs() + (p[2] - p[0]).cwiseAbs();
  if (!sight_ || !sight_->known()) {
    bound_.add_possible_element(0.5 * twice_area, extent_of(posed_), geometry, error_.barycentre_Me + anywhere);
    return;
  }
  if (sight_->flush()) bound_.flip();
  note_visible_depth(scratch);
  const ViewError::Beside beside = sight_->beside();
  passing_.add_elsewhere(twice_area * beside.passed_area, twice_area * beside.passed_volume);
  ElementForceError passed;
  passing_.finish(passed);
  bound_.add(passed);
  if (!(beside.area > 0)) return;
  // An element's force grows with its volume, and with its area where it is damped.
  const Eigen::Vector3d foot_error = error_.barycentre_Me + anywhere + Eigen::Vector3d::Constant(beside.depth);
  const GreatestForce greatest = greatest_force(problem_, twice_area * beside.area, beside.volume / beside.area,
                                                geometry.barycentre_Me(), foot_error);
  bound_.add({greatest.normal * geometry.n_Me.cwiseAbs() +
                  Eigen::Vector3d::Constant(greatest.normal * error_.normal + greatest.friction),
              Eigen::Vector3d::Constant(greatest.torque)});
}

}  // namespace

MasterForce sum_bounded_clipped_elements(const Intersection& intersection, const ForceProblem& problem,
                                         ClippedFaceScratch& forming, ClippedBoundScratch& scratch, MasterBound& bound,
                                         ElementRecord& record) {
  const Side master = bound.master();
  PosedPair& posed = intersection.posed;
  const auto add_elements = [&](const ClippedFace& seen, ElementSum& sum) {
    FaceBound face_bound(posed, problem, seen, scratch, bound);
    for (const VisiblePart& part : seen.parts) {
      if (!part.is_element()) continue;
      Element element = element_before_law(seen, part);
      sum.add(part.moments.greatest, seen.foot_Me(part), element);
      face_bound.add_element(part, element, sum.total());
    }
    face_bound.add_rest(scratch.depth);
  };
  ElementSum sum(problem, record, posed.work);
  for_each_active_face(intersection, master, [&](Index face) {
    const ClippedFace seen = clip_face(intersection, master, face, problem.law, false, forming);
    record_beside_elements(seen, problem.law, record);
    add_elements(seen, sum);
  });
  // Faces that are not active, but may be in the exact problem: what they would add.
  ForceProblem unrecorded = problem;
  unrecorded.keep_elements = unrecorded.with_statistics = false;
  for (const Index face : bound.undecided().faces) {
    if (intersection.is_active(master, face)) continue;
    ElementRecord none;
    WorkCounters no_work;
    ElementSum nothing(unrecorded, none, no_work);
    add_elements(clip_face(intersection, master, face, problem.law, false, forming), nothing);
  }
  return sum.total();
}

}  // namespace pcm::fast
