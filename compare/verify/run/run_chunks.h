// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "compare/campaign/campaign.h"
#include "compare/verify/run/verify.h"

namespace pcm::compare {

/// Holds chunks on `jobs` threads until none is to be had or `stop` says so; it is asked before each pose. `progress`
/// gets the number of poses done by this call so far. What is thrown ends it, after what the other threads are at.
void run_chunks(const Verification& run, Chunks<Outcomes>& chunks, int jobs, const std::function<bool()>& stop,
                const std::function<void(std::int64_t)>& progress);

/// The whole run, or what is done of it when `stop` says so, in this process alone and kept nowhere.
void run_all(Verification& run, int jobs, const std::function<bool()>& stop,
             const std::function<void(std::int64_t)>& progress);

}  // namespace pcm::compare
