// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/run/integrator_comparison.h"

#include <fmt/core.h>

#include <array>
#include <optional>

#include "pcm/bad_input.h"

namespace pcm::simulate {
namespace {

constexpr std::array kTolerances = {1e-3, 1e-4, 1e-5, 1e-6};
constexpr std::array kSlipVelocityFactors = {100.0, 10.0, 1.0, 0.1};
/// Of relative ones: not all integrators take others.
constexpr double kTolerancesBelow = 1;

/// Those made of differences where nothing else is said.
void set_integrator(Scene& scene, Method method, double tolerance, JacobianOf jacobian = JacobianOf::differences) {
  scene.integrator.method = method;
  scene.integrator.jacobian = jacobian;
  scene.integrator.relative_tolerance = scene.integrator.absolute_tolerance = tolerance;
}

/// Of all laws with friction, which have to agree.
double slip_velocity_of(const Scene& scene) {
  std::optional<double> found;
  for (const ScenePairing& pairing : scene.pairings) {
    if (!(pairing.law.friction > 0)) continue;
    const double slip_velocity = pairing.law.slip_velocity;
    if (!(slip_velocity > 0))
      throw BadInput(
          "integrators are compared over the slip velocity, and a law with friction has none; give --slip-velocity");
    if (slip_velocity != found.value_or(slip_velocity))
      throw BadInput(fmt::format(
          "integrators are compared over the slip velocity, and laws of this scene have {:g} and {:g} m/s; give all "
          "laws one by --slip-velocity",
          *found, slip_velocity));
    found = slip_velocity;
  }
  if (!found) throw BadInput("integrators are compared over the slip velocity, and no law of this scene has friction");
  return *found;
}

/// The state at the end.
Eigen::VectorXd end_of(Simulation& simulation) {
  simulation.start();
  while (!simulation.finished()) simulation.step();
  return simulation.checkpoint().y;
}

Eigen::VectorXd reference(Scene scene, Method method) {
  set_integrator(scene, method, kReferenceTolerance);
  Simulation simulation(scene);
  return end_of(simulation);
}

double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

struct Choice {
  std::string integrator;
  Method method;
  JacobianOf jacobian;

  std::string name() const { return IntegratorTrial{integrator, jacobian}.name(); }
};

std::vector<Choice> choices_of(const std::vector<std::pair<std::string, Method>>& integrators) {
  std::vector<Choice> choices;
  for (const auto& [integrator, method] : integrators) {
    choices.push_back({integrator, method, JacobianOf::differences});
    if (takes_jacobians(method)) choices.push_back({integrator, method, JacobianOf::tangents});
  }
  return choices;
}

/// Its error where there is a reference.
IntegratorTrial tried(Scene scene, const Choice& choice, double tolerance,
                      const std::optional<Eigen::VectorXd>& reference) {
  set_integrator(scene, choice.method, tolerance, choice.jacobian);
  IntegratorTrial trial{choice.integrator, choice.jacobian, tolerance, slip_velocity_of(scene)};
  Simulation simulation(scene);
  try {
    const Eigen::VectorXd y = end_of(simulation);
    if (reference) trial.error = difference(y, *reference);
  } catch (const IntegrationFailure&) {
    trial.gave_up = true;
  }
  trial.work = simulation.work();
  return trial;
}

}  // namespace

void set_slip_velocity(Scene& scene, double slip_velocity) {
  for (ScenePairing& pairing : scene.pairings)
    if (pairing.law.friction > 0) pairing.law.slip_velocity = slip_velocity;
}

IntegratorComparison compare_integrators(const Scene& scene,
                                         const std::vector<std::pair<std::string, Method>>& integrators,
                                         const std::function<void(const std::string&)>& begin) {
  IntegratorComparison result;
  result.slip_velocity = slip_velocity_of(scene);
  result.reference_tolerance = kReferenceTolerance;
  begin("reference");
  const Eigen::VectorXd at_end = reference(scene, Method::bdf);
  result.reference_error = difference(at_end, reference(scene, Method::esdirk));
  for (const Choice& choice : choices_of(integrators)) {
    begin(choice.name() + " over the tolerance");
    for (const double tolerance : kTolerances) result.by_tolerance.push_back(tried(scene, choice, tolerance, at_end));
    begin(choice.name() + " over the slip velocity");
    for (const double factor : kSlipVelocityFactors) {
      const double tolerance = 0.1 * factor * result.slip_velocity;
      if (!(tolerance < kTolerancesBelow)) continue;
      Scene changed = scene;
      set_slip_velocity(changed, factor * result.slip_velocity);
      result.by_slip_velocity.push_back(tried(changed, choice, tolerance, {}));
    }
  }
  return result;
}

}  // namespace pcm::simulate
