// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/active_areas.h"
#include "fast/clipped_areas.h"
#include "fast/contact.h"
#include "fast/contact_force.h"
#include "fast/crossings.h"
#include "fast/engine.h"
#include "fast/patches.h"
#include "fast/polygons.h"
#include "fast/posed_pair.h"
#include "fast/separation.h"

namespace pcm::fast {

/// The values that each step hands to the next, each step's own scratch memory, and the answer.
struct Workspace::Data {
  PosedPair posed;
  Crossings crossings;
  PolygonChains polygons;
  ActiveAreas active;
  Patches patches;
  ElementRecord elements;

  CrossingScratch crossing_scratch;
  std::vector<Index> polygon_scratch;
  ActiveAreaScratch active_scratch;
  PatchScratch patch_scratch;
  ClippedAreaScratch area_scratch;
  ForceScratch force_scratch;

  Contact contact;
  Contact apart;  ///< what a scene says of pairings it need not look at
  BoxPairs gaps;  ///< of searches for a distance
};

}  // namespace pcm::fast
