// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/random/random.h"
#include "compare/stability/sweeps.h"
#include "pcm/inputs.h"

namespace pcm::compare::stability {

/// A generic pose at a given depth: a drawn point of F lies below the barycentre of a drawn face of E, straight below
/// and as deep as the bodies say, outward normals opposed but for a tilt, turned about that line at random.
///
/// Feature `face`: the point lies in the middle of a drawn face, and the tilt's tangent is a quarter to the whole of
/// depth over the face's longest edge, but at most 1/4: so at every depth the faces lie nearly parallel, about that
/// deep in each other all over, which is how a contact of small depth carries a force in the barycentric scheme.
/// Feature `vertex`: the point is a drawn vertex, the tangent at most 1/10, less than what the faces of an icosphere of
/// 320 slope there, so that the vertex is what lies deepest.
///
/// r is the double nearest to what makes the point lie there, from exact numbers: the depth is what it says to an ulp
/// of r. Bodies as drawn, that is, before `scale`.
Pose draw_feature_pose(const SweptBodies& bodies, PoseRandom random);

}  // namespace pcm::compare::stability
