// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "compare/io/json/exact_json.h"
#include "compare/motion/force_jumps.h"
#include "compare/motion/path_work.h"

namespace pcm::compare {

/// What was found along a path, for people and for programs.
struct PathReport {
  const fast::Pairing& pairing;
  const PosePath& path;
  const JumpSearch& search;
  const PathWalk& walk;
  PathWork work;
  std::optional<Eigen::Vector3d> normal_Me;  ///< for the tangential force
};

/// One screen: the greatest jumps, sums by cause, work, and the tangential force where a normal is given.
std::string path_table(const PathReport& report);

/// One object for a jump. Places as {"at", "segment", "share", "pose"}, the pose as the twelve numbers of a poses file.
Json jump_json(const ForceJump& jump);
/// One object for the path: counts, sums, work, tangential force.
Json path_json(const PathReport& report);

}  // namespace pcm::compare
