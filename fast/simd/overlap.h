// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fast/posed/placement.h"
#include "fast/prism/master_prism.h"
#include "fast/simd/pairs.h"
#include "fast/surface/wide_tree.h"

namespace pcm::fast {

/// A pose between the coordinates of two wide trees, in single precision: x_E = rotation (scale x_F) + shift, with what
/// keeps tests of boxes and planes conservative for all positions of F's vertices within their rounding.
///
/// Let v = 2^-24 and let G be the sum of both radii in E's coordinates. Along an axis of E no point of F is farther
/// than G from F's origin, and that no farther than G from E's, once the root boxes were found to touch. A point of F
/// is a sum of four terms, three roundings in each product and three sums: off by 8 v G; less a centre of E: 11 v G;
/// half widths and their sums lose less than 8 v G. Turned back into F's axes, the columns of A, whose absolute sums
/// are at most sqrt(3): 34 v G in all. So 64 v G covers boxes. A plane n . (x - p) = 0 whose normal is off by 8 v (A
/// off a rotation included) and x, p by 8 v G and v G, where no |x - p| exceeds 3.5 G, errs by 100 v G at most: 128 v
/// G. The roundings of double precision are those of Placement. They also tilt the plane of a face of F: by no more
/// than their double over its least height, over a length of 2 G.
///
/// The sign of (b x c) . d, b and d edges of a face of E and of one of F whose boxes touch, c from a corner to a
/// corner: with beta, gamma and zeta no less than |b|, |c| and |d|, 1-norms, vectors off by delta in each component
/// cost at most delta (gamma zeta + beta zeta + beta gamma). b is off by 2 v G, c by 9 v G, d by 16 v G. Eight
/// roundings take 8 v beta gamma zeta, at most a third of that sum times 8 v 3.5 G. So 32 v G covers both.
///
/// With a margin boxes and planes part faces at all poses at which no point of F is farther than that from where it is
/// here: a point that both faces have then is no farther from either here. Which edges pass through the other face
/// holds at these poses as well. F's corners are off by the margin before E's plane; c is off by as much and d by twice
/// as much; and where all of a side of the face of E is farther than the margin from the other face's plane here, no
/// point of that face comes to it. Only the sides on which corners of E lie hold here alone: the plane of a small face
/// moves farther, far from it. With margins of no more than G / 8, and Tracking asks for no greater ones, the shift is
/// no more than 9 G / 8, and the above are 39, 113 and 29 v G: within the same bounds.
///
/// Where F is so much larger than E that numbers might overflow, all errors are infinite, so that everything is
/// possible.
struct WidePose {
  std::array<std::array<float, 3>, 3> rotation{};
  std::array<std::array<float, 3>, 3> rotation_absolute{};
  std::array<float, 3> shift{};
  float scale = 1;        ///< F's unit over E's
  float box_error_E = 0;  ///< of boxes along E's axes
  float box_error_F = 0;  ///< along F's
  float plane_error = 0;  ///< a point this far from a plane, or farther, surely is on that side
  float edge_error = 0;   ///< delta above; infinite where products of three lengths might overflow

  WidePose() = default;
  /// `margin` in m.
  WidePose(const WideTree& E, const WideTree& F, const Placement& placement, double margin = 0);
};

/// A penetration line in the coordinates of a wide tree, in single precision. It stands for all lines whose points are
/// within a given distance of its own, and for all surfaces whose points are that near to the tree's.
///
/// Let G bound |x| + |y| + |z| of the tree's points and of the line's origin, added up. Positions are off by 3 v G; a
/// box is entered at the greatest of three quotients, off by less than 24 v G where it is not out of reach: boxes that
/// grow by 64 v G are entered no later than the true ones. A face is passed at a distance, times an edge's length, off
/// by 8 v G times that length and 8 v G more for the positions: 64 v G covers both, outside and inside. Where the
/// origin is so far off that numbers might overflow, that error is infinite.
struct WideRay {
  std::array<float, 3> origin{};
  std::array<float, 3> direction{};
  std::array<float, 3> inverse{};  ///< of the direction's components; those near 0 count as 2^-60
  float box_error = 0;

  /// Origin and direction in the frame of the tree's surface, `distance` in m.
  WideRay(const WideTree& tree, const Eigen::Vector3d& ray_origin, const Eigen::Vector3d& ray_direction,
          double distance);
};

/// A prism in the coordinates of a wide tree, in single precision: four half spaces axis . x >= offset, and the depth
/// at which it ends.
///
/// Axes have unit length. With v = 2^-24 and G the tree's radius, the scalar product with a box's centre, that with its
/// half widths and their sum are off by less than 12 v G, an offset by v times itself: 16 v (G + |offset|) covers them.
struct WidePrism {
  std::array<std::array<float, 3>, 4> axis{};  ///< inward from the three sides, then downward
  std::array<std::array<float, 3>, 4> axis_absolute{};
  std::array<float, 4> offset{};  ///< less its error
  float deepest = 0;              ///< greatest axis . x of the last, with its error

  /// `deepest` in m.
  WidePrism(const WideTree& tree, const TreePrism& prism, double deepest_depth);
};

/// Which of E's children may touch which of F's: bit 8 j + i is child i of E with child j of F.
using LanePairs = std::uint64_t;

/// What surely is so of two faces, bit by bit.
class SureSigns {
 public:
  // kAboveOfE + k: corner k of E's face is above the plane of F's; kAboveOfF + k the reverse. The lone corner of a face
  // is alone on its side of the other's plane. kPassing + 0: the edge from the lone corner of E's face passes through
  // F's face, + 1: the edge to it does; + 2 and + 3: the same of F's face.
  enum Bit : unsigned { kAboveOfE = 0, kAboveOfF = 3, kPassing = 6, kSureOfE = 10, kSureOfF = 11, kSureOfPassing = 12 };

  SureSigns() = default;
  explicit SureSigns(std::uint32_t bits) : bits_(bits) {}

  bool of_E() const { return has(kSureOfE); }  ///< of E's face against the plane of F's
  bool of_F() const { return has(kSureOfF); }
  bool of_passing() const { return has(kSureOfPassing); }  ///< of all three
  unsigned above_of_E() const { return bits_ >> kAboveOfE & 7U; }
  unsigned above_of_F() const { return bits_ >> kAboveOfF & 7U; }
  unsigned passing() const { return bits_ >> kPassing & 15U; }

 private:
  bool has(Bit bit) const { return (bits_ >> bit & 1U) != 0; }
  std::uint32_t bits_ = 0;
};

/// Pairs of faces of two bottom nodes.
struct FacePairs {
  LanePairs possible = 0;  ///< all others have boxes that are apart, or one surely is on one side of the other's plane
  int rows = 0, live = 0;  ///< faces of F that were tested against E's, and pairs of these whose boxes touch
  std::array<std::uint32_t, kLanes * kLanes> bits;  ///< of SureSigns, where possible; else not filled

  SureSigns signs(int pair) const { return SureSigns(bits[static_cast<std::size_t>(pair)]); }
};

/// Faces and a line, bit by bit.
struct FacesMet {
  std::uint32_t possible = 0;  ///< all others surely are missed
  std::uint32_t leaving = 0;   ///< surely passed through, from inside: along their normal
  std::uint32_t entering = 0;  ///< surely passed through, from outside
};

/// The tests, compiled for one set of instructions. Plain multiplications and additions only, never fused: all sets
/// give the same bits. False only for what is apart in every position of F's vertices within their rounding.
struct WideTests {
  /// Boxes of two nodes' children.
  LanePairs (*boxes)(const WideNode& E, const WideNode& F, const WidePose& pose);
  /// The box of F itself against those of E's children (bits 0 to 7), and the reverse.
  std::uint32_t (*children_of_E)(const WideNode& E, const WideNode& F, const WidePose& pose);
  std::uint32_t (*children_of_F)(const WideNode& E, const WideNode& F, const WidePose& pose);
  /// Faces of two bottom nodes: their boxes along E's axes, on which side of the other's plane their corners lie, and
  /// which edges pass through the other face.
  FacePairs (*faces)(const WideNode& E, const FaceGroup& faces_E, const WideNode& F, const FaceGroup& faces_F,
                     const WidePose& pose);
  /// Children whose boxes the ray may meet, and how far along it at least.
  std::uint32_t (*boxes_met)(const WideNode& node, const WideRay& ray, Lanes& entry);
  /// Children whose boxes may have a point in the prism.
  std::uint32_t (*boxes_in_prism)(const WideNode& node, const WidePrism& prism);
  /// Faces that the line, taken as infinite both ways, passes through.
  FacesMet (*faces_met)(const FaceGroup& faces, const WideRay& ray);
  /// Pairs of faces in double precision.
  LookAtPairs pairs;
};

}  // namespace pcm::fast
