// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// usage: take_walks SEED WALKS STEPS. Walks of many pairs, both with and without what is known of the pose before (see
// tests/fast/engine/tracked_walks.h); fails where a bit of an answer differs.
#include <cstdio>
#include <cstdlib>

#include "tests/fast/engine/tracked_walks.h"

int main(int count, char** arguments) {
  if (count != 4) {
    std::fputs("usage: take_walks SEED WALKS STEPS\n", stderr);
    return 2;
  }
  const auto seed = static_cast<std::uint64_t>(std::atoll(arguments[1]));
  const pcm::fast::test::WalkTally tally =
      pcm::fast::test::take_walks(seed, std::atoi(arguments[2]), std::atoi(arguments[3]));
  std::printf("%lld evaluations, %lld touching, %lld of them followed, %lld different\n",
              static_cast<long long>(tally.evaluations), static_cast<long long>(tally.touching),
              static_cast<long long>(tally.followed), static_cast<long long>(tally.different));
  if (tally.different > 0) std::printf("first: %s\n", tally.first_difference.c_str());
  return tally.different == 0 ? 0 : 1;
}
