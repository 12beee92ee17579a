// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "compare/known_answers/identity_result.h"
#include "compare/known_answers/known_answers.h"

/// Identities that need no reference: what must hold of any answer, whatever its value.
namespace pcm::compare {

/// All identities, on poses drawn by `draw_pose` with this seed from the built-in pairs, and on poses made for them.
/// The same result whatever the number of threads of the current TBB arena.
std::vector<IdentityResult> check_identities(std::uint64_t seed, Extent extent);

}  // namespace pcm::compare
