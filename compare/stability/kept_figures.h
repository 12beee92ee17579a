// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "compare/stability/pose_figures.h"

namespace pcm::compare::stability {

/// Figures of poses as a run keeps them to go on from, bit for bit.
nlohmann::ordered_json kept_figures(const std::vector<PoseFigures>& poses);
std::vector<PoseFigures> figures_from(const nlohmann::ordered_json& kept);

}  // namespace pcm::compare::stability
