// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Motions known in closed form, through the whole path: scene file, Simbody's model, contact, integrator.
#include <cmath>
#include <string>

#include "tests/simulate/run/run_scene.h"

namespace pcm::simulate {
namespace {

TEST_P(KnownMotion, OfAThrownBodyIsAParabola) {
  const Scene scene = scene_with(R"({"bodies": [{"name": "stone", "mass": 2, "inertia": [1, 1, 1],
      "centre_of_mass": [0, 0, 0], "velocity": [3, 0, 4], "angular_velocity": [0, 0, 2]}],
    "duration": 1, "gravity": [0, 0, -9.81], "output": {"checkpoint_interval": 0.3}})",
                                 GetParam(), 1e-8);
  const Eigen::VectorXd y = end_of(scene);
  EXPECT_NEAR(y[kX], 3, 1e-6);
  EXPECT_NEAR(y[kZ], 4 - 9.81 / 2, 1e-6);
  // Turned by 2 rad; a method of order 2 takes tolerance^(-1/3) steps for it.
  EXPECT_NEAR(std::abs(y[0]), std::abs(std::cos(1)), GetParam() == Method::rkc ? 5e-6 : 1e-6);
}

// It meets the bumper's spring at 2 m/s and leaves it after half a period, pi sqrt(m / k).
TEST_P(KnownMotion, OfACartOnABumperIsHalfAPeriodOfItsSpring) {
  const double period = std::acos(-1.0) * std::sqrt(2.0 / 800);
  Scene scene = scene_with(R"({"bodies": [{"name": "cart", "mass": 2, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0],
      "joint": {"type": "slider", "speeds": [2], "limits": [{"coordinate": 0, "from": -5, "to": 1, "stiffness": 800}]}}],
    "duration": 1, "gravity": [0, 0, 0]})",
                           GetParam(), 1e-8);
  scene.duration = 0.5 + period + 0.25;
  const Eigen::VectorXd y = end_of(scene);
  EXPECT_NEAR(y[0], 1 - 0.25 * 2, 1e-5);
  EXPECT_NEAR(y[1], -2, 1e-5);
}

/// A block of 10 kg with a footprint of 1 m x 1 m that starts at the depth which carries it, on a plate that gravity is
/// inclined to by `tilt`: a slope.
std::string block_on_slope(double tilt, const std::string& friction, const std::string& velocity) {
  const double g_x = 9.81 * std::sin(tilt), g_z = 9.81 * std::cos(tilt), depth = 10 * g_z / 1e6;
  return R"({"laws": {"law": {"stiffness": 1e6, "damping": 2e4, "slip_velocity": 1e-3, "friction": )" + friction +
         R"(}},
    "ground": {"surfaces": [{"name": "slope", "make": "plate", "parameters": {"extent_x": 8, "extent_y": 8, "thickness": 2}}]},
    "bodies": [{"name": "block", "density": 100, "at": {"position": [-2.01, 0.02, )" +
         std::to_string(0.05) + R"(]}, "velocity": [)" + velocity + R"(, 0, 0],
      "surfaces": [{"name": "block", "make": "box", "parameters": {"extent_x": 1, "extent_y": 1, "extent_z": 0.1},
                    "at": {"position": [0, 0, )" +
         std::to_string(-depth) + R"(]}}]}],
    "pairings": [{"E": "slope", "F": "block", "law": "law", "mode": "E", "scheme": "clipped"}],
    "gravity": [)" +
         std::to_string(g_x) + ", 0, " + std::to_string(-g_z) + R"(],
    "duration": 0.5, "integrator": {"greatest_step": 0.01}})";
}

// Friction tilts the block by a little at first, so that the bound is not the tolerance alone: moments of friction
// about its centre of mass, mu N h / 2 = 0.3 * 94 N * 0.05 m, against the stiffness of the foundation, c b^4 / 12 = 8e4
// N m: 2e-5 rad, which moves the block by 1e-6 m and turns gravity against the block by 2e-5.
TEST_P(KnownMotion, OfASlidingBlockHasGravityLessFriction) {
  const double tilt = 0.3, mu = 0.2;
  const Scene scene = scene_with(block_on_slope(tilt, "0.2", "0.5"), GetParam(), 1e-6);
  const Eigen::VectorXd y = end_of(scene);
  const double a = 9.81 * (std::sin(tilt) - mu * std::cos(tilt));
  EXPECT_NEAR(y[kVx], 0.5 + a * 0.5, 2e-4);
  EXPECT_NEAR(y[kX], -2.01 + 0.5 * 0.5 + a * 0.125, 1e-4);
}

// Steeper friction than slope: it stops, but for a creep at which regularised friction (20) carries it, below v_eps.
TEST_P(KnownMotion, OfASlidingBlockEndsInACreepBelowTheSlipVelocity) {
  const double tilt = 0.1, mu = 0.5;
  const Scene scene = scene_with(block_on_slope(tilt, "0.5", "0.5"), GetParam(), 1e-5);
  const double a = 9.81 * (mu * std::cos(tilt) - std::sin(tilt));
  const Eigen::VectorXd y = end_of(scene);
  EXPECT_NEAR(y[kX], -2.01 + 0.5 * 0.5 / (2 * a), 5e-4);
  EXPECT_LT(std::abs(y[kVx]), 1e-3);
}

// A block falls flat on a plate: undamped, it comes back to its height, and no energy is lost.
TEST_P(KnownMotion, OfAnUndampedBounceEndsWhereItBegan) {
  const std::string text = R"({"laws": {"law": {"stiffness": 1e6}},
    "ground": {"surfaces": [{"name": "floor", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 4, "thickness": 2}}]},
    "bodies": [{"name": "block", "mass": 100, "at": {"position": [0.03, 0.02, 0.7]}, "surfaces": [{"name": "block", "make": "box"}]}],
    "pairings": [{"E": "floor", "F": "block", "law": "law", "mode": "E", "scheme": "clipped"}],
    "gravity": [0, 0, -10], "duration": 1, "integrator": {"greatest_step": 0.005}})";
  // Down 0.2 m in sqrt(0.04) s; then m d2u/dt2 = m g - c u from 2 m/s on: as long as u > 0.
  const double w = std::sqrt(1e6 / 100), shift = 10 / (w * w);
  const double contact = 2 * (std::acos(-1.0) - std::atan2(2 / w, shift)) / w;
  Scene scene = scene_with(text, GetParam(), 1e-8);
  scene.duration = 0.4 + contact;
  double energy = 0, greatest_change = 0;
  const Eigen::VectorXd y = end_of(scene, [&](const SimulatedStep& step) {
    if (energy == 0) energy = step.observation.energies.total();
    greatest_change = std::max(greatest_change, std::abs(step.observation.energies.total() - energy));
  });
  EXPECT_NEAR(y[kZ], 0.7, 1e-5);
  EXPECT_NEAR(y[kVz], 0, 1e-4);
  EXPECT_LT(greatest_change, 1e-5 * energy);
}

INSTANTIATE_TEST_SUITE_P(Methods, KnownMotion, kEachMethod, method_name);

TEST(Multiples, AreCountedAsTheyAreMade) {
  for (const double interval : {0.1, 0.3, 0.07, 0.01, 0.001})
    for (std::int64_t n = 1; n <= 3000; ++n) {
      const double t = multiple_or_end(n, interval, 1e9);
      ASSERT_EQ(multiples_until(t, interval, 1e9), n);
      ASSERT_EQ(multiples_until(std::nextafter(t, 0), interval, 1e9), n - 1);
      const double written = std::round(1000 * t) / 1000;
      ASSERT_EQ(multiple_or_end(n, interval, written), written);
      ASSERT_EQ(multiples_until(written, interval, written), n);
    }
}

// What the flow of energy takes is what is missing at the end.
TEST(Simulation, EnergyTakenByFrictionAndDampingIsWhatIsMissing) {
  const Scene scene = scene_with(block_on_slope(0.3, "0.2", "0.5"), Method::dormand_prince, 1e-7);
  Simulation simulation(scene);
  simulation.start();
  const double before = simulation.checkpoint().energy_at_start;
  SimulatedStep last;
  while (!simulation.finished()) last = simulation.step();
  EXPECT_GT(last.flow.friction, 0.2 * 90 * 0.3);
  EXPECT_NEAR(last.observation.energies.total() + last.flow.lost(), before, 1e-4 * last.flow.friction);
}

TEST(Simulation, CountsElementsThatEnterAndLeave) {
  Scene scene = scene_with(std::string(built_in_scenes().front().text), Method::adams, 2e-4);
  scene.duration = 0.6;
  Index elements = 0;
  bool any = false;
  end_of(scene, [&](const SimulatedStep& step) {
    elements += step.entered - step.left;
    EXPECT_EQ(step.elements, elements);
    any = any || step.elements > 0;
  });
  EXPECT_TRUE(any);
}

// The floor is 4 m thick: the block starts within it, without crossing.
TEST(Simulation, RefusesBodiesThatAreNestedAtTheStart) {
  const std::string text = R"({"laws": {"law": {"stiffness": 1e6}},
    "ground": {"surfaces": [{"name": "floor", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 4, "thickness": 4}}]},
    "bodies": [{"name": "body", "mass": 1, "at": {"position": [0, 0, -2]}, "surfaces": [{"name": "block", "make": "box"}]}],
    "pairings": [{"E": "floor", "F": "block", "law": "law"}], "duration": 1})";
  Simulation simulation(parse_scene(text, "test.json"));
  try {
    simulation.start();
    ADD_FAILURE();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("'floor' and 'block' are nested"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace pcm::simulate
