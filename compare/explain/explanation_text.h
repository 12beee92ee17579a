// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/explain/explain.h"

namespace pcm::compare {

/// The explanation in sentences for readers of docs/PCM.md, without a headline. `all`: also signs beyond the first few
/// of a coincidence.
std::string explanation_text(const Explanation& explanation, const ExplainOptions& options, bool all);

}  // namespace pcm::compare
