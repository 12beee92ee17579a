// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/verify/verdict/checks.h"
#include "pcm/scene.h"

namespace pcm::compare {

/// Holds what a scene counts of its only pairing, asked once since the last move, against the work of its answer: one
/// outcome; no work where the bodies are apart; that of the evaluation, and no less where a certificate was sought.
void hold_counters(const fast::SceneCounters& counters, const fast::WorkCounters& work_of_answer, Checks& checks);

}  // namespace pcm::compare
