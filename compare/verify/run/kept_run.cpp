// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/kept_run.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "compare/io/json/json_file.h"
#include "compare/verify/run/run_identity.h"
#include "compare/verify/verdict/case_file.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// What every finished run leaves, and what is there while its tables are written.
constexpr std::string_view kProvenance = "verification.provenance.json",
                           kUnfinished = "verification.provenance.json.part";

/// What a run leaves in its folder beside the campaign and the case files.
constexpr std::array<std::string_view, 12> kTables = {
    "overview.md",      "overview.tex",      "overview.csv", "verification.md", "verification.tex", "widths.csv",
    "verification.csv", "verification.json", "times.md",     "times.tex",       kProvenance,        kUnfinished};

constexpr const char* kFindings = "findings";

std::string now() {
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::chrono::system_clock::now()));
}

/// Says whether there were any.
bool remove_results(const fs::path& folder) {
  bool removed = remove_case_files(folder);
  std::error_code error;
  for (const std::string_view table : kTables) {
    removed |= fs::remove(folder / table, error);
    if (error) throw BadInput((folder / table).string() + ": of another run, and it can't be removed");
  }
  return removed;
}

std::string findings_text(const std::vector<Finding>& findings) {
  auto json = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    auto list = nlohmann::ordered_json::array();
    for (const Disagreement& d : finding.disagreements) list.push_back({static_cast<int>(d.kind), d.text});
    json.push_back({finding.cell, finding.pose, list});
  }
  return json_line(json);
}

std::vector<Finding> findings_from(const nlohmann::ordered_json& json) {
  std::vector<Finding> findings;
  for (const auto& entry : json) {
    Finding finding{entry.at(0).get<std::size_t>(), entry.at(1).get<std::int64_t>(), {}};
    for (const auto& d : entry.at(2))
      finding.disagreements.push_back({static_cast<Kind>(d.at(0).get<int>()), d.at(1).get<std::string>()});
    findings.push_back(std::move(finding));
  }
  return findings;
}

void refuse_earlier_version(const fs::path& folder) {
  if (fs::exists(folder / "state.json"))
    throw BadInput("--out " + folder.string() + ": it holds a run of an earlier version of pcm; choose another folder");
}

/// Files under the names of tables, without what says of them that a run has begun them, are no run's.
void refuse_files_of_others(const fs::path& folder) {
  std::error_code ignored;
  const auto is_there = [&](std::string_view table) { return fs::exists(fs::symlink_status(folder / table, ignored)); };
  const auto found = std::find_if(kTables.begin(), kTables.end(), is_there);
  if (found != kTables.end() && !is_there(kProvenance) && !is_there(kUnfinished))
    throw BadInput(
        fmt::format("--out {}: {} is there, which no run has left; choose another folder", folder.string(), *found));
}

/// The folder, before anything is made in it.
fs::path of_runs_alone(fs::path folder) {
  if (!fs::exists(folder / kCampaignFile)) {
    refuse_earlier_version(folder);
    refuse_files_of_others(folder);
  }
  return folder;
}

}  // namespace

void remove_unfinished_tables(const fs::path& folder) {
  for (const std::string_view table : kTables) remove_unfinished(folder / table);
}

KeptRun::KeptRun(fs::path folder, const Verification& run, JobPart part)
    : SharedChunks(of_runs_alone(folder)), folder_(std::move(folder)), run_(run) {
  campaign_.begin([&](const std::optional<Campaign::Job>& held, bool at_work) { return decide(held, at_work, part); });
}

std::optional<Campaign::Job> KeptRun::decide(const std::optional<Campaign::Job>& held, bool at_work, JobPart part) {
  const std::string out = "--out " + folder_.string() + ": ";
  const Campaign::Job anew{json_line(identity_of(run_.plan())), run_.chunks(), part};
  if (!held) {
    // Beside a campaign that was opened, but begun by nobody.
    refuse_earlier_version(folder_);
    refuse_files_of_others(folder_);
    if (remove_results(folder_)) notice_ = out + "tables and cases of a run whose campaign is gone are removed";
    return anew;
  }
  const auto identity = nlohmann::ordered_json::parse(held->identity);
  if (!same_arguments(run_.plan(), identity))
    throw BadInput(out +
                   "it holds another run (other poses, seed, strata, modes, scheme or law); choose another folder");
  if (const std::string difference = difference_from(run_.plan(), identity); !difference.empty()) {
    if (at_work)
      throw BadInput(fmt::format("{}others may be at work here on a run {}; wait for them or choose another folder",
                                 out, difference));
    remove_results(folder_);
    notice_ = fmt::format("{}it held a run {}; that run's tables and cases are removed, this one starts anew", out,
                          difference);
    return anew;
  }
  if (held->part != part)
    throw BadInput(held->part.of == 1
                       ? out + "it holds the whole run; choose another folder"
                       : fmt::format("{}it holds {} of the run; choose another folder", out,
                                     held->part == kNoPart
                                         ? "parts taken from other folders"
                                         : fmt::format("part {} of {}", held->part.number, held->part.of)));
  return std::nullopt;
}

std::optional<KeptRun::Finished> KeptRun::finished() {
  const std::optional<std::string> note = campaign_.finished();
  if (!note) return std::nullopt;
  try {
    const auto json = nlohmann::ordered_json::parse(*note);
    return Finished{json.at("at"), json.at("by"), json.at("launch")};
  } catch (const nlohmann::json::exception&) {
    throw_damaged(folder_ / kCampaignFile);
  }
}

void KeptRun::commit(ChunkRange chunks, Outcomes outcomes) {
  const std::lock_guard lock(mutex_);
  std::map<std::string, std::string> found;
  for (auto& [cell, outcome] : outcomes.cells) {
    if (const auto before = mine_.cells.find(cell); before != mine_.cells.end()) outcome.merge(before->second);
    found[std::to_string(cell)] = json_line(outcome.to_json());
  }
  Outcomes findings{{}, std::move(outcomes.findings)};
  if (!findings.findings.empty()) {
    findings.merge({{}, mine_.findings});
    found[kFindings] = findings_text(findings.findings);
  }
  if (!campaign_.commit(chunks, found)) return;
  for (auto& [cell, outcome] : outcomes.cells) mine_.cells[cell] = std::move(outcome);
  if (!findings.findings.empty()) mine_.findings = std::move(findings.findings);
}

Outcomes KeptRun::outcomes() {
  Outcomes all;
  campaign_.for_each_found([&](const std::string& key, const std::string& text) {
    const auto json = nlohmann::ordered_json::parse(text);
    if (key == kFindings)
      all.merge({{}, findings_from(json)});
    else
      all.cells[std::stoul(key)].merge(CellOutcome::from_json(json));
  });
  return all;
}

void KeptRun::finish(const nlohmann::ordered_json& program, const std::string& launch) {
  campaign_.finish(json_line({{"at", now()}, {"by", program}, {"launch", launch}}));
}

void KeptRun::merge(const std::vector<fs::path>& folders) {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders) files.push_back(folder / kCampaignFile);
  campaign_.take_in(files);
}

}  // namespace pcm::compare
