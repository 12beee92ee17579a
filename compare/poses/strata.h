// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/poses/surface_features.h"
#include "compare/random/random.h"
#include "pcm/inputs.h"

/// The strata that verification poses are drawn from (DESIGN section 4). A pose is a pure function of (seed, stratum,
/// pair, pose number) and of the two meshes.
namespace pcm::compare {

/// A new one takes a value here, at the end of those that are drawn, for its number is part of what random numbers are
/// drawn from, and a place in kStrata; a row in strata.cpp; and a function that draws a pose, declared in `detail`
/// below (strata_generic.cpp, ...; CMakeLists.txt). Help texts, tables and most tests go over all of them;
/// docs/verification.md and DESIGN section 4 list them, and tests of the judge count them (tests/compare/cli/judge,
/// tests/compare/judge/poses, tests/compare/contestants).
enum class Stratum : std::uint8_t {
  generic,          ///< uniform rotation, penetration log-uniform between 1e-6 and 0.5 of the smaller body's size
  grazing,          ///< the same, penetration between 1e-15 and 1e-6
  separated,        ///< bounding boxes overlap, surfaces do not
  nested,           ///< one body inside the other, no crossing
  degenerate,       ///< features coincide exactly
  near_degenerate,  ///< degenerate, then moved by 1 to 8 ulps
  extreme,          ///< surfaces taken to the ends of what doubles hold (extreme_meshes.h), in poses of all these kinds
  adversarial,      ///< several features within roundings of each other, in no special place, and not onto each other
  trajectory,       ///< along what a simulation went through (recorded_motion.h), or just as one recorded it
                    ///< (compare/verify/run/trajectory.h)
};

/// Those that poses of any two surfaces are drawn from.
inline constexpr std::array kStrata = {Stratum::generic, Stratum::grazing,    Stratum::separated,
                                       Stratum::nested,  Stratum::degenerate, Stratum::near_degenerate,
                                       Stratum::extreme, Stratum::adversarial};

/// Those that ask no more than most engines say they can do: surfaces of ordinary sizes and shapes, and poses that were
/// not searched for.
inline constexpr std::array kUsualStrata = {Stratum::generic, Stratum::grazing,    Stratum::separated,
                                            Stratum::nested,  Stratum::degenerate, Stratum::near_degenerate};

/// The word of DESIGN section 4, e.g. "near-degenerate".
std::string_view name(Stratum stratum);
/// Of all: "generic, grazing, ...".
std::string strata_names();
std::optional<Stratum> stratum_named(std::string_view word);

/// True of the strata whose poses are made to hurt, so that small surfaces show as much as large ones.
bool hard(Stratum stratum);

/// Where F is, seen from E, and how it moves.
struct MovingPose {
  Pose pose;
  Velocity velocity;
};

/// A pose and how it came about.
struct DrawnPose {
  Pose pose;
  Velocity velocity;
  std::string_view construction;  ///< e.g. "vertex on edge"
  /// Degenerate poses: the features coincide in both problems without rounding (`false`: only nearly so).
  bool exact = false;
  std::vector<MovingPose> before;  ///< stratum trajectory: how F came here, in the order of time
};

/// A pair made fit for the stratum nested: the guest is scaled by a power of two, hence exactly, until it fits into a
/// ball inside the host. The host is the closed surface with the larger ball for its guest. None where neither surface
/// is closed or no ball was found.
struct NestedMeshes {
  TriangleMesh E;
  TriangleMesh F;
  InnerBall ball;
  Side host = Side::E;
};
std::optional<NestedMeshes> nested_meshes(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F);

/// Two surfaces as the strata see them.
struct FeaturePair {
  FeaturePair(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : E(mesh_E), F(mesh_F) {}
  explicit FeaturePair(const NestedMeshes& meshes) : E(meshes.E), F(meshes.F), ball(meshes.ball), host(meshes.host) {}

  /// Size of the smaller body, m.
  double size() const { return E.size < F.size ? E.size : F.size; }

  SurfaceFeatures E;
  SurfaceFeatures F;
  InnerBall ball;       ///< stratum nested only: where the guest goes
  Side host = Side::E;  ///< stratum nested only: whose ball it is
};

/// Draws one pose. `random` must be fresh. Stratum nested asks for a pair made of `NestedMeshes`, extreme
/// for one of `extreme_meshes`.
/// Throws std::logic_error for `trajectory`, which wants a recording (recorded_motion.h).
/// Cost: O(n) in the number of vertices.
DrawnPose draw_pose(Stratum stratum, const FeaturePair& pair, PoseRandom random);

namespace detail {
DrawnPose draw_overlapping(const FeaturePair& pair, double least, double greatest, PoseRandom& random);
DrawnPose draw_separated(const FeaturePair& pair, PoseRandom& random);
DrawnPose draw_nested(const FeaturePair& pair, PoseRandom& random);
DrawnPose draw_degenerate(const FeaturePair& pair, PoseRandom& random);
/// With a rotation that is none by up to 1e-9, and features that coincide all the same in the rounded problem.
DrawnPose draw_drifted(const FeaturePair& pair, PoseRandom& random);
DrawnPose draw_extreme(const FeaturePair& pair, PoseRandom& random);
DrawnPose draw_adversarial(const FeaturePair& pair, PoseRandom& random);
void move_by_ulps(const FeaturePair& pair, PoseRandom& random, DrawnPose& drawn);
}  // namespace detail

}  // namespace pcm::compare
