// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "simulate/record/recording.h"

namespace pcm::simulate {

/// The frame next to an instant, as the page has it; of two that are equally near the earlier one. There must be one.
const Frame& frame_next_to(double t, const std::vector<Frame>& frames);

/// Draws the recorded frame next to each of these instants, s, as a PNG in the folder, and returns the files. Throws
/// BadInput where the recording is one that no page is made of (page/check_recording.h) and where a file can't be
/// written.
std::vector<std::filesystem::path> write_stills(const std::filesystem::path& folder, const Recording& recording,
                                                const std::vector<double>& instants);

}  // namespace pcm::simulate
