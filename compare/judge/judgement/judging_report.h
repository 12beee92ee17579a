// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/io/tables/table.h"
#include "compare/judge/judgement/judging.h"

/// The tables of `pcm judge`.
namespace pcm::compare {

/// A row for each stratum and each fact that was judged in it, and for each fact over all.
Table facts_table(const Judging& run);
/// A row for each stratum and one for all: poses, wrong ones, breakdowns.
Table strata_table(const Judging& run);

/// A row for each pair of surfaces that has a wrong answer, or one near another: the same counts.
Table pairs_table(const Judging& run);

/// How the run was made, which tables and JSON carry with them.
struct JudgingSetup {
  std::string who;  ///< the file of answers or the command
  std::string poses;
  std::string tolerances;  ///< Tolerances::text
  std::int64_t near_ulps = 0;
  std::string answers_sha256;  ///< of the file of answers; empty where they came from elsewhere
  std::string poses_sha256;    ///< of poses.jsonl
};

/// What the tables' columns are, in words for people.
std::string judging_legend(const JudgingSetup& setup);

/// Counts and settings for programs. `ended`: why it ended before all was judged; empty where it did not.
nlohmann::ordered_json judging_json(const Judging& run, const JudgingSetup& setup, const std::string& ended);

/// The verdict in a line, e.g. "right: 20160 answers, 0 wrong, 3 near another answer"; "nothing judged"
/// where there was nothing in them that could be.
std::string judging_verdict(const Judging& run, bool finished);

}  // namespace pcm::compare
