// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The README's example; a test holds the two equal.

#include <pcm/engine.h>
#include <pcm/read_mesh.h>

#include <cstdio>

int main() {
  const pcm::fast::Surface bubble{pcm::read_mesh("meshes/surfaces/bubble.obj")};  // checked, immutable, shareable
  pcm::ContactLaw law;
  law.stiffness = 5.9e5;  // N/m^3; damping, friction and layers have defaults
  const pcm::fast::Pairing pairing{bubble, bubble, law, pcm::Mode::both};
  pcm::Pose pose;
  pose.A << 1, 0, 0, 0, 0.96, -0.28, 0, 0.28, 0.96;  // orientation of F seen from E
  pose.r = {0.16, 0.02, 0.01};                       // its position, m
  pcm::fast::Workspace workspace;                    // one per thread
  const auto& contact = pcm::fast::evaluate(pairing, pose, pcm::Velocity{}, pcm::Wanted{}, workspace);
  std::printf("force on E: %g %g %g N\n", contact.force_Me.x(), contact.force_Me.y(), contact.force_Me.z());
}
