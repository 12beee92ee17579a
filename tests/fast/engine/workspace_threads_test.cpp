// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>

#include "meshes/generate/round.h"
#include "pcm/scene.h"
#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"
#include "tests/meshes/expect_bad_input.h"

namespace pcm::fast {
namespace {

using Eigen::Vector3d;

const Velocity kAlong{{0.3, -0.2, 0.5}, {0.7, 0.4, -0.6}};

/// The overlap of spheres that are one and the same, nearly all of whose faces are undecided.
constexpr double kCoincide = 2;

struct Case {
  std::string name;
  Scheme scheme;
  Wanted wanted;
  Index level;        ///< of the spheres
  double overlap;     ///< of the radius
  bool open = false;  ///< E without one of its faces
  bool flat = false;  ///< E a lens, through which lines pass before they leave F
  Savings savings = {};
};

void PrintTo(const Case& asked, std::ostream* out) {
  *out << asked.name;
}

constexpr Wanted kForceAlone{.polygons = false, .areas = false, .force = true, .elements = false};
constexpr Wanted kTouchAlone{.polygons = false, .areas = false, .force = false, .elements = false};
constexpr Wanted kForceAndBound{.polygons = false, .areas = false, .force = true, .elements = false, .bound = true};

Surface body_E(const Case& asked) {
  TriangleMesh mesh = generate::icosphere(1, asked.level);
  if (asked.open) mesh.faces.pop_back();
  if (asked.flat) {
    for (Vector3d& x : mesh.vertices) x.z() /= 16;
  }
  return Surface(std::move(mesh));
}

class WorkspaceThreads : public testing::TestWithParam<Case> {};

/// Patches that are large enough for threads to share each step, others that are not in between, and again with what
/// one pose has left behind.
TEST_P(WorkspaceThreads, GiveTheBitsOfOneThread) {
  const Case& asked = GetParam();
  const Pairing pairing(body_E(asked), Surface(generate::icosphere(1, asked.level)), test::rough(1000), Mode::both,
                        asked.scheme);
  Workspace one;
  Workspace many[] = {Workspace(2), Workspace(3), Workspace(8)};
  std::int64_t crossing = 0;
  Index too_deep = 0;
  for (int step = 0; step < 3; ++step) {
    const double overlap = step == 1 ? 0.002 : asked.overlap;
    const Pose pose = overlap == kCoincide
                          ? Pose()
                          : test::turned(0.4 + step, (2 - overlap) * Vector3d(1, 2 - step, -1).normalized());
    const Contact& expected = evaluate(pairing, pose, kAlong, asked.wanted, one, asked.savings);
    crossing = std::max(crossing, expected.work.crossing_pairs);
    too_deep = std::max(too_deep, expected.too_deep);
    for (Workspace& workspace : many) {
      const Contact& found = evaluate(pairing, pose, kAlong, asked.wanted, workspace, asked.savings);
      test::expect_same_answer(expected, found);
      EXPECT_EQ(expected.work.crossing_pairs, found.work.crossing_pairs);
      EXPECT_EQ(expected.work.candidate_pairs, found.work.candidate_pairs);
      EXPECT_EQ(expected.work.elements, found.work.elements);
      EXPECT_EQ(expected.work.velocities, found.work.velocities);
    }
  }
  const std::int64_t least = wants_only_touch(asked.wanted) ? -1 : asked.overlap == 1 && asked.level == 6 ? 1024 : 100;
  EXPECT_GT(crossing, least);
  EXPECT_EQ(too_deep > 0, asked.flat);
}

INSTANTIATE_TEST_SUITE_P(
    , WorkspaceThreads,
    testing::Values(Case{"Force", Scheme::barycentric, kForceAlone, 6, 1},
                    Case{"Everything", Scheme::barycentric, {}, 6, 1},
                    Case{"Tangent", Scheme::barycentric, test::kTangent, 6, 0.3},
                    Case{"Touch", Scheme::barycentric, kTouchAlone, 6, 1},
                    Case{"Bound", Scheme::barycentric, kForceAndBound, 6, 0.3},
                    Case{"BoundWhereAllCoincides", Scheme::barycentric, kForceAndBound, 4, kCoincide},
                    Case{"Open", Scheme::barycentric, {}, 6, 1, true},
                    Case{"NothingSaved", Scheme::barycentric, kForceAlone, 5, 0.3, false, false, Savings::none()},
                    Case{"ClippedLens", Scheme::clipped, kForceAlone, 4, 1, false, true},
                    Case{"ClippedForce", Scheme::clipped, kForceAlone, 5, 0.1},
                    Case{"ClippedEverything", Scheme::clipped, {}, 5, 0.1},
                    Case{"ClippedTangent", Scheme::clipped, test::kTangent, 5, 0.1}),
    [](const testing::TestParamInfo<Case>& tested) { return tested.param.name; });

TEST(WorkspaceThreadsTest, FewerThanOneAreRefused) {
  expect_bad_input([] { Workspace(0); }, "workspace: needs at least 1 thread, not 0");
  expect_bad_input([] { Workspace(-1); }, "not -1");
}

/// What overflows is refused as by one thread, and the workspace stays usable.
TEST(WorkspaceThreadsTest, ARefusalIsThatOfOneThread) {
  const Surface sphere(generate::icosphere(10, 6));
  const ContactLaw stiff = test::stiffness(1e307);
  const Pairing refused(sphere, sphere, stiff), answered(sphere, sphere, test::rough(0));
  Workspace one, two(2);
  const Pose pose = test::turned(0.3, {12, 0, 0});
  for (Workspace* workspace : {&one, &two}) {
    expect_bad_input([&] { evaluate(refused, pose, {}, kForceAlone, *workspace); }, "exceeds the range of doubles");
  }
  test::expect_same_answer(evaluate(answered, pose, {}, kForceAlone, one),
                           evaluate(answered, pose, {}, kForceAlone, two));
}

/// Two large pairings are fewer than three threads, and no fewer than two.
TEST(WorkspaceThreadsTest, ASceneWithLargePairingsGivesTheBitsOfOneThread) {
  const Surface sphere(generate::icosphere(1, 6)), small(generate::icosphere(0.5, 2));
  const auto scene_of_four = [&] {
    Scene scene;
    for (const Surface& surface : {sphere, sphere, sphere, small}) scene.add_body(surface);
    for (Index E = 0; E < 4; ++E)
      for (Index F = E + 1; F < 4; ++F)
        scene.add_pairing(E, F, test::rough(1000), Mode::E, Scheme::barycentric, kForceAlone);
    return scene;
  };
  Scene one = scene_of_four(), two = scene_of_four(), three = scene_of_four();
  for (int step = 0; step < 3; ++step) {
    std::vector<BodyState> states(4);
    for (int b = 0; b < 4; ++b) {
      BodyState& state = states[static_cast<std::size_t>(b)];
      state.pose = test::turned(b + 0.3 * step, {1.45 * b, 0.1 * step, 0});
      state.velocity = {{-0.1 * b, 0.2, 0}, {0.1, 0.2 * b, 0.3}};
    }
    int visits[3] = {};
    Scene* const scenes[] = {&one, &two, &three};
    for (int s = 0; s < 3; ++s) {
      scenes[s]->move(states);
      std::atomic<int> count = 0;
      scenes[s]->evaluate_all(s + 1, [&](Index, const Contact&) { ++count; });
      visits[s] = count;
      EXPECT_EQ(scenes[s]->counters().work.elements, one.counters().work.elements);
      for (Index i = 0; i < one.pairings(); ++i) {
        EXPECT_TRUE(test::same(one.load(i).force_Me, scenes[s]->load(i).force_Me));
        EXPECT_TRUE(test::same(one.load(i).torque_Me, scenes[s]->load(i).torque_Me));
        EXPECT_EQ(one.load(i).touching, scenes[s]->load(i).touching);
      }
    }
    EXPECT_GE(visits[0], 3);
    EXPECT_EQ(visits[0], visits[1]);
    EXPECT_EQ(visits[0], visits[2]);
    EXPECT_GT(one.counters().work.elements, 8000);
  }
}

}  // namespace
}  // namespace pcm::fast
