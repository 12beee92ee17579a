// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The two scenes of the paper, against what it says of them (PCM section 8) and against the generators they are made
// by.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "meshes/generate/human.h"
#include "simulate/model/model.h"
#include "simulate/scenes/read_scene.h"
#include "tests/simulate/scenes/built_in_scene.h"

namespace pcm::simulate {
namespace {

const Body& body_named(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.bodies.begin(), scene.bodies.end(), [&name](const Body& body) { return body.name == name; });
  EXPECT_NE(found, scene.bodies.end()) << name;
  return *found;
}

TEST(BubblesScene, IsThePapers) {
  const Scene scene = built_in_scene("bubbles");
  EXPECT_EQ(Model(scene).degrees_of_freedom(), 18);
  EXPECT_EQ(Model(scene).size(), 39);  // 36 states of the paper's, and a quaternion's fourth number for each bubble
  ASSERT_EQ(scene.surfaces.size(), 4U);
  EXPECT_EQ(scene.surfaces[0].surface.mesh().faces.size(), 4U);
  for (std::size_t s = 1; s < 4; ++s) EXPECT_EQ(scene.surfaces[s].surface.mesh().faces.size(), 950U);
  for (const Body& bubble : scene.bodies) EXPECT_EQ(bubble.mass.mass, 2);
  ASSERT_EQ(scene.pairings.size(), 6U);
  for (std::size_t p = 0; p < 6; ++p) {
    EXPECT_EQ(scene.pairings[p].law.stiffness, p < 3 ? 5.9e5 : 1.2e6);
    EXPECT_EQ(scene.pairings[p].law.damping, p < 3 ? 1000 : 500);
    EXPECT_EQ(scene.pairings[p].law.friction, 0.25);
    EXPECT_EQ(scene.pairings[p].F == 0, p >= 3);
  }
  EXPECT_EQ(scene.duration, 3);
  EXPECT_EQ(scene.integrator.relative_tolerance, 2e-4);
}

TEST(PedestrianScene, IsThePapers) {
  const Scene scene = built_in_scene("pedestrian");
  EXPECT_EQ(Model(scene).degrees_of_freedom(), 29);
  ASSERT_EQ(scene.bodies.size(), 16U);
  double mass = 0;
  std::size_t faces = 0;
  for (std::size_t b = 1; b < scene.bodies.size(); ++b) mass += scene.bodies[b].mass.mass;
  for (std::size_t s = 1; s < scene.surfaces.size(); ++s) faces += scene.surfaces[s].surface.mesh().faces.size();
  EXPECT_NEAR(mass, 75, 1e-4);
  EXPECT_EQ(faces, 20452U);
  EXPECT_EQ(scene.surfaces[0].surface.mesh().faces.size(), 1240U);
  EXPECT_NEAR(*scene.bodies[0].joint.prescribed_speed, -30 / 3.6, 1e-12);
  ASSERT_EQ(scene.pairings.size(), 27U);
  for (std::size_t p = 0; p < 27; ++p) {
    EXPECT_EQ(scene.pairings[p].F == 0, p < 15) << p;
    EXPECT_EQ(scene.pairings[p].law.stiffness, p < 15 ? 3.2e7 : 2.1e7);
    EXPECT_EQ(scene.pairings[p].law.damping, p < 15 ? 1e5 : 2e5);
    EXPECT_EQ(scene.pairings[p].law.friction, 0.4);
  }
  EXPECT_EQ(scene.duration, 1.5);
  EXPECT_EQ(scene.integrator.relative_tolerance, 1e-3);
}

// The file's numbers are those of the generators, to six digits.
TEST(PedestrianScene, HasTheManOfTheGenerators) {
  const Scene scene = built_in_scene("pedestrian");
  const std::vector<generate::HumanSegment>& segments = generate::human_segments();
  for (const generate::HumanSegment& segment : segments) {
    SCOPED_TRACE(segment.name);
    const Body& body = body_named(scene, segment.name);
    EXPECT_NEAR(body.mass.mass, segment.mass, 1e-5 * segment.mass);
    EXPECT_LT((body.mass.centre_B - segment.center_of_mass).norm(), 1e-5);
    EXPECT_LT((body.mass.inertia_B - segment.inertia).norm(), 1e-5 * segment.inertia.norm());
    if (segment.parent < 0) continue;
    EXPECT_EQ(scene.bodies[static_cast<std::size_t>(body.joint.parent)].name,
              segments[static_cast<std::size_t>(segment.parent)].name);
    EXPECT_LT((body.joint.in_parent.p - segment.joint).norm(), 1e-5);
    EXPECT_EQ(body.joint.in_body.p.norm(), 0);
  }
}

// Neighbours overlap at their joints and are no pairings; nothing else touches at the start.
TEST(PedestrianScene, StartsWithNothingInContactAndStandsAsTheGeneratorsSay) {
  const Scene scene = built_in_scene("pedestrian");
  Model model(scene);
  const Observation now = model.observe(0, model.start());
  for (const PairingObservation& pairing : now.pairings) EXPECT_FALSE(pairing.touching || pairing.nested);
  const std::vector<generate::SegmentPose> standing = generate::standing_pose();
  // He crosses the road: turned by a quarter about z.
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (std::size_t i = 0; i < standing.size(); ++i) {
    const Pose& pose = now.surfaces_G[i + 1];
    EXPECT_LT((pose.r - turn * standing[i].position).norm(), 1e-3) << scene.surfaces[i + 1].name;
    EXPECT_LT((pose.A - turn * standing[i].rotation).norm(), 1e-3) << scene.surfaces[i + 1].name;
  }
}

}  // namespace
}  // namespace pcm::simulate
