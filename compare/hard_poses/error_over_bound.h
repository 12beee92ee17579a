// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/verify/routes/held_pairing.h"

namespace pcm::compare {

/// How much of its own bound the engine's error of the force uses up.
struct ErrorOverBound {
  /// |engine's force - exact problem's| over the engine's bound on that, the greatest over the three components in Me:
  /// at most 1 where the bound keeps its promise. The exact force is rounded to doubles first. 0 where both are equal
  /// and where the bound is infinite.
  double ratio = 0;
  bool flipped = false;  ///< the bound says so: a decision may be another one in the exact problem
};

/// At rest, in the pairing's first mode, law and scheme. Throws as engine and oracle do.
ErrorOverBound error_over_bound(const HeldPairing& held, const Pose& pose, fast::Workspace& workspace);

}  // namespace pcm::compare
