// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// `pcm` is several programs in one folder, so that `pcm verify` needn't wait until the others are built: what its own
/// file lacks, pcm hands over, command line and all, to one of the programs beside it (cli/verify/main.cpp).
namespace pcm::compare {

/// What `pcm --help` says of the subcommands that other programs have.
inline constexpr const char* kAnswerDescription =
    "Answer poses with this project's engines, as 'pcm judge' reads answers";
inline constexpr const char* kBenchDescription =
    "How fast the engine is, beside others, over sizes, and by what it skips";
inline constexpr const char* kContactDescription =
    "Contact between two surfaces: polygons, areas, force and torque, one JSON object a line for each pose";
inline constexpr const char* kExplainDescription =
    "Why an answer is what it is: what coincides, who decides, how near another answer is";
inline constexpr const char* kInspectDescription =
    "Jumps of the elastic force along a path of poses: where, how large and why; and the work done";
inline constexpr const char* kJudgeDescription = "Anybody's answers to the poses of 'pcm poses' before the oracle";
inline constexpr const char* kMeshDescription = "Surfaces: check, make, convert";
inline constexpr const char* kPosesDescription = "The poses of 'pcm verify' as files that any program reads";
inline constexpr const char* kSimulateDescription =
    "Bodies in motion: the paper's scenes or one of yours, integrated, recorded, with its energies";

/// Goes on as the program of that name beside this one, with the same arguments; throws BadInput where it can't.
[[noreturn]] void become(const std::string& program, char** argv);

}  // namespace pcm::compare
