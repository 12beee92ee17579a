// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "compare/verify/routes/engine_seam.h"

namespace pcm::fuzz {

/// The target `contact` (target.h), with something between the engine and the comparison.
void compare_contact_through(std::string_view bytes, const compare::EngineSeam& seam);

}  // namespace pcm::fuzz
