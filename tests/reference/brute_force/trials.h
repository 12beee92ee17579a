// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::brute_force {

/// How many of `count` trials to run: all, or half in a sanitizer build, where exact arithmetic is some thirty times
/// slower. The parts of `count` that tests want touching or with an element hold for the first half as well; fewer
/// trials are too few to tell.
constexpr int affordable(int count) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  return count / 2;
#endif
#endif
  return count;
}

/// Kinds of tiny pose to hold an engine or oracle against the twin on.
enum class Kind : std::uint8_t {
  generic,       ///< tetrahedra, boxes, octahedra, icospheres in any rotation
  lattice,       ///< tetrahedra and boxes with small integer coordinates, turned by right angles: exact ties everywhere
  near_lattice,  ///< the same, F moved by 1 to 8 ulps
  grids,         ///< gridded boxes upon each other at rational offsets
  open,          ///< containers, plates and boxes with faces missing, on a lattice or not
  folded,  ///< octahedra and boxes that mostly pass through themselves, some beside small ones, on a lattice or not
};

/// "Generic", "NearLattice" ...
std::string name_of(Kind kind);

struct Trial {
  std::string description;  ///< kind, seed and number: enough to draw it again
  TriangleMesh E;
  TriangleMesh F;
  Pose pose;
};

/// Trial `number` of a kind: a pure function of its arguments.
Trial draw_trial(Kind kind, std::uint64_t seed, int number);

}  // namespace pcm::brute_force
