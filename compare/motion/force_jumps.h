// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "compare/motion/path_force.h"

namespace pcm::compare {

/// Why a master face's force jumps.
enum class JumpCause : std::uint8_t {
  edge,      ///< the barycentre's line passed an edge of the slave and leaves through another face, not adjacent there
  entry,     ///< the barycentre entered or left the slave other than through the face its line leaves by
  activity,  ///< the face became active, or no longer is
  depth,     ///< the line leaves the master before the slave on one side: the body is too thin there
  flush,     ///< a slave face of the same normal passed through the face's plane
  other,     ///< none of these
};
inline constexpr std::array kJumpCauses = {JumpCause::edge,  JumpCause::entry, JumpCause::activity,
                                           JumpCause::depth, JumpCause::flush, JumpCause::other};
std::string_view name(JumpCause cause);      ///< one word
std::string_view describe(JumpCause cause);  ///< in a few words

/// What one master face's force does at a jump. Forces in mode `both` are the face's share in the mean.
struct FaceJump {
  FaceLoad before, after;  ///< no slave faces where it carries nothing
  JumpCause cause = JumpCause::other;
  double size = 0;        ///< by how much, N: see ContinuousChange::change
  double continuous = 0;  ///< at most this much of that can be continuous, N

  const FaceLoad& loaded() const { return before.slave_faces.empty() ? after : before; }
  Eigen::Vector3d force_Me() const { return after.force_Me - before.force_Me; }
};

/// A jump of the elastic force between two places that are neighbours on the grid (pose_path.h); at a flush pose
/// between places as near to it as rounding tells.
struct ForceJump {
  PathPoint before, after;
  Pose pose_before, pose_after;
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< sum of the faces' jumps, on E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on E about Mf, N m
  double force_there = 0;                               ///< greater |F| of both sides, N
  std::vector<FaceJump> faces;                          ///< the greatest first

  double size() const { return force_Me.stableNorm(); }
  /// Share of the force there: at most 2, where the force turns round. 0 where there is none on either side.
  double relative() const { return force_there > 0 ? size() / force_there : 0; }
};

/// What the walk along a path yields beside the jumps, place by place.
struct PathForcePoint {
  PathPoint where;
  Eigen::Vector3d r_Me;
  Eigen::Vector3d force_Me, torque_Me;  ///< on E, the torque about Mf
  bool step = false;                    ///< one of the places asked for, not one looked at in search of a jump
  bool after_jump = false;              ///< between this place and the one before it lies a jump, and nothing else
};

/// How a path is walked.
struct JumpSearch {
  std::int64_t steps = 64;  ///< a segment
  double least = 1e-9;      ///< jumps below this share of the greatest force on the path are not looked for
};

struct PathWalk {
  std::vector<ForceJump> jumps;        ///< in the order of the path
  std::vector<PathForcePoint> points;  ///< in the order of the path
  Index most_too_deep = 0;             ///< greatest number of faces too deep at a step
  std::int64_t evaluations = 0;
};

/// Walks a path in steps and finds the jumps of the elastic force between them.
///
/// What is a jump. Decisions of the engine are exact, so a face's force jumps only where a discrete fact changes: in
/// the barycentric scheme, which slave face its line leaves through, or none; in the clipped scheme, whether it carries
/// anything at all, and a pass through a flush pose, whose places are known beforehand (flush_places.h) and looked at
/// from both sides. A step over
/// which such a fact changes is halved, and so is each half over which it does, until both ends are neighbours on the
/// grid; or until the force of each face concerned changes by less than `least` allows to ignore, or no more than
/// passing the common edge of two slave faces can make it, which is continuous. At neighbours
/// the change is a jump where it exceeds what continuous motion allows: between both poses no point of F moves farther
/// than d, so the depth along a line to one plane changes by at most d / |n_e . n_f|, and where the line passes to an
/// adjacent face, by at most 3 d (1 / |n_e . n_f| + 1 / |n_e . n_g|), as it is at most 2 d beyond the common edge;
/// c_l A_k times that is `FaceJump::continuous`. In the clipped scheme the parts' borders, of the face's perimeter at
/// most each, sweep at most d / |n_e . n_f| as well. The clamp to max_penetration is continuous: it bounds jumps and
/// causes none.
///
/// Not found: two changes within a step that undo each other, or look like one passing of a common edge. O(52
/// evaluations) a change. `progress` gets the number of the segment at hand. Throws BadInput where the engine refuses a
/// pose.
PathWalk walk(const fast::Pairing& pairing, const PosePath& path, const JumpSearch& search,
              const std::function<void(std::size_t)>& progress = {});

}  // namespace pcm::compare
