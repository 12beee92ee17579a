// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/triangle_mesh.h"

/// The car of the pedestrian crash (PCM section 8).
namespace pcm::generate {

/// The body of a saloon car without wheels, closed, exactly 1,240 faces: a loft of 20 segments around and 32 bands from
/// front to rear. Metres; the front is at x = 0 and the rear at x = 4.4, so it drives towards -x; z is up, the road
/// z = 0, the underside about 0.22 above it; y points to the driver's right, the half-width is 0.87. Symmetric in y.
/// The upper outline in the plane y = 0 passes bonnet (x = 1.15, z = 0.95), windscreen, roof (1.95, 1.42 to 3.2, 1.40)
/// and boot (3.9, 1.05); above the waistline the sides lean inwards.
TriangleMesh car();

}  // namespace pcm::generate
