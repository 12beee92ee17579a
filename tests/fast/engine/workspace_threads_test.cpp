// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

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
/// one pose has left behind, of which fewer threads may take part in the last one.
TEST_P(WorkspaceThreads, GiveTheBitsOfOneThread) {
  const Case& asked = GetParam();
  const Pairing pairing(body_E(asked), Surface(generate::icosphere(1, asked.level)), test::rough(1000), Mode::both,
                        asked.scheme);
  Workspace one;
  Workspace many[] = {Workspace(2), Workspace(3), Workspace(40)};
  std::int64_t crossing = 0;
  Index too_deep = 0;
  for (int step = 0; step < 4; ++step) {
    const double overlap = step == 1 ? 0.002 : step == 3 && asked.overlap < 2 ? 0.6 * asked.overlap : asked.overlap;
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
                    Case{"NothingSaved", Scheme::barycentric, kForceAlone, 6, 1, false, false, Savings::none()},
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

/// All pairings of spheres in a row, each overlapping the next.
Scene row_of(const std::vector<Surface>& surfaces, Scheme scheme) {
  Scene scene;
  for (const Surface& surface : surfaces) scene.add_body(surface);
  for (Index E = 0; E < scene.bodies(); ++E) {
    for (Index F = E + 1; F < scene.bodies(); ++F)
      scene.add_pairing(E, F, test::rough(1000), Mode::E, scheme, kForceAlone);
  }
  return scene;
}

std::vector<BodyState> states_of_row(int bodies, int step) {
  std::vector<BodyState> states;
  for (int b = 0; b < bodies; ++b)
    states.push_back(
        {test::turned(b + 0.3 * step, {1.45 * b, 0.1 * step, 0}), {{-0.1 * b, 0.2, 0}, {0.1, 0.2 * b, 0.3}}});
  return states;
}

void expect_same_loads(const Scene& expected, const Scene& found) {
  EXPECT_EQ(expected.counters().work.elements, found.counters().work.elements);
  for (Index i = 0; i < expected.pairings(); ++i) {
    EXPECT_TRUE(test::same(expected.load(i).force_Me, found.load(i).force_Me));
    EXPECT_TRUE(test::same(expected.load(i).torque_Me, found.load(i).torque_Me));
    EXPECT_EQ(expected.load(i).touching, found.load(i).touching);
  }
}

class SceneThreads : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, SceneThreads, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& tested) {
                           return tested.param == Scheme::clipped ? "Clipped" : "Barycentric";
                         });

TEST_P(SceneThreads, OfSomeLargePairingsGiveTheBitsOfOne) {
  const Surface large(generate::icosphere(1, 6)), small(generate::icosphere(0.5, 2));
  const std::vector<Surface> bodies{large, large, large, small};
  Scene one = row_of(bodies, GetParam()), two = row_of(bodies, GetParam()), other = row_of(bodies, GetParam());
  for (int step = 0; step < 3; ++step) {
    int visits[3] = {};
    Scene* const scenes[] = {&one, &two, &other};
    const int threads[] = {1, 2, step == 1 ? 2 : 5};
    for (int s = 0; s < 3; ++s) {
      scenes[s]->move(states_of_row(4, step));
      std::atomic<int> count = 0;
      scenes[s]->evaluate_all(threads[s], [&](Index, const Contact&) { ++count; });
      visits[s] = count;
      expect_same_loads(one, *scenes[s]);
    }
    EXPECT_GE(visits[0], 3);
    EXPECT_EQ(visits[0], visits[1]);
    EXPECT_EQ(visits[0], visits[2]);
    EXPECT_GT(one.counters().work.elements, 8000);
  }
}

std::ptrdiff_t threads_of_process() {
#ifdef __linux__
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::distance(begin(tasks), end(tasks));
#else
  return 0;
#endif
}

/// From the second step on the scene knows which pairing is large: then it is the first that is seen, by the caller,
/// whose threads are all at work within it.
TEST_P(SceneThreads, OneLargePairingComesFirstWithAllThreads) {
  const Surface large(generate::icosphere(1, 6)), small(generate::icosphere(0.5, 2));
  const std::vector<Surface> bodies{small, small, large, large, small};
  Scene one = row_of(bodies, GetParam()), three = row_of(bodies, GetParam());
  constexpr Index kLarge = 7;
  const std::ptrdiff_t threads_before = threads_of_process();
  std::ptrdiff_t threads_within = 0;
  for (int step = 0; step < 6; ++step) {
    one.move(states_of_row(5, step));
    one.evaluate_all();
    three.move(states_of_row(5, step));
    std::mutex seeing;
    std::vector<std::pair<Index, std::thread::id>> seen;
    const auto see = [&](Index pairing, const Contact&) {
      const std::lock_guard lock(seeing);
      seen.emplace_back(pairing, std::this_thread::get_id());
      if (pairing == kLarge) threads_within = threads_of_process();
      if (step == 3 && pairing == kLarge) throw std::runtime_error("seen enough");
    };
    if (step == 3) {
      EXPECT_THROW(three.evaluate_all(3, see), std::runtime_error);
    } else {
      three.evaluate_all(step == 4 ? 2 : 3, see);
    }
    expect_same_loads(one, three);
    ASSERT_GE(seen.size(), 2U);
    if (step > 0) {
      EXPECT_EQ(seen.front(), std::pair(kLarge, std::this_thread::get_id()));
#ifdef __linux__
      // The scene's own, which wait, and those of the workspace that the large pairing is answered in.
      EXPECT_EQ(threads_within, threads_before + 2 + (step == 4 ? 1 : 2)) << step;
#endif
    }
  }
}

TEST_P(SceneThreads, AFewPairingsAreTakenByDifferentOnes) {
  const Surface sphere(generate::icosphere(1, 4));
  Scene scene = row_of({sphere, sphere, sphere}, GetParam());
  std::size_t most = 0;
  for (int step = 0; step < 200 && most < 2; ++step) {
    scene.move(states_of_row(3, step));
    std::mutex seeing;
    std::set<std::thread::id> threads;
    scene.evaluate_all(2, [&](Index, const Contact&) {
      const std::lock_guard lock(seeing);
      threads.insert(std::this_thread::get_id());
    });
    most = std::max(most, threads.size());
  }
  EXPECT_EQ(most, 2U);
}

}  // namespace
}  // namespace pcm::fast
