// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/verify.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "compare/io/names.h"
#include "compare/io/program_hash.h"
#include "compare/verify/run/run_identity.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// Poses a batch: enough to keep the threads busy, few enough to lose little when interrupted.
constexpr std::int64_t kBatch = 1024;

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

}  // namespace

Verification::Verification(VerificationPlan plan, const EngineSeam& seam)
    : poses_(with_build(std::move(plan)), seam), seam_(&seam) {
  std::int64_t all = 0;
  for (const PlannedCell& planned : poses_.cells()) {
    cells_.push_back({planned, 0, {}});
    all += planned.poses;
  }
  batches_ = (all / poses_.modes_per_pose() + kBatch - 1) / kBatch;
}

std::int64_t Verification::poses_done() const {
  std::int64_t done = 0;
  for (const Cell& cell : cells_) done += cell.tally.poses;
  return done / poses_.modes_per_pose();
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

Verification::Held Verification::hold(const Cell& cell, std::int64_t pose, fast::Workspace& workspace) const {
  try {
    const HeldPairing::State state = poses_.asked(cell, pose);
    return {poses_.held_pairing(cell, pose).hold(state, workspace, *seam_), is_pose_for_scenes(state.pose)};
  } catch (const std::exception& error) {
    PoseOutcome failed;
    failed.disagreements.push_back({Kind::failure, std::string("drawing the state: ") + error.what()});
    return {std::vector<PoseOutcome>(static_cast<std::size_t>(poses_.modes_per_pose()), failed),
            true};  // it says itself what was not asked
  }
}

void Verification::run_batch(int jobs, const std::function<bool()>& stop,
                             const std::function<void(std::int64_t)>& progress) {
  struct Task {
    std::size_t cell = 0;  ///< of the first mode
    std::int64_t pose = 0;
  };
  std::vector<Task> tasks;
  for (std::size_t c = 0; c < cells_.size(); c += static_cast<std::size_t>(poses_.modes_per_pose())) {
    const std::int64_t n = cells_[c].poses, first = cells_[c].first;
    for (std::int64_t k = n * batches_done_ / batches_; k < n * (batches_done_ + 1) / batches_; ++k)
      tasks.push_back({c, first + k});
  }
  // The costly ones first, so that no thread is left alone with them at the end.
  const auto cost = [this](const Task& task) {
    const Cell& cell = cells_[task.cell];
    return plan().pairs[cell.pair].cost(cell.stratum, cell.scheme);
  };
  std::stable_sort(tasks.begin(), tasks.end(), [&](const Task& a, const Task& b) { return cost(a) > cost(b); });

  const std::int64_t before = poses_done();
  std::vector<Held> held(tasks.size());
  std::atomic<std::int64_t> done = 0;
  std::mutex reporting;
  oneapi::tbb::enumerable_thread_specific<fast::Workspace> workspaces;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, tasks.size(), 1),
        [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
          for (std::size_t t = range.begin(); t < range.end(); ++t) {
            if (done_of_batch_.contains(t)) continue;
            if (stop()) return;
            held[t] = hold(cells_[tasks[t].cell], tasks[t].pose, workspaces.local());
            const std::int64_t now = before + ++done;
            if (const std::unique_lock lock(reporting, std::try_to_lock); lock) progress(now);
          }
        },
        oneapi::tbb::simple_partitioner());
  });

  for (std::size_t t = 0; t < tasks.size(); ++t) {
    std::vector<PoseOutcome>& outcomes = held[t].outcomes;
    if (!outcomes.empty()) done_of_batch_.insert(t);
    for (std::size_t m = 0; m < outcomes.size(); ++m) {
      const std::size_t c = tasks[t].cell + m;
      PoseOutcome& outcome = outcomes[m];
      cells_[c].without_scene += !held[t].in_scene;
      cells_[c].tally.add(outcome, poses_.pose_name(cells_[c], tasks[t].pose));
      if (!outcome.disagreements.empty()) findings_.push_back({c, tasks[t].pose, std::move(outcome.disagreements)});
    }
  }
  // The same ones are kept, in the same order, however often the run was interrupted.
  std::sort(findings_.begin(), findings_.end(),
            [](const Finding& a, const Finding& b) { return std::pair(a.cell, a.pose) < std::pair(b.cell, b.pose); });
  if (findings_.size() > kMostFindings) findings_.resize(kMostFindings);
  if (done_of_batch_.size() < tasks.size()) return;
  done_of_batch_.clear();
  ++batches_done_;
}

nlohmann::ordered_json Verification::state() const {
  nlohmann::ordered_json json;
  json["run"] = identity_of(plan());
  json["batches_done"] = batches_done_;
  json["done_of_batch"] = done_of_batch_;
  json["cells"] = nlohmann::ordered_json::array();
  for (const Cell& cell : cells_) {
    json["cells"].push_back(cell.tally.to_json());
    json["without_scene"].push_back(cell.without_scene);
  }
  json["findings"] = nlohmann::ordered_json::array();
  for (const Finding& finding : findings_) {
    auto list = nlohmann::ordered_json::array();
    for (const Disagreement& d : finding.disagreements) list.push_back({static_cast<int>(d.kind), d.text});
    json["findings"].push_back({finding.cell, finding.pose, list});
  }
  return json;
}

void Verification::restore(const nlohmann::ordered_json& state) {
  if (state.at("run") != identity_of(plan())) throw BadInput("the state is of another run");
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    cells_[c].tally = Tally::from_json(state.at("cells").at(c));
    cells_[c].without_scene = state.at("without_scene").at(c).get<std::int64_t>();
  }
  batches_done_ = state.at("batches_done").get<std::int64_t>();
  done_of_batch_ = state.at("done_of_batch").get<std::set<std::size_t>>();
  findings_.clear();
  for (const auto& entry : state.at("findings")) {
    Finding finding{entry.at(0).get<std::size_t>(), entry.at(1).get<std::int64_t>(), {}};
    for (const auto& d : entry.at(2))
      finding.disagreements.push_back({static_cast<Kind>(d.at(0).get<int>()), d.at(1).get<std::string>()});
    findings_.push_back(std::move(finding));
  }
}

}  // namespace pcm::compare
