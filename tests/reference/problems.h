// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/vocabulary/answer.h"

namespace pcm::reference {

/// Those that the oracle answers.
inline constexpr Problem kProblems[] = {Problem::rounded, Problem::exact};

}  // namespace pcm::reference
