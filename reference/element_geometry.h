// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/vector3.h"

namespace pcm::reference {

/// What the force law needs of a contact element of either scheme, in numbers of kind T, without a square root: all of
/// it is rational.
template <class T>
struct ElementGeometry {
  Vec3<T> N;        ///< doubled normal of the master face, outward: n_k = -N / |N|
  Vec3<T> slave_N;  ///< and of the slave face
  T alpha;          ///< A_k = alpha |N|: 1/2 for a whole face
  T q;              ///< u_k = q |N| before clamping: of the barycentre (11), or the mean over the part seen
  T q_greatest;     ///< of the barycentre, or the greatest over the part seen
  Vec3<T> foot;     ///< the point C_k is measured from along n_k (13): C_e (8), or the centre of pressure
};

}  // namespace pcm::reference
