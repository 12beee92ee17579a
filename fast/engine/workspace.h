// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/active/active_areas.h"
#include "fast/active/inside_areas.h"
#include "fast/active/patches.h"
#include "fast/crossings/crossings.h"
#include "fast/crossings/polygons.h"
#include "fast/engine/force_by_scheme.h"
#include "fast/engine/separation.h"
#include "fast/posed/posed_team.h"
#include "pcm/contact.h"
#include "pcm/workspace.h"

namespace pcm::fast {

/// The values that each step hands to the next, each step's own scratch memory, and the answer.
struct Workspace::Data {
  explicit Data(std::size_t threads) : team(threads) {}

  PosedTeam team;
  PosedPair posed;
  Crossings crossings;
  PolygonChains polygons;
  ActiveAreas active;
  Patches patches;
  ElementRecord elements;

  CrossingScratch crossing_scratch;
  std::vector<Index> polygon_scratch;
  std::array<ActiveAreaScratch, 2> active_scratch;  ///< by side
  PatchScratch patch_scratch;
  InsideAreaScratch area_scratch;
  ForceScratch force_scratch;

  Contact contact;
  Contact apart;  ///< what a scene says of pairings it need not look at
  BoxPairs gaps;  ///< of searches for a distance
};

}  // namespace pcm::fast
