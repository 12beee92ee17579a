// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "compare/cli/verify/kept_folder.h"
#include "compare/cli/verify/verify_run.h"
#include "compare/hard_poses/search_report.h"
#include "compare/io/create_folder.h"
#include "compare/io/names.h"
#include "compare/io/provenance/sha256.h"
#include "compare/io/tables/report_folder.h"
#include "compare/verify/run/held_again.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// Of each goal and scheme.
constexpr std::size_t kHardest = 10;

constexpr const char* kCases = "hardest";

/// Of both surfaces together: the margins of all their orientations are looked at.
constexpr std::size_t kMostFacesAsked = 2000;

/// All of them are held in memory, each with its surfaces.
constexpr std::uint64_t kMostClimbs = 100'000;

void require_small(const std::string& what, const TriangleMesh& E, const TriangleMesh& F) {
  const std::size_t faces = E.faces.size() + F.faces.size();
  if (faces > kMostFacesAsked)
    throw BadInput(
        fmt::format("--search: {} has {} faces, {} at most; take coarser surfaces", what, faces, kMostFacesAsked));
}

/// The file, or the case files of the folder.
std::vector<fs::path> case_files(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return {path};
  std::vector<fs::path> files = case_files_in(path);
  if (files.empty()) throw BadInput("--from " + path.string() + ": no case file (case_....json) in this folder");
  return files;
}

/// Where cases are written those that are there are removed.
void refuse_own_cases(const fs::path& file, const VerifyOptions& options) {
  std::error_code error;
  if (options.out && fs::equivalent(file.parent_path(), fs::path(*options.out) / kCases, error))
    throw BadInput("--from " + file.string() + ": --out " + *options.out +
                   " would remove it; choose another folder for what is found");
}

/// Where climbs begin: a search that is kept goes on where it was as long as that is the same.
nlohmann::ordered_json places_of(const SearchPlan& plan) {
  nlohmann::ordered_json question = nlohmann::ordered_json::object();
  if (!plan.cases.empty()) {
    for (const Case& posed : plan.cases)
      question["cases"].push_back({{"origin", posed.origin}, {"sha256", sha256(format_case(posed, {}, {}))}});
    return question;
  }
  for (const Scheme scheme : plan.schemes) question["schemes"].push_back(std::string(name(scheme)));
  for (const SurfacePair& pair : plan.pairs)
    question["pairs"].push_back({{"name", pair.name}, {"surfaces", {sha256(pair.E), sha256(pair.F)}}});
  return question;
}

void write_cases(const fs::path& folder, const SearchReport& report, const std::vector<const Climbed*>& hardest) {
  create_folder(folder);
  remove_case_files(folder);
  std::set<const Climbed*> told(hardest.begin(), hardest.end());
  for (const Climbed& climbed : report.climbs)
    if (!climbed.hardest.disagreements.empty() && told.size() < kMostFindings) told.insert(&climbed);
  fast::Workspace workspace;
  for (const Climbed* climbed : told) {
    const HardState hard = hard_state(climbed->hardest);
    write_text_file(folder / case_file_name(climbed->name), case_file_text(*hard.held, climbed->hardest, workspace));
  }
}

void write_tables(const fs::path& path, const SearchPlan& plan, const SearchReport& report) {
  const std::vector<const Climbed*> hardest = hardest_climbs(report, kHardest);
  nlohmann::ordered_json question = places_of(plan);
  question["seed"] = plan.seed;
  question["climbs"] = climbs_of(plan);
  ReportFolder folder(path, "search", std::move(question));
  const Table table = search_table(report), table_of_hardest = hardest_table(hardest);
  write_cases(path / kCases, report, hardest);
  folder.markdown("search", search_markdown(report, hardest));
  folder.csv("search", csv(table), {});
  folder.csv("hardest", csv(table_of_hardest), {});
  folder.json("search", {{"verdict", {{"verified", report.disagreeing() == 0}, {"line", search_verdict(report)}}},
                         {"goals", json(table)},
                         {"hardest", json(table_of_hardest)}});
  folder.finish();
}

}  // namespace

SearchPlan search_plan(const VerifyOptions& options) {
  SearchPlan plan;
  plan.seed = seed_of(options);
  if (options.poses) plan.climbs = static_cast<std::int64_t>(whole_number("--poses", *options.poses, 1, kMostClimbs));
  plan.schemes = schemes_of(options);
  for (const std::string& from : options.from)
    for (const fs::path& file : case_files(from)) {
      refuse_own_cases(file, options);
      plan.cases.push_back(read_case(file));
      require_small(file.string(), plan.cases.back().E, plan.cases.back().F);
    }
  std::vector<std::string> notices;
  plan.pairs = pairs_named(options, notices);
  for (const SurfacePair& pair : plan.pairs) require_small(pair.name, pair.E, pair.F);
  for (const std::string& notice : notices) complain(notice);
  if (plan.pairs.empty()) plan.pairs = searched_pairs();
  return plan;
}

Exit verify_search(const SearchPlan& plan, int jobs, const std::optional<fs::path>& folder) {
  KeptValues kept = kept_values(folder, "search", places_of(plan));
  if (kept.size() > 0) complain(fmt::format("--out {}: continued, {} climbs are kept", folder->string(), kept.size()));
  SearchReport report;
  {
    const Interruptible work(climbs_of(plan), "climbs");
    report = search(
        plan, jobs, kept, [&] { return work.interrupted(); }, [&](std::int64_t done) { work.show(done); });
  }
  std::cout << search_summary(report) << search_verdict(report) << '\n';
  if (folder && report.finished()) {
    write_tables(*folder, plan, report);
    kept.finish();
  }
  return report.finished() && report.disagreeing() == 0 ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
