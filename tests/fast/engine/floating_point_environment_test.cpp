// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <functional>
#include <string>
#include <utility>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "fast/force/law_parameters.h"
#include "pcm/bad_input.h"
#include "pcm/layer_stiffness.h"
#include "pcm/pairing_memory.h"
#include "pcm/scene.h"
#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"

/// The engine's answers do not depend on the environment a host has set up, and leave it as it was.
namespace pcm::fast {
namespace {

using namespace test;

struct Environment {
  const char* name;
  int rounding;
  unsigned set;         ///< bits of MXCSR
  unsigned masked;      ///< bits of MXCSR that are cleared: exceptions that trap then
  unsigned raised = 0;  ///< bits of MXCSR: sticky flags that the host has raised before
};

void PrintTo(const Environment& environment, std::ostream* out) {
  *out << environment.name;
}

#if defined(__SSE2__)
/// All of it: modes, masks, sticky flags.
unsigned registers() {
  return _mm_getcsr();
}
/// But for sticky flags.
bool is_default() {
  return (_mm_getcsr() & ~0x3fU) == 0x1f80;
}
#else
int registers() {
  return std::fegetround();
}
bool is_default() {
  return std::fegetround() == FE_TONEAREST;
}
#endif

/// The host's environment as long as it lives. Whoever holds it must not compute himself.
class Host {
 public:
  explicit Host(const Environment& environment) {
    std::fegetenv(&before_);
    std::fesetround(environment.rounding);
#if defined(__SSE2__)
    _mm_setcsr(((_mm_getcsr() | environment.set) & ~(environment.masked | 0x3fU)) | environment.raised);
#endif
    entered_ = registers();
  }
  ~Host() {
    std::fesetenv(&before_);
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  bool as_before() const {
    return registers() == entered_;
  }

 private:
  std::fenv_t before_{};
  decltype(registers()) entered_;
};

/// Bodies, poses and laws; answered in one go, so that nothing is computed in between.
struct Question {
  TriangleMesh E, F;
  std::vector<Pose> poses;
};

std::vector<Question> questions() {
  const TriangleMesh cube = generate::gridded_box(2, 2), ball = generate::icosphere(1, 2);
  // Faces a denormal apart: which lies before the other depends on it.
  const double tiny = 0x1p-1070;
  const TriangleMesh standing = generate::box(Eigen::Vector3d(-0.5, -0.5, 0), Eigen::Vector3d(0.5, 0.5, 1));
  TriangleMesh uneven = generate::plate(2, 2, 1, 3, 3);
  for (std::size_t i = 0; i < uneven.vertices.size(); i += 2) {
    if (uneven.vertices[i].z() == 0) uneven.vertices[i].z() = tiny;
  }
  std::vector<Question> all{{ball, generate::torus(1, 0.3, 16, 8), {}}, {cube, cube, {}}, {uneven, standing, {}}};
  for (int i = 0; i < 12; ++i) all[0].poses.push_back(turned(0.5 * i, {0.4, 0.3, 0.1 * i}));
  for (const double r : {0.0, 0.5, 1.0, 2.0}) {
    all[1].poses.push_back(shifted(r, 0, 0));
    all[1].poses.push_back(shifted(r, 0.5, 1));
    all[1].poses.push_back(shifted(tiny, r, -tiny));
    all[1].poses.push_back(shifted(r, -3 * tiny, 2));
    for (const double z : {-0.125, -tiny, 0.0, 0.5 * tiny, tiny}) all[2].poses.push_back(shifted(0.25, 0.25 * r, z));
  }
  return all;
}

ContactLaw law_of_everything() {
  ContactLaw law;
  law.layers = LayerStiffness{3e5, 2e5};
  law.damping = 700;
  law.transition_depth = 0.3;
  law.friction = 0.4;
  law.slip_velocity = 0.1;
  law.max_penetration = 0.25;
  return law;
}

constexpr double kThirds = 1.0 / 3;
const Velocity kVelocity{{0.2, -kThirds, 0.9}, {0.5, -0.2, kThirds}};

std::vector<Contact> answers(const Question& question, const ContactLaw& law, bool with_bound) {
  std::vector<Contact> all;
  const Surface E(question.E), F(question.F);
  Wanted wanted;
  wanted.bound = with_bound;
  Workspace workspace;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const Pairing pairing(E, F, law, Mode::both, scheme);
    PairingMemory memory(pairing);
    for (const Pose& pose : question.poses) {
      all.push_back(evaluate(pairing, pose, kVelocity, wanted, workspace));
      memory.evaluate(pose, {}, wanted, workspace);
      all.push_back(memory.evaluate(pose, kVelocity, wanted, workspace));
    }
  }
  return all;
}

bool refused(const std::function<void()>& act) {
  try {
    act();
  } catch (const BadInput&) {
    return true;
  }
  return false;
}

class EnvironmentOfAHost : public testing::TestWithParam<Environment> {};

TEST_P(EnvironmentOfAHost, ChangesNoBitOfAnAnswerAndIsLeftAsItWas) {
  const ContactLaw law = law_of_everything();
  for (const Question& question : questions()) {
    for (const bool with_bound : {false, true}) {
      const std::vector<Contact> expected = answers(question, law, with_bound);
      std::vector<Contact> found;
      bool as_before = false;
      {
        const Host host(GetParam());
        found = answers(question, law, with_bound);
        as_before = host.as_before();
      }
      EXPECT_TRUE(as_before);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        SCOPED_TRACE(i);
        expect_same_answer(expected[i], found[i]);
        if (HasFailure()) return;
      }
    }
  }
}

TEST_P(EnvironmentOfAHost, ChangesNoBitOfASceneOnSeveralThreads) {
  const TriangleMesh ball_mesh = generate::icosphere(1, 2), cube_mesh = generate::gridded_box(2, 2);
  std::vector<BodyState> states(4);
  for (int b = 0; b < 4; ++b) {
    states[static_cast<std::size_t>(b)].pose = turned(0.7 * b, {0.3 * b, 0.5 * b, kThirds * b});
    states[static_cast<std::size_t>(b)].velocity = {{0.1 * b, 0, kThirds}, {0, 0.2 * b, 0.1}};
  }
  struct Loads {
    std::vector<PairingLoad> loads;
    std::vector<BodyLoad> body_loads;
    Pose pose;
    Velocity velocity;
    Contact contact;
    int visits = 0, visits_elsewhere = 0;
  };
  // Surfaces of its own, so that what faces have near them is computed in the host's environment too.
  const auto run = [&](bool all_faces_first) {
    const Surface ball(ball_mesh), cube(cube_mesh);
    if (all_faces_first) {
      ball.prepare_all_faces();
      cube.prepare_all_faces();
    }
    Scene scene;
    for (int b = 0; b < 4; ++b) scene.add_body(b % 2 == 0 ? ball : cube);
    for (Index E = 0; E < 4; ++E)
      for (Index F = 0; F < E; ++F)
        scene.add_pairing(E, F, law_of_everything(), Mode::E, E % 2 == 0 ? Scheme::clipped : Scheme::barycentric);
    scene.move(states);
    std::atomic<int> visits = 0, visits_elsewhere = 0;
    const auto visit = [&](Index, const Contact&) {
      ++visits;
      if (!is_default()) ++visits_elsewhere;
    };
    scene.evaluate_all(3, visit);
    scene.evaluate_all(2, visit);
    Loads all;
    for (Index p = 0; p < scene.pairings(); ++p) all.loads.push_back(scene.load(p));
    all.body_loads = scene.body_loads();
    all.pose = scene.relative_pose(2);
    all.velocity = scene.relative_velocity(2);
    Workspace workspace;
    all.contact = scene.evaluate(0, workspace);
    all.visits = visits;
    all.visits_elsewhere = visits_elsewhere;
    return all;
  };
  const Loads expected = run(false);
  for (const bool all_faces_first : {false, true}) {
    Loads found;
    bool as_before = false;
    {
      const Host host(GetParam());
      found = run(all_faces_first);
      as_before = host.as_before();
    }
    EXPECT_TRUE(as_before);
    EXPECT_GT(found.visits, 4);
    EXPECT_EQ(found.visits_elsewhere, 0) << "in an environment that is not the default one";
    ASSERT_EQ(found.loads.size(), expected.loads.size());
    for (std::size_t p = 0; p < found.loads.size(); ++p) {
      EXPECT_TRUE(same(found.loads[p].force_Me, expected.loads[p].force_Me));
      EXPECT_TRUE(same(found.loads[p].torque_Me, expected.loads[p].torque_Me));
    }
    for (std::size_t b = 0; b < 4; ++b) {
      EXPECT_TRUE(same(found.body_loads[b].force_W, expected.body_loads[b].force_W));
      EXPECT_TRUE(same(found.body_loads[b].torque_W, expected.body_loads[b].torque_W));
    }
    for (Eigen::Index k = 0; k < 3; ++k)
      EXPECT_TRUE(same(Eigen::Vector3d(found.pose.A.col(k)), Eigen::Vector3d(expected.pose.A.col(k))));
    EXPECT_TRUE(same(found.pose.r, expected.pose.r));
    EXPECT_TRUE(same(found.velocity.v, expected.velocity.v));
    EXPECT_TRUE(same(found.velocity.w, expected.velocity.w));
    expect_same_answer(found.contact, expected.contact);
  }
}

TEST_P(EnvironmentOfAHost, IsLeftAsItWasWhereInputIsRefused) {
  const TriangleMesh cube = generate::gridded_box(2, 2);
  Pose skewed;
  skewed.A(0, 1) = 1e-5;
  Pose nowhere;
  nowhere.r.x() = std::numeric_limits<double>::quiet_NaN();
  ContactLaw tiny_stiffness;
  tiny_stiffness.stiffness = 0x1p-1070;
  const Surface surface(cube);
  const Pairing pairing(surface, surface);
  TriangleMesh flat = cube;
  for (Eigen::Vector3d& x : flat.vertices) x.z() = 0;
  Scene scene;
  scene.add_body(surface);
  Workspace workspace;
  const std::pair<std::function<void()>, bool> acts[] = {{[&] { evaluate(pairing, skewed, {}, {}, workspace); }, true},
                                                         {[&] { evaluate(pairing, nowhere, {}, {}, workspace); }, true},
                                                         {[&] {
                                                            scene.move({{skewed, {}}});
                                                          },
                                                          true},
                                                         {[&] { const Surface unfit(flat); }, true},
                                                         {[&] { layer_stiffness(1, 0.45, 1); }, true},
                                                         {[&] { Pairing(surface, surface, tiny_stiffness); }, false}};
  for (const auto& [act, is_refused] : acts) {
    bool found = false, as_before = false;
    {
      const Host host(GetParam());
      found = refused(act);
      as_before = host.as_before();
    }
    EXPECT_TRUE(as_before);
    EXPECT_EQ(found, is_refused);
  }
}

TEST_P(EnvironmentOfAHost, ChangesNoBitOfALayersStiffness) {
  const double expected = layer_stiffness(2.1e11, 0.3, 0.007);
  double found = 0;
  bool as_before = false;
  {
    const Host host(GetParam());
    found = layer_stiffness(2.1e11, 0.3, 0.007);
    as_before = host.as_before();
  }
  EXPECT_TRUE(as_before);
  EXPECT_TRUE(same(found, expected));
}

#if defined(__SSE2__)
INSTANTIATE_TEST_SUITE_P(
    Modes, EnvironmentOfAHost,
    testing::Values(
        Environment{"Default", FE_TONEAREST, 0, 0}, Environment{"Upward", FE_UPWARD, 0, 0},
        Environment{"Downward", FE_DOWNWARD, 0, 0}, Environment{"TowardZero", FE_TOWARDZERO, 0, 0},
        Environment{"FlushToZero", FE_TONEAREST, 0x8000, 0}, Environment{"DenormalsAreZero", FE_TONEAREST, 0x0040, 0},
        Environment{"AllButTraps", FE_UPWARD, 0x8040, 0}, Environment{"TrapOnInvalid", FE_TONEAREST, 0, 0x0080},
        Environment{"TrapOnDenormal", FE_TONEAREST, 0, 0x0100}, Environment{"TrapOnDivision", FE_TONEAREST, 0, 0x0200},
        Environment{"TrapOnOverflow", FE_TONEAREST, 0, 0x0400}, Environment{"TrapOnUnderflow", FE_TONEAREST, 0, 0x0800},
        Environment{"TrapOnInexact", FE_TONEAREST, 0, 0x1000}, Environment{"Raised", FE_TONEAREST, 0, 0, 0x15},
        Environment{"UpwardRaised", FE_UPWARD, 0, 0, 0x2a}),
    [](const testing::TestParamInfo<Environment>& test) { return std::string(test.param.name); });
#else
INSTANTIATE_TEST_SUITE_P(Modes, EnvironmentOfAHost,
                         testing::Values(Environment{"Default", FE_TONEAREST, 0, 0},
                                         Environment{"Upward", FE_UPWARD, 0, 0},
                                         Environment{"Downward", FE_DOWNWARD, 0, 0},
                                         Environment{"TowardZero", FE_TOWARDZERO, 0, 0}),
                         [](const testing::TestParamInfo<Environment>& test) { return std::string(test.param.name); });
#endif

}  // namespace
}  // namespace pcm::fast
