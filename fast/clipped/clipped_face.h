// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "fast/clipped/face_view.h"
#include "fast/clipped/visible_parts.h"
#include "fast/force/element_sum.h"
#include "fast/search/line_search.h"

namespace pcm::fast {

/// The part of a master face whose penetration lines leave the slave through one and the same face of it.
struct VisiblePart {
  Index slave_face = 0;
  double area = 0;         ///< A_k, m^2; 0 where it is not certain that there is a part
  double penetration = 0;  ///< u_k, mean of the clamped depth, m
  Moments moments;         ///< of min(depth, max_penetration); area and greatest depth are none of the clamp's
  ClippingError clipping_error;
  double left_out = 0;  ///< what was computed of it and makes no element, in (s, t)

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
  const std::vector<VisiblePart>& parts;  ///< by slave face
  bool too_deep = false;                  ///< the line of the barycentre leaves the master first

  /// The element that a part makes, but for its force.
  Element element(const VisiblePart& part) const {
    Element element;
    element.master = master;
    element.master_face = face;
    element.slave_face = part.slave_face;
    element.area = part.area;
    element.penetration = part.penetration;
    element.normal_Me = -geometry.n_Me;
    return element;
  }
  /// Its centre of pressure, p0 + s (p1 - p0) + t (p2 - p0), within the face.
  Eigen::Vector3d foot_Me(const VisiblePart& part) const {
    const double s = std::clamp(part.moments.s_depth / part.moments.depth, 0.0, 1.0);
    const double t = std::clamp(part.moments.t_depth / part.moments.depth, 0.0, 1.0);
    return prism->p0_Me() + (s * prism->edge_s_Me() + t * prism->edge_t_Me());
  }
};

/// Scratch memory of clip_face.
struct ClippedFaceScratch {
  FaceViewScratch looking;
  FaceView view;
  std::vector<VisiblePart> parts;
  std::vector<std::size_t> order;  ///< of find_overlaps
  std::vector<Overlap> overlaps;
  std::vector<ConvexPolygon> polygons;   ///< the pieces that are left of the slave face at hand
  std::vector<ConvexPolygon> remaining;  ///< of subtract_hidden
  LineNodes line_open;                   ///< of the search along a line
};

/// Finds what a master face sees in the clipped scheme (fast/clipped/clipped_elements.h).
ClippedFace clip_face(PosedPair& posed, Side master, Index face, const ContactLaw& law, ClippedFaceScratch& scratch);

/// Records what the face has beside elements.
void record_beside_elements(const ClippedFace& face, const ContactLaw& law, ElementRecord& record);

}  // namespace pcm::fast
