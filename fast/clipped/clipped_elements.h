// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "fast/active/face_shares.h"
#include "fast/active/intersection.h"
#include "fast/clipped/face_view.h"
#include "fast/clipped/part_motion.h"
#include "fast/clipped/visible_parts.h"
#include "fast/force/element_sum.h"
#include "fast/search/line_search.h"

/// Contact elements of the clipped scheme (PCM section 6), from surfaces to forces in six files: clip_face lets an
/// active face look along its penetration lines (face_view.h: the faces that its prism meets, in the coordinates of
/// fast/prism/master_prism.h), parts what it sees (visible_parts.h) and integrates the depth over each part (Moments,
/// fast/prism/convex_polygon.h; how that changes with the pose: part_motion.h); ElementQueue (fast/force/element_sum.h)
/// applies the law to four elements at a time and adds up, as it does in both schemes.
namespace pcm::fast {

/// The part of a master face whose penetration lines leave the slave through one and the same face of it.
struct VisiblePart {
  Index slave_face;
  double area = 0;         ///< A_k, m^2; 0 where it is not certain that there is a part
  double penetration = 0;  ///< u_k, mean of the clamped depth, m; > 0 where that is, however small
  /// Of min(depth, max_penetration); area and greatest depth are none of the clamp's. Next to the least double those of
  /// the depth lose their digits, or all; penetration and centre of pressure do not.
  Moments moments;
  double centre_s = 0, centre_t = 0;  ///< of pressure, kept within 0 and 1 for roundings
  ClippingError clipping_error;
  double left_out = 0;  ///< what was computed of it and makes no element, in (s, t)

  explicit VisiblePart(Index face) : slave_face(face) {}

  /// Otherwise it is too small, or not certain to exist.
  bool is_element() const { return area > 0 && penetration > 0; }
};

/// What one master face sees: all that its elements are made of, and their errors (fast/bounds/clipped_bound.h). What
/// it refers to is the scratch memory's, until the next face.
struct ClippedFace {
  Side master;
  Index face;
  FaceGeometry geometry;  ///< its normal sure
  /// None where the face has no area, and sees nothing.
  std::optional<MasterPrism> prism;
  const FaceView& view;
  const std::vector<VisiblePart>& parts;      ///< by slave face
  const std::vector<ElementMotion>& motions;  ///< of those that are elements, where they are asked for
  bool too_deep = false;                      ///< the line of the barycentre leaves the master first

  ClippedFace(Side of, Index index, const FaceGeometry& sure, const FaceView& seen,
              const std::vector<VisiblePart>& found, const std::vector<ElementMotion>& found_motions)
      : master(of), face(index), geometry(sure), view(seen), parts(found), motions(found_motions) {}

  /// The centre of pressure of a part, p0 + s (p1 - p0) + t (p2 - p0).
  Eigen::Vector3d foot_Me(const VisiblePart& part) const {
    return prism->p0_Me() + (part.centre_s * prism->edge_s_Me() + part.centre_t * prism->edge_t_Me());
  }
};

/// Scratch memory of clip_face.
struct ClippedFaceScratch {
  FaceViewScratch looking;
  FaceView view;
  std::vector<VisiblePart> parts;
  std::vector<ElementMotion> motions;
  std::vector<FaceExtent> by_low_s;  ///< of find_overlaps
  std::vector<Overlap> overlaps;
  std::vector<ConvexPolygon> polygons;   ///< the pieces that are left of the slave face at hand
  std::vector<ConvexPolygon> remaining;  ///< of subtract_hidden
  std::vector<ConvexPolygon> scaled;     ///< of depths next to the least double
  PartMotionScratch moving;
  LineNodes line_open;  ///< of the search along a line
};

/// Finds what a master face sees, and the parts that its elements are made of; how these move where that is asked for.
ClippedFace clip_face(const Intersection& intersection, Side master, Index face, const ContactLaw& law,
                      bool with_motions, ClippedFaceScratch& scratch);

/// Records what the face has beside elements.
void record_beside_elements(const ClippedFace& face, const ContactLaw& law, ElementRecord& record);

/// An element of the clipped scheme before the law.
struct ClippedElement {
  ElementFaces faces;
  double area = 0, penetration = 0;
  Eigen::Vector3d n_Me, foot_Me;  ///< the master face's outward normal; the centre of pressure
};

/// What one of several threads finds.
struct alignas(kApart) ClippedOfThread {
  ClippedFaceScratch face;
  std::vector<ClippedElement> found;
  std::vector<ElementMotion> motions;  ///< of those, where they are asked for
  ElementRecord beside;                ///< what faces have beside elements
};

/// Scratch memory of sum_clipped_elements.
struct ClippedScratch {
  ClippedFaceScratch face;
  ElementLanes lanes;
  FaceShares<ClippedOfThread> shares;
};

/// Forms the contact elements of a master in the clipped scheme (PCM section 6): for each active face e and each slave
/// face f one element, the part of e whose penetration lines leave the slave through f first, before they meet
/// another face of the master. Its area A_k, mean penetration u_k and centre of pressure are integrals over that part,
/// which need be neither convex nor connected, of the linear penetration u, or of min(u, max_penetration) where the law
/// clamps it. Recorded and summed as in the barycentric scheme; elements by master face, then slave face.
///
/// Degenerate cases: a face of the slave with the same normal that lies in e's plane is met at distance 0, so u = 0
/// there (flush faces: the force jumps when the pose passes through); one of opposite normal in e's plane carries
/// nothing and hides what is behind it. Slivers of rounding size may appear or not, their share is as small. Parts
/// whose area or penetration underflows to 0 make no element. Error against the rounded problem: that of lines and
/// depths moved by a few ulps of the greatest coordinate S (fast/clipped/visible_parts.h), so relative to the sum of
/// |F_k| a few ulps times S over the mean penetration, or over the width of what is seen where that is less; flush and
/// nearly flush faces included. Cost: near O(log n + overlapping faces) a master face; parts are cut only where sheets
/// overlap. Where there are many faces all threads of the team look through them; one applies the law and sums.
MasterForce sum_clipped_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                 PosedTeam& team, ClippedScratch& scratch, ElementRecord& record);

}  // namespace pcm::fast
