// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "compare/motion/pose_path.h"
#include "pcm/engine.h"

namespace pcm::compare {

/// What one master face carries at one place of a path. In mode `both` its share in the mean: half of its force.
struct FaceLoad {
  Side master = Side::E;
  Index face = 0;
  std::vector<Index> slave_faces;  ///< those its penetration lines leave through, ascending; one if barycentric
  double depth = 0;                ///< the greatest of its elements' penetrations, clamped, m
  bool clamped = false;            ///< some element is deeper than the law's max_penetration, at least in part
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on E about Mf, N m

  bool before(const FaceLoad& other) const {
    return master != other.master ? master < other.master : face < other.face;
  }
};

/// The elastic contact at one place of a path.
struct PathSample {
  PathPoint where;
  Pose pose;
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on E about Mf, N m
  Index too_deep = 0;
  std::vector<FaceLoad> loads;  ///< by master (E first), then face
};

/// What becomes of a master face that carries nothing.
struct IdleFace {
  enum class Why : std::uint8_t {
    inactive,  ///< it is neither intersected nor inside the other body
    outside,   ///< active, but its barycentre's line meets nothing, enters the slave or leaves it at distance 0
    too_deep,  ///< its barycentre's line leaves the master first
  };
  Why why = Why::inactive;
  Index first_met = -1;  ///< the first slave face on the barycentre's line, -1 where there is none
};

/// Evaluates a pairing by the engine along a path, at rest: the elastic force alone. Not for several threads at once.
class PathForce {
 public:
  PathForce(const fast::Pairing& pairing, const PosePath& path);

  /// Throws BadInput, naming the place, where the engine refuses the pose.
  PathSample at(const PathPoint& point);

  /// Why a face that is not among the loads of the last sample carries nothing. For the latest call of `at`.
  IdleFace why_idle(Side master, Index face);

  const fast::Pairing& pairing() const { return pairing_; }
  const PosePath& path() const { return path_; }
  /// Calls of `at`.
  std::int64_t evaluations() const { return evaluations_; }

 private:
  void mark_clamped(PathSample& sample, const fast::Contact& contact);

  const fast::Pairing& pairing_;
  const PosePath& path_;
  fast::Workspace workspace_;
  std::int64_t evaluations_ = 0;
  std::optional<fast::Pairing> unclamped_;  ///< the same without max_penetration, where the law has one
  fast::Workspace unclamped_workspace_;
};

}  // namespace pcm::compare
