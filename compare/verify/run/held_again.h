// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/verdict/case_file.h"

namespace pcm::compare {

/// What comes of the question of a case file, put again with the way on which F came there.
PoseOutcome held_again(const Case& posed, const EngineSeam& seam = EngineSeam::none());

}  // namespace pcm::compare
