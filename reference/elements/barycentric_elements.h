// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/combinatorics/combinatorics.h"

namespace pcm::reference {

/// A barycentric contact element before its numbers: a master face and the slave face its penetration line leaves
/// through.
struct ElementPair {
  Side master = Side::E;
  Index master_face = 0;
  Index slave_face = 0;
};

struct ElementPairs {
  std::vector<ElementPair> pairs;  ///< by master face
  Index too_deep = 0;              ///< active faces whose line would leave the slave but leaves the master first
  bool certified = true;           ///< see Answer::certified
};

/// Elements of the barycentric scheme (PCM section 6) that one master carries. The first slave face along the line
/// must be one that the line leaves through, at q > 0, with no other face of the master strictly before it.
///
/// Certified: the elements are the same ones, and the same faces are too deep, for all vertices within their rounding
/// boxes; whichever of both problems is asked, for it is told by what holds all over the boxes. Against an open slave:
/// no crossing can come or go, so the active faces are the same, and the decisions of all their lines hold. Against a
/// closed slave, of any winding numbers, for each master face e one of these:
///
/// 1. It cannot be crossed: no candidate pair of it can cross. As vertices move within their boxes none of e's passes
///    through the slave then, so the winding number about them, one all over e, stays what it is, and so does whether e
///    is active. If it is, the decisions of its line hold.
/// 2. It is certainly crossed, and the decisions of its line hold.
/// 3. The decisions of its line hold, and leave nothing to carry, active or not.
/// 4. The decisions of its line hold, and the slave winds about its barycentre C at least once. C lies on no face of
///    the slave then wherever vertices are within their boxes, for whether the line meets such a face at q = 0 would be
///    in doubt: so the winding number about C, too, stays what it is. e is active throughout: crossed or, if not, with
///    that winding number all over. A face that is not crossed here and active is one of these.
///
/// That the line leaves the slave first says nothing of the winding number: a slave folded over itself is left from 0
/// to -1 as well as from 1 to 0.
ElementPairs find_elements(const ExactPose& pose, Side master, const Combinatorics& combinatorics);

}  // namespace pcm::reference
