// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>
#include <pcm/bad_input.h>
#include <pcm/engine.h>

#include <utility>

#include "meshes/generate/bubbles.h"

namespace pcm::fast {
namespace {

TEST(SurfaceFromArrays, ReadmesTetrahedronAndABubbleGiveAForceInTheClippedScheme) {
  const Surface bubble{generate::bubble()};
  ContactLaw law;
  law.stiffness = 5.9e5;
  // The README's lines; a test holds them equal (tests/architecture/readme_test.cpp).
  // clang-format off
  pcm::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // m
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};     // counterclockwise seen from outside
  const pcm::fast::Surface tetrahedron{mesh};                    // throws where it is unfit, and says what mends it
  const pcm::fast::Pairing clipped{tetrahedron, bubble, law, pcm::Mode::E, pcm::Scheme::clipped};
  // clang-format on
  Workspace workspace;
  Pose pose;
  pose.r = {0.25, 0.25, -0.125};  // m
  const Contact& contact = evaluate(clipped, pose, {}, {}, workspace);
  EXPECT_GT(contact.element_count, 0);
  EXPECT_GT(contact.force_Me.z(), 0) << "E is pushed up, off what is below it";
  std::swap(mesh.faces[0][1], mesh.faces[0][2]);
  EXPECT_THROW(Surface{mesh}, BadInput);
}

}  // namespace
}  // namespace pcm::fast
