// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "simulate/record/noted_table.h"
#include "simulate/record/run_folder.h"
#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// What the run cost: the paper's own rows first where the scene is one of its two from its start on
/// (tables 1 and 2, SIMPACK on a mobile Pentium III of 1133 MHz), then ours.
NotedTable cost_table(const std::string& scene_name, const Scene& scene, const KeptRun& run);

/// Where the energy is at the end and where it went, and what the sum lacks of what there was at the start.
NotedTable energy_table(const KeptRun& run, const Energies& at_end);

}  // namespace pcm::simulate
