// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_other_tables.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/verify/verify_audits.h"
#include "compare/cli/verify/verify_engines.h"
#include "compare/cli/verify/verify_error_budget.h"
#include "compare/cli/verify/verify_known_answers.h"
#include "compare/cli/verify/verify_run.h"
#include "compare/cli/verify/verify_search.h"
#include "compare/cli/verify/verify_stability.h"
#include "compare/io/tables/report_folder.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// The folder of --out, without files of others under these names.
std::optional<fs::path> own_folder(const VerifyOptions& options, const std::string& command,
                                   const std::vector<std::string>& files) {
  std::optional<fs::path> folder = prepared_folder(options);
  if (folder) refuse_files_of_others(*folder, command, files);
  return folder;
}

Extent extent_of(const VerifyOptions& options) {
  return options.quick ? Extent::quick : Extent::full;
}

Exit engine_comparison(const VerifyOptions& options) {
  if (options.scheme && *options.scheme != "barycentric")
    throw BadInput("--engine: the published algorithms know the barycentric scheme only; leave out --scheme");
  const int jobs = number_of_jobs(options);
  std::vector<Engine> engines;
  for (const Engine engine : kEngines)
    if (std::find(options.engines.begin(), options.engines.end(), name(engine)) != options.engines.end())
      engines.push_back(engine);
  std::vector<std::string> notices;
  VerificationPlan plan = plan_from(options, notices);
  plan.schemes = {Scheme::barycentric};
  const std::optional<fs::path> folder = own_folder(
      options, "wrong_answers", {"wrong_answers.md", "wrong_answers.tex", "wrong_answers.csv", "wrong_answers.json"});
  for (const std::string& notice : notices) complain(notice);
  const Interruptible work(plan.poses);
  return verify_engines(
      std::move(plan), engines, jobs, folder, [&] { return work.interrupted(); },
      [&](std::int64_t done) { work.show(done); });
}

Exit known_answers(const VerifyOptions& options) {
  const std::uint64_t seed = seed_of(options);
  const std::optional<fs::path> folder =
      own_folder(options, "known_answers",
                 {"known_answers.md", "known_answers.tex", "known_answers.csv", "known_answers.json", "identities.md",
                  "identities.tex", "identities.csv"});
  return verify_known_answers(extent_of(options), seed, number_of_jobs(options), folder);
}

Exit error_budget(const VerifyOptions& options) {
  const std::optional<fs::path> folder = own_folder(
      options, "error_budget", {"error_budget.md", "error_budget.tex", "error_budget.csv", "error_budget.json"});
  return verify_error_budget(extent_of(options), number_of_jobs(options), folder);
}

Exit audits(const VerifyOptions& options) {
  const std::optional<fs::path> folder =
      own_folder(options, "audits", {"audits.md", "audits.tex", "audits.csv", "audits.json"});
  return verify_audits(extent_of(options), number_of_jobs(options), folder);
}

Exit stability(const VerifyOptions& options) {
  const std::uint64_t seed = seed_of(options);
  const std::optional<fs::path> folder = own_folder(options, "stability", stability_files());
  return verify_stability(extent_of(options), seed, number_of_jobs(options), folder);
}

Exit search(const VerifyOptions& options) {
  const SearchPlan plan = search_plan(options);
  const int jobs = number_of_jobs(options);
  const std::optional<fs::path> folder =
      own_folder(options, "search", {"search.md", "search.tex", "search.csv", "search.json", "hardest.csv"});
  return verify_search(plan, jobs, folder);
}

}  // namespace

Exit verify_other_tables(const VerifyOptions& options) {
  if (options.audits) return audits(options);
  if (options.search) return search(options);
  if (options.stability) return stability(options);
  if (options.error_budget) return error_budget(options);
  if (options.known_answers) return known_answers(options);
  return engine_comparison(options);
}

}  // namespace pcm::compare
