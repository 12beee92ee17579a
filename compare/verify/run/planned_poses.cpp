// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/planned_poses.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <optional>

#include "compare/io/names.h"
#include "compare/poses/extreme_meshes.h"
#include "compare/verify/routes/state_draw.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// Larger pairs have no part in the stratum nested.
constexpr std::size_t kMostNestedFaces = 20000;

/// Nor have larger ones in extreme, where each is prepared for contact many times over.
constexpr std::size_t kMostExtremeFaces = 2000;

/// One pose in this many of a hard stratum falls to the general pairs.
constexpr std::int64_t kGeneralShare = 50;

/// In a plan that has both schemes one pose in this many is answered in the clipped one.
constexpr std::int64_t kClippedShare = 3;

/// A recorded pose is come to from this many states before it: a pairing's memory follows short steps from the fourth
/// in a row on.
constexpr std::size_t kRecordedBefore = 6;

/// A whole cut into portions in the ratio of their weights: each is the difference of two rounded-down running sums.
class Portions {
 public:
  Portions(std::int64_t whole, std::int64_t weights) : whole_(whole), weights_(weights) {}

  std::int64_t next(std::int64_t weight) {
    const std::int64_t before = whole_ * weight_ / weights_;
    weight_ += weight;
    return whole_ * weight_ / weights_ - before;
  }

 private:
  std::int64_t whole_, weights_, weight_ = 0;
};

/// The stream of random numbers of a pair: 64 bits of the FNV-1a hash of its name. Written out, because another hash
/// would draw other poses, and that of the standard library is another one from library to library.
std::uint64_t stream_of(const std::string& pair_name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : pair_name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// The first of the names, and how many more there are.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(kMost, names.size()); ++k) text += (k == 0 ? "" : ", ") + names[k];
  return names.size() <= kMost ? text : text + fmt::format(" and {} more", names.size() - kMost);
}

}  // namespace

PlannedPoses::PlannedPoses(VerificationPlan plan, const EngineSeam& seam)
    : plan_(std::move(plan)),
      modes_per_pose_(std::ssize(plan_.recorded.empty() ? plan_.modes : plan_.recorded.front().modes)),
      seam_(&seam),
      held_pairings_(plan_.pairs.size()) {
  prepare_pairings();
  if (plan_.recorded.empty())
    add_drawn_cells();
  else
    add_recorded_cells();
}

void PlannedPoses::prepare_pairings() {
  const auto wants = [this](Stratum stratum) {
    return std::find(plan_.strata.begin(), plan_.strata.end(), stratum) != plan_.strata.end();
  };
  const bool wants_nested = wants(Stratum::nested), wants_extreme = wants(Stratum::extreme);
  oneapi::tbb::parallel_for(std::size_t{0}, plan_.pairs.size(), [&](std::size_t i) {
    const SurfacePair& pair = plan_.pairs[i];
    if (!plan_.recorded.empty() && plan_.recorded[i].chosen.empty()) return;
    const HeldPairing::Modes& modes = plan_.recorded.empty() ? plan_.modes : plan_.recorded[i].modes;
    try {
      const auto held = [&](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
        return std::make_unique<HeldPairing>(mesh_E, mesh_F, pair.law, modes, plan_.schemes.front());
      };
      held_pairings_[i].usual.push_back(held(pair.E, pair.F));
      for (const auto& [mesh_E, mesh_F] : pair.variants) held_pairings_[i].usual.push_back(held(mesh_E, mesh_F));
      if (!pair.motion.empty()) return;
      if (wants_extreme && pair.for_hard_strata && pair.faces() <= kMostExtremeFaces) {
        // Of a family each pair is taken to one extreme after the other.
        const std::vector<std::unique_ptr<HeldPairing>>& family = held_pairings_[i].usual;
        for (std::size_t k = 0; k < std::max(kExtremes, family.size()); ++k) {
          const FeaturePair& of = family[k % family.size()]->features();
          const auto [mesh_E, mesh_F] = extreme_meshes(of.E.mesh, of.F.mesh, k % kExtremes);
          held_pairings_[i].extreme.push_back(held(mesh_E, mesh_F));
        }
      }
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

/// Whether it has the surfaces, or the recording, that the stratum asks for.
bool PlannedPoses::takes_part(std::size_t pair, Stratum stratum) const {
  const bool is_recorded = !plan_.pairs[pair].motion.empty();
  if (is_recorded != (stratum == Stratum::trajectory)) return false;
  if (stratum == Stratum::nested) return held_pairings_[pair].nested != nullptr;
  if (stratum == Stratum::extreme) return !held_pairings_[pair].extreme.empty();
  return true;
}

void PlannedPoses::add_drawn_cells() {
  Fit fit;
  std::map<std::pair<std::size_t, Stratum>, std::int64_t> numbered;
  const auto add_cells_in = [&](Scheme scheme, Stratum stratum, std::int64_t poses,
                                const std::vector<std::size_t>& pairs) {
    std::int64_t hurting = 0, others = 0;
    for (const std::size_t k : pairs) {
      const SurfacePair& pair = plan_.pairs[k];
      (pair.made_to_hurt ? hurting : others) += pair.share(stratum, scheme);
    }
    // The measure is demanded of the others' generic poses: they get half of these at least.
    const bool halved = stratum == Stratum::generic && others > 0 && hurting > others;
    Portions of_others(halved ? poses - poses / 2 : poses, halved ? others : others + hurting);
    Portions of_hurting(poses / 2, hurting);
    for (const std::size_t k : pairs) {
      const SurfacePair& pair = plan_.pairs[k];
      Portions& portions = halved && pair.made_to_hurt ? of_hurting : of_others;
      const std::int64_t n = portions.next(pair.share(stratum, scheme));
      fit.pairs.insert(k);
      fit.strata.insert(stratum);
      ++fit.cells;
      if (n == 0) continue;
      std::int64_t& first = numbered[{k, stratum}];
      for (const Mode mode : plan_.modes) cells_.push_back({k, stratum, scheme, mode, first, n});
      first += n;
    }
  };
  const auto add_cells = [&](Stratum stratum, std::int64_t poses, const std::vector<std::size_t>& pairs) {
    const bool both = plan_.schemes.size() > 1;
    const std::int64_t clipped = (poses + 1) / kClippedShare;
    for (const Scheme scheme : plan_.schemes)
      add_cells_in(scheme, stratum, !both ? poses : scheme == Scheme::clipped ? clipped : poses - clipped, pairs);
  };
  Portions of_strata(plan_.poses, std::ssize(plan_.strata));
  for (const Stratum stratum : plan_.strata) {
    std::vector<std::size_t> general, small;
    for (std::size_t i = 0; i < plan_.pairs.size(); ++i) {
      const SurfacePair& pair = plan_.pairs[i];
      if (takes_part(i, stratum)) {
        if (hard(stratum) && pair.for_hard_strata)
          small.push_back(i);
        else if (pair.for_all_strata)
          general.push_back(i);
      } else if (stratum == Stratum::nested && pair.for_all_strata && pair.motion.empty()) {
        omissions_.push_back("nested: left out for " + pair.name +
                             " (no room inside either surface, or too many faces)");
      }
    }
    const std::int64_t poses = of_strata.next(1);
    const std::int64_t for_general = small.empty() ? poses : general.empty() ? 0 : poses / kGeneralShare;
    add_cells(stratum, for_general, general);
    add_cells(stratum, poses - for_general, small);
  }
  if (cells_.empty())
    throw BadInput(
        "none of the strata asked for is to be had with these pairs (trajectory has pairs of its own, those of the "
        "scenes of 'pcm simulate'); ask for other strata, or leave out --pair");
  say_what_gets_no_pose(fit);
}

void PlannedPoses::add_recorded_cells() {
  std::size_t without = 0;
  for (std::size_t k = 0; k < plan_.pairs.size(); ++k) {
    const RecordedPoses& recorded = plan_.recorded[k];
    const std::int64_t n = std::ssize(recorded.chosen);
    for (const Mode mode : recorded.modes)
      if (n > 0) cells_.push_back({k, Stratum::trajectory, recorded.scheme, mode, 0, n});
    if (n > 0) continue;
    ++without;
    omissions_.push_back("pair " + plan_.pairs[k].name + " gets no pose: " +
                         (recorded.states.empty() ? "none is recorded, for it never touched"
                                                  : fmt::format("{} poses are too few", plan_.poses)));
  }
  if (cells_.empty()) throw BadInput("no pose is recorded");
  if (without > 0) without_poses_ = fmt::format("{} of {} pairs", without, plan_.pairs.size());
}

void PlannedPoses::say_what_gets_no_pose(const Fit& fit) {
  std::set<std::size_t> pairs;
  std::set<Stratum> strata;
  std::set<Scheme> schemes;
  for (const PlannedCell& cell : cells_) {
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

std::string PlannedPoses::pose_name(const PlannedCell& cell, std::int64_t pose) const {
  const RecordedState* const state = recorded(cell, pose);
  const std::int64_t number = state == nullptr ? pose : state->line;
  return plan_.pairs[cell.pair].name + "/" + std::string(name(cell.stratum)) + "/" + std::to_string(number) + "/" +
         std::string(name(cell.mode)) + (plan_.schemes.size() > 1 && cell.scheme == Scheme::clipped ? "/clipped" : "");
}

const HeldPairing& PlannedPoses::held_pairing(const PlannedCell& cell, std::int64_t pose) const {
  const HeldPairings& pairings = held_pairings_[cell.pair];
  if (cell.stratum == Stratum::nested) return *pairings.nested;
  const auto& variants = cell.stratum == Stratum::extreme ? pairings.extreme : pairings.usual;
  return *variants[static_cast<std::size_t>(pose) % variants.size()];
}

const RecordedState* PlannedPoses::recorded(const PlannedCell& cell, std::int64_t pose) const {
  if (plan_.recorded.empty()) return nullptr;
  const RecordedPoses& poses = plan_.recorded[cell.pair];
  return &poses.states[poses.chosen[static_cast<std::size_t>(pose)]];
}

std::vector<MovingPose> PlannedPoses::recorded_before(const PlannedCell& cell, std::int64_t pose) const {
  const RecordedPoses& poses = plan_.recorded[cell.pair];
  const std::size_t at = poses.chosen[static_cast<std::size_t>(pose)];
  std::vector<MovingPose> before;
  for (std::size_t i = at - std::min(at, kRecordedBefore); i < at; ++i)
    before.push_back({poses.states[i].pose, poses.states[i].velocity});
  return before;
}

PoseRandom PlannedPoses::random_of(const PlannedCell& cell, std::int64_t pose, Purpose purpose) const {
  return {plan_.seed, static_cast<std::uint64_t>(cell.stratum), stream_of(plan_.pairs[cell.pair].name),
          static_cast<std::uint64_t>(pose), purpose};
}

DrawnPose PlannedPoses::draw(const PlannedCell& cell, std::int64_t pose) const {
  if (const RecordedState* const state = recorded(cell, pose))
    return {state->pose, state->velocity, "recorded", false, {}};
  const PoseRandom random = random_of(cell, pose, Purpose::pose);
  const FeaturePair& features = held_pairing(cell, pose).features();
  return cell.stratum == Stratum::trajectory ? draw_along(plan_.pairs[cell.pair].motion, features.size(), random)
                                             : draw_pose(cell.stratum, features, random);
}

HeldPairing::State PlannedPoses::asked(const PlannedCell& cell, std::int64_t pose) const {
  if (const RecordedState* const state = recorded(cell, pose))
    return {state->pose, state->velocity, plan_.pairs[cell.pair].law, cell.scheme, recorded_before(cell, pose)};
  if (cell.stratum == Stratum::trajectory) {
    DrawnPose drawn = draw(cell, pose);
    return {drawn.pose, drawn.velocity, plan_.pairs[cell.pair].law, cell.scheme, std::move(drawn.before)};
  }
  if (plan_.law)
    return state_under_law(held_pairing(cell, pose), cell.stratum, draw(cell, pose), cell.scheme, *plan_.law,
                           random_of(cell, pose, Purpose::velocity));
  return draw_state(held_pairing(cell, pose), cell.stratum, draw(cell, pose), cell.scheme,
                    random_of(cell, pose, Purpose::law), random_of(cell, pose, Purpose::velocity), *seam_);
}

std::string PlannedPoses::origin(const PlannedCell& cell, std::int64_t pose) const {
  if (const RecordedState* const state = recorded(cell, pose))
    return fmt::format("{}:{}, {}", plan_.recorded[cell.pair].file.string(), state->line, pose_name(cell, pose));
  return fmt::format("seed {}, {}, {}", plan_.seed, pose_name(cell, pose), draw(cell, pose).construction);
}

Case PlannedPoses::as_case(const PlannedCell& cell, std::int64_t pose) const {
  const SurfacePair& pair = plan_.pairs[cell.pair];
  const FeaturePair& meshes = held_pairing(cell, pose).features();
  Case posed;
  posed.origin = origin(cell, pose);
  posed.E = meshes.E.mesh;
  posed.F = meshes.F.mesh;
  // The strata nested and extreme scale meshes; they are then no longer those of the files.
  if (posed.E.name == pair.E.name) posed.file_E = pair.file_E;
  if (posed.F.name == pair.F.name) posed.file_F = pair.file_F;
  const auto set = [&posed](const HeldPairing::State& state, Mode mode) {
    posed.pose = state.pose;
    posed.velocity = state.velocity;
    posed.before = state.before;
    posed.law = state.law;
    posed.mode = mode;
    posed.scheme = state.scheme;
  };
  try {
    set(asked(cell, pose), cell.mode);
  } catch (const DrawFailure& failure) {
    set(failure.state(), Mode::both);
  }
  return posed;
}

}  // namespace pcm::compare
