// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "compare/verify/verify.h"

/// The tables of a verification. All but the times are the same bit for bit whenever the plan is.
namespace pcm::compare {

/// Agreement and rounding errors, a row for each pair, stratum, scheme and mode, for each stratum, scheme and mode, for
/// each mode, and for all; and how wide the checks were.
std::string verification_markdown(const Verification& run);
/// The same numbers, and each kind of disagreement in a column of its own.
std::string verification_csv(const Verification& run);
nlohmann::ordered_json verification_json(const Verification& run);

/// Median times of the engine, of the oracle on the rounded and of the oracle on the exact problem.
std::string times_markdown(const Verification& run);

/// What rounding errors of generic poses may be at most, in units of S/p (DESIGN section 3): of areas, vector areas,
/// volume, force and torque at the 99.9th percentile, of the greatest penetration at the 99th. That one is no sum: in
/// the clipped scheme it may be that of a sliver. One answer at least is left out; so are pairs that are made to hurt
/// (SurfacePair::made_to_hurt).
inline constexpr double kMeasure = 1e-13;

/// The generic poses that the measure is demanded of, together; in one scheme or in all.
Tally measured_poses(const Verification& run, std::optional<Scheme> scheme = std::nullopt);

/// An error that is greater, the greatest of them.
struct MissedMeasure {
  std::string what;
  double error = 0;
  std::string percentile;
};
std::optional<MissedMeasure> missed_measure(const Tally& measured);
/// Of the poses that it is demanded of.
std::optional<MissedMeasure> missed_measure(const Verification& run);

/// How many poses no scene was asked about, and in which strata (call_routes.h); a line for people, empty where there
/// are none.
std::string without_scene_line(const Verification& run);

/// Finished, without disagreements, and by the measure, where there are generic poses.
bool is_verified(const Verification& run);

/// The last line printed, e.g. "verified: 20160 poses, 9876 touching, 0 disagreements"; each pose once,
/// however many modes; disagreements in all modes. "verified" stands there where the run is_verified alone; a run that
/// was interrupted is "unfinished", or, with disagreements already, "NOT verified". What got no pose is named.
std::string verdict_line(const Verification& run);

}  // namespace pcm::compare
