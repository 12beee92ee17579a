// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "fast/simd/elements.h"
#include "pcm/inputs.h"

namespace pcm::fast {

/// The faces of an element, and the penetration of its deepest point, before clamping, m.
struct ElementFaces {
  Index master, slave;
  double greatest_penetration;
};

/// Up to four elements of one master.
struct KeptLanes : FoundLanes {
  std::array<ElementFaces, kElementLanes> faces{};
  LaneBits which = 0;  ///< lanes that hold one
};

/// The elements of a pairing at a pose, before the law: all that it reads but the motion, in the order of summation.
class FoundElements {
 public:
  std::vector<KeptLanes>& of(Side master) { return of_master_[static_cast<std::size_t>(master)]; }
  const std::vector<KeptLanes>& of(Side master) const { return of_master_[static_cast<std::size_t>(master)]; }
  /// Empties it and keeps its memory.
  void clear() {
    for (std::vector<KeptLanes>& kept : of_master_) kept.clear();
  }

 private:
  std::array<std::vector<KeptLanes>, 2> of_master_;
};

}  // namespace pcm::fast
