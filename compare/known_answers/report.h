// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/io/tables/column_units.h"
#include "compare/io/tables/table.h"
#include "compare/known_answers/identities.h"
#include "compare/known_answers/known_answers.h"

/// Tables of known answers and identities. They hold no times, so that they are the same on every run.
namespace pcm::compare {

/// Everything a run found.
struct KnownAnswersReport {
  std::vector<KnownAnswerResult> problems;  ///< ordered by id
  std::vector<IdentityResult> identities;

  std::size_t rows() const;
  std::size_t missed_rows() const;
  std::size_t missed_identities() const;
  bool met() const { return missed_rows() == 0 && missed_identities() == 0; }
};

/// Runs all families and identities on `jobs` threads; `progress` is told what comes next. The same report whatever the
/// number of threads. Only identities are looked at again where values are kept.
KnownAnswersReport run_known_answers(Extent extent, std::uint64_t seed, int jobs, KeptValues& kept,
                                     const std::function<void(const std::string&)>& progress);

/// One page: problem, reference and its source, a table of rows and one of their levels.
std::string problem_markdown(const KnownAnswerResult& result);
std::string identities_markdown(const std::vector<IdentityResult>& identities);

/// All levels of all rows; all identities.
std::string rows_csv(const std::vector<KnownAnswerResult>& problems);
ColumnUnits rows_units();
std::string identities_csv(const std::vector<IdentityResult>& identities);
nlohmann::ordered_json cases_json(const std::vector<KnownAnswerResult>& problems);
nlohmann::ordered_json known_answers_json(const KnownAnswersReport& report);

/// A row for each problem.
Table cases_table(const KnownAnswersReport& report);
/// That on a page, with the verdict.
std::string known_answers_markdown(const KnownAnswersReport& report);

/// One screen: a line for each problem and each identity, then every miss.
std::string known_answers_summary(const KnownAnswersReport& report);
/// The last line printed.
std::string known_answers_verdict(const KnownAnswersReport& report);

}  // namespace pcm::compare
