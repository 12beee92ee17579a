// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/scene.h"

namespace pcm::compare {

/// What a drawn pose is asked with: a law drawn in three steps, with thresholds at the figures of the engine's own
/// elements there (law_draw.h), in mode `both`; and in the hard strata a velocity drawn anew, for there it may be
/// exactly 0, along a face's normal or in its plane. A pure function of scene, pose, scheme and random numbers.
Scene::State draw_state(const Scene& scene, Stratum stratum, const DrawnPose& drawn, Scheme scheme, PoseRandom for_law,
                        PoseRandom for_velocity);

}  // namespace pcm::compare
