// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compare/io/provenance/program_hash.h"
#include "compare/io/tables/kept_values.h"
#include "compare/known_answers/known_answers.h"

namespace pcm::compare {

/// What this program has worked out for a command's tables in the folder, to go on from; without a folder nothing is
/// kept, and what is of another question is begun anew. The file is called TABLES.kept.
inline KeptValues kept_values(const std::optional<std::filesystem::path>& folder, const std::string& tables,
                              const nlohmann::ordered_json& question) {
  if (!folder) return {};
  nlohmann::ordered_json identity{{"format", "pcm kept values 1"}, {"program", program_hash()}};
  identity.update(question);
  return {*folder / (tables + ".kept"), identity};
}
inline KeptValues kept_values(const std::optional<std::filesystem::path>& folder, const std::string& tables,
                              Extent extent) {
  nlohmann::ordered_json question;
  question["quick"] = extent == Extent::quick;
  return kept_values(folder, tables, question);
}

}  // namespace pcm::compare
