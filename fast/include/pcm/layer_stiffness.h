// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcm::fast {

/// Stiffness of an elastic layer c = K / b (3), N/m^3, as LayerStiffness takes it, with the layer modulus (2)
/// K = (1 - nu) / ((1 + nu) (1 - 2 nu)) young. `young` > 0 in Pa, -1 < `poisson` < 0.45 (a layer nearer to
/// incompressible can't be thought of as springs side by side), `thickness` b > 0 in m. Throws BadInput otherwise, and
/// where the stiffness is less than 2^-1022, or it or K beyond what doubles hold.
double layer_stiffness(double young, double poisson, double thickness);

}  // namespace pcm::fast
