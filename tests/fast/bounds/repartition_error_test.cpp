// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/bounds/repartition_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "fast/force/force_problem.h"
#include "tests/fast/true_force.h"

/// What it costs that elements of one master face pass area and volume to each other, against the law in long double.
namespace pcm::fast::repartition_error_test {
namespace {

struct Example {
  const char* name;
  ContactLaw law;
  bool elsewhere;      ///< something passes to where no element was computed
  double least_ratio;  ///< the bound is no looser than that
};

void PrintTo(const Example& example, std::ostream* out) {
  *out << example.name;
}

ContactLaw made(double damping, double transition, double friction) {
  ContactLaw law;
  law.stiffness = 1e5;
  law.damping = damping;
  law.transition_depth = transition;
  law.friction = friction;
  law.slip_velocity = 0.1;
  law.damping_mode = DampingMode::full;
  return law;
}

class PassingErrorOf : public testing::TestWithParam<Example> {};

TEST_P(PassingErrorOf, HoldsForWhatElementsPassToEachOther) {
  const Example& example = GetParam();
  std::mt19937_64 random(92);
  SCOPED_TRACE("seed 92");
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] {
    const double x = unit(random), y = unit(random), z = unit(random);
    return Eigen::Vector3d(x, y, z);
  };
  double greatest_force_ratio = 0, greatest_torque_ratio = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    Pose pose;
    pose.r = vector();
    const Velocity velocity{vector(), 3 * vector()};
    ForceProblem problem(example.law, pose, velocity, {});
    problem.with_velocities = true;
    const Side master = random() % 2 == 0 ? Side::E : Side::F;
    const Eigen::Vector3d n = vector().normalized();
    const RealVector true_n = n.cast<Real>().normalized();
    const double normal_error = static_cast<double>((true_n - n.cast<Real>()).norm()) * 1.001;
    const std::size_t count = 2 + random() % 3;
    const double scale = std::pow(10.0, -3 - 6 * std::abs(unit(random)));

    struct Part {
      double area, depth;
      Eigen::Vector3d foot;
      double passed_area, passed_volume;  ///< what it gets
    };
    std::vector<Part> parts;
    for (std::size_t k = 0; k < count; ++k) {
      parts.push_back({0.01 * (1.1 + unit(random)), 0.01 * (1.01 + unit(random)), vector(), 0, 0});
    }
    for (std::size_t k = 1; k < count; ++k) {
      const double area = scale * 0.001 * unit(random), volume = area * 0.01 * (1 + unit(random));
      parts[k].passed_area += area;
      parts[k - 1].passed_area -= area;
      parts[k].passed_volume += volume;
      parts[k - 1].passed_volume -= volume;
    }
    if (example.elsewhere) {
      const double area = scale * 0.001 * std::abs(unit(random));
      parts[0].passed_area -= area;
      parts[0].passed_volume -= 0.005 * area;
      parts.push_back({0, 0.005, vector(), area, 0.005 * area});
    }

    RealVector force = RealVector::Zero(), torque = RealVector::Zero();  // How far off.
    ElementForceError bound;
    RepartitionError passing;
    for (const Part& part : parts) {
      const Real true_area = Real(part.area) + Real(part.passed_area);
      const Real true_volume = Real(part.area) * Real(part.depth) + Real(part.passed_volume);
      const TrueForce truth = true_force(example.law, pose, velocity, master, true_area, true_volume / true_area,
                                         true_n, part.foot.cast<Real>());
      force += truth.force;
      torque += truth.torque;
      const double passed_area = std::abs(part.passed_area), passed_volume = std::abs(part.passed_volume);
      if (part.area == 0) {
        passing.add_elsewhere(passed_area, passed_volume);
        const GreatestForce most = greatest_force(problem, passed_area, passed_volume / passed_area, part.foot,
                                                  Eigen::Vector3d::Constant(1e-12));
        bound.force_Me += Eigen::Vector3d::Constant(most.force());
        bound.torque_Me += Eigen::Vector3d::Constant(most.torque);
        continue;
      }
      Element element;
      element.master = master;
      element.area = part.area;
      element.penetration = part.depth;
      element.normal_Me = n;
      apply_force(problem, part.foot, element);
      force -= element.force_Me.cast<Real>();
      torque -= (element.position_Me - pose.r).cast<Real>().cross(element.force_Me.cast<Real>());
      ElementError error;
      error.mean = part.depth;
      error.normal = normal_error;
      error.volume = 0x1p-52 * part.area * part.depth;
      error.penetration = 1.0001 * (passed_volume + part.depth * passed_area) / (part.area - passed_area);
      error.passed_area = passed_area;
      error.passed_volume = passed_volume;
      passing.add(problem, element, error, bound);
      const ElementForceError own = force_error(problem, element, error);
      bound.force_Me += RepartitionError::kGrowth * own.force_Me;
      bound.torque_Me += RepartitionError::kGrowth * own.torque_Me;
    }
    passing.finish(bound);
    for (int k = 0; k < 3; ++k) {
      const auto force_off = static_cast<double>(std::abs(force[k])),
                 torque_off = static_cast<double>(std::abs(torque[k]));
      ASSERT_LE(force_off, bound.force_Me[k]) << "trial " << trial << " scale " << scale;
      ASSERT_LE(torque_off, bound.torque_Me[k]) << "trial " << trial << " scale " << scale;
      greatest_force_ratio = std::max(greatest_force_ratio, force_off / bound.force_Me[k]);
      greatest_torque_ratio = std::max(greatest_torque_ratio, torque_off / bound.torque_Me[k]);
    }
  }
  std::printf("  %s: greatest error over its bound, force %.3f, torque %.3f\n", example.name, greatest_force_ratio,
              greatest_torque_ratio);
  EXPECT_GE(greatest_force_ratio, example.least_ratio);
}

INSTANTIATE_TEST_SUITE_P(Laws, PassingErrorOf,
                         testing::Values(Example{"Elastic", made(0, 0, 0), false, 0},
                                         Example{"Damping", made(1e5, 0, 0), false, 0.9},
                                         Example{"FadingDamping", made(1e6, 0.05, 0), false, 0.9},
                                         Example{"PartlyFadingDamping", made(1e5, 0.008, 0), false, 0.9},
                                         Example{"Friction", made(0, 0, 0.5), false, 0.9},
                                         Example{"DampingElsewhere", made(1e5, 0, 0), true, 0.9},
                                         Example{"PartlyFadingElsewhere", made(1e3, 0.004, 0), true, 0.9}),
                         [](const testing::TestParamInfo<Example>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pcm::fast::repartition_error_test
