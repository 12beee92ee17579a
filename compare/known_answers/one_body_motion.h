// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "compare/known_answers/initial_value_problem.h"
#include "pcm/engine.h"

/// One body in contact with a body at rest, the engine giving the force: the dynamic known answers stand on it.
namespace pcm::compare {

/// The body that carries F. It moves by translation; rotation is held, and so are the axes without freedom.
struct MovingBody {
  double mass = 1;                                        ///< kg
  Eigen::Vector3d gravity_Me = Eigen::Vector3d::Zero();   ///< m/s^2
  Eigen::Vector3d freedom_Me = Eigen::Vector3d::UnitZ();  ///< 1 along the axes of Me it moves along, 0 along others
};

/// Where F is, x from its home, and how fast it moves; resolved in Me.
struct MotionState {
  double t = 0;                                    ///< s
  Eigen::Vector3d x_Me = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d v_Me = Eigen::Vector3d::Zero();  ///< m/s
};

/// Sizes of displacement and velocity that an error is measured against, axis by axis; all positive.
struct MotionScale {
  Eigen::Vector3d length_Me = Eigen::Vector3d::Ones();    ///< m
  Eigen::Vector3d velocity_Me = Eigen::Vector3d::Ones();  ///< m/s
};

/// A fall on E, the contact and the rise to the height of the start.
struct Bounce {
  MotionState touch;         ///< the lowest vertex of F reaches the highest of E
  MotionState deepest;       ///< the vertical velocity is zero
  MotionState force_ends;    ///< separation, or before that the force vanishes and would pull (PCM (18))
  MotionState end;           ///< at the height of the start
  double deepest_force = 0;  ///< vertical contact force on F at `deepest`, N
};

/// E at rest with its top flat and horizontal (outward normal +z), F above it at `home`.
///
/// A bounce is integrated phase by phase - fall, approach, release, drift without force, rise - each ending in an event
/// that the integrator locates: the force law is smooth within a phase only. At its end a phase is continued by the law
/// that holds in it (nothing of that enters a result but through the integrator's last step): beyond the turning point
/// and beyond the point where the force would pull by the law without that switch, DampingMode::full; beyond separation
/// by reflection, F(-u) = 2 F(0+) - F(u), which goes on with value and slope and exactly so if F is linear in u.
class OneBodyMotion {
 public:
  /// `relative` is the integrator's tolerance; with `scale` it gives the absolute one.
  OneBodyMotion(const fast::Pairing& pairing, const Pose& home, const MovingBody& body, const MotionScale& scale,
                double relative);

  /// From above E, falling. Throws std::runtime_error where the body does not come back.
  Bounce bounce(const MotionState& start);

  /// Moves the state to `t_end`, or to where the speed along x falls through `stop_speed_x` if that is before.
  MotionState slide(MotionState state, double t_end, double stop_speed_x = 0);

  /// Moves the state on for `decay_times` / rate, errors meanwhile decaying as exp(-rate t): `effective_steps` are the
  /// steps, each weighted with what is left of its error at the end at most.
  MotionState settle(MotionState state, double rate, int decay_times, double& effective_steps);

  /// Contact force on F by the law of the pairing, N.
  Eigen::Vector3d contact_force(const Eigen::Vector3d& x_Me, const Eigen::Vector3d& v_Me);

  const IntegrationWork& work() const { return work_; }

 private:
  using Force = std::function<Eigen::Vector3d(const Eigen::Vector3d& x_Me, const Eigen::Vector3d& v_Me)>;
  using Event = std::function<double(const Eigen::Vector3d& x_Me, const Eigen::Vector3d& v_Me)>;

  Eigen::Vector3d force_by(const fast::Pairing& pairing, const Eigen::Vector3d& x_Me, const Eigen::Vector3d& v_Me);
  Eigen::Vector3d reflected(const Force& force, const Eigen::Vector3d& x_Me, const Eigen::Vector3d& v_Me) const;
  double depth(const Eigen::Vector3d& x_Me) const { return depth_at_home_ - x_Me.z(); }
  std::optional<std::size_t> advance(const Force& force, const std::vector<Event>& events, double t_end,
                                     MotionState& state);
  void advance_to(const Force& force, const std::vector<Event>& events, MotionState& state);

  fast::Pairing pairing_;
  fast::Pairing without_switches_;
  fast::Workspace workspace_;
  Pose home_;
  MovingBody body_;
  MotionScale scale_;
  StepTolerance tolerance_;
  double depth_at_home_ = 0;
  double least_depth_ = 0;  ///< where reflection begins: a depth of positive size for the engine, but negligible
  IntegrationWork work_;
};

}  // namespace pcm::compare
