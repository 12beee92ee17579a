// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "compare/io/provenance/program_hash.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

TEST(ProgramHash, ProgramThatCantBeReadIsBadInput) {
  EXPECT_THROW(program_hash_of("/no/such/proc/self/exe"), BadInput);
  EXPECT_EQ(program_hash_of("/proc/self/exe"), program_hash());
}

}  // namespace
}  // namespace pcm::compare
