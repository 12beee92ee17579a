// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/pose_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "pcm/bad_input.h"

namespace pcm::compare {

void add_orientation_options(CLI::App& command, OrientationOptions& options) {
  command
      .add_option(
          "--quaternions", options.quaternions,
          "Poses begin with a unit quaternion in place of A: 7 numbers, or 13 with v and w; wxyz: its real part "
          "comes first, xyzw: last")
      ->type_name("ORDER")
      ->check(CLI::IsMember({"wxyz", "xyzw"}));
  command.add_flag("--orthonormalise", options.orthonormalise,
                   "Orientations with few digits, three behind the point at least, are replaced by the nearest "
                   "rotation; without it they are refused");
}

PoseReading reading_from(const OrientationOptions& options, double metres_per_unit) {
  PoseReading reading;
  if (options.quaternions)
    reading.notation = *options.quaternions == "wxyz" ? OrientationNotation::wxyz : OrientationNotation::xyzw;
  reading.orthonormalise = options.orthonormalise;
  reading.metres_per_unit = metres_per_unit;
  return reading;
}

void add_pose_options(CLI::App& command, PoseOptions& options) {
  command
      .add_option("--poses", options.poses,
                  "Where F is, pose by pose (default: the identity, at rest); - reads standard input")
      ->type_name("FILE");
  add_orientation_options(command, options.orientations);
}

std::optional<PosesFile> poses_from(const PoseOptions& options, double metres_per_unit) {
  if (!options.poses) {
    if (options.orientations.quaternions || options.orientations.orthonormalise)
      throw BadInput("--quaternions and --orthonormalise say how poses are read; add --poses");
    return std::nullopt;
  }
  return std::optional<PosesFile>(std::in_place, *options.poses, reading_from(options.orientations, metres_per_unit));
}

void ReplacementNotice::look_at(const State& state, const PosesFile& poses) {
  if (given_ || state.replaced_error == 0) return;
  given_ = true;
  complain(
      fmt::format("note: {}: the orientation is off by {:.2g} and is replaced by the nearest rotation, as are all "
                  "others off by more than 1e-9",
                  poses.place(), state.replaced_error));
}

}  // namespace pcm::compare
