// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/poses/pairs.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"

namespace pcm::compare {

/// A ball and a box of few faces, both closed, for every stratum.
inline SurfacePair small_pair() {
  SurfacePair pair;
  pair.name = "icosphere-gridded box";
  pair.E = generate::icosphere(0.5, 2);
  pair.F = generate::gridded_box(0.8, 2);
  pair.law = verification_law(0, pair.E, pair.F);
  pair.for_hard_strata = true;
  return pair;
}

}  // namespace pcm::compare
