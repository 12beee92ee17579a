// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/moving_bubbles.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "compare/random/random.h"
#include "compare/verify/routes/wanted_presets.h"
#include "meshes/generate/bubbles.h"

namespace pcm::compare {
namespace {

constexpr double kWidth = 4, kDepth = 1.2;        // of the container, m
constexpr double kSlope = kDepth / (kWidth / 2);  // of its walls
constexpr double kSpacing = 0.36;                 // of the grid, m: less than the bubbles' length of 0.40
constexpr double kLowest = 0.5;                   // of the lowest layer above the apex, m

/// The places of a layer's bubbles, from one wall to the other.
std::vector<Eigen::Vector3d> layer(double height) {
  const double half_width = height / kSlope - 0.28;
  const int across = 1 + static_cast<int>(2 * half_width / kSpacing);
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j)
      places.emplace_back(kSpacing * (i - 0.5 * (across - 1)), kSpacing * (j - 0.5 * (across - 1)), height);
  return places;
}

ContactLaw law_of(double stiffness, double damping) {
  ContactLaw law;
  law.stiffness = stiffness;
  law.damping = damping;
  law.transition_depth = 0.001;
  law.friction = 0.25;
  law.slip_velocity = 0.01;
  return law;
}

}  // namespace

MovingBubbles::MovingBubbles(int bubbles, std::uint64_t seed)
    : bubble_(generate::bubble()), container_(generate::pyramid(kWidth, kDepth)) {
  for (double height = kLowest; static_cast<int>(swings_.size()) < bubbles; height += kSpacing) {
    for (const Eigen::Vector3d& place : layer(height)) {
      if (static_cast<int>(swings_.size()) == bubbles) break;
      PoseRandom random(seed, 0, 0, swings_.size());
      Swing swing;
      swing.place = place;
      for (int k = 0; k < 3; ++k) {
        swing.amplitude[k] = random.uniform(0.01, 0.04);
        swing.frequency[k] = 2 * std::numbers::pi * random.uniform(0.5, 1.5);
        swing.phase[k] = 2 * std::numbers::pi * random.uniform();
      }
      swing.axis = random.direction();
      swing.angle = 2 * std::numbers::pi * random.uniform();
      swing.speed = random.uniform(-1, 1);
      swings_.push_back(swing);
    }
  }
}

fast::Scene MovingBubbles::scene(const fast::Savings& savings) const {
  fast::Scene scene(savings);
  scene.add_body(container_);
  for (std::size_t b = 0; b < swings_.size(); ++b) scene.add_body(bubble_);
  for (Index E = 0; E < scene.bodies(); ++E) {
    const ContactLaw law = E == 0 ? law_of(1.2e6, 500) : law_of(5.9e5, 1000);
    // The container's four faces are no masters.
    for (Index F = E + 1; F < scene.bodies(); ++F)
      scene.add_pairing(E, F, law, E == 0 ? Mode::F : Mode::E, Scheme::barycentric, kForceOnly);
  }
  return scene;
}

std::vector<fast::BodyState> MovingBubbles::states(double time) const {
  std::vector<fast::BodyState> states(1);
  for (const Swing& swing : swings_) {
    fast::BodyState state;
    const Eigen::Array3d phase = swing.phase.array() + swing.frequency.array() * time;
    state.pose.r = swing.place.array() + swing.amplitude.array() * phase.sin();
    state.velocity.v = swing.amplitude.array() * swing.frequency.array() * phase.cos();
    state.pose.A = Eigen::AngleAxisd(swing.angle + swing.speed * time, swing.axis).toRotationMatrix();
    state.velocity.w = swing.speed * swing.axis;
    states.push_back(state);
  }
  return states;
}

}  // namespace pcm::compare
