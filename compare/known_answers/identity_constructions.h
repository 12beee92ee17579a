// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "compare/known_answers/identity_support.h"

/// Identities on poses made for them, and on how the work is spread.
namespace pcm::compare {

/// Boxes [0,2]^3 and [0,2]^2 x [1,3], four pairs of flanks flush, K = 1: (0, 0, -4) on the lower box as master, in
/// `orders` orders of faces and vertices, and whichever body comes first.
IdentityResult flush_flanks(int orders);

/// A plate sunk under a large face and a pin beside it, one surface: the force changes by the pin's part alone.
IdentityResult plate_with_pin();

/// Every pose once on its own and once by many threads, each with a workspace that other pairs have used.
IdentityResult threads_and_workspaces(const std::vector<Posed>& poses);

/// Tables of `pcm verify` over as many poses with one and with two threads.
IdentityResult jobs_of_verify(std::uint64_t seed, std::int64_t poses);

}  // namespace pcm::compare
