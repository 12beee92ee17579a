// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulate/integrators/integrator.h"
#include "simulate/model/model.h"
#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// Energy that went since the start, J.
struct EnergyFlow {
  double damping = 0;
  double friction = 0;
  double joints = 0;
  double motions = 0;  ///< brought by prescribed motions

  double lost() const { return damping + friction + joints - motions; }
};

/// Eigenvalues of df/dy, 1/s: how stiff the equations are, and how they oscillate.
struct Spectrum {
  double least_real = 0;          ///< the most negative real part
  double greatest_imaginary = 0;  ///< the greatest absolute imaginary part
  double radius = 0;              ///< the greatest absolute value
};

/// One accepted step and the state at its end.
struct SimulatedStep {
  Step step;
  Index elements = 0;  ///< over all pairings
  Index entered = 0;   ///< elements that the step's beginning had not
  Index left = 0;      ///< elements that its end has no more
  Index too_deep = 0;  ///< faces without a force, over all pairings
  Observation observation;
  EnergyFlow flow;
  /// At every spectrum_interval-th step since the last checkpoint. It takes a derivative for each component of the
  /// state, which Work does not count.
  std::optional<Spectrum> spectrum;
};

/// Number `n` of the instants at multiples of an interval, s. A multiple within a billionth of an interval of the end
/// is the end itself: 3 times 0.1 rounds to more than 0.3, and 3 times 0.3 to less than 0.9.
double multiple_or_end(std::int64_t n, double interval, double end);
/// How many of these instants, numbered from 1 on, are at `t` or before it.
std::int64_t multiples_until(double t, double interval, double end);

/// A scene in motion. Between checkpoints one integrator is alive; at each it starts anew, interrupted or not, so that
/// what follows depends on the checkpoint alone, bit for bit.
class Simulation {
 public:
  /// All that the continuation depends on.
  struct Checkpoint {
    double t = 0;
    Eigen::VectorXd y;
    EnergyFlow flow;
    double energy_at_start = 0;  ///< J
  };

  /// For a scene in which some body can move. Throws BadInput where the initial state is that of another scene, or not
  /// before the end.
  explicit Simulation(const Scene& scene);
  Simulation(const Simulation&) = delete;  // the integrator's equation holds `this`
  Simulation& operator=(const Simulation&) = delete;

  /// As it starts, at t = 0 or from the scene's initial state, or goes on. Throws BadInput where bodies of a pairing
  /// are nested at the start, or deeper within one another than the law allows.
  void start();
  void start(const Checkpoint& checkpoint);

  /// One accepted step, ending at the next checkpoint at the latest. Throws IntegrationFailure, where energies exceed
  /// what a double can hold too, and stays where it was.
  SimulatedStep step();
  double t() const { return t_; }
  bool finished() const { return t() >= scene_.duration; }
  /// Where a checkpoint was reached, which `step` then begins from.
  bool at_checkpoint() const;
  Checkpoint checkpoint() const;

  /// Within the last step.
  Eigen::VectorXd state_at(double t) const;

  Model& model() { return model_; }
  const Scene& scene() const { return scene_; }
  const Work& work() const;
  /// Of the evaluations that `work` counts: those that asked the engine for the law at most, as only velocities
  /// differed from a state whose contacts were known (ModelCounters::law_only).
  std::int64_t law_only() const { return law_only_; }
  /// Processor time of the integrator's steps so far, what is looked at beside them left out, s.
  double integration_seconds() const { return integration_seconds_; }

 private:
  double next_checkpoint() const;
  Linearisation linearise(double t, const Eigen::VectorXd& y);
  std::optional<Spectrum> spectrum(double t, const Eigen::VectorXd& y);
  void begin_segment(double t, const Eigen::VectorXd& y);

  Scene scene_;
  Model model_;
  std::unique_ptr<Integrator> integrator_;
  EnergyFlow flow_;
  double energy_at_start_ = 0;
  double t_ = 0;                           ///< up to here it has come
  Eigen::VectorXd y_;                      ///< at t()
  Powers powers_;                          ///< at t()
  std::vector<ObservedElement> elements_;  ///< at t()
  std::int64_t segment_ = 0;               ///< checkpoints passed
  std::int64_t steps_since_checkpoint_ = 0;
  std::int64_t law_only_ = 0;
  double integration_seconds_ = 0;
};

}  // namespace pcm::simulate
