// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "simulate/run/simulation.h"
#include "simulate/scenes/read_scene.h"
#include "tests/simulate/scenes/built_in_scene.h"

namespace pcm::simulate {

/// For motions that every integrator has to find.
class KnownMotion : public testing::TestWithParam<Method> {};

inline const auto kEachMethod = testing::Values(Method::adams, Method::bdf, Method::ida, Method::dormand_prince,
                                                Method::esdirk, Method::rkc, Method::runge_kutta_merson);

/// For motions that are asked for so accurately that a method of order 2 would take too many steps.
inline const auto kEachMethodOfHigherOrder = testing::Values(
    Method::adams, Method::bdf, Method::ida, Method::dormand_prince, Method::esdirk, Method::runge_kutta_merson);

inline std::string method_name(const testing::TestParamInfo<Method>& tested) {
  constexpr const char* kNames[] = {"Adams", "Bdf", "Ida", "DormandPrince", "Esdirk", "Rkc", "RungeKuttaMerson"};
  return kNames[static_cast<std::size_t>(tested.param)];
}

/// By this method, at this relative and absolute tolerance.
inline Scene with_integrator(Scene scene, Method method, double tolerance) {
  scene.integrator.method = method;
  scene.integrator.relative_tolerance = scene.integrator.absolute_tolerance = tolerance;
  return scene;
}

inline Scene scene_with(const std::string& text, Method method, double tolerance) {
  return with_integrator(parse_scene(text, "test.json"), method, tolerance);
}

inline Scene built_in_scene_with(const std::string& name, Method method, double tolerance) {
  return with_integrator(built_in_scene(name), method, tolerance);
}

/// Coordinates and speeds at the end of the scene.
inline Eigen::VectorXd end_of(const Scene& scene, const std::function<void(const SimulatedStep&)>& visit = {}) {
  Simulation simulation(scene);
  simulation.start();
  while (!simulation.finished()) {
    const SimulatedStep step = simulation.step();
    if (visit) visit(step);
  }
  return simulation.checkpoint().y;
}

// A free joint's coordinates: quaternion, position; its speeds: angular velocity, velocity.
inline constexpr int kX = 4, kZ = 6, kWy = 8, kVx = 10, kVz = 12;

}  // namespace pcm::simulate
