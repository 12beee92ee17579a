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

#include "compare/io/poses_file.h"
#include "compare/io/question_json.h"
#include "fast/force/law_parameters.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// What `read` gives; what it throws names the place.
template <class Read>
auto within(const std::string& place, const Read& read) {
  try {
    return read();
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(place + ": " + description(error));
  } catch (const BadInput& error) {
    throw BadInput(place + ": " + error.what());
  }
}

const Json& array_at(const Json& json, const char* key) {
  const Json& array = json.at(key);
  if (!array.is_array()) throw BadInput(std::string(key) + ": is no array");
  return array;
}

std::string text_at(const Json& json, const char* key) {
  const Json& text = json.at(key);
  return within(key, [&] { return text.get<std::string>(); });
}

struct NamedSurface {
  std::string name;
  fs::path file;
  TriangleMesh mesh;
};

NamedSurface surface_from(const Json& json, const fs::path& folder) {
  NamedSurface surface{text_at(json, "name"), folder / text_at(json, "file"), {}};
  surface.mesh = read_mesh(surface.file);
  require_fit(surface.mesh);
  return surface;
}

const NamedSurface& surface_at(const Json& json, const char* key, const std::vector<NamedSurface>& surfaces) {
  const Json& index = json.at(key);
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
  const Json& law = json.at("law");
  within("law", [&] {
    pair.law = law_from(law);
    fast::require_valid(pair.law);
  });
  RecordedPoses& recorded = plan.recorded.emplace_back();
  const Json& mode = json.at("mode");
  const Json& scheme = json.at("scheme");
  recorded.modes = {within("mode", [&] { return mode_from(mode); })};
  recorded.scheme = within("scheme", [&] { return scheme_from(scheme); });
  recorded.file = folder / text_at(json, "poses");
}

constexpr std::string_view kNoTrajectory =
    "this is no trajectory of pcm; give trajectory/trajectory.json of a folder of 'pcm simulate'";

Json parsed_index(const std::string& text) {
  try {
    return Json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(std::string(kNoTrajectory) + ": " + description(error));
  }
}

VerificationPlan read_index(const fs::path& file) {
  const std::string text = read_text_file(file);
  return within(file.string(), [&] {
    VerificationPlan plan;
    const Json json = parsed_index(text);
    if (!json.is_object() || !json.contains("pcm_trajectory"))
      throw BadInput(std::string(kNoTrajectory) + " (\"pcm_trajectory\": 1 is missing)");
    if (json["pcm_trajectory"] != 1)
      throw BadInput("\"pcm_trajectory\" is " + json["pcm_trajectory"].dump() +
                     ", and only 1 is known; record it anew");
    const fs::path folder = file.parent_path();
    std::vector<NamedSurface> surfaces;
    for (const Json& surface : array_at(json, "surfaces"))
      surfaces.push_back(
          within(fmt::format("surfaces[{}]", surfaces.size()), [&] { return surface_from(surface, folder); }));
    for (const Json& pairing : array_at(json, "pairings"))
      within(fmt::format("pairings[{}]", plan.pairs.size()), [&] { add_pairing(pairing, surfaces, folder, plan); });
    return plan;
  });
}

std::vector<RecordedState> read_states(const fs::path& file) {
  std::vector<RecordedState> states;
  std::error_code error;
  if (fs::is_regular_file(file, error) && fs::file_size(file, error) == 0) return states;
  PosesFile poses(file);
  while (const std::optional<State> state = poses.next())
    states.push_back({state->pose, state->velocity, poses.line()});
  return states;
}

/// Of all that are recorded, one pairing after the other, those at even distances: so each pairing keeps its share.
void keep_evenly(std::vector<RecordedPoses>& pairings, std::int64_t all, std::int64_t kept) {
  std::int64_t seen = 0, next = 0;
  for (RecordedPoses& pairing : pairings) {
    std::vector<RecordedState> states;
    for (const RecordedState& state : pairing.states)
      if (seen++ == next * all / kept) {
        states.push_back(state);
        ++next;
      }
    pairing.states = std::move(states);
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
    pairing.in_file = std::ssize(pairing.states);
    all += pairing.in_file;
    if (choice.modes) pairing.modes = *choice.modes;
    pairing.scheme = choice.scheme.value_or(pairing.scheme);
  }
  if (all == 0) throw BadInput(file.string() + ": no pairing has a pose; its bodies never touched");
  plan.poses = std::min(all, choice.poses.value_or(all));
  keep_evenly(plan.recorded, all, plan.poses);
  plan.strata = {Stratum::trajectory};
  plan.modes = choice.modes.value_or(
      taken(std::array{Mode::E, Mode::F, Mode::both}, plan.recorded,
            [](const RecordedPoses& pairing, Mode mode) { return pairing.modes.front() == mode; }));
  plan.schemes = taken(std::array{Scheme::barycentric, Scheme::clipped}, plan.recorded,
                       [](const RecordedPoses& pairing, Scheme scheme) { return pairing.scheme == scheme; });
  return plan;
}

}  // namespace pcm::compare
