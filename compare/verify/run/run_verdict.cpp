// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/run_verdict.h"

#include <fmt/core.h>

#include <algorithm>

#include "compare/io/names.h"

namespace pcm::compare {

// Whether the surfaces cross does not depend on the mode.
std::int64_t touching_poses(const Verification& run) {
  return run.total().touching / run.poses().modes_per_pose();
}

std::map<Stratum, std::int64_t> poses_without_scene(const Verification& run) {
  std::map<Stratum, std::int64_t> poses;
  for (std::size_t c = 0; c < run.cells().size(); c += static_cast<std::size_t>(run.poses().modes_per_pose()))
    if (const Cell& cell = run.cells()[c]; cell.without_scene > 0) poses[cell.stratum] += cell.without_scene;
  return poses;
}

Tally measured_poses(const Verification& run, std::optional<Scheme> scheme) {
  Tally measured;
  for (const Cell& cell : run.cells()) {
    const bool is_measured = cell.stratum == Stratum::generic && !run.plan().pairs[cell.pair].made_to_hurt;
    if (is_measured && scheme.value_or(cell.scheme) == cell.scheme) measured.merge(cell.tally);
  }
  return measured;
}

// Of few answers the greatest error is left out as well: one of them tells nothing of a percentile. Where a face hides
// part of another, a strip as narrow as roundings may be the deepest thing seen, or not: so the greatest penetration
// alone is held at another percentile.
double measured_error(const Tally& measured, std::size_t k) {
  const std::int64_t one_in = k == kPenetrationError ? 100 : 1000;
  const Histogram& errors = measured.errors[k];
  const std::int64_t rank = errors.count() - std::max<std::int64_t>(1, errors.count() / one_in);
  return rank < 1 ? 0 : errors.at_rank(rank);
}

std::optional<MissedMeasure> missed_measure(const Tally& measured) {
  std::optional<MissedMeasure> worst;
  for (std::size_t k = 0; k < kFirstBound; ++k) {
    const double error = measured_error(measured, k);
    if (!(error <= kMeasure) && !(worst && error <= worst->error))
      worst = MissedMeasure{kErrorNames[k], error, k == kPenetrationError ? "99th" : "99.9th"};
  }
  return worst;
}

std::optional<MissedMeasure> missed_measure(const Verification& run) {
  return missed_measure(measured_poses(run));
}

std::string without_scene_line(const Verification& run) {
  std::string strata;
  std::int64_t all = 0;
  for (const auto& [stratum, poses] : poses_without_scene(run)) {
    strata += fmt::format("{}{} {}", strata.empty() ? "" : ", ", name(stratum), poses);
    all += poses;
  }
  if (all == 0) return "";
  return fmt::format("paths: no scene was asked about {} of {} poses, whose A is no rotation to 1e-10 ({})", all,
                     run.poses_done(), strata);
}

bool is_verified(const Verification& run) {
  return run.finished() && run.total().disagreeing == 0 && !missed_measure(run);
}

std::string verdict_line(const Verification& run, const std::string& why_unfinished) {
  const std::int64_t disagreeing = run.total().disagreeing;
  const std::int64_t modes = run.poses().modes_per_pose();
  const std::optional<MissedMeasure> missed = missed_measure(run);
  const char* verdict = is_verified(run)                      ? "verified"
                        : disagreeing == 0 && !run.finished() ? "unfinished"
                                                              : "NOT verified";
  std::string line = fmt::format("{}: {} poses{}, {} touching, {} disagreements", verdict, run.poses_done(),
                                 modes > 1 ? fmt::format(" in {} modes", modes) : "", touching_poses(run), disagreeing);
  if (missed)
    line += fmt::format(", {} error of {:.1e} S/p at the {} percentile of generic (measure: {:.0e})", missed->what,
                        missed->error, missed->percentile, kMeasure);
  if (!run.poses().without_poses().empty()) line += fmt::format(" (no pose: {})", run.poses().without_poses());
  if (!run.finished()) line += fmt::format(" ({}, {} poses wanted)", why_unfinished, run.plan().poses);
  return line;
}

}  // namespace pcm::compare
