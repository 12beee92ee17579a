// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "simulate/model/model.h"
#include "simulate/record/recording.h"
#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// A kept run to be looked at, moving along with the surface that the scene follows: frames at the recorded states,
/// which the model is asked about once more, and the series of its tables. Throws BadInput where a table can't be read.
Recording recording_of_run(const std::filesystem::path& folder, const Scene& scene, Model& model);

}  // namespace pcm::simulate
