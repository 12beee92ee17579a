// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <string_view>

#include "compare/verify/bounds/rounding_bounds.h"
#include "compare/wrong_answers/tested_engine.h"

/// A verdict on several engines by one measure, coarser than that of verdict.h, which is the engine's alone.
namespace pcm::compare {

/// In what an engine's answer can differ from the oracle's answer to the rounded problem.
enum class Wrong : std::uint8_t {
  failure,       ///< it gave none
  touching,      ///< do the surfaces cross?
  open_chains,   ///< intersection polygons of closed surfaces that do not close
  polygons,      ///< number of polygons, or a polygon as a cycle of crossings
  active_faces,  ///< intersected or inner faces
  elements,      ///< contact elements as (master, master face, slave face)
  force,         ///< force or torque
};

inline constexpr std::size_t kWrongs = 7;

/// The kind as a word of the tables.
std::string_view name(Wrong wrong);

/// Whether an engine has an answer in which it could be wrong in this: the variant of 2023 knows elements and force
/// only.
bool answers(Engine engine, Wrong wrong);

/// Force and torque are wrong beyond this part of the sum of |F_k|, or of |C_k - r| |F_k|; where the contact is so
/// shallow that doubles can't tell it that well, beyond the rounding bound of a right evaluation (rounding_bounds.h).
inline constexpr double kForceTolerance = 1e-9;

using Wrongs = std::bitset<kWrongs>;

/// What is wrong with an answer, of what the engine knows; `contact` is nullptr where it gave none. Active faces of a
/// published algorithm are not held where no rule of its says which are inner (nested or ambiguous answers).
Wrongs wrongs(const Question& question, Engine engine, const fast::Contact* contact, const reference::Answer& truth);

/// The published algorithms have no rule for what is nested, ambiguous or too deep (PCM sections 5 and 6): their
/// elements and forces differ there by definition and are told apart from wrong ones.
bool without_rule(const reference::Answer& truth);

}  // namespace pcm::compare
