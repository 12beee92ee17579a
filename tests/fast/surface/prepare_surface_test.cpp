// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a surface computes on demand: no answer depends on what was asked before, nor by which thread.
#include "fast/surface/prepare_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include "meshes/generate/bubbles.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"
#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"

namespace pcm::fast {
namespace {

Wanted all_answers() {
  Wanted wanted;
  wanted.elements = wanted.bound = wanted.statistics = true;
  return wanted;
}

/// Poses at which two surfaces of about that radius overlap somewhere else each time.
std::vector<Pose> touching_poses(double radius, unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d direction(uniform(random), uniform(random), uniform(random) + 2);
    poses.push_back(test::turned(
        3 * uniform(random), 1.8 * radius * test::turned(3 * uniform(random), {0, 0, 0}).A * direction.normalized()));
  }
  return poses;
}

/// Every pose's answer, by surfaces that were prepared as a whole.
std::vector<Contact> answers_of_whole_surfaces(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Scheme scheme,
                                               const std::vector<Pose>& poses) {
  const Surface E(mesh_E), F(mesh_F);
  E.prepare_all_faces();
  F.prepare_all_faces();
  const Pairing pairing(E, F, {}, Mode::both, scheme);
  Workspace workspace;
  std::vector<Contact> answers;
  for (const Pose& pose : poses) answers.push_back(evaluate(pairing, pose, {}, all_answers(), workspace));
  return answers;
}

class SurfacesOnDemand : public testing::TestWithParam<Scheme> {
 protected:
  const TriangleMesh bubble = generate::bubble();
  const TriangleMesh socket = generate::socket(0.2, 0.15, 24, 6);
  const std::vector<Pose> poses = touching_poses(0.2, 19, 40);
  const std::vector<Contact> expected = answers_of_whole_surfaces(bubble, socket, GetParam(), poses);
};

TEST_P(SurfacesOnDemand, AnswersAreThoseOfSurfacesPreparedAsAWholeInAnyOrderOfThePoses) {
  EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](const Contact& c) { return c.element_count > 0; }), 20);
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::vector<std::size_t> order(poses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    const Pairing pairing{Surface(bubble), Surface(socket), {}, Mode::both, GetParam()};
    Workspace workspace;
    for (const std::size_t i : order)
      EXPECT_TRUE(test::same(evaluate(pairing, poses[i], {}, all_answers(), workspace), expected[i])) << i;
  }
}

TEST_P(SurfacesOnDemand, ThreadsThatShareSurfacesGetTheSameAnswers) {
  const Pairing pairing{Surface(bubble), Surface(socket), {}, Mode::both, GetParam()};
  std::vector<std::size_t> different(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < different.size(); ++t) {
    threads.emplace_back([&, t] {
      Workspace workspace;
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::size_t at = t % 2 == 0 ? i : poses.size() - 1 - i;
        if (!test::same(evaluate(pairing, poses[at], {}, all_answers(), workspace), expected[at])) ++different[t];
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(different, std::vector<std::size_t>(4, 0));
}

INSTANTIATE_TEST_SUITE_P(Schemes, SurfacesOnDemand, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::barycentric ? std::string("barycentric")
                                                                      : std::string("clipped");
                         });

TEST(PrepareAllFaces, LeavesNothingToCompute) {
  const PreparedSurface surface = prepare_surface(generate::icosphere(1, 2));
  look_around_all_faces(surface);
  for (Index face = 0; face < static_cast<Index>(surface.mesh.faces.size()); ++face) {
    surface.known_thickness.get(face, [] { return ADD_FAILURE(), 0.0; });
    surface.known_thickness_everywhere.get(face, [] { return ADD_FAILURE(), ThicknessEverywhere(); });
    surface.known_clearance.get(face, [] { return ADD_FAILURE(), Clearance(); });
    surface.known_exit_depth.get(face, [] { return ADD_FAILURE(), 0.0; });
  }
}

}  // namespace
}  // namespace pcm::fast
