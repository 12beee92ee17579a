// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/run/simulation.h"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <ctime>
#include <iterator>
#include <string>
#include <tuple>

#include "pcm/bad_input.h"
#include "simulate/integrators/difference_quotients.h"
#include "simulate/integrators/integrator.h"
#include "simulate/integrators/make_integrator.h"

namespace pcm::simulate {
namespace {

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

StepControl control_for(const Scene& scene, Eigen::Index size) {
  StepControl control;
  control.relative = scene.integrator.relative_tolerance;
  control.absolute = Eigen::VectorXd::Constant(size, scene.integrator.absolute_tolerance);
  control.greatest_step = scene.integrator.greatest_step;
  return control;
}

auto key(const ObservedElement& e) {
  return std::tuple(e.pairing, e.master, e.face, e.slave_face);
}

bool before(const ObservedElement& a, const ObservedElement& b) {
  return key(a) < key(b);
}

/// How many of `elements` are not among `others`; both ascending.
Index missing_from(const std::vector<ObservedElement>& others, const std::vector<ObservedElement>& elements) {
  std::vector<ObservedElement> missing;
  std::set_difference(elements.begin(), elements.end(), others.begin(), others.end(), std::back_inserter(missing),
                      before);
  return static_cast<Index>(missing.size());
}

/// Simpson's rule: exact for powers that are cubic over the step.
void add_step(EnergyFlow& flow, double h, const Powers& begin, const Powers& middle, const Powers& end) {
  const auto integral = [&](double Powers::*power) { return h / 6 * (begin.*power + 4 * middle.*power + end.*power); };
  flow.damping += integral(&Powers::damping);
  flow.friction += integral(&Powers::friction);
  flow.joints += integral(&Powers::joints);
  flow.motions += integral(&Powers::motions);
}

/// Throws BadInput where the states of this scene are not of these components.
void check_columns(const InitialState& from, const std::vector<StateColumn>& own) {
  const std::string other = ": it is of a scene whose bodies, their order or their joints are others";
  const auto size = static_cast<std::size_t>(from.y.size());
  assert(from.columns.size() == size);
  if (size != own.size())
    throw BadInput("the state to start from has " + std::to_string(size) + " numbers, this scene " +
                   std::to_string(own.size()) + other);
  for (std::size_t i = 0; i < size; ++i)
    if (from.columns[i] != own[i].name)
      throw BadInput("the state to start from has '" + from.columns[i] + "' where this scene has '" + own[i].name +
                     "'" + other);
}

void check(const InitialState& from, const Scene& scene) {
  if (!from.y.allFinite()) throw BadInput("the state to start from is not finite");
  if (!(from.t >= 0 && from.t < scene.duration))
    throw BadInput("the state to start from is not before the end of the scene, its duration");
}

}  // namespace

double multiple_or_end(std::int64_t n, double interval, double end) {
  const double t = static_cast<double>(n) * interval;
  return std::abs(t - end) <= 1e-9 * interval ? end : t;
}

std::int64_t multiples_until(double t, double interval, double end) {
  // The quotient is rounded too, by less than 1.
  auto n = std::max(std::int64_t{1}, static_cast<std::int64_t>(t / interval)) - 1;
  while (multiple_or_end(n + 1, interval, end) <= t) ++n;
  return n;
}

Simulation::Simulation(const Scene& scene) : scene_(scene), model_(scene) {
  if (scene_.initial_state) {
    check_columns(*scene_.initial_state, model_.columns());
    check(*scene_.initial_state, scene_);
    static_cast<void>(model_.normalised(scene_.initial_state->y));  // throws where a body has no orientation
  }
  DifferentialEquation equation;
  equation.size = model_.size();
  equation.derivative = [this](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
    const std::int64_t before = model_.counters().law_only;
    const Evaluation evaluation = model_.derivative(t, y, dydt);
    law_only_ += model_.counters().law_only - before;
    return evaluation;
  };
  equation.linearise = [this](double t, const Eigen::VectorXd& y) { return linearise(t, y); };
  integrator_ = make_integrator(scene_.integrator.method, equation, control_for(scene_, model_.size()));
}

Linearisation Simulation::linearise(double t, const Eigen::VectorXd& y) {
  Linearisation linear;
  if (scene_.integrator.jacobian == JacobianOf::tangents) {
    const TangentCost cost = model_.linearise(t, y);
    linear.cost = cost.evaluations;
    if (cost.exists) {
      linear.derivative = [this](double at, const Eigen::VectorXd& changed, Eigen::VectorXd& dydt) {
        model_.linear_derivative(at, changed, dydt);
      };
      return linear;
    }
  }
  model_.remember(t, y);
  return linear;
}

void Simulation::start() {
  const double t = scene_.begin();
  const Eigen::VectorXd y = scene_.initial_state ? scene_.initial_state->y : model_.start();
  Eigen::VectorXd dydt(model_.size());
  if (model_.derivative(t, y, dydt) == Evaluation::not_here) {
    const Observation now = model_.observe(t, y);
    for (std::size_t p = 0; p < now.pairings.size(); ++p) {
      const ScenePairing& pairing = scene_.pairings[p];
      if (!now.pairings[p].nested && !(now.pairings[p].max_penetration > pairing.law.max_penetration)) continue;
      const auto name = [this](Index s) { return scene_.surfaces[static_cast<std::size_t>(s)].name; };
      throw BadInput("at the start, '" + name(pairing.E) + "' and '" + name(pairing.F) + "' are " +
                     (now.pairings[p].nested ? "nested: one lies within the other"
                                             : "deeper within one another than max_penetration") +
                     "; place them apart, or leave out their pairing");
    }
  }
  Checkpoint checkpoint;
  checkpoint.t = t;
  checkpoint.y = y;
  checkpoint.energy_at_start = model_.observe(t, y).energies.total();
  if (!std::isfinite(checkpoint.energy_at_start))
    throw BadInput(
        "the energy at the start exceeds what a double can hold; masses, speeds, heights or gravity are too great");
  start(checkpoint);
}

void Simulation::start(const Checkpoint& checkpoint) {
  flow_ = checkpoint.flow;
  energy_at_start_ = checkpoint.energy_at_start;
  segment_ = multiples_until(checkpoint.t, scene_.output.checkpoint_interval, scene_.duration);
  begin_segment(checkpoint.t, checkpoint.y);
}

void Simulation::begin_segment(double t, const Eigen::VectorXd& y) {
  steps_since_checkpoint_ = 0;
  const Eigen::VectorXd unit = model_.normalised(y);
  model_.forget();
  integrator_->start(t, unit);
  t_ = t;
  y_ = unit;
  Observation now = model_.observe(t, unit);
  powers_ = now.powers;
  elements_ = std::move(now.elements);
  std::sort(elements_.begin(), elements_.end(), before);
}

double Simulation::next_checkpoint() const {
  return std::min(scene_.duration, multiple_or_end(segment_ + 1, scene_.output.checkpoint_interval, scene_.duration));
}

bool Simulation::at_checkpoint() const {
  return t() >= next_checkpoint();
}

Simulation::Checkpoint Simulation::checkpoint() const {
  return {t_, y_, flow_, energy_at_start_};
}

Eigen::VectorXd Simulation::state_at(double t) const {
  return integrator_->state_at(t);
}

const Work& Simulation::work() const {
  return integrator_->work();
}

std::optional<Spectrum> Simulation::spectrum(double t, const Eigen::VectorXd& y) {
  Eigen::VectorXd dydt(y.size());
  Eigen::MatrixXd J(y.size(), y.size());
  const auto derivative = [this](double at, const Eigen::VectorXd& changed, Eigen::VectorXd& slope) {
    return model_.derivative(at, changed, slope);
  };
  if (derivative(t, y, dydt) == Evaluation::not_here) return std::nullopt;
  model_.remember(t, y);
  // A tenth is the change, in m, rad, m/s and rad/s: far below any slip velocity, far above rounding.
  const Eigen::VectorXd absolute = Eigen::VectorXd::Constant(y.size(), 1e-7);
  if (difference_quotients(derivative, absolute, t, y, dydt, J) == Evaluation::not_here) return std::nullopt;
  const Eigen::VectorXcd eigenvalues = J.eigenvalues();
  return Spectrum{eigenvalues.real().minCoeff(), eigenvalues.imag().cwiseAbs().maxCoeff(),
                  eigenvalues.cwiseAbs().maxCoeff()};
}

SimulatedStep Simulation::step() {
  if (at_checkpoint()) {
    ++segment_;
    begin_segment(t_, y_);
  }
  SimulatedStep result;
  const double begin = t(), seconds = processor_seconds();
  result.step = integrator_->step(next_checkpoint());
  integration_seconds_ += processor_seconds() - seconds;

  const double end = integrator_->t(), middle = begin + (end - begin) / 2;
  const Powers in_the_middle = model_.observe(middle, state_at(middle)).powers;
  result.observation = model_.observe(end, integrator_->y());
  result.flow = flow_;
  add_step(result.flow, end - begin, powers_, in_the_middle, result.observation.powers);
  if (!std::isfinite(result.observation.energies.total()) || !std::isfinite(result.flow.lost()))
    throw IntegrationFailure(
        begin,
        fmt::format("the energy exceeds what a double can hold after t = {:g} s: forces, masses or speeds are too "
                    "great",
                    begin));
  t_ = end;
  y_ = integrator_->y();
  powers_ = result.observation.powers;
  flow_ = result.flow;

  std::vector<ObservedElement> now = result.observation.elements;
  std::sort(now.begin(), now.end(), before);
  result.elements = static_cast<Index>(now.size());
  result.entered = missing_from(elements_, now);
  result.left = missing_from(now, elements_);
  elements_ = std::move(now);
  ++steps_since_checkpoint_;
  const std::int64_t interval = scene_.output.spectrum_interval;
  if (interval > 0 && steps_since_checkpoint_ % interval == 0) result.spectrum = spectrum(end, y_);
  for (const PairingObservation& pairing : result.observation.pairings) result.too_deep += pairing.too_deep;
  return result;
}

}  // namespace pcm::simulate
