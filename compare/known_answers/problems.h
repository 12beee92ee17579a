// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/known_answers/known_answers.h"

/// The families of known answers, each made in a file of its own.
namespace pcm::compare {

std::vector<KnownAnswer> blocks(Extent extent);             ///< A1, A11
std::vector<KnownAnswer> spheres_on_planes(Extent extent);  ///< A2, A3, A4, A18 and the error of the mesh, D
std::vector<KnownAnswer> cylinders(Extent extent);          ///< A5, A7
std::vector<KnownAnswer> sockets(Extent extent);            ///< A6
std::vector<KnownAnswer> volumes(Extent extent);            ///< A8
std::vector<KnownAnswer> wedges(Extent extent);             ///< A9, A10
#ifdef PCM_WITH_DYNAMICS
std::vector<KnownAnswer> motions(Extent extent);  ///< A12 to A17
#endif

/// Problems that share their meshes, made when they are asked for: those of fine levels are large.
using KnownAnswerFamily = std::vector<KnownAnswer> (*)(Extent);

/// All families.
const std::vector<KnownAnswerFamily>& known_answer_families();

}  // namespace pcm::compare
