// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verify.h"

#include <fmt/core.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "compare/io/names.h"
#include "compare/io/program_hash.h"
#include "compare/io/question_json.h"
#include "compare/io/sha256.h"
#include "compare/verify/state_draw.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// Poses a batch: enough to keep the threads busy, few enough to lose little when interrupted.
constexpr std::int64_t kBatch = 1024;

/// Larger pairs have no part in the stratum nested.
constexpr std::size_t kMostNestedFaces = 20000;

/// One pose in this many of a hard stratum falls to the general pairs.
constexpr std::int64_t kGeneralShare = 50;

/// In a plan that has both schemes one pose in this many is answered in the clipped one.
constexpr std::int64_t kClippedShare = 3;

/// The stream of random numbers of a pair: 64 bits of the FNV-1a hash of its name. Written out, because another hash
/// would draw other poses, and that of the standard library is another one from library to library.
std::uint64_t stream_of(const std::string& pair_name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : pair_name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// What of a kept run's identity is not an argument of the command line.
bool is_argument(const std::string& key) {
  return key != "format" && key != "build" && key != "pairs";
}

/// Equal where poses, velocities and lines are, bit for bit.
std::string bytes_of(const std::vector<RecordedState>& states) {
  std::string bytes;
  const auto add = [&bytes](const auto& number) {
    const auto chars = std::bit_cast<std::array<char, sizeof number>>(number);
    bytes.append(chars.data(), chars.size());
  };
  for (const RecordedState& state : states) {
    for (const double x : state.pose.A.reshaped()) add(x);
    for (const Eigen::Vector3d& vector : {state.pose.r, state.velocity.v, state.velocity.w})
      for (const double x : vector) add(x);
    add(state.line);
  }
  return bytes;
}

/// The first of the names, and how many more there are.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(kMost, names.size()); ++k) text += (k == 0 ? "" : ", ") + names[k];
  return names.size() <= kMost ? text : text + fmt::format(" and {} more", names.size() - kMost);
}

/// The cells that have the same value of `key`, together.
template <class KeyOf>
auto merged(const std::vector<Cell>& cells, const KeyOf& key_of) {
  std::map<decltype(key_of(cells.front())), Tally> groups;
  for (const Cell& cell : cells) groups[key_of(cell)].merge(cell.tally);
  return groups;
}

}  // namespace

Verification::~Verification() = default;

Verification::Verification(VerificationPlan plan, const EngineSeam& seam)
    : plan_(std::move(plan)),
      modes_per_pose_(std::ssize(plan_.recorded.empty() ? plan_.modes : plan_.recorded.front().modes)),
      seam_(&seam),
      held_pairings_(plan_.pairs.size()) {
  if (plan_.build.empty()) plan_.build = program_hash();
  prepare_pairings();
  if (plan_.recorded.empty())
    add_drawn_cells();
  else
    add_recorded_cells();
  std::int64_t all = 0;
  for (const Cell& cell : cells_) all += cell.poses;
  batches_ = (all / modes_per_pose_ + kBatch - 1) / kBatch;
}

void Verification::prepare_pairings() {
  const bool wants_nested = std::find(plan_.strata.begin(), plan_.strata.end(), Stratum::nested) != plan_.strata.end();
  oneapi::tbb::parallel_for(std::size_t{0}, plan_.pairs.size(), [&](std::size_t i) {
    const SurfacePair& pair = plan_.pairs[i];
    if (!plan_.recorded.empty() && plan_.recorded[i].states.empty()) return;
    const HeldPairing::Modes& modes = plan_.recorded.empty() ? plan_.modes : plan_.recorded[i].modes;
    try {
      const auto add = [&](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
        held_pairings_[i].usual.push_back(
            std::make_unique<HeldPairing>(mesh_E, mesh_F, pair.law, modes, plan_.schemes.front()));
      };
      add(pair.E, pair.F);
      for (const auto& [mesh_E, mesh_F] : pair.variants) add(mesh_E, mesh_F);
      // All faces of a nested guest are active: tens of thousands cost the oracle tens of seconds a pose.
      if (!wants_nested || !pair.for_all_strata || pair.faces() > kMostNestedFaces) return;
      if (std::optional<NestedMeshes> meshes = nested_meshes(pair.E, pair.F))
        held_pairings_[i].nested =
            std::make_unique<HeldPairing>(std::move(*meshes), pair.law, modes, plan_.schemes.front());
    } catch (const BadInput& error) {
      throw BadInput("pair " + pair.name + ": " + error.what());
    }
  });
}

void Verification::add_drawn_cells() {
  // Part k of a whole cut in the ratio of the weights: the difference of two rounded-down running sums.
  const auto part = [](std::int64_t whole, std::int64_t before, std::int64_t weight, std::int64_t all) {
    return whole * (before + weight) / all - whole * before / all;
  };
  Fit fit;
  std::map<std::pair<std::size_t, Stratum>, std::int64_t> numbered;
  const auto add_cells_in = [&](Scheme scheme, Stratum stratum, std::int64_t poses,
                                const std::vector<std::size_t>& pairs) {
    const auto share_of = [&](std::size_t k) { return plan_.pairs[k].share(stratum, scheme); };
    std::int64_t all = 0, before = 0;
    for (const std::size_t k : pairs) all += share_of(k);
    for (const std::size_t k : pairs) {
      const std::int64_t share = share_of(k);
      fit.pairs.insert(k);
      fit.strata.insert(stratum);
      ++fit.cells;
      if (const std::int64_t n = part(poses, before, share, all); n > 0) {
        std::int64_t& first = numbered[{k, stratum}];
        for (const Mode mode : plan_.modes) cells_.push_back({k, stratum, scheme, mode, first, n, 0, {}});
        first += n;
      }
      before += share;
    }
  };
  const auto add_cells = [&](Stratum stratum, std::int64_t poses, const std::vector<std::size_t>& pairs) {
    const bool both = plan_.schemes.size() > 1;
    const std::int64_t clipped = (poses + 1) / kClippedShare;
    for (const Scheme scheme : plan_.schemes)
      add_cells_in(scheme, stratum, !both ? poses : scheme == Scheme::clipped ? clipped : poses - clipped, pairs);
  };
  const auto strata = static_cast<std::int64_t>(plan_.strata.size());
  for (std::size_t s = 0; s < plan_.strata.size(); ++s) {
    const Stratum stratum = plan_.strata[s];
    std::vector<std::size_t> general, small;
    for (std::size_t i = 0; i < plan_.pairs.size(); ++i) {
      const SurfacePair& pair = plan_.pairs[i];
      if (hard(stratum) && pair.for_hard_strata)
        small.push_back(i);
      else if (pair.for_all_strata && (stratum != Stratum::nested || held_pairings_[i].nested))
        general.push_back(i);
      else if (pair.for_all_strata)
        omissions_.push_back("nested: left out for " + pair.name +
                             " (no room inside either surface, or too many faces)");
    }
    const std::int64_t poses = part(plan_.poses, static_cast<std::int64_t>(s), 1, strata);
    const std::int64_t for_general = small.empty() ? poses : general.empty() ? 0 : poses / kGeneralShare;
    add_cells(stratum, for_general, general);
    add_cells(stratum, poses - for_general, small);
  }
  if (cells_.empty()) throw BadInput("none of the strata asked for is to be had with these pairs");
  say_what_gets_no_pose(fit);
}

void Verification::add_recorded_cells() {
  std::size_t without = 0;
  for (std::size_t k = 0; k < plan_.pairs.size(); ++k) {
    const RecordedPoses& recorded = plan_.recorded[k];
    const std::int64_t n = std::ssize(recorded.states);
    for (const Mode mode : recorded.modes)
      if (n > 0) cells_.push_back({k, Stratum::trajectory, recorded.scheme, mode, 0, n, 0, {}});
    if (n > 0) continue;
    ++without;
    omissions_.push_back("pair " + plan_.pairs[k].name + " gets no pose: " +
                         (recorded.in_file == 0 ? "none is recorded, for it never touched"
                                                : fmt::format("{} poses are too few", plan_.poses)));
  }
  if (cells_.empty()) throw BadInput("no pose is recorded");
  if (without > 0) without_poses_ = fmt::format("{} of {} pairs", without, plan_.pairs.size());
}

void Verification::say_what_gets_no_pose(const Fit& fit) {
  std::set<std::size_t> pairs;
  std::set<Stratum> strata;
  std::set<Scheme> schemes;
  for (const Cell& cell : cells_) {
    pairs.insert(cell.pair);
    strata.insert(cell.stratum);
    schemes.insert(cell.scheme);
  }
  const std::string too_few = fmt::format("{} poses are too few; ask for more with --poses", plan_.poses);
  const auto say = [&](const std::string& what, bool is_named, bool is_fit) {
    const std::string why = " gets no pose: " + (is_fit ? too_few : "it is not to be had with these pairs");
    if (is_named) throw BadInput(what + why);
    omissions_.push_back(what + why);
  };
  const auto add = [&](const std::string& words) { without_poses_ += (without_poses_.empty() ? "" : "; ") + words; };
  for (const Stratum stratum : plan_.strata)
    if (!strata.contains(stratum)) {
      say("stratum " + std::string(name(stratum)), plan_.strata_named, fit.strata.contains(stratum));
      add(std::string(name(stratum)));
    }
  for (const Scheme scheme : plan_.schemes)
    if (!schemes.contains(scheme)) {
      say("the " + std::string(name(scheme)) + " scheme", plan_.schemes_named, true);
      add(std::string(name(scheme)) + " scheme");
    }
  std::vector<std::string> unused;
  for (std::size_t k = 0; k < plan_.pairs.size(); ++k)
    if (!pairs.contains(k)) {
      unused.push_back(plan_.pairs[k].name);
      if (plan_.pairs_named) say("pair " + unused.back(), true, fit.pairs.contains(k));
    }
  if (const std::int64_t empty = fit.cells - std::ssize(cells_) / modes_per_pose(); empty > 0)
    omissions_.push_back(
        fmt::format("{} of {} combinations of pair, stratum and scheme get no pose: {}", empty, fit.cells, too_few));
  if (unused.empty()) return;
  const std::string words = fmt::format("{} of {} pairs", unused.size(), plan_.pairs.size());
  omissions_.push_back(words + " get no pose (" + listed(unused) + "): " + too_few);
  add(words);
}

std::int64_t Verification::poses_done() const {
  std::int64_t done = 0;
  for (const Cell& cell : cells_) done += cell.tally.poses;
  return done / modes_per_pose();
}

Tally Verification::total() const {
  Tally total;
  for (const Cell& cell : cells_) total.merge(cell.tally);
  return total;
}

std::vector<NamedTally> Verification::by_pair() const {
  std::vector<NamedTally> tallies;
  for (const auto& [pair, tally] : merged(cells_, [](const Cell& c) { return c.pair; }))
    tallies.push_back({plan_.pairs[pair].name, tally});
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
  for (const Mode mode : plan_.modes) tallies.push_back({std::string(name(mode)), std::move(groups[mode])});
  return tallies;
}

std::vector<NamedTally> Verification::by_scheme() const {
  std::vector<NamedTally> tallies;
  std::map<Scheme, Tally> groups = merged(cells_, [](const Cell& cell) { return cell.scheme; });
  for (const Scheme scheme : plan_.schemes) tallies.push_back({std::string(name(scheme)), std::move(groups[scheme])});
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

std::string Verification::pose_name(const Cell& cell, std::int64_t pose) const {
  const RecordedState* const state = recorded(cell, pose);
  const std::int64_t number = state == nullptr ? pose : state->line;
  return plan_.pairs[cell.pair].name + "/" + std::string(name(cell.stratum)) + "/" + std::to_string(number) + "/" +
         std::string(name(cell.mode)) + (plan_.schemes.size() > 1 && cell.scheme == Scheme::clipped ? "/clipped" : "");
}

const HeldPairing& Verification::held_pairing(const Cell& cell, std::int64_t pose) const {
  const HeldPairings& pairings = held_pairings_[cell.pair];
  if (cell.stratum == Stratum::nested) return *pairings.nested;
  return *pairings.usual[static_cast<std::size_t>(pose) % pairings.usual.size()];
}

const RecordedState* Verification::recorded(const Cell& cell, std::int64_t pose) const {
  return plan_.recorded.empty() ? nullptr : &plan_.recorded[cell.pair].states[static_cast<std::size_t>(pose)];
}

DrawnPose Verification::draw(const Cell& cell, std::int64_t pose) const {
  if (const RecordedState* const state = recorded(cell, pose)) return {state->pose, state->velocity, "recorded"};
  return draw_pose(cell.stratum, held_pairing(cell, pose).features(),
                   PoseRandom(plan_.seed, static_cast<std::uint64_t>(cell.stratum),
                              stream_of(plan_.pairs[cell.pair].name), static_cast<std::uint64_t>(pose)));
}

HeldPairing::State Verification::asked(const Cell& cell, std::int64_t pose) const {
  if (const RecordedState* const state = recorded(cell, pose))
    return {state->pose, state->velocity, plan_.pairs[cell.pair].law, cell.scheme};
  const auto random = [&](Purpose purpose) {
    return PoseRandom(plan_.seed, static_cast<std::uint64_t>(cell.stratum), stream_of(plan_.pairs[cell.pair].name),
                      static_cast<std::uint64_t>(pose), purpose);
  };
  return draw_state(held_pairing(cell, pose), cell.stratum, draw(cell, pose), cell.scheme, random(Purpose::law),
                    random(Purpose::velocity), *seam_);
}

std::string Verification::origin(const Cell& cell, std::int64_t pose) const {
  if (const RecordedState* const state = recorded(cell, pose))
    return fmt::format("{}:{}, {}", plan_.recorded[cell.pair].file.string(), state->line, pose_name(cell, pose));
  return fmt::format("seed {}, {}, {}", plan_.seed, pose_name(cell, pose), draw(cell, pose).construction);
}

Case Verification::as_case(const Finding& finding) const {
  const Cell& cell = cells_[finding.cell];
  const SurfacePair& pair = plan_.pairs[cell.pair];
  const FeaturePair& meshes = held_pairing(cell, finding.pose).features();
  Case posed;
  posed.origin = origin(cell, finding.pose);
  posed.E = meshes.E.mesh;
  posed.F = meshes.F.mesh;
  // The stratum nested scales meshes; they are then no longer those of the files.
  if (posed.E.name == pair.E.name) posed.file_E = pair.file_E;
  if (posed.F.name == pair.F.name) posed.file_F = pair.file_F;
  const auto set = [&posed](const HeldPairing::State& state, Mode mode) {
    posed.pose = state.pose;
    posed.velocity = state.velocity;
    posed.law = state.law;
    posed.mode = mode;
    posed.scheme = state.scheme;
  };
  try {
    set(asked(cell, finding.pose), cell.mode);
  } catch (const DrawFailure& failure) {
    set(failure.state(), Mode::both);
  }
  return posed;
}

Verification::Held Verification::hold(const Cell& cell, std::int64_t pose, fast::Workspace& workspace) const {
  try {
    const HeldPairing::State state = asked(cell, pose);
    return {held_pairing(cell, pose).hold(state, workspace, *seam_), is_pose_for_scenes(state.pose)};
  } catch (const std::exception& error) {
    PoseOutcome failed;
    failed.disagreements.push_back({Kind::failure, std::string("drawing the state: ") + error.what()});
    return {std::vector<PoseOutcome>(static_cast<std::size_t>(modes_per_pose_), failed),
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
  for (std::size_t c = 0; c < cells_.size(); c += static_cast<std::size_t>(modes_per_pose_)) {
    const std::int64_t n = cells_[c].poses, first = cells_[c].first;
    for (std::int64_t k = n * batches_done_ / batches_; k < n * (batches_done_ + 1) / batches_; ++k)
      tasks.push_back({c, first + k});
  }

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
      cells_[c].tally.add(outcome, pose_name(cells_[c], tasks[t].pose));
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

nlohmann::ordered_json Verification::identity() const {
  nlohmann::ordered_json json;
  json["format"] = "pcm verification 6";
  json["build"] = plan_.build;
  json["poses"] = plan_.poses;
  json["seed"] = plan_.seed;
  for (const Mode mode : plan_.modes) json["modes"].push_back(std::string(name(mode)));
  for (const Scheme scheme : plan_.schemes) json["schemes"].push_back(std::string(name(scheme)));
  for (const Stratum stratum : plan_.strata) json["strata"].push_back(std::string(name(stratum)));
  for (const SurfacePair& pair : plan_.pairs) {
    nlohmann::ordered_json surfaces{sha256(pair.E), sha256(pair.F)};
    for (const auto& [mesh_E, mesh_F] : pair.variants) {
      surfaces.push_back(sha256(mesh_E));
      surfaces.push_back(sha256(mesh_F));
    }
    json["pairs"].push_back({{"name", pair.name}, {"surfaces", surfaces}});
  }
  for (std::size_t k = 0; k < plan_.recorded.size(); ++k) {
    const RecordedPoses& recorded = plan_.recorded[k];
    nlohmann::ordered_json& entry = json["pairs"][k];
    for (const Mode mode : recorded.modes) entry["modes"].push_back(std::string(name(mode)));
    entry["scheme"] = std::string(name(recorded.scheme));
    entry["law"] = law_json(plan_.pairs[k].law);
    entry["states"] = sha256(bytes_of(recorded.states));
  }
  return json;
}

bool Verification::same_arguments(const nlohmann::ordered_json& state) const {
  // What the program and its pairs add is compared apart.
  const nlohmann::ordered_json ours = identity();
  const nlohmann::ordered_json& theirs = state.at("run");
  if (!theirs.is_object()) return false;
  for (const auto& [key, value] : ours.items())
    if (is_argument(key) && (!theirs.contains(key) || theirs[key] != value)) return false;
  for (const auto& [key, value] : theirs.items())
    if (is_argument(key) && !ours.contains(key)) return false;
  return true;
}

std::string Verification::difference_from(const nlohmann::ordered_json& state) const {
  const nlohmann::ordered_json& run = state.at("run");
  if (!run.contains("build") || run["build"] != plan_.build) return "of another build of pcm";
  if (run == identity()) return "";
  return plan_.recorded.empty() ? "on other surfaces" : "of another recording";
}

nlohmann::ordered_json Verification::state() const {
  nlohmann::ordered_json json;
  json["run"] = identity();
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
  if (state.at("run") != identity()) throw BadInput("the state is of another run");
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
