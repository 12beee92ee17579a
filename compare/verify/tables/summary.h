// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/verify/run/verify.h"

namespace pcm::compare {

/// A verification on one screen, for people: agreement by pair and by stratum, median times, rounding errors by
/// stratum. The tables of verification_table.h have it all, by pair and stratum.
std::string verification_summary(const Verification& run);

}  // namespace pcm::compare
