// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm::fast {

/// What the search along a line came upon, for whoever looks at the same line again.
struct LineTrace {
  double radius = 0;               ///< wanted: faces this near to the line belong to the trace as well, m
  double beyond = 0;               ///< wanted: and as much farther along it than what it tells, m
  std::vector<Index> slave_faces;  ///< holds every face of the slave that near, up to `slave_searched` along the line
  double slave_searched = 0;       ///< m
  std::vector<Index> own_faces;    ///< the same for the master's other faces
  double own_searched = 0;         ///< m
  bool own_listed = false;  ///< looked for, all up to `own_searched`; else only what the thickness tells is known

  void clear() {
    slave_faces.clear();
    own_faces.clear();
    slave_searched = own_searched = 0;
    own_listed = false;
  }
};

}  // namespace pcm::fast
