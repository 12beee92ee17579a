// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "fast/surface/prepared_surface.h"
#include "pcm/inputs.h"

namespace pcm::fast {

/// How many contact elements are computed at once.
inline constexpr std::size_t kElementLanes = 4;

/// Four numbers.
struct alignas(32) DoubleLanes {
  std::array<double, kElementLanes> value{};
};

/// Four vectors in Me, by component.
struct VectorLanes {
  std::array<DoubleLanes, 3> component;

  Eigen::Vector3d operator[](std::size_t lane) const {
    return {component[0].value[lane], component[1].value[lane], component[2].value[lane]};
  }
  void set(std::size_t lane, const Eigen::Vector3d& v) {
    for (std::size_t k = 0; k < 3; ++k) component[k].value[lane] = v[static_cast<Eigen::Index>(k)];
  }
};

/// Where the corners of four faces are, by corner: three coordinates in Me each. The lanes are filled from there in one
/// go; number by number they would have to reach memory before they could be read as vectors.
using CornerLanes = std::array<std::array<const double*, kElementLanes>, 3>;

/// Some of the lanes: bit i is lane i.
using LaneBits = std::uint32_t;
inline bool has_lane(LaneBits bits, std::size_t lane) {
  return (bits >> lane & 1U) != 0;
}

/// Four elements as they were found: all of them that `force` and `tangent` read.
struct FoundLanes {
  VectorLanes n_Me, barycentre_Me;  ///< of the master faces; in the clipped scheme the centre of pressure
  DoubleLanes area, depth;
  /// How the depth grows as the slave's face moves, 0 where it is clamped; where a tangent is wanted.
  VectorLanes depth_gradient_Me;
};

/// Four master faces of the barycentric scheme, the slave faces that they were matched with, and their elements.
struct ElementLanes : FoundLanes {
  CornerLanes master_corners{};
  // What `geometry` fills, beside n_Me, barycentre_Me and area.
  std::array<VectorLanes, 3> p_Me;  ///< corners of the master faces
  std::array<DoubleLanes, 2> side;  ///< 1-norms of p1 - p0 and p2 - p0, m
  // For `leave` and `decide`.
  CornerLanes slave_corners{};
  DoubleLanes thickness;                             ///< of the master faces, fast/surface/thickness.h, m
  std::array<Clearance, kElementLanes> clearance{};  ///< of the slave faces
  /// So far along the line no other face of the slave is met, whatever the clearance says, m; infinite: nowhere.
  DoubleLanes slave_free;
  // `decide` fills depth.
  // What `force` fills: see Element; the torque is about Mf.
  DoubleLanes normal_velocity, tangential_velocity, normal_force, tangential_force;
  VectorLanes position_Me, force_Me, torque_Me;
};

/// How four elements of the clipped scheme change as the slave's face moves: fast/force/element_motion.h.
struct ElementMotionLanes {
  struct Slope {
    VectorLanes by_position, by_rotation;
  };
  Slope area, depth, s, t;
  VectorLanes edge_s_Me, edge_t_Me;
};

/// Four matrices, entry (i, j) at 3 i + j.
using MatrixLanes = std::array<DoubleLanes, 9>;

/// Sums over elements, lane by lane, of which a tangent is made: fast/force/tangent_sum.h.
struct TangentLanes {
  MatrixLanes force_by_position, force_by_rotation, force_by_velocity, force_by_lever;
  MatrixLanes torque_by_position, torque_by_rotation, torque_by_velocity, torque_by_lever;
};

/// What `leave` and `decide` compare with.
struct DecisionLimits {
  double least_share = 0;           ///< of two sides' product, that a face's area exceeds
  double max_coordinate = 0;        ///< of both surfaces in Me, m
  double slave_max_coordinate = 0;  ///< unit of Clearance::beneath, m
  double error = 0;                 ///< of distances, m
  double thick_edges = 0;           ///< the thickness of a master face holds where this times both sides is less than
  double thick_area = 0;            ///< this times its area
  std::array<double, 2> cone_cosine_square{};
};

/// Whether the line of each face passes through its slave face from within the slave's body, at whatever distance;
/// lanes in neither are not decided.
struct LeavingLanes {
  LaneBits surely = 0;
  LaneBits surely_not = 0;
};

/// What the line of each face finds; all lanes in none of them are not decided.
struct DecidedLanes {
  LaneBits nothing = 0;        ///< meets no face
  LaneBits left = 0;           ///< surely leaves the slave's body through its face f, at a distance greater than 0
  LaneBits element = 0;        ///< and meets nothing before: an element
  LaneBits nearest_known = 0;  ///< its depth is in `depth`; else two corners of f are about as near to the barycentre
  // Why no more is decided:
  LaneBits oblique = 0;  ///< it is too far off the normal of f, or f is a needle
  LaneBits thin = 0;     ///< the master's face is not surely thicker than the distance
};

/// The law and the motion as `force` takes them, see fast/force/force_problem.h.
struct ForceLimits {
  ContactLaw law;
  double c_l = 0;
  double shift = 0;  ///< of the element from the master's surface, relative to the penetration (13)
  bool master_E = true;
  bool with_velocities = false;
  std::array<double, 3> r_Me{}, v_Me{}, w_Me{};  ///< of Mf: position, velocity, angular velocity of F
};

/// The steps from faces to forces, compiled for one set of instructions, in the order of operations of FaceGeometry,
/// DepthBelow and apply_force: never fused, so that all sets give the bits of these. `geometry` finds barycentres and
/// sides in all lanes and returns those whose area and normal it found; `force` returns the lanes it filled. The
/// numbers in others are too large or too small for them. `depth` fills the depths to the slave faces at slave_corners
/// and returns the lanes where that is right: in others two corners are about as near to the barycentre. `gradient`
/// fills depth_gradient_Me, of slave faces at slave_corners, in all lanes; `tangent` adds what elements with their
/// forces make of it, in those asked for, and `tangent_of_parts` what they make of the motions given.
struct WideElements {
  LaneBits (*geometry)(ElementLanes& lanes);
  LeavingLanes (*leave)(const ElementLanes& lanes, const DecisionLimits& limits);
  DecidedLanes (*decide)(ElementLanes& lanes, const DecisionLimits& limits);
  LaneBits (*depth)(ElementLanes& lanes);
  LaneBits (*force)(ElementLanes& lanes, const ForceLimits& limits);
  void (*gradient)(ElementLanes& lanes);
  void (*tangent)(const ElementLanes& lanes, const ForceLimits& limits, LaneBits which, TangentLanes& sums);
  void (*tangent_of_parts)(const ElementLanes& lanes, const ElementMotionLanes& motion, const ForceLimits& limits,
                           LaneBits which, TangentLanes& sums);
};

}  // namespace pcm::fast
