// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Somebody else's program: it knows the engine's public headers only. Its argument is the surface bubble.obj.

#include <pcm/engine.h>
#include <pcm/read_mesh.h>
#include <pcm/scene.h>
#include <pcm/version.h>

#include <cstdio>

#if __cplusplus >= 202002L
#error "C++17 has to be enough for users"
#endif
#ifndef __FAST_MATH__
#error "the policy on floating point is the library's own: users choose their flags"
#endif
static_assert(!decltype(pcm::Pose::A)::IsRowMajor);

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const pcm::fast::Surface bubble{pcm::read_mesh(argv[1])};
  pcm::ContactLaw law;
  law.stiffness = 5.9e5;
  law.damping = 1000;
  law.friction = 0.25;
  pcm::fast::Scene scene;
  const pcm::Index E = scene.add_body(bubble);
  const pcm::Index F = scene.add_body(bubble);
  const pcm::Index pairing = scene.add_pairing(E, F, law, pcm::Mode::both);
  std::vector<pcm::fast::BodyState> states(2);
  states[1].pose.r = {0.15, 0.02, 0.1};
  scene.move(states);
  scene.evaluate_all(2);  // threads have to be linked
  const Eigen::Vector3d& force = scene.load(pairing).force_Me;
  std::printf("pcm %s, force on E: %g %g %g N\n", PCM_VERSION, force.x(), force.y(), force.z());
}
