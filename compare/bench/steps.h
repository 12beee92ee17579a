// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compare/bench/timing.h"
#include "compare/io/tables/table.h"
#include "pcm/work_counters.h"

/// `pcm bench steps`: what an evaluation costs that follows others at poses near by, beside one that knows of none, and
/// what each has to do; with the answers compared bit for bit.
namespace pcm::compare {

/// One kind of step of one pair of bodies, one scheme.
struct StepsResult {
  std::string bodies, steps, scheme;
  std::int64_t evaluations = 0;  ///< measured, of either
  std::int64_t different = 0;    ///< of these, with another bit of force or torque
  // Medians over the steps of medians over the passes.
  double following_us = 0;
  double isolated_us = 0;
  double whole_ratio = 0;                  ///< of the sums over all steps
  fast::WorkCounters following, isolated;  ///< sums over all steps
};

/// Bodies of `bench peers` at some of its poses, on seeded ways; then the recorded scenes. Force and torque.
std::vector<StepsResult> run_steps(std::int64_t ways, int passes,
                                   const std::function<void(const std::string&)>& progress);

Table steps_table(const std::vector<StepsResult>& results);
Table steps_work_table(const std::vector<StepsResult>& results);
std::string steps_screen(const std::vector<StepsResult>& results, const Machine& machine);
std::string steps_markdown(const std::vector<StepsResult>& results, const Machine& machine);

}  // namespace pcm::compare
