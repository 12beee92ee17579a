// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/verify/verify_options.h"

namespace pcm::compare {

/// What else `pcm verify` does than its main job: --known-answers, --error-budget, --audits, --stability, --engine. A
/// program of its own (programs.h), so that the main job doesn't wait until all this is compiled.
Exit verify_other_tables(const VerifyOptions& options);

}  // namespace pcm::compare
