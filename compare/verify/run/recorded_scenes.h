// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/poses/pairs.h"

namespace pcm::compare {

/// The pairings of the built-in scenes of `pcm simulate` that touched, each with its law and with stretches of what it
/// went through: pairs of the stratum trajectory, and of no other.
///
/// What they went through is a file that is compiled in (recorded_scenes.json, made by record_scenes.py from two runs
/// of `pcm simulate`): so a run of `pcm verify` needs neither Simbody nor SUNDIALS, whose last bits are others from
/// machine to machine, and asks the same poses on all.
std::vector<SurfacePair> recorded_pairs();

}  // namespace pcm::compare
