// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/report_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "compare/io/json/json_file.h"
#include "compare/io/provenance/sha256.h"
#include "compare/io/split_at_commas.h"
#include "compare/io/tables/latex.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// Indented by four blanks, which Markdown leaves as it stands.
std::string made_by(const ProgramProvenance& program) {
  return fmt::format("pcm {}, commit {}; {}, {}; {}:\n\n    {}\n", program.version, program.commit, program.compiler,
                     program.flags, program.processor, program.command_line);
}

/// Which tables a call has begun to write, until all are there.
std::string unfinished_file(const std::string& command) {
  return provenance_file(command) + ".part";
}

/// What earlier calls have left, an object by name.
nlohmann::ordered_json files_of(const fs::path& folder, const std::string& command) {
  auto files = nlohmann::ordered_json::object();
  for (const std::string& name : {provenance_file(command), unfinished_file(command)}) {
    const nlohmann::ordered_json provenance = json_or_discarded(folder / name);
    if (provenance.is_object() && provenance.contains("files") && provenance["files"].is_object())
      files.update(provenance["files"]);
  }
  return files;
}

std::string as_latex_comment(const std::string& text) {
  std::string comment = "% ";
  for (const char c : text) {
    comment += c;
    if (c == '\n') comment += "% ";
  }
  return comment + "\n";
}

bool is_column(std::string name, const std::string& pattern) {
  const std::size_t words = name.find_last_not_of("0123456789");
  if (words != std::string::npos && words > 0 && words + 1 < name.size() && name[words] == '_') name.erase(words);
  if (name == pattern) return true;
  return name.size() > pattern.size() && name.ends_with(pattern) &&
         std::string_view(" _").find(name[name.size() - pattern.size() - 1]) != std::string_view::npos;
}

}  // namespace

void refuse_files_of_others(const fs::path& folder, const std::string& command, const std::vector<std::string>& files) {
  const nlohmann::ordered_json own = files_of(folder, command);
  std::error_code none_there;
  for (const std::string& file : files)
    if (!own.contains(file) && fs::exists(fs::symlink_status(folder / file, none_there)))
      throw BadInput(fmt::format(
          "{} is there, and {} does not say that this command has written it; move it away, or choose another folder",
          (folder / file).string(), provenance_file(command)));
}

ReportFolder::ReportFolder(fs::path folder, const std::string& command, nlohmann::ordered_json question,
                           ProgramProvenance program)
    : folder_(std::move(folder)),
      provenance_file_(provenance_file(command)),
      unfinished_file_(unfinished_file(command)),
      program_(std::move(program)),
      provenance_(provenance_json(program_)),
      files_(nlohmann::ordered_json::object()),
      own_(files_of(folder_, command)) {
  provenance_["question"] = std::move(question);
  std::error_code none_there;
  // What an earlier call has left is its own until all is there anew.
  if (fs::exists(folder_ / provenance_file_, none_there))
    fs::rename(folder_ / provenance_file_, folder_ / unfinished_file_, none_there);
}

void ReportFolder::write(const std::string& file, const std::string& text) {
  files_[file]["sha256"] = sha256(text);
  if (!own_.contains(file)) {
    own_[file] = files_[file];
    write_text_file(folder_ / unfinished_file_, json_file_text({{"files", own_}}));
  }
  write_text_file(folder_ / file, text);
}

void ReportFolder::markdown(const std::string& name, const std::string& text) {
  write(name + ".md", text + "\nMade by " + made_by(program_));
  write(name + ".tex", as_latex_comment("Made by " + made_by(program_)) + latex_tables(text));
}

void ReportFolder::csv(const std::string& name, const std::string& text, const ColumnUnits& units) {
  write(name + ".csv", text);
  note_units(name + ".csv", std::string_view(text).substr(0, text.find('\n')), units);
}

void ReportFolder::csv_there(const std::string& name, const ColumnUnits& units) {
  const std::string file = name + ".csv";
  const std::optional<std::string> hash = sha256_of_file(folder_ / file);
  std::ifstream in(folder_ / file);
  std::string header;
  if (!hash || !std::getline(in, header)) throw BadInput((folder_ / file).string() + ": can't be read");
  files_[file]["sha256"] = *hash;
  note_units(file, header, units);
}

void ReportFolder::note_units(const std::string& file, std::string_view header, const ColumnUnits& units) {
  nlohmann::ordered_json& named = files_[file]["units"] = nlohmann::ordered_json::object();
  // The names hold no quotes.
  for (const std::string& column : split_at_commas(header)) {
    const auto unit =
        std::find_if(units.begin(), units.end(), [&](const auto& entry) { return is_column(column, entry.first); });
    if (unit != units.end()) named[column] = unit->second;
  }
}

void ReportFolder::json(const std::string& name, const nlohmann::ordered_json& value) {
  if (!value.is_object()) {
    write(name + ".json", json_file_text(value));
    return;
  }
  nlohmann::ordered_json whole{{"provenance", provenance_}};
  whole.update(value);
  write(name + ".json", json_file_text(whole));
}

void ReportFolder::picture(const std::string& name, const std::string& svg) {
  write(name + ".svg", svg);
}

void ReportFolder::finish() {
  nlohmann::ordered_json whole = provenance_;
  whole["files"] = files_;
  write_text_file(folder_ / provenance_file_, json_file_text(whole));
  std::error_code none_there;
  fs::remove(folder_ / unfinished_file_, none_there);
}

}  // namespace pcm::compare
