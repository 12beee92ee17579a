// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// What the run in a folder has recorded at t, to the bit: to start from. Throws BadInput where it has nothing there;
/// it records states at multiples of its output's interval.
InitialState recorded_state(const std::filesystem::path& folder, double t);

}  // namespace pcm::simulate
