// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "compare/verify/run/verify.h"

/// A verification kept in a folder, so that a later call of the program continues it.
namespace pcm::compare {

/// Keeps the run's state with its SHA-256, so that a damaged file is not continued from; where it is finished with the
/// date and `program`, the call that finished it (provenance_json).
void keep_run(const std::filesystem::path& folder, const Verification& run, const nlohmann::ordered_json& program);

/// What became of a run that was kept.
struct Resumption {
  std::string notice;                      ///< a line on it for standard error; empty where there is nothing to say
  std::optional<std::string> finished_at;  ///< where an earlier call finished the run: when
  nlohmann::ordered_json finished_by;      ///< and what it said of itself
};

/// Continues `run` from what is kept in the folder, if anything is.
///
/// A run of another build of the program or on other surfaces says nothing about this one: it is not continued, and its
/// state, tables and cases are removed, so that nothing of it is left beside the new ones; so are tables and cases
/// without a state. Throws BadInput, and removes nothing, where the state is damaged, or of a run with other arguments
/// (poses, seed, strata, modes, schemes; also where it lacks one of them or has one more), which the caller may want to
/// keep.
Resumption resume_run(const std::filesystem::path& folder, Verification& run);

}  // namespace pcm::compare
