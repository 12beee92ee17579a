// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/combinatorics.h"

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
/// Certified: the line decisions of all active faces hold for all vertices within their rounding boxes; and no inactive
/// face can become active there: against a closed slave because none of its candidate pairs can begin to cross (then it
/// stays outside, as vertices move continuously), against an open one because no crossing at all can come or go.
ElementPairs find_elements(const ExactPose& pose, Side master, const Combinatorics& combinatorics);

}  // namespace pcm::reference
