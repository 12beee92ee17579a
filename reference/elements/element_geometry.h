// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/numbers/quadratic.h"
#include "reference/numbers/vector3.h"

namespace pcm::reference {

/// What the force law needs of a contact element of either scheme, in numbers of kind T, where that goes without a
/// square root: all of it is rational, but q and the foot of an element of the clipped scheme that is clamped. With L =
/// |N|, the clamp is at d = max_penetration / L, so both are in Q(L).
template <class T>
struct ElementGeometry {
  Vec3<T> N;        ///< doubled normal of the master face, outward: n_k = -N / |N|
  Vec3<T> slave_N;  ///< and of the slave face
  T alpha;          ///< A_k = alpha |N|: 1/2 for a whole face
  T q;              ///< u_k = q |N|: of the barycentre (11), or the mean over the part seen, clamped point by point
  T q_greatest;     ///< of the barycentre, or the greatest over the part seen, before clamping
  Vec3<T> foot;     ///< the point C_k is measured from along n_k (13): C_e (8), or the centre of (clamped) pressure
};

inline Vec3<Quadratic> converted(const Vec3<Rational>& v) {
  return {Quadratic(v.x), Quadratic(v.y), Quadratic(v.z)};
}

inline ElementGeometry<Quadratic> converted(const ElementGeometry<Rational>& g) {
  return {converted(g.N), converted(g.slave_N),    Quadratic(g.alpha),
          Quadratic(g.q), Quadratic(g.q_greatest), converted(g.foot)};
}

}  // namespace pcm::reference
