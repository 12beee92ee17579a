// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compare/bench/timing.h"
#include "compare/io/tables/table.h"
#include "pcm/savings.h"

/// `pcm bench skip`: what each thing that is skipped saves, with the answers compared bit for bit.
namespace pcm::compare {

/// Something skipped, on and off, in a scene made for it: times and the work it spares.
struct SavingResult {
  std::string saving;
  std::string scene;
  double on_us = 0;  ///< median
  double off_us = 0;
  std::string counted;  ///< what `work_on` and `work_off` count
  std::int64_t work_on = 0;
  std::int64_t work_off = 0;
};

/// The scene of bubbles under one setting, over all steps.
struct SceneResult {
  std::string setting;
  double median_us = 0;  ///< of a step
  double mean_us = 0;
  double apart_by_boxes = 0;  ///< pairings, a step; so are the following
  double apart_by_certificate = 0;
  double evaluated = 0;
  double certificates_sought = 0;
  double predicates = 0;
  double exact_predicates = 0;
  double vertices_transformed = 0;
};

struct SkipResult {
  int bubbles = 0;
  std::int64_t pairings = 0;
  std::int64_t steps = 0;
  double step_s = 0;
  double touching = 0;                ///< pairings, a step
  double certificate_ns = 0;          ///< median cost of a pairing with a valid certificate
  double boxes_ns = 0;                ///< of one whose boxes are apart
  std::int64_t answers_compared = 0;  ///< loads of pairings, each bit for bit with those of all savings on
  std::int64_t answers_different = 0;
  std::vector<SceneResult> scenes;  ///< all on, one off each, all off
  std::vector<SavingResult> savings;
};

/// Times interleaved: at every step or question each setting takes its turn.
SkipResult run_skip(int bubbles, std::int64_t steps, std::int64_t poses,
                    const std::function<void(const std::string&)>& progress);

Table scenes_table(const SkipResult& result);
Table savings_table(const SkipResult& result);
std::string skip_screen(const SkipResult& result, const Machine& machine);
std::string skip_markdown(const SkipResult& result, const Machine& machine);

}  // namespace pcm::compare
