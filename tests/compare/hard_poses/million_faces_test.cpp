// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// No step may want a stack or a square of a million faces.
#include <gtest/gtest.h>

#include "meshes/generate/boxes.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

TEST(MillionFaces, ABoxAQuarterDeepInTheirTopHasItsVolumeAndForceByEngineAndOracle) {
  const TriangleMesh plate = generate::gridded_box({-4, -4, -1}, {4, 4, 0}, {512, 512, 1});
  EXPECT_GE(plate.faces.size(), std::size_t{1} << 20);
  const TriangleMesh box = generate::box({1, 1, 1});
  // Off the lines of the grid, which lie 2^-6 m apart.
  const Pose pose{Eigen::Matrix3d::Identity(), {0x1p-8, 0x1p-9, 0.25}};
  ContactLaw law;
  law.stiffness = 1;
  fast::Workspace workspace;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const fast::Pairing pairing(fast::Surface(plate), fast::Surface(box), law, Mode::F, scheme);
    const fast::Contact& contact = fast::evaluate(pairing, pose, {}, {}, workspace);
    // Thousands of faces are summed up, each with a few roundings.
    EXPECT_NEAR(contact.volume, 0.25, 0x1p-40);
    EXPECT_NEAR(contact.force_Me.z(), -0.25, 0x1p-40);
    EXPECT_LT(contact.force_Me.head<2>().norm(), 0x1p-40);
    const reference::Answer truth =
        reference::Oracle(plate, box, law, Mode::F, scheme).answer(reference::Problem::exact, pose, {});
    EXPECT_EQ(truth.volume, 0.25);
    EXPECT_EQ(truth.force_Me, Eigen::Vector3d(0, 0, -0.25));
    EXPECT_EQ(truth.polygons.size(), contact.polygons.size());
  }
}

}  // namespace
}  // namespace pcm::compare
