// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What docs/simulate.md says of two integrators that approach one another, and of a scene's sensitivity. The tables
// there are what this program prints.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/simulate/run/run_scene.h"

namespace pcm::simulate {
namespace {

constexpr double kInterval = 0.01;  // s

/// Where the origins of all surfaces are at multiples of kInterval, one column each, m.
std::vector<Eigen::Matrix3Xd> path(const Scene& scene) {
  Simulation simulation(scene);
  std::vector<Eigen::Matrix3Xd> places;
  const auto add = [&](double t, const Eigen::VectorXd& y) {
    const std::vector<Pose> poses = simulation.model().observe(t, y).surfaces_G;
    Eigen::Matrix3Xd now(3, static_cast<Eigen::Index>(poses.size()));
    for (std::size_t s = 0; s < poses.size(); ++s) now.col(static_cast<Eigen::Index>(s)) = poses[s].r;
    places.push_back(now);
  };
  simulation.start();
  add(0, simulation.checkpoint().y);
  while (!simulation.finished()) {
    simulation.step();
    const auto reached = static_cast<std::size_t>(multiples_until(simulation.t(), kInterval, scene.duration));
    while (places.size() <= reached) {
      const double t = multiple_or_end(static_cast<std::int64_t>(places.size()), kInterval, scene.duration);
      add(t, simulation.state_at(t));
    }
  }
  return places;
}

/// The greatest distance between the same surface's places, at each instant, m.
std::vector<double> distances(const std::vector<Eigen::Matrix3Xd>& a, const std::vector<Eigen::Matrix3Xd>& b) {
  std::vector<double> all;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    all.push_back((a[i] - b[i]).colwise().norm().maxCoeff());
  }
  return all;
}

/// Up to which instant all distances are below `bound`, s.
double together_until(const std::vector<double>& distances, double bound) {
  std::size_t i = 0;
  while (i < distances.size() && distances[i] < bound) ++i;
  return kInterval * (static_cast<double>(i) - 1);
}

double at(const std::vector<double>& distances, double t) {
  return distances.at(static_cast<std::size_t>(std::lround(t / kInterval)));
}

/// By each of both methods at each tolerance.
std::vector<std::vector<double>> approach(const std::string& name, double duration, Method one, Method other,
                                          const std::vector<double>& tolerances) {
  std::vector<std::vector<double>> all;
  std::printf("| tolerance | within 0.1 mm until | 1 mm | 1 cm |\n|---|---|---|---|\n");
  for (const double tolerance : tolerances) {
    const auto by = [&](Method method) {
      Scene scene = built_in_scene_with(name, method, tolerance);
      scene.duration = duration;
      return path(scene);
    };
    all.push_back(distances(by(one), by(other)));
    std::printf("| %.0e | %.2f s | %.2f s | %.2f s |\n", tolerance, together_until(all.back(), 1e-4),
                together_until(all.back(), 1e-3), together_until(all.back(), 1e-2));
    std::fflush(stdout);
  }
  return all;
}

TEST(Convergence, OfTwoIntegratorsOnTheBubblesLastsTheLongerTheFinerTheTolerance) {
  const auto apart = approach("bubbles", 3, Method::adams, Method::dormand_prince, {1e-4, 1e-5, 1e-6, 1e-7});
  for (std::size_t i = 1; i < apart.size(); ++i) {
    EXPECT_GE(together_until(apart[i], 1e-3), together_until(apart[i - 1], 1e-3)) << i;
  }
}

// Here a finer tolerance does not help: docs/simulate.md.
TEST(Convergence, OfTwoIntegratorsOnTheCrashLastsHalfASecond) {
  for (const std::vector<double>& apart :
       approach("pedestrian", 0.6, Method::bdf, Method::dormand_prince, {1e-3, 1e-4})) {
    EXPECT_GT(together_until(apart, 1e-2), 0.5);
  }
}

// The first bubble is let go 1e-12 m higher.
TEST(Sensitivity, OfTheBubblesToTheirInitialHeightGrowsWithContact) {
  Scene scene = built_in_scene_with("bubbles", Method::dormand_prince, 1e-7);
  const std::vector<Eigen::Matrix3Xd> as_it_is = path(scene);
  scene.bodies[0].at_G.p[2] += 1e-12;
  const std::vector<double> apart = distances(as_it_is, path(scene));
  std::printf("| t, s | distance, m |\n|---|---|\n");
  for (double t = 0; t < 3.05; t += 0.25) std::printf("| %.2f | %.1e |\n", t, at(apart, t));
  EXPECT_LT(at(apart, 0.25), 2e-12);  // still in flight
  EXPECT_GT(at(apart, 3), 1e-4);
}

}  // namespace
}  // namespace pcm::simulate
