// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

namespace {

// A sanitized suite without optimization takes many times as long, unnoticed.
TEST(Build, IsOptimizedUnlessDebugging) {
  const std::string configuration = PCM_CONFIGURATION;
  if (configuration == "Debug") GTEST_SKIP() << "a Debug build";
#ifdef __OPTIMIZE__
  SUCCEED();
#else
  FAIL() << "build type " << configuration << " sets no optimization";
#endif
}

}  // namespace
