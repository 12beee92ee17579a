// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "pcm/scene.h"

namespace pcm::compare {

/// Bubbles (PCM section 8) that jostle in an open pyramidal container on a prescribed motion: layer upon layer on a
/// grid a little narrower than they are long, each swinging about its place and turning. Nothing is integrated, so
/// every engine and every setting sees the same motion; `seed` draws amplitudes, frequencies and axes.
class MovingBubbles {
 public:
  MovingBubbles(int bubbles, std::uint64_t seed);

  /// The container and the bubbles, everything paired with everything; the container is E, bubbles in their order. The
  /// paper's laws, with u_d = 1 mm and v_eps = 1 cm/s, which it leaves open; force and torque wanted.
  fast::Scene scene(const fast::Savings& savings) const;

  /// Where all bodies are at `time` seconds.
  std::vector<fast::BodyState> states(double time) const;

 private:
  struct Swing {
    Eigen::Vector3d place, amplitude, frequency, phase;  ///< m, m, rad/s, rad
    Eigen::Vector3d axis;
    double angle = 0, speed = 0;  ///< rad, rad/s
  };
  std::vector<Swing> swings_;
  fast::Surface bubble_, container_;
};

}  // namespace pcm::compare
