// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "compare/io/provenance/program_provenance.h"
#include "compare/io/tables/column_units.h"

namespace pcm::compare {

/// What tables of a command are told of in.
inline std::string provenance_file(const std::string& command) {
  return command + ".provenance.json";
}

/// Throws BadInput naming the first of these files that is in the folder without an earlier call of the command having
/// left it there, as its provenance file tells, or the one ending in .part: to be asked before long work.
void refuse_files_of_others(const std::filesystem::path& folder, const std::string& command,
                            const std::vector<std::string>& files);

/// A command's tables in one folder, each with what made it.
///
/// NAME.md ends with version, commit, compiler, machine and command line, and NAME.tex has the same tables for LaTeX.
/// An object in NAME.json begins with the key "provenance", which adds what was asked. A CSV file holds nothing but its
/// columns; so COMMAND.provenance.json, written last, has all of this once more, the SHA-256 of every table and
/// picture, and the units of the columns of every CSV file. Several commands may share a folder.
///
/// Every file is written whole or not at all; throws BadInput naming it where it can't be. Until the last of them
/// COMMAND.provenance.json.part tells which ones the command has begun, so that it may replace them.
class ReportFolder {
 public:
  /// `question`: what was asked, an object: seed, schemes, modes, laws, hashes of the surfaces. What an earlier call of
  /// the command said of its tables holds no more.
  ReportFolder(std::filesystem::path folder, const std::string& command, nlohmann::ordered_json question,
               ProgramProvenance program = this_program());

  void markdown(const std::string& name, const std::string& text);
  void csv(const std::string& name, const std::string& text, const ColumnUnits& units);
  /// A CSV file that is there already: of one written line by line. Throws BadInput where it can't be read.
  void csv_there(const std::string& name, const ColumnUnits& units);
  void json(const std::string& name, const nlohmann::ordered_json& value);
  /// NAME.svg.
  void picture(const std::string& name, const std::string& svg);
  /// COMMAND.provenance.json.
  void finish();

 private:
  void write(const std::string& file, const std::string& text);
  /// Of the columns whose names stand in `header`, the first line of a CSV file.
  void note_units(const std::string& file, std::string_view header, const ColumnUnits& units);

  std::filesystem::path folder_;
  std::string provenance_file_, unfinished_file_;
  ProgramProvenance program_;
  nlohmann::ordered_json provenance_;
  nlohmann::ordered_json files_;
  nlohmann::ordered_json own_;  ///< by name, what is known as the command's: of earlier calls, and what is begun
};

}  // namespace pcm::compare
