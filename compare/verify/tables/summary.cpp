// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/tables/summary.h"

#include <fmt/core.h>

#include <optional>
#include <vector>

#include "compare/verify/run/run_verdict.h"
#include "compare/verify/tables/verification_widths.h"

namespace pcm::compare {
namespace {

std::string agreement_row(const std::string& label, const Tally& t) {
  return fmt::format("{:<26}{:>8}{:>10}{:>15}{:>11}{:>9}{:>11}{:>10}{:>11.0f}{:>11.2f}\n", label, t.poses, t.touching,
                     t.disagreeing, t.ambiguous, t.flipped, t.unbounded, t.too_deep,
                     1e6 * t.engine_seconds.quantile(0.5), 1e3 * t.oracle_seconds.quantile(0.5));
}

std::string error_row(const std::string& label, const Tally& t) {
  std::string row = fmt::format("{:<16}", label);
  for (std::size_t k = 0; k < kFirstBound; ++k) {
    if (t.errors[k].count() == 0) {
      row += fmt::format("{:>16}", "-");
      continue;
    }
    row += fmt::format("{:>16}", fmt::format("{:.0e} {:.0e}", t.error_quantile(k, 0.999), t.worst[k].value));
  }
  return row + "\n";
}

/// What is demanded of the errors; of recorded poses, which are not generic, only what would be.
std::string measure_row(const Verification& run) {
  if (run.plan().recorded.empty())
    return error_row("measured", measured_poses(run)) +
           "measured: generic poses of the pairs that are not made to hurt; of them the verdict demands 1e-13 S/p,\nof "
           "penetrations at the 99th percentile\n";
  const std::optional<MissedMeasure> missed = missed_measure(run.total());
  return fmt::format(
      "The verdict demands no measure of recorded poses, for they are not generic. By that of generic ones, {:.0e} S/p "
      "at the\n99.9th percentile, of penetrations at the 99th, they {}\n",
      kMeasure,
      missed ? fmt::format("would fail: {} error of {:.1e} at the {}", missed->what, missed->error, missed->percentile)
             : "would pass");
}

std::string bound_row(const std::string& label, const Tally& t) {
  const std::int64_t broken =
      t.by_kind[static_cast<std::size_t>(Kind::bound)] + t.by_kind[static_cast<std::size_t>(Kind::penetration_bound)];
  std::string row = fmt::format("{:<16}{:>9}{:>10}{:>11}{:>11}", label, broken, t.errors[kFirstBound].count(),
                                t.unbounded, t.announced);
  for (std::size_t k = kFirstBound; k < kErrors; ++k)
    row +=
        t.errors[k].count() == 0
            ? fmt::format("{:>20}", "-")
            : fmt::format("{:>20}", fmt::format("{:.0e} {:.0e}", t.error_quantile(k, 0.5), t.error_quantile(k, 0.999)));
  return row + "\n";
}

/// The engine's own bounds on its rounding error; nothing where it gave none.
std::string bounds_table(const std::vector<NamedTally>& strata, const Tally& all) {
  if (all.errors[kFirstBound].count() + all.unbounded == 0) return "";
  std::string text =
      "\nThe engine's own bounds on these errors of force and torque: how often broken; how many are finite, of\n"
      "poses with a force that are not flipped, and how many infinite; how often it announced that a decision\n"
      "may be another one in the exact problem; median and 99.9th percentile in the same units\n";
  text += fmt::format("{:<16}{:>9}{:>10}{:>11}{:>11}{:>20}{:>20}\n", "stratum", "broken", "finite", "infinite",
                      "announced", "force bound", "torque bound");
  for (const auto& [label, tally] : strata) text += bound_row(label, tally);
  return text + bound_row("all", all);
}

}  // namespace

std::string verification_summary(const Verification& run) {
  const std::vector<NamedTally> strata = run.by_stratum();
  const Tally all = run.total();

  std::string text =
      fmt::format("{:<26}{:>8}{:>10}{:>15}{:>11}{:>9}{:>11}{:>10}{:>11}{:>11}\n", "pair", "poses", "touching",
                  "disagreements", "ambiguous", "flipped", "unbounded", "too deep", "engine us", "oracle ms");
  for (const auto& [label, tally] : run.by_pair()) text += agreement_row(label, tally);
  text += "stratum\n";
  for (const auto& [label, tally] : strata) text += agreement_row(label, tally);
  text += agreement_row("all", all);
  if (run.plan().schemes.size() > 1) {
    text += "scheme\n";
    for (const auto& [label, tally] : run.by_scheme()) text += agreement_row(label, tally);
  }
  if (run.plan().modes.size() > 1) {
    text += run.poses().modes_per_pose() > 1 ? "mode (above a pose counts once in each)\n" : "mode\n";
    for (const auto& [label, tally] : run.by_mode()) text += agreement_row(label, tally);
  }
  text += "unbounded: the engine's bound on its force or torque is infinite\n";
  text += "engine us, oracle ms: medians, everything asked for";
  text += run.poses().modes_per_pose() > 1
              ? "; a pose's first mode pays for what the others share or find in the cache\n"
              : "\n";

  text +=
      "\nRounding error of the engine against the exact problem: 99.9th percentile and maximum, in units of S/p\n"
      "(S: greatest coordinate, p: mean thickness of the contact; force and torque without flipped poses)\n";
  text += fmt::format("{:<16}", "stratum");
  for (std::size_t k = 0; k < kFirstBound; ++k) text += fmt::format("{:>16}", kErrorNames[k]);
  text += "\n";
  for (const auto& [label, tally] : strata) text += error_row(label, tally);
  text += error_row("all", all);
  text += measure_row(run);
  text += bounds_table(strata, all);
  text += widths_summary(run);
  if (const std::string line = without_scene_line(run); !line.empty()) text += "\n" + line + "\n";
  for (const std::string& omission : run.poses().omissions()) text += "\n" + omission + "\n";
  return text;
}

}  // namespace pcm::compare
