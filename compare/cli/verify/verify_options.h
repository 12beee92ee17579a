// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/frame/command_line.h"
#include "compare/cli/frame/law_options.h"

namespace pcm::compare {

/// The options of `pcm verify` as they were typed; those that are not given have their defaults, or nothing where what
/// that means depends on others.
struct VerifyOptions {
  std::optional<std::string> poses;
  std::string seed;
  std::vector<std::string> strata;
  bool usual_strata = false;  ///< where none is named: kUsualStrata, not all
  std::vector<std::vector<std::string>> pairs;
  std::optional<std::string> mode;
  std::optional<std::string> scheme;
  std::vector<std::string> engines;
  std::optional<std::string> jobs;
  std::optional<std::string> out;
  std::optional<std::string> case_file;
  std::optional<std::string> trajectory;
  std::optional<std::string> part;
  std::vector<std::string> merge;
  LawOptions law;
  bool known_answers = false;
  bool error_budget = false;
  bool audits = false;
  bool stability = false;
  bool search = false;
  std::vector<std::string> from;
  bool quick = false;
};

/// Adds the options that say which poses are asked: --poses, --seed, --strata, --pair, --mode, --scheme.
void add_plan_options(CLI::App& command, VerifyOptions& options);

/// Adds the subcommand; `act` is what it does.
void add_verify_command(CLI::App& program, Run& run, const std::function<Exit(const VerifyOptions&)>& act);

/// Whether the options ask for other tables than those of random or recorded poses or a case file
/// (verify_other_tables.h).
bool asks_for_other_tables(const VerifyOptions& options);

}  // namespace pcm::compare
