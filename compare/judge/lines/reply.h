// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "compare/judge/lines/given_answer.h"

namespace pcm::compare {

/// How an engine that is asked pose by pose (conversation.h) may fail to answer.
enum class Breakdown : std::uint8_t {
  crash,    ///< it ended before it had answered
  hang,     ///< no answer within the time limit
  garbage,  ///< a line that is no answer to the pose
};

inline constexpr std::size_t kBreakdowns = 3;
inline constexpr std::array<std::string_view, kBreakdowns> kBreakdownNames = {"crash", "hang", "garbage"};

/// What came back for a pose.
struct Reply {
  std::size_t question = 0;  ///< its number
  GivenAnswer answer;
  std::int64_t line = 0;  ///< of the file of answers; 0 where there is none
  std::optional<Breakdown> breakdown;
  std::string failure;  ///< what broke down, in words
};

}  // namespace pcm::compare
