// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "compare/io/json/question_json.h"
#include "compare/io/json/strict_json.h"
#include "compare/poses/poses_file.h"
#include "compare/verify/verdict/question_range.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

struct NamedSurface {
  std::string name;
  fs::path file;
  TriangleMesh mesh;
};

NamedSurface surface_from(const Json& json, const fs::path& folder) {
  NamedSurface surface{text_at(json, "name"), folder / text_at(json, "file"), {}};
  refuse_other_keys(json, {"name", "file"});
  surface.mesh = read_mesh(surface.file);
  require_fit(surface.mesh);
  return surface;
}

const NamedSurface& surface_at(const Json& json, const char* key, const std::vector<NamedSurface>& surfaces) {
  const Json& index = value_at(json, key);
  if (!index.is_number_integer() || index < 0 || index >= surfaces.size())
    throw BadInput(
        fmt::format("{}: {} is no surface's number; there are {}, from 0", key, index.dump(), surfaces.size()));
  return surfaces[index.get<std::size_t>()];
}

/// Adds a pairing to the plan, without its poses yet.
void add_pairing(const Json& json, const std::vector<NamedSurface>& surfaces, const fs::path& folder,
                 VerificationPlan& plan) {
  const NamedSurface& E = surface_at(json, "E", surfaces);
  const NamedSurface& F = surface_at(json, "F", surfaces);
  SurfacePair& pair = plan.pairs.emplace_back();
  pair.name = pair_name(E.name, F.name);
  pair.E = E.mesh;
  pair.F = F.mesh;
  pair.file_E = E.file;
  pair.file_F = F.file;
  pair.law = read_at(json, "law", [](const Json& law) { return law_from(law); });
  within("law", [&] { require_in_range(pair.law); });
  RecordedPoses& recorded = plan.recorded.emplace_back();
  recorded.modes = {read_at(json, "mode", mode_from)};
  recorded.scheme = read_at(json, "scheme", scheme_from);
  recorded.file = folder / text_at(json, "poses");
  refuse_other_keys(json, {"E", "F", "law", "mode", "scheme", "poses"});
}

constexpr std::string_view kNoTrajectory =
    "this is no trajectory of pcm; give trajectory/trajectory.json of a folder of 'pcm simulate'";

VerificationPlan read_index(const fs::path& file) {
  const std::string text = read_text_file(file);
  return within(file.string(), [&] {
    VerificationPlan plan;
    const Json json = strict_json(text, kNoTrajectory);
    if (!json.is_object() || !json.contains("pcm_trajectory"))
      throw BadInput(std::string(kNoTrajectory) + " (\"pcm_trajectory\": 1 is missing)");
    if (json["pcm_trajectory"] != 1)
      throw BadInput("\"pcm_trajectory\" is " + json["pcm_trajectory"].dump() +
                     ", and only 1 is known; record it anew");
    refuse_other_keys(json, {"pcm_trajectory", "surfaces", "pairings"});
    const fs::path folder = file.parent_path();
    std::vector<NamedSurface> surfaces;
    for (const Json& surface : list_at(json, "surfaces"))
      surfaces.push_back(
          within(fmt::format("surfaces[{}]", surfaces.size()), [&] { return surface_from(surface, folder); }));
    for (const Json& pairing : list_at(json, "pairings"))
      within(fmt::format("pairings[{}]", plan.pairs.size()), [&] { add_pairing(pairing, surfaces, folder, plan); });
    return plan;
  });
}

std::vector<RecordedState> read_states(const fs::path& file) {
  std::vector<RecordedState> states;
  std::error_code error;
  if (fs::is_regular_file(file, error) && fs::file_size(file, error) == 0) return states;
  PosesFile poses(file);
  while (const std::optional<State> state = poses.next()) {
    within(poses.place(), [&] { require_in_range(state->pose, state->velocity); });
    states.push_back({state->pose, state->velocity, poses.line()});
  }
  return states;
}

/// Of all that are recorded, one pairing after the other, those at even distances: so each pairing keeps its share.
void choose_evenly(std::vector<RecordedPoses>& pairings, std::int64_t all, std::int64_t number) {
  std::int64_t seen = 0, next = 0;
  for (RecordedPoses& pairing : pairings)
    for (std::size_t i = 0; i < pairing.states.size(); ++i)
      if (seen++ == next * all / number) {
        pairing.chosen.push_back(i);
        ++next;
      }
}

/// The values that `of` takes over all pairings, in the order of the enumeration.
template <class Value, std::size_t N, class Has>
std::vector<Value> taken(const std::array<Value, N>& values, const std::vector<RecordedPoses>& pairings,
                         const Has& has) {
  std::vector<Value> found;
  for (const Value value : values)
    if (std::any_of(pairings.begin(), pairings.end(), [&](const RecordedPoses& p) { return has(p, value); }))
      found.push_back(value);
  return found;
}

}  // namespace

VerificationPlan read_trajectory(const fs::path& file, const TrajectoryChoice& choice) {
  VerificationPlan plan = read_index(file);
  tell_apart(plan.pairs);
  std::int64_t all = 0;
  for (RecordedPoses& pairing : plan.recorded) {
    pairing.states = read_states(pairing.file);
    all += std::ssize(pairing.states);
    if (choice.modes) pairing.modes = *choice.modes;
    pairing.scheme = choice.scheme.value_or(pairing.scheme);
  }
  if (all == 0) throw BadInput(file.string() + ": no pairing has a pose; its bodies never touched");
  plan.poses = std::min(all, choice.poses.value_or(all));
  choose_evenly(plan.recorded, all, plan.poses);
  plan.strata = {Stratum::trajectory};
  plan.modes = choice.modes.value_or(
      taken(std::array{Mode::E, Mode::F, Mode::both}, plan.recorded,
            [](const RecordedPoses& pairing, Mode mode) { return pairing.modes.front() == mode; }));
  plan.schemes = taken(std::array{Scheme::barycentric, Scheme::clipped}, plan.recorded,
                       [](const RecordedPoses& pairing, Scheme scheme) { return pairing.scheme == scheme; });
  return plan;
}

}  // namespace pcm::compare
