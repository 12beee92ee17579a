// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "compare/verify/run/verification_plan.h"

namespace pcm::compare {

/// What of a recorded trajectory is asked, and how.
struct TrajectoryChoice {
  std::optional<std::int64_t> poses;        ///< no more than these, spread evenly over all that are recorded
  std::optional<HeldPairing::Modes> modes;  ///< else each pairing's own
  std::optional<Scheme> scheme;             ///< else each pairing's own
};

/// The plan of a run over the poses that a simulation recorded: `file` is the trajectory.json of its folder, which
/// names surfaces, pairings and files of poses beside it (simulate/record/run_folder.h). A pairing whose file of poses
/// is empty never touched: it is a pair of the plan without poses.
///
/// Throws BadInput naming the file and the key or line: not JSON, a key missing or of the wrong type, a surface that
/// does not exist or is unfit for contact, a law out of its ranges, a malformed pose, no pose at all.
VerificationPlan read_trajectory(const std::filesystem::path& file, const TrajectoryChoice& choice = {});

}  // namespace pcm::compare
