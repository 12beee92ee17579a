// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The README's example; a test holds the two equal.

#include <cstdio>

#include "pcm/engine.h"
#include "pcm/read_mesh.h"

int main() {
  const pcm::fast::Surface bubble{pcm::read_mesh("meshes/surfaces/bubble.obj")};  // checked, immutable, shareable
  pcm::ContactLaw law;
  law.stiffness = 5.9e5;  // c_l, N/m^3
  law.damping = 1000;     // d_l, N s/m^3
  law.friction = 0.25;    // mu
  const pcm::fast::Pairing pairing{bubble, bubble, law, pcm::Mode::both};
  pcm::fast::Workspace workspace;  // one per thread
  pcm::Pose pose;
  pose.r = {0.15, 0.02, 0.1};  // of F's marker in E's frame, m
  const auto& contact = pcm::fast::evaluate(pairing, pose, pcm::Velocity{}, pcm::Wanted{}, workspace);
  std::printf("force on E: %g %g %g N\n", contact.force_Me.x(), contact.force_Me.y(), contact.force_Me.z());
}
