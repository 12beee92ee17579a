// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "fast/bounds/face_enclosure.h"
#include "fast/bounds/prism_error.h"
#include "fast/bounds/visible_depth.h"
#include "fast/clipped/clipped_elements.h"
#include "fast/posed/transform.h"
#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

/// How far the integrals over the parts of one master face, as computed, may be from the exact problem's (PCM sections
/// 1 and 6, clipped scheme).
///
/// Both problems, and what is computed, see the same face first at every point (s, t) of the master but those near a
/// line where that is decided. So the part that belongs to a face f has an area off by no more than the strips
///
///   - along the border of f, and of every face g that may lie before f over it, as wide as it may be shifted;
///   - where f's own depth is 0, or g's: within the errors of that depth;
///   - where f and g may lie at one depth: within both errors.
///
/// A strip costs its area times the greatest depth of f, except where f's own depth is near 0; and elsewhere f's depth
/// is off by no more than its error. Where nothing is sure over all that f and g have in common, g lies nearly flush
/// with f or with the master: all of it counts. Roundings of cuts and integrals count as position errors
/// (fast/bounds/face_enclosure.cpp, fast/bounds/uncertain_strips.cpp). What the engine knowingly leaves out is added
/// (ClippingError).
///
/// Where the law clamps the depth u to u_max, point by point, |min(u, u_max) - min(u', u_max)| <= |u - u'|: all of this
/// holds of the integrals of the clamped depth as well, and no area costs more than itself times u_max. Where a part is
/// cut at u_max, that cut has roundings of its own (fast/bounds/clipped_error.cpp).
class ViewError {
 public:
  ViewError(ViewScratch& scratch, const MasterPrism& prism, const PrismError& error, const ContactLaw& law)
      : scratch_(&scratch),
        prism_(prism),
        error_(error),
        continuous_(law.damping == 0 && law.friction == 0),
        greatest_allowed_(law.max_penetration) {
    scratch.sights.clear();
  }

  /// Any face that the master's prism may meet, ascending, the slave's first. `projected`: as the engine sees it, where
  /// it does.
  void see(PosedSurface& surface, Index face, bool of_master, const SeenCorners& corners,
           const ProjectedFace* projected, WorkCounters& work);
  /// No part is seen deeper in either problem, before clamping; less than 0 where no face may carry anything, m.
  double greatest_depth() const { return greatest_depth_; }
  /// No face of the master itself need be entered, but its lines deviate from where it would be so by up to this times
  /// the depth: upright faces beside its prism may hide as much.
  void may_lean(double lean) { lean_ = lean; }
  /// To be called once all faces are entered.
  void compare(const PreparedSurface& slave, const PreparedSurface& master);

  /// What was computed of this part makes no element.
  void leave_out(const VisiblePart& part);
  /// Errors of the element made of a part.
  ElementError of_element(const VisiblePart& part, const FaceError& face);

  /// What the exact problem may have beside the computed elements.
  struct Beside {
    double area = 0;                            ///< in (s, t)
    double volume = 0;                          ///< integral of the depth, clamped, m
    double depth = 0;                           ///< no deeper, clamped, m
    double passed_area = 0, passed_volume = 0;  ///< of these, what may pass between them and the computed ones
  };
  Beside beside() const;

  /// Of what the exact problem sees, before clamping (fast/bounds/visible_depth.h).
  DepthRange visible_depth(double computed, double floor, VisibleDepthScratch& scratch) const;

  /// Otherwise there is no such bound: the master's vertices, or those of a face in view, may move by more than a small
  /// part of the master's width.
  bool known() const { return known_; }
  /// Whether a face is seen flush: elements with a force of any size may be others.
  bool flush() const { return flush_; }

 private:
  double clamped(double depth) const { return std::min(depth, greatest_allowed_); }
  /// An integral of the depth over no more than this area, where that is nowhere greater than `greatest`, m.
  double clamped_volume(double volume, double area, double greatest) const {
    return greatest > greatest_allowed_ ? std::min(volume, area * greatest_allowed_) : volume;
  }
  void measure_alone(FaceInView& sight, const PreparedSurface& slave);
  void compare_pair(FaceInView& f, FaceInView& g, const PreparedSurface& slave, const PreparedSurface& master);
  /// Adds what g, which has no more than the area `overlap` in common with f, may hide of it.
  void charge(FaceInView& f, const FaceInView& g, const BoxST& box, double overlap);
  std::array<double, 3> weights_within(double distance) const;
  double area_leant_over(const FaceEnclosure& f) const;
  void find_outline(FaceInView& sight, const PreparedSurface& surface);
  FaceInView* find(bool of_master, Index face) const;

  ViewScratch* scratch_;
  const MasterPrism& prism_;
  const PrismError& error_;
  /// Forces are sums of integrals of the depth, whatever elements these are parted into: only lines where the depth
  /// itself jumps count for them.
  bool continuous_;
  double greatest_allowed_;  ///< u_max, m
  double lean_ = 0;
  double greatest_depth_ = -1;
  bool known_ = true;
  bool flush_ = false;
};

}  // namespace pcm::fast
