// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/contact.h"
#include "pcm/engine.h"

namespace pcm::simbody {

/// The sum over the contact's elements of the integral of c_l u^2 / 2 over the element, J; in mode `both` half of it.
///
/// Barycentric scheme: u is u_k all over the face. Clipped scheme: u is linear over an element, and the element's
/// position gives the centroid x of u, so that the integral of u^2 is that of u, A_k u_k, times u(x): for linear u =
/// a + g . x, it is a (integral of u) + g . (integral of u x) = (a + g . x_u) (integral of u). Where depths are clamped
/// u is not linear: A_k u_k^2 stands there, which is no more (Cauchy-Schwarz) than the integral of the clamped depth's
/// square.
///
/// `contact` is the pairing's at `pose`, with its elements.
double elastic_energy(const fast::Pairing& pairing, const Pose& pose, const fast::Contact& contact);

}  // namespace pcm::simbody
