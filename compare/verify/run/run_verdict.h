// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "compare/verify/run/verify.h"

/// What a verification comes to, from the verdicts about its poses: the measure it is held to, and its last line.
namespace pcm::compare {

/// What rounding errors of generic poses may be at most, in units of S/p (DESIGN section 3): of areas, vector areas,
/// volume, force and torque at the 99.9th percentile, of the greatest penetration at the 99th. That one is no sum: in
/// the clipped scheme it may be that of a sliver. One answer at least is left out; so are pairs that are made to hurt
/// (SurfacePair::made_to_hurt).
inline constexpr double kMeasure = 1e-13;

/// The generic poses that the measure is demanded of, together; in one scheme or in all.
Tally measured_poses(const Verification& run, std::optional<Scheme> scheme = std::nullopt);

/// The error number k (kErrorNames) at the percentile that it is held to.
double measured_error(const Tally& measured, std::size_t k);

/// An error that is greater, the greatest of them.
struct MissedMeasure {
  std::string what;
  double error = 0;
  std::string percentile;
};
std::optional<MissedMeasure> missed_measure(const Tally& measured);
/// Of the poses that it is demanded of.
std::optional<MissedMeasure> missed_measure(const Verification& run);

/// Poses whose surfaces cross; each once, however many modes.
std::int64_t touching_poses(const Verification& run);

/// How many poses no scene was asked about (asks.h), each once, in the strata that have such poses.
std::map<Stratum, std::int64_t> poses_without_scene(const Verification& run);
/// A line for people, empty where there are none.
std::string without_scene_line(const Verification& run);

/// Finished, without disagreements, and by the measure, where there are generic poses.
bool is_verified(const Verification& run);

/// The last line printed, e.g. "verified: 20160 poses, 9876 touching, 0 disagreements"; each pose once,
/// however many modes; disagreements in all modes. "verified" stands there where the run is_verified alone; a run that
/// was interrupted, or of which only a part is here, is "unfinished", or, with disagreements already, "NOT verified".
/// What got no pose is named.
std::string verdict_line(const Verification& run, const std::string& why_unfinished = "interrupted");

}  // namespace pcm::compare
