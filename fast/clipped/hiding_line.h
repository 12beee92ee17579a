// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "fast/posed/posed_pair.h"
#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// What a master face sees of f, and all that it sees.
struct SeenFaces {
  PosedPair& posed;  ///< asked for the faces' vertices
  Side master;
  const MasterPrism& prism;
  const std::vector<ProjectedFace>& faces;
  const ProjectedFace& f;
};

/// Part of a straight way, as shares of it, and the line on which it lies.
struct PartOnLine {
  SideLine line;
  double from, to;
};

/// Of a way from a to b along f, which is seen on the left of it alone: the edge at which f itself ends there, or the
/// line at which a face ends or begins to lie before f, as far as that lies on the way to within roundings. Whether a
/// face passes through f, or through the master, or lies before f, is decided exactly where depths do not tell; beside
/// a corner at which it just does, edge and line lie on one another, and either is taken. Nothing where no line does
/// on a stretch that is longer than roundings. Where there are several, any.
std::optional<PartOnLine> find_hiding_line(const SeenFaces& seen, const PrismPoint& a, const PrismPoint& b);

}  // namespace pcm::fast
