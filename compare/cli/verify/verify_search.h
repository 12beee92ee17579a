// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/verify/verify_options.h"

namespace pcm::compare {

/// `pcm verify --search`: climbs to hard states (compare/hard_poses/search.h), prints how hard they are and the verdict
/// on them, and writes search.md, .csv and .json, hardest.csv, and into the folder's folder `hardest` case files of the
/// hardest and of those with a disagreement.
Exit verify_search(const VerifyOptions& options);

}  // namespace pcm::compare
