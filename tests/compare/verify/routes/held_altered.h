// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

#include "compare/poses/strata.h"
#include "compare/verify/verdict/disagreement_kind.h"
#include "pcm/inputs.h"
#include "tests/compare/verify/routes/altering_seam.h"

namespace pcm::compare {

/// Of the poses at which answers are altered.
inline constexpr std::uint64_t kSeed = 41;

/// What came of altered answers, and of those at which there was nothing to alter.
struct Held {
  int altered = 0;
  int flagged = 0;
  std::set<Kind> kinds;
  int unaltered = 0;
  int unaltered_flagged = 0;
};

/// Holds altered answers at drawn poses of the stratum until `enough` have been altered.
Held hold_altered(const AlteringSeam& seam, Stratum stratum, Scheme scheme, int enough, int most_poses = 400);

/// Tests of altered answers in both schemes.
class SeamOverSchemes : public testing::TestWithParam<Scheme> {};

}  // namespace pcm::compare
