// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "compare/io/json/question_json.h"

namespace pcm::compare {

/// Writes the named degenerate cases (meshes/generate/degenerate/catalogue.h) as a folder of poses, each in mode both
/// and in either scheme, under an elastic law, with the volume of the intersection where it was worked out by hand.
/// Returns how many poses they are.
std::int64_t write_catalogue_poses(const std::filesystem::path& folder, Notation notation);

}  // namespace pcm::compare
