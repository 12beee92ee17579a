// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/record/recording.h"

namespace pcm::simulate {

/// Throws BadInput that names the place unless: there are surfaces with faces, and frames; indices lie within their
/// lists; there is a pose for each surface in each frame; times are finite and ascend (those of series may repeat);
/// series have as many values as times; and all numbers but values of series are finite as floats. Orientations must be
/// rotations to 1e-6, more than Pose demands: pictures need no more.
void check_recording(const Recording& recording);

}  // namespace pcm::simulate
