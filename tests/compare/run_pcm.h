// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pcm::compare {

/// What a run of the program left behind.
struct Outcome {
  int status = -1;  ///< exit status; -1 where a signal ended it
  std::string out;
  std::string err;
};

/// Runs the built program with these arguments (no shell in between) and waits for its end.
/// `output` is where standard output goes instead of into the outcome, e.g. "/dev/full"; `input` is where standard
/// input comes from.
Outcome run_pcm(const std::vector<std::string>& arguments, const std::filesystem::path& output = {},
                const std::filesystem::path& input = "/dev/null");

/// Whether run_by_mpirun can be called; tests skip where not.
bool has_mpirun();
/// The same by so many processes that mpirun starts together.
Outcome run_by_mpirun(int processes, const std::vector<std::string>& arguments);

/// The lines of a text, without their line feeds.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace pcm::compare
