// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/output_files.h"

#include <sys/stat.h>
#include <unistd.h>

#include "pcm/bad_input.h"

namespace pcm::compare {

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const std::filesystem::path one = std::filesystem::weakly_canonical(std::filesystem::absolute(a), error);
  const std::filesystem::path other = std::filesystem::weakly_canonical(std::filesystem::absolute(b), error);
  return !one.empty() && one == other;
}

namespace {

/// Whether the file is the one that a standard stream was led from or into.
bool is_stream(int stream, const std::filesystem::path& file) {
  struct stat named {
  }, led{};
  return fstat(stream, &led) == 0 && S_ISREG(led.st_mode) && stat(file.c_str(), &named) == 0 &&
         named.st_dev == led.st_dev && named.st_ino == led.st_ino;
}

}  // namespace

bool is_taken_as(const std::filesystem::path& file, const std::string& other) {
  return other == "-" ? is_stream(STDIN_FILENO, file) : is_same_file(file, other);
}

std::vector<std::string> require_files_of_their_own(const std::vector<OutputFile>& outputs,
                                                    const std::vector<std::string>& inputs) {
  std::vector<std::string> taken = inputs;
  for (const auto& [option, file] : outputs) {
    if (!file) continue;
    if (file->empty() || *file == "-") throw BadInput(option + ": name a file");
    if (std::filesystem::is_directory(*file)) throw BadInput(*file + ": this is a folder; name a file");
    for (const std::string& other : taken)
      if (is_taken_as(*file, other))
        throw BadInput(*file + ": is read or written already; name another file for " + option);
    taken.push_back(*file);
  }
  return taken;
}

void require_no_standard_output(const std::vector<OutputFile>& outputs) {
  for (const auto& [option, file] : outputs)
    if (file && is_stream(STDOUT_FILENO, *file))
      throw BadInput(*file + ": what is printed goes there already; name another file for " + option);
}

void require_writable(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw BadInput(file.string() + ": this is a folder or a device; name a file");
  // A file is written beside the one that it replaces: it is the folder that must allow it.
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, error) || access(folder.c_str(), W_OK | X_OK) != 0)
    throw BadInput(file.string() +
                   ": the file can't be created; check that its folder exists and that you may write to it");
}

}  // namespace pcm::compare
