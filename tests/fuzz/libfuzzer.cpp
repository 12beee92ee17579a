// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What libFuzzer calls; PCM_FUZZ_TARGET is the target's name. What a target throws ends the program, and libFuzzer
// keeps the bytes that led there.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/fuzz/target.h"

#ifndef PCM_FUZZ_TARGET  // for clang-tidy, which sees the file outside the programs it is part of
#define PCM_FUZZ_TARGET "contact"
#endif

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const pcm::fuzz::Target& target = pcm::fuzz::target_named(PCM_FUZZ_TARGET);
  try {
    target.run({reinterpret_cast<const char*>(data), size});
  } catch (const std::exception& finding) {
    std::fprintf(stderr, "%s: %s\n", PCM_FUZZ_TARGET, finding.what());
    std::abort();
  }
  return 0;
}
