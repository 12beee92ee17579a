// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/verify.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/io/names.h"
#include "compare/io/provenance/program_hash.h"

namespace pcm::compare {
namespace {

/// Poses a chunk, at most: few enough to lose little when interrupted.
constexpr std::int64_t kChunk = 8;

/// The cells that have the same value of `key`, together.
template <class KeyOf>
auto merged(const std::vector<Cell>& cells, const KeyOf& key_of) {
  std::map<decltype(key_of(cells.front())), Tally> groups;
  for (const Cell& cell : cells) groups[key_of(cell)].merge(cell.tally);
  return groups;
}

VerificationPlan with_build(VerificationPlan plan) {
  if (plan.build.empty()) plan.build = program_hash();
  return plan;
}

bool is_before(const Finding& a, const Finding& b) {
  return std::pair(a.cell, a.pose) < std::pair(b.cell, b.pose);
}

/// The same ones are kept, in the same order, whoever found them when.
void merge_findings(std::vector<Finding>& findings, std::vector<Finding>&& others) {
  std::move(others.begin(), others.end(), std::back_inserter(findings));
  std::sort(findings.begin(), findings.end(), is_before);
  if (findings.size() > kMostFindings) findings.resize(kMostFindings);
}

}  // namespace

void CellOutcome::merge(const CellOutcome& other) {
  without_scene += other.without_scene;
  tally.merge(other.tally);
}

nlohmann::ordered_json CellOutcome::to_json() const {
  nlohmann::ordered_json json = tally.to_json();
  json["without_scene"] = without_scene;
  return json;
}

CellOutcome CellOutcome::from_json(const nlohmann::ordered_json& json) {
  return {json.at("without_scene").get<std::int64_t>(), Tally::from_json(json)};
}

void Outcomes::merge(Outcomes&& other) {
  for (auto& [cell, outcome] : other.cells) cells[cell].merge(outcome);
  if (!other.findings.empty()) merge_findings(findings, std::move(other.findings));
}

Verification::Verification(VerificationPlan plan, const EngineSeam& seam)
    : poses_(with_build(std::move(plan)), seam), seam_(&seam) {
  std::int64_t all = 0;
  for (const PlannedCell& planned : poses_.cells()) {
    if (std::ssize(cells_) % poses_.modes_per_pose() == 0) {
      first_of_group_.push_back(all);
      all += planned.poses;
    }
    cells_.push_back({planned, {}});
  }
  first_of_group_.push_back(all);
  chunks_ = std::max<std::int64_t>(1, (all + kChunk - 1) / kChunk);
}

std::int64_t Verification::poses_done() const {
  std::int64_t done = 0;
  for (const Cell& cell : cells_) done += cell.tally.poses;
  return done / poses_.modes_per_pose();
}

bool Verification::finished() const {
  return std::all_of(cells_.begin(), cells_.end(), [](const Cell& cell) { return cell.tally.poses == cell.poses; });
}

Tally Verification::total() const {
  Tally total;
  for (const Cell& cell : cells_) total.merge(cell.tally);
  return total;
}

std::vector<NamedTally> Verification::by_pair() const {
  std::vector<NamedTally> tallies;
  for (const auto& [pair, tally] : merged(cells_, [](const Cell& c) { return c.pair; }))
    tallies.push_back({plan().pairs[pair].name, tally});
  return tallies;
}

std::vector<NamedTally> Verification::by_stratum() const {
  std::vector<NamedTally> tallies;
  for (const auto& [stratum, tally] : merged(cells_, [](const Cell& c) { return c.stratum; }))
    tallies.push_back({std::string(name(stratum)), tally});
  return tallies;
}

std::vector<NamedTally> Verification::by_mode() const {
  std::vector<NamedTally> tallies;
  std::map<Mode, Tally> groups = merged(cells_, [](const Cell& cell) { return cell.mode; });
  for (const Mode mode : plan().modes) tallies.push_back({std::string(name(mode)), std::move(groups[mode])});
  return tallies;
}

std::vector<NamedTally> Verification::by_scheme() const {
  std::vector<NamedTally> tallies;
  std::map<Scheme, Tally> groups = merged(cells_, [](const Cell& cell) { return cell.scheme; });
  for (const Scheme scheme : plan().schemes) tallies.push_back({std::string(name(scheme)), std::move(groups[scheme])});
  return tallies;
}

std::vector<StratumTally> Verification::by_stratum_scheme_and_mode() const {
  std::vector<StratumTally> tallies;
  for (const auto& [key, tally] :
       merged(cells_, [](const Cell& c) { return std::tuple(c.stratum, c.scheme, c.mode); })) {
    const auto [stratum, scheme, mode] = key;
    tallies.push_back({stratum, scheme, mode, tally});
  }
  return tallies;
}

Case Verification::as_case(const Finding& finding) const {
  Case posed = poses_.as_case(cells_[finding.cell], finding.pose);
  posed.disagreements = in_words(finding.disagreements);
  return posed;
}

Verification::Held Verification::hold(const Cell& cell, std::int64_t pose, fast::Workspace& workspace) const {
  const char* what = "drawing the state";
  try {
    const HeldPairing::State state = poses_.asked(cell, pose);
    const HeldPairing& held = poses_.held_pairing(cell, pose);
    what = "holding the answers";
    return {held.hold(state, workspace, *seam_), is_pose_for_scenes(state.pose)};
  } catch (const std::exception& error) {
    PoseOutcome failed;
    failed.disagreements.push_back({Kind::failure, std::string(what) + ": " + error.what()});
    return {std::vector<PoseOutcome>(static_cast<std::size_t>(poses_.modes_per_pose()), failed),
            true};  // it says itself what was not asked
  }
}

std::optional<Outcomes> Verification::hold_chunk(std::int64_t chunk, fast::Workspace& workspace,
                                                 const std::function<bool(std::int64_t)>& goes_on) const {
  Outcomes outcomes;
  std::int64_t done = 0;
  // Every chunks_-th pose, so that all chunks are alike.
  for (std::int64_t number = chunk; number < poses_in_all(); number += chunks_) {
    if (!goes_on(std::exchange(done, 1))) return std::nullopt;
    const auto after = std::upper_bound(first_of_group_.begin(), first_of_group_.end(), number);
    const auto first_cell = static_cast<std::size_t>((after - first_of_group_.begin() - 1) * poses_.modes_per_pose());
    const std::int64_t pose = cells_[first_cell].first + number - *std::prev(after);
    Held held = hold(cells_[first_cell], pose, workspace);
    for (std::size_t m = 0; m < held.outcomes.size(); ++m) {
      const std::size_t c = first_cell + m;
      PoseOutcome& outcome = held.outcomes[m];
      CellOutcome& of_cell = outcomes.cells[c];
      of_cell.without_scene += !held.in_scene;
      of_cell.tally.add(outcome, poses_.pose_name(cells_[c], pose));
      if (!outcome.disagreements.empty()) outcomes.findings.push_back({c, pose, std::move(outcome.disagreements)});
    }
  }
  goes_on(done);
  std::sort(outcomes.findings.begin(), outcomes.findings.end(), is_before);
  return outcomes;
}

void Verification::add(Outcomes outcomes) {
  for (const auto& [cell, outcome] : outcomes.cells) cells_.at(cell).merge(outcome);
  if (!outcomes.findings.empty()) merge_findings(findings_, std::move(outcomes.findings));
}

}  // namespace pcm::compare
