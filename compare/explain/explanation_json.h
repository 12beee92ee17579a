// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "compare/explain/explain.h"
#include "compare/io/json/exact_json.h"

namespace pcm::compare {

/// The explanation as explanation.schema.json has it; SI units. `origin`: what was asked about, in words.
Json explanation_json(const Explanation& explanation, const Explainer& surfaces, const ExplainOptions& options,
                      const std::string& origin);

/// The JSON schema (draft 7).
std::string_view explanation_schema();

}  // namespace pcm::compare
