// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/verify/verify_options.h"

namespace pcm::compare {

/// `pcm verify`: engine against oracle over randomized poses, or over the one pose of a case file.
Exit verify(const VerifyOptions& options);

}  // namespace pcm::compare
