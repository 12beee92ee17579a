// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace pcm::compare {

/// Which program made a table, how it was built and started, and where it ran.
struct ProgramProvenance {
  std::string version;       ///< e.g. "0.1.0"
  std::string commit;        ///< of commit.h
  std::string command_line;  ///< as a shell takes it, e.g. "pcm verify --out 'my results'"
  std::string processor;     ///< as the kernel names it
  std::string compiler;      ///< e.g. "gcc 12.2.0"
  std::string flags;         ///< that the release was compiled with
};

ProgramProvenance this_program();

nlohmann::ordered_json provenance_json(const ProgramProvenance& program);
/// What provenance_json wrote. Throws nlohmann::json::exception where it is none.
ProgramProvenance program_from(const nlohmann::ordered_json& provenance);

/// Words as a shell takes them, quoted where it would not take them as they are.
std::string quoted_for_shell(const std::string& word);

}  // namespace pcm::compare
