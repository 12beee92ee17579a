// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcm::compare {

/// Whether both name the same file, links and all ways to write a path seen through, whether it is there or not.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// An option of the command line and the file that it names, if it was given.
using OutputFile = std::pair<std::string, std::optional<std::string>>;

/// Whether a file to write is this input, or output: `-` stands for the file that standard input was led from.
bool is_taken_as(const std::filesystem::path& file, const std::string& other);

/// Throws BadInput where a file to write has no name, is a folder, another one of those to write, or one of `inputs`,
/// among them `-` where standard input is read. Returns all of them, inputs first.
std::vector<std::string> require_files_of_their_own(const std::vector<OutputFile>& outputs,
                                                    const std::vector<std::string>& inputs);

/// Throws BadInput where a file to write is the one that standard output was led into: of commands that print as well.
void require_no_standard_output(const std::vector<OutputFile>& outputs);

/// Throws BadInput where write_text_file could not write the file, as far as can be told without writing: what is there
/// stays as it is.
void require_writable(const std::filesystem::path& file);

}  // namespace pcm::compare
