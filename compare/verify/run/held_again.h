// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/verdict/case_file.h"

namespace pcm::compare {

/// What comes of the question of a case file, put again with the way on which F came there.
PoseOutcome held_again(const Case& posed, const EngineSeam& seam = EngineSeam::none());

/// The text of a case file with what engine and oracle decide there; `held` has its surfaces ready. Where either side
/// breaks down neither is told of: the disagreement says it.
std::string case_file_text(const HeldPairing& held, const Case& posed, fast::Workspace& workspace);

}  // namespace pcm::compare
