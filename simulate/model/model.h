// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "pcm/contact.h"
#include "pcm/inputs.h"
#include "simulate/integrators/integrator.h"
#include "simulate/model/state_columns.h"
#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// A pairing at one state.
struct PairingObservation {
  bool touching = false;
  bool nested = false;
  Index too_deep = 0;
  Index elements = 0;
  double max_penetration = 0;                         ///< m
  double patch_area = 0;                              ///< m^2
  Eigen::Vector3d force_G = Eigen::Vector3d::Zero();  ///< on E's body, N
  /// Mean place of its elements by |F_n|, where that is 0 by A_k, m; zero where there are none.
  Eigen::Vector3d centre_of_force_G = Eigen::Vector3d::Zero();
  double normal_force = 0;      ///< sum of F_n over elements, halved in mode both, N
  double tangential_force = 0;  ///< sum of F_t likewise, N
  Pose pose;                    ///< what the engine was asked, with `velocity`
  Velocity velocity;
};

/// Energies in J, powers in W.
struct Energies {
  double kinetic = 0;  ///< without bodies that move as prescribed
  double gravity = 0;
  double elastic = 0;  ///< of the contacts' foundations
  double bumpers = 0;  ///< of the springs at the joints' limits
  double total() const { return kinetic + gravity + elastic + bumpers; }
};

/// At what rate energy goes or comes.
struct Powers {
  double damping = 0;   ///< taken by the foundations' damping
  double friction = 0;  ///< taken by friction
  double joints = 0;    ///< taken by the joints' and bumpers' damping
  double motions = 0;   ///< brought by prescribed motions to all other bodies
};

/// A contact element.
struct ObservedElement {
  Index pairing = 0;
  Side master = Side::E;
  Index face = 0;  ///< of the master
  Index slave_face = 0;
  double pressure = 0;  ///< F_n / A, Pa
};

/// Everything worth knowing of one state.
struct Observation {
  std::vector<Pose> surfaces_G;  ///< in their order: x_G = A x_S + r
  std::vector<PairingObservation> pairings;
  std::vector<ObservedElement> elements;  ///< by pairing, then as the engine has them
  Energies energies;
  Powers powers;
};

/// What tangents of the contacts cost.
struct TangentCost {
  bool exists = true;            ///< false where bodies are nested or too deep
  std::int64_t evaluations = 0;  ///< of all pairings
};

/// How derivatives were answered.
struct ModelCounters {
  std::int64_t nested = 0;                ///< not_here: one body within another
  std::int64_t penetration_exceeded = 0;  ///< not_here: deeper than max_penetration of the law
  /// No surface was elsewhere than at the remembered state: at most the law was asked for.
  std::int64_t law_only = 0;
};

/// A scene as equations of motion: y = (q, u), Simbody's generalized coordinates and speeds, the orientations of free
/// and ball joints as quaternions. Not for several threads at once.
class Model {
 public:
  /// Throws BadInput where Simbody cannot make it up.
  explicit Model(const Scene& scene);
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  Eigen::Index size() const;                 ///< of y
  Eigen::Index degrees_of_freedom() const;   ///< without prescribed ones
  Eigen::VectorXd start() const;             ///< at t = 0
  std::vector<StateColumn> columns() const;  ///< what the components of y are
  /// The same state with quaternions of length 1, and joints as fast as they are prescribed to be. Throws BadInput
  /// where a quaternion has less than half that length, or twice as much.
  Eigen::VectorXd normalised(const Eigen::VectorXd& y) const;

  /// dy/dt. `not_here` where bodies are nested or deeper within one another than the law allows.
  Evaluation derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt);
  /// Difference quotients from y on ask the engine only about pairings whose bodies they move, and only for the law
  /// where they change velocities alone. Changes no bit.
  void remember(double t, const Eigen::VectorXd& y);
  /// From here on as if nothing had been remembered.
  void forget();

  /// Tangents of the contacts at y, for `linear_derivative`.
  TangentCost linearise(double t, const Eigen::VectorXd& y);
  /// dy/dt with the contacts' loads by the last tangents, which must exist, and all else as it is: about where they
  /// were taken the derivative to first order. Asks no engine.
  void linear_derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt);

  Observation observe(double t, const Eigen::VectorXd& y);

  const ModelCounters& counters() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace pcm::simulate
