// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fast/bounds/box_st.h"
#include "fast/prism/convex_polygon.h"
#include "fast/prism/master_prism.h"
#include "fast/prism/prism_position_error.h"
#include "pcm/triangle_mesh.h"

namespace pcm::fast {

class PrismError;

/// A linear function of (s, t): a depth, m.
struct LinearDepth {
  double value = 0, s_0 = 0, t_0 = 0;  ///< at this point
  double per_s = 0, per_t = 0;         ///< gradient

  double at(double s, double t) const { return value + (per_s * (s - s_0) + per_t * (t - t_0)); }
  /// Values over a box: their middle, and how far they go to either side of it.
  double middle(const BoxST& box) const {
    return value + (per_s * (0.5 * (box.low_s + box.high_s) - s_0) + per_t * (0.5 * (box.low_t + box.high_t) - t_0));
  }
  double half_range(const BoxST& box) const {
    return 0.5 * (std::abs(per_s) * box.width_s() + std::abs(per_t) * box.width_t());
  }
};

/// Where a face may be seen over the master face, in the rounded problem and in the exact one (PCM section 1), and how
/// far its border and its depth there may be off. A point (s, t) of the master that does not lie within
/// `position_error` of the projected border is covered by the face in both problems or in neither; where it is, both
/// depths are within `depth_error` of `depth`.
struct FaceEnclosure {
  Index face;
  bool of_master;               ///< of the master
  Eigen::Vector3d rounding_Me;  ///< how far its vertices may be from the exact problem's, m
  int facing;                   ///< -1: the lines leave the face's body there; +1: they enter; 0: not sure
  std::array<Index, 3> vertices;
  std::array<PrismPoint, 3> corners;  ///< of `vertices`, counterclockwise in (s, t)
  BoxST box;  ///< holds all of it that is over the master face at a depth >= 0, in both problems
  PrismPositionError position_error;  ///< of its points over the master face
  PrismPositionError cut_error;       ///< of its border, by roundings of the cuts that shape it alone
  PrismRounding rounding;             ///< roundings of its vertices as they are seen
  std::array<bool, 3> fixed;          ///< corners that are the master's own
  bool knows_sides;                   ///< find_side_errors was called
  std::array<double, 3> side_error;   ///< of side k over the master: (side k) x (displacement) in (s, t)
  std::array<double, 3> side_cuts;    ///< and by roundings where it is cut itself
  double third_side_error;            ///< of the master's side where s + t = 1, as cuts have it: of s + t
  PrismPositionError vertex_error;    ///< of its vertices
  PrismPositionError corner_error;    ///< of its corners, in s and t, but for an affine map of the plane
  LinearDepth depth;                  ///< its plane, where facing is sure
  double field_error;                 ///< of the depth at its points, m
  double line_error;                  ///< of the depth where faces are cut along it, m
  double depth_error;                 ///< of the plane as it is computed here, m
  double greatest;                    ///< it is seen nowhere deeper, m
  /// Of a face that stands on corners of the master: the height of its other corners beneath, m, and how far these may
  /// be shifted; 0 otherwise. At a depth d it is shifted by no more than d over that height times as much.
  double hinge_depth;
  PrismPositionError hinge_error;
  /// It has a corner of the master, and wherever else it is over the master it is deeper than 0, in both problems.
  bool only_hangs;
  double sliver;             ///< where facing is not sure: its area as computed
  double relative_rounding;  ///< of a linear function that is given by its values at the corners
  double crossing_rounding;  ///< how far off the line may be, m over m, where this plane meets a face that far away

  FaceEnclosure() {}
};

/// An enclosure together with what is found out about the element it may carry (fast/bounds/clipped_error.h).
struct FaceInView {
  FaceEnclosure enclosure;
  const ProjectedFace* projected = nullptr;  ///< the face as the engine sees it, where it does
  bool may_carry = false;
  bool has_element = false;
  bool knows_outline = false;
  std::array<bool, 3> outline{};  ///< sides beyond which the surface does not go on as it does here
  double sheet_error = 0;         ///< greatest depth_error of the face and of those beyond its other sides, m
  double passed_area = 0;         ///< that other faces of the sheet may see instead, in (s, t)
  double passed_volume = 0;       ///< integral of the depth there, m
  double area_error = 0;          ///< beside that, of the part of the master that sees it, in (s, t)
  double volume_error = 0;        ///< of the integral of its depth over that part, m

  FaceInView() {}  // Defaulted, it would have the whole enclosure set to 0 first.
};

/// Scratch memory.
struct ViewScratch {
  std::vector<FaceInView> sights;
  std::vector<std::size_t> order;
};

/// Whether the face certainly lies beyond one of the master's sides or above it, in both problems: a first test.
bool surely_unseen(const PrismError& error, bool of_master, const std::array<PrismPoint, 3>& corners);

/// A face of either surface as a master face sees it.
struct FaceInPrism {
  Index face;
  bool of_master;  ///< of the master
  std::array<Index, 3> vertices;
  std::array<Eigen::Vector3d, 3> points_Me;
  std::array<PrismPoint, 3> corners;
  std::array<bool, 3> shared;   ///< which of them are the master face's own
  Eigen::Vector3d rounding_Me;  ///< how far its vertices may be from the exact problem's, m
};

/// How far the weights of p0, p1 and p2 at a point may be off that is itself off by `off` in s and t. `third`: of the
/// weight of p0 by itself (PrismRounding).
inline std::array<double, 3> weight_errors(const PrismPositionError& off, double third) {
  return {off.s + off.t + third, off.s, off.t};
}

/// False where the face is certainly not seen, in neither problem.
bool find_face_enclosure(const PrismError& error, const FaceInPrism& seen, FaceEnclosure& enclosure);

/// Fills side_error and side_cuts, unless they are.
void find_side_errors(const PrismError& error, FaceEnclosure& enclosure);

/// No more than this area of the master is covered by the face, in either problem.
double greatest_area(const FaceEnclosure& face);

/// What is certain, in both problems, of the order in which the lines meet two faces wherever they meet both.
enum class CertainOrder : std::uint8_t { before, after, unsure };
/// Of g against f. Decided as the engine decides it, by the sides of a face's plane that the other's vertices lie on;
/// those that both share lie on both planes.
CertainOrder certain_order(const FaceEnclosure& g, const FaceEnclosure& f);

}  // namespace pcm::fast
