// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "compare/io/json/question_json.h"
#include "compare/verify/run/planned_poses.h"

namespace pcm::compare {

/// Under which law the poses are asked.
enum class PosedLaw : std::uint8_t {
  drawn,    ///< as `pcm verify` asks them: a law and a velocity drawn for each
  of_pair,  ///< the pair's own, as `pcm verify --engine` asks them
  elastic,  ///< at rest, with stiffness alone: for engines that have another law of damping and friction, or none
};

inline constexpr std::array kPosedLaws = {PosedLaw::drawn, PosedLaw::of_pair, PosedLaw::elastic};

/// The word of --law: drawn, pair or elastic.
std::string_view name(PosedLaw law);
/// Throws BadInput for another word.
PosedLaw posed_law_named(const std::string& word);

/// Writes what a plan asks: every pose in every mode as a line of poses.jsonl, the surfaces beside it as OBJ files,
/// those of variants and of the stratum nested included. The same bytes whatever the number of threads. Memory does not
/// grow with the number of poses. Once `stop` says yes nothing is left behind, and what an earlier run wrote stays as
/// it is; `progress` gets the number of lines written. Returns whether all were.
bool write_poses(const std::filesystem::path& folder, const PlannedPoses& poses, PosedLaw law, Notation notation,
                 int jobs, const std::function<bool()>& stop, const std::function<void(std::int64_t)>& progress);

}  // namespace pcm::compare
