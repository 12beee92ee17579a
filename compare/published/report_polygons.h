// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/published/workspace.h"

namespace pcm::compare::published {

/// Writes the polygons into the answer in the order that its contract asks for, so that they can be held against the
/// oracle's: a closed one starts at its smallest crossing, polygons go by their first one. A point that two
/// intersection lines share counts as the crossing at the start of the second.
void report_polygons(const Surface& surface_E, const Surface& surface_F, Workspace& workspace);

}  // namespace pcm::compare::published
