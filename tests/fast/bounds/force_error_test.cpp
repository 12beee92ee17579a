// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/bounds/force_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "fast/force/force_problem.h"
#include "tests/fast/true_force.h"

/// The force law's error bounds against the law in long double at geometry moved within its errors: to the ends of
/// them more often than not. Errors from none at all (roundings alone) to a tenth of the values (no term of higher
/// order may be missing).
namespace pcm::fast {
namespace {

/// A law, and which motion makes the law's sharp places likely.
struct Example {
  const char* name;
  ContactLaw law;
  double speed;
  double least_ratio;  ///< the bound is no looser than that
  double length = 1;   ///< times which all lengths are drawn
};

void PrintTo(const Example& example, std::ostream* out) {
  *out << example.name;
}

ContactLaw made(double damping, double transition, double friction, double slip,
                DampingMode mode = DampingMode::no_tension) {
  ContactLaw law;
  law.stiffness = 1e5;
  law.damping = damping;
  law.transition_depth = transition;
  law.friction = friction;
  law.slip_velocity = slip;
  law.damping_mode = mode;
  return law;
}

ContactLaw soft(double stiffness, ContactLaw law) {
  law.stiffness = stiffness;
  return law;
}

ContactLaw layered(ContactLaw law, double c_E, double c_F) {
  law.layers = LayerStiffness{c_E, c_F};
  return law;
}

ContactLaw clamped(ContactLaw law, double max_penetration) {
  law.max_penetration = max_penetration;
  return law;
}

TEST(ForceError, HoldsForAStiffnessWhosePartOnANarrowColumnUnderflows) {
  const ContactLaw law = soft(3e-320, made(0, 0, 0, 0));
  const Pose pose;
  const Velocity velocity;
  const ForceProblem problem(law, pose, velocity, {});
  Element element;
  element.normal_Me = {0, 0, 1};
  for (double area = 0.63; area > 1e-6; area *= 0.7) {
    element.area = area;
    element.penetration = 1e8;
    apply_force(problem, Eigen::Vector3d::Zero(), element);
    const TrueForce truth = true_force(law, problem.pose, problem.velocity, Side::E, area, element.penetration,
                                       element.normal_Me.cast<Real>(), RealVector::Zero());
    const ElementForceError bound = force_error(problem, element, ElementError{});
    EXPECT_LE(std::abs(truth.force.z() - Real(element.force_Me.z())), Real(bound.force_Me.z())) << area;
    const GreatestForce most = greatest_force(problem, area, 1e8, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    EXPECT_LE(truth.force.z(), Real(most.force())) << area;
  }
}

// The normal force underflows, and friction multiplies what it lost.
TEST(ForceError, HoldsWhereGreatFrictionMultipliesANormalForceThatUnderflows) {
  ContactLaw law = soft(0x1p-1060, made(0, 0, 0, 0));
  law.friction = 0x1p100;
  const Pose pose;
  const Velocity velocity{{1, 0, 0}, {0, 0, 0}};
  const ForceProblem problem(law, pose, velocity, {});
  Element element;
  element.normal_Me = {0, 0, 1};
  element.area = 0.3125;
  for (double depth = 0x1p-10; depth > 0x1p-30; depth /= 2) {
    element.penetration = depth;
    apply_force(problem, Eigen::Vector3d::Zero(), element);
    const TrueForce truth = true_force(law, problem.pose, problem.velocity, Side::E, element.area, depth,
                                       element.normal_Me.cast<Real>(), RealVector::Zero());
    const ElementForceError bound = force_error(problem, element, ElementError{});
    EXPECT_LE(std::abs(truth.force.x() - Real(element.force_Me.x())), Real(bound.force_Me.x())) << depth;
    const GreatestForce most =
        greatest_force(problem, element.area, depth, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    EXPECT_LE(std::abs(truth.force.x()), Real(most.friction)) << depth;
  }
}

class ForceErrorOf : public testing::TestWithParam<Example> {};

TEST_P(ForceErrorOf, HoldsAtTheEndsOfTheErrors) {
  const Example& example = GetParam();
  std::mt19937_64 random(91);
  SCOPED_TRACE("seed 91");
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] {
    const double x = unit(random), y = unit(random), z = unit(random);
    return Eigen::Vector3d(x, y, z);
  };
  const auto end = [&] { return random() % 3 == 0 ? unit(random) : (random() % 2 == 0 ? 1.0 : -1.0); };
  double greatest = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    Pose pose;
    pose.r = example.length * vector();
    const Velocity velocity{example.speed * std::exp2(-8 * std::abs(unit(random))) * vector(),
                            example.speed * std::exp2(-8 * std::abs(unit(random))) * vector()};
    ForceProblem problem(example.law, pose, velocity, {});
    problem.with_velocities = true;
    const double scale = trial % 4 == 0 ? 0 : std::pow(10.0, -1 - 12 * std::abs(unit(random)));
    Element element;
    element.master = random() % 2 == 0 ? Side::E : Side::F;
    element.area = 0.01 * example.length * (1.1 + unit(random)) * example.length;
    const double depth = 0.01 * example.length * (1.01 + unit(random));
    element.penetration = std::min(depth, example.law.max_penetration);
    element.normal_Me = vector().normalized();
    const Eigen::Vector3d foot = example.length * vector();
    apply_force(problem, foot, element);

    // One kind of error at a time, or all of them.
    const auto which = random() % 5;
    ElementError error;
    if (which == 0 || which == 4) error.area = scale * element.area;
    if (which == 1 || which == 4) error.penetration = scale * depth;
    if (which == 2 || which == 4) error.normal = scale;
    if (which == 3 || which == 4) error.foot_Me = scale * example.length * vector().cwiseAbs();
    const Eigen::Vector3d turn = vector().normalized();
    const RealVector n =
        (element.normal_Me.cast<Real>().normalized() + Real(error.normal * 0.99) * turn.cast<Real>()).normalized();
    error.normal = std::max(error.normal, static_cast<double>(1.0001L * (n - element.normal_Me.cast<Real>()).norm()));
    const Eigen::Vector3d ends(end(), end(), end());
    const RealVector true_foot = foot.cast<Real>() + error.foot_Me.cwiseProduct(ends).cast<Real>();
    const Real true_area = Real(element.area) + Real(error.area) * Real(end());
    const Real true_depth = Real(depth) + Real(error.penetration) * Real(end());
    // The clipped scheme knows the volume, of the depth as clamped, better than its factors, which may be off together.
    if (trial % 3 == 0) {
      const Real true_volume = true_area * std::min(true_depth, static_cast<Real>(example.law.max_penetration));
      error.volume = static_cast<double>(std::abs(true_volume - Real(element.area) * Real(element.penetration)) +
                                         1e-19L * true_volume);
    }
    const TrueForce truth =
        true_force(example.law, pose, velocity, element.master, true_area, true_depth, n, true_foot);

    const ElementForceError bound = force_error(problem, element, error);
    const Eigen::Vector3d torque = (element.position_Me - pose.r).cross(element.force_Me);
    for (int k = 0; k < 3; ++k) {
      const auto force_off = static_cast<double>(std::abs(truth.force[k] - Real(element.force_Me[k])));
      const auto torque_off = static_cast<double>(std::abs(truth.torque[k] - Real(torque[k])));
      ASSERT_LE(force_off, bound.force_Me[k]) << "trial " << trial << " errors " << which << " times " << scale;
      ASSERT_LE(torque_off, bound.torque_Me[k]) << "trial " << trial << " errors " << which << " times " << scale;
      greatest = std::max({greatest, force_off / bound.force_Me[k], torque_off / bound.torque_Me[k]});
    }
    const GreatestForce most =
        greatest_force(problem, element.area + error.area, depth + error.penetration, foot, error.foot_Me);
    ASSERT_LE(static_cast<double>(truth.force.norm()), most.force());
    ASSERT_LE(static_cast<double>(truth.torque.norm()), most.torque);
  }
  std::printf("  %s: greatest error over its bound %.3f\n", example.name, greatest);
  EXPECT_GE(greatest, example.least_ratio);
}

INSTANTIATE_TEST_SUITE_P(
    Laws, ForceErrorOf,
    testing::Values(Example{"Elastic", made(0, 0, 0, 0), 0, 0.5},
                    Example{"Layers", layered(made(0, 0, 0, 0), 3e5, 7e4), 0, 0.5},
                    Example{"Clamped", clamped(made(0, 0, 0, 0), 0.01), 0, 0.5},
                    Example{"Damping", made(1e5, 0, 0, 0), 1, 0.5},
                    Example{"FadingDamping", made(1e6, 0.02, 0, 0), 1, 0.5},
                    Example{"FullDamping", layered(made(1e5, 0.01, 0, 0, DampingMode::full), 1e5, HUGE_VAL), 1, 0.5},
                    Example{"CompressionDamping", made(1e5, 0.01, 0, 0, DampingMode::compression), 1, 0.5},
                    Example{"DryFriction", made(0, 0, 0.5, 0), 1e-3, 0.3},
                    Example{"RegularisedFriction", made(0, 0, 10, 1), 1, 0.3},
                    Example{"SteepFriction", made(0, 0, 10, 1e-3), 1e-3, 0.3},
                    Example{"Everything", clamped(layered(made(1e5, 0.01, 0.5, 0.1), 3e5, 7e4), 0.015), 1, 0.3},
                    // At the end of doubles: what underflows is multiplied on, or divides.
                    Example{"SubnormalSlip", made(0, 0, 0.5, 0), 1e-321, 0},
                    Example{"SubnormalSlipThatIsSteep", made(0, 0, 0.5, 1e-320), 1e-321, 0},
                    Example{"SubnormalSpin", made(0, 0, 0.5, 0), 1e-310, 0, 0x1p-20},
                    Example{"SubnormalApproach", soft(1e-300, made(1e200, 0, 0, 0)), 1e-321, 0},
                    Example{"SubnormalDamping", soft(1e-320, made(1e-320, 0, 0.5, 0)), 1e200, 0},
                    Example{"SubnormalFade", soft(1e-300, made(1e200, 1e308, 0, 0)), 1e10, 0},
                    Example{"HardOnSoft", layered(made(0, 0, 0, 0), 1e300, 1e-300), 0, 0},
                    Example{"SoftOnHard", layered(made(0, 0, 0, 0), 1e-300, 1e300), 0, 0},
                    Example{"SoftOnes", layered(made(0, 0, 0, 0), 3e-308, 5e-309), 0, 0, 0x1p100}),
    [](const testing::TestParamInfo<Example>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pcm::fast
