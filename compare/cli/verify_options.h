// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/command_line.h"

namespace pcm::compare {

/// The options of `pcm verify` as they were typed, or their defaults.
struct VerifyOptions {
  std::string poses;
  std::string seed;
  std::vector<std::string> strata;
  std::vector<std::vector<std::string>> pairs;
  std::string mode = "both";
  std::optional<std::string> scheme;  ///< both, where it is not given
  std::vector<std::string> engines;
  std::optional<std::string> jobs;
  std::optional<std::string> out;
  std::optional<std::string> case_file;
  bool known_answers = false;
  bool error_budget = false;
  bool audits = false;
  bool quick = false;
};

/// Adds the subcommand; `act` is what it does.
void add_verify_command(CLI::App& program, Run& run, const std::function<Exit(const VerifyOptions&)>& act);

/// Whether the options ask for other tables than those of random poses or a case file (verify_other_tables.h).
bool asks_for_other_tables(const VerifyOptions& options);

}  // namespace pcm::compare
