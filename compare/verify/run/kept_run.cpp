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

#include "compare/io/sha256.h"
#include "compare/verify/run/run_identity.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kState = "state.json";

/// What a run leaves in its folder beside the state and the case files.
constexpr std::array<std::string_view, 8> kTables = {
    "verification.md",   "verification.tex", "widths.csv", "verification.csv",
    "verification.json", "times.md",         "times.tex",  "verification.provenance.json"};

std::string dump(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string now() {
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::chrono::system_clock::now()));
}

bool is_case_file(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with("case_") && name.ends_with(".json");
}

/// What a run that was killed while it wrote left.
void remove_unfinished_files(const fs::path& folder) {
  remove_unfinished(folder / kState);
  for (const std::string_view table : kTables) remove_unfinished(folder / table);
}

/// Says whether there were any.
bool remove_results(const fs::path& folder) {
  std::vector<fs::path> files = {folder / kState};
  for (const std::string_view table : kTables) files.push_back(folder / table);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (is_case_file(entry.path())) files.push_back(entry.path());
  std::error_code error;
  bool removed = false;
  for (const fs::path& file : files) {
    removed |= fs::remove(file, error);
    if (error) throw BadInput(file.string() + ": of another run, and it can't be removed");
  }
  return removed;
}

}  // namespace

void keep_run(const fs::path& folder, const Verification& run, const nlohmann::ordered_json& program) {
  nlohmann::ordered_json state = run.state();
  if (run.finished()) {
    state["finished_at"] = now();
    state["finished_by"] = program;
  }
  const std::string text = dump(state);
  write_text_file(folder / kState, R"({"sha256":")" + sha256(text) + R"(","state":)" + text + "}\n");
}

Resumption resume_run(const fs::path& folder, Verification& run) {
  const fs::path state_file = folder / kState;
  if (fs::is_directory(folder)) remove_unfinished_files(folder);
  if (!fs::exists(state_file)) {
    if (!fs::is_directory(folder) || !remove_results(folder)) return {};
    return {"--out " + folder.string() + ": tables and cases of a run whose state is gone are removed", {}, {}};
  }
  const std::string text = read_text_file(state_file);
  try {
    const auto kept = nlohmann::ordered_json::parse(text);
    const nlohmann::ordered_json& state = kept.at("state");
    if (sha256(dump(state)) != kept.at("sha256").get<std::string>())
      throw BadInput("its state.json is damaged; choose another folder");
    if (!same_arguments(run.plan(), state.at("run")))
      throw BadInput("it holds another run (other poses, seed, strata, modes, scheme or law); choose another folder");
    if (const std::string difference = difference_from(run.plan(), state.at("run")); !difference.empty()) {
      remove_results(folder);
      return {fmt::format("--out {}: it held a run {}; that run's tables and cases are removed, this one starts anew",
                          folder.string(), difference),
              {},
              {}};
    }
    run.restore(state);
    if (run.finished()) return {"", state.at("finished_at"), state.at("finished_by")};
  } catch (const nlohmann::json::exception&) {
    throw BadInput(state_file.string() + ": this is no state of a verification; choose another folder");
  } catch (const BadInput& error) {
    throw BadInput("--out " + folder.string() + ": " + error.what());
  }
  return {fmt::format("--out {}: continued after {} poses", folder.string(), run.poses_done()), {}, {}};
}

}  // namespace pcm::compare
