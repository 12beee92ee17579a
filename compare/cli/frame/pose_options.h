// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "compare/cli/frame/command_line.h"
#include "compare/poses/poses_file.h"

namespace pcm::compare {

/// How a file of poses is to be read.
struct OrientationOptions {
  std::optional<std::string> quaternions;
  bool orthonormalise = false;
};

/// Adds --quaternions and --orthonormalise to a subcommand.
void add_orientation_options(CLI::App& command, OrientationOptions& options);
PoseReading reading_from(const OrientationOptions& options, double metres_per_unit);

/// Where the poses of a command come from and how they are written.
struct PoseOptions {
  std::optional<std::string> poses;  ///< "-": standard input
  OrientationOptions orientations;
};

/// Adds --poses and the options above to a subcommand.
void add_pose_options(CLI::App& command, PoseOptions& options);

/// The poses, where there are any; their lengths are in units of so many metres.
std::optional<PosesFile> poses_from(const PoseOptions& options, double metres_per_unit);

/// Says on standard error, the first time, that an orientation of the file was replaced.
class ReplacementNotice {
 public:
  void look_at(const State& state, const PosesFile& poses);

 private:
  bool given_ = false;
};

}  // namespace pcm::compare
