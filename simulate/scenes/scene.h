// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pcm/engine.h"
#include "pcm/inputs.h"
#include "simulate/integrators/integrator.h"

/// A scene as a file describes it (scene.schema.json), nothing built of it yet. SI units, angles in radians. Frames: G
/// ground, B a body's, S a surface's.
namespace pcm::simulate {

/// Of a frame in another one: x_outer = R x_inner + p.
struct Placement {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< m
};

struct MassProperties {
  double mass = 0;                                      ///< kg
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();   ///< of mass, m
  Eigen::Matrix3d inertia_B = Eigen::Matrix3d::Zero();  ///< about the centre of mass, kg m^2
};

enum class JointType : std::uint8_t { weld, pin, slider, universal, gimbal, ball, free };

/// Coordinates of a joint, as `coordinates` and `limits` number them; 0 for ball and free, whose orientations are
/// quaternions.
inline int coordinate_count(JointType type) {
  switch (type) {
    case JointType::pin:
    case JointType::slider:
      return 1;
    case JointType::universal:
      return 2;
    case JointType::gimbal:
      return 3;
    default:
      return 0;
  }
}

/// A spring beyond either end of a coordinate's range.
struct Limit {
  int coordinate = 0;
  double from = 0, to = 0;  ///< rad or m
  double stiffness = 0;     ///< N m/rad or N/m
  double dissipation = 0;   ///< s/rad or s/m
};

/// Frame K on the body moves against frame J on the parent.
struct Joint {
  JointType type = JointType::free;
  Index parent = -1;  ///< body, -1: ground
  Placement in_parent, in_body;
  std::vector<double> coordinates, speeds;  ///< at the start; empty: 0
  double damping = 0;                       ///< N m s/rad or N s/m
  std::vector<Limit> limits;
  std::optional<double> prescribed_speed;  ///< m/s or rad/s
};

struct Body {
  std::string name;
  MassProperties mass;
  Joint joint;
  // At the start, of free joints.
  Placement at_G;
  Eigen::Vector3d velocity_G = Eigen::Vector3d::Zero();          ///< of B's origin, m/s
  Eigen::Vector3d angular_velocity_G = Eigen::Vector3d::Zero();  ///< rad/s
};

struct SceneSurface {
  std::string name;
  Index body = -1;  ///< -1: ground
  Placement at_B;
  fast::Surface surface;  ///< its vertices in S, m
  std::array<std::uint8_t, 3> colour{170, 170, 170};
};

struct ScenePairing {
  Index E = 0, F = 0;  ///< surfaces
  ContactLaw law;
  Mode mode = Mode::E;
  Scheme scheme = Scheme::barycentric;
};

/// What the Jacobians of implicit methods are made of.
enum class JacobianOf : std::uint8_t {
  differences,  ///< of the equations of motion: the engine is asked in every column
  tangents,     ///< of the pairings, and differences of the equations of motion with them: the engine is asked once
};

/// No run may have to take more steps, nor to record itself more often.
inline constexpr double kMostSteps = 1e9, kMostRecords = 1e6;

struct IntegratorSettings {
  Method method = Method::bdf;
  double relative_tolerance = 1e-4;
  double absolute_tolerance = 1e-4;  ///< m, rad, m/s, rad/s
  double greatest_step = 5e-3;       ///< s
  JacobianOf jacobian = JacobianOf::differences;
};

struct OutputSettings {
  double interval = 0.01;              ///< s
  double checkpoint_interval = 0.25;   ///< s
  std::int64_t spectrum_interval = 0;  ///< steps from one spectrum to the next, 0: none
  std::optional<Index> follow;         ///< surface that pictures move along with
  std::vector<double> stills;          ///< instants of still pictures, s; within the duration, none twice
};

/// Coordinates and speeds to start from in place of the bodies' own, as an earlier run has recorded them.
struct InitialState {
  double t = 0;  ///< s
  Eigen::VectorXd y;
  std::vector<std::string> columns;  ///< names of y's components (StateColumn), by which another scene's are refused
};

struct Scene {
  std::string title;
  Eigen::Vector3d gravity_G{0, 0, -9.81};  ///< m/s^2
  std::vector<Body> bodies;                ///< parents before those that depend on them
  std::vector<SceneSurface> surfaces;
  std::vector<ScenePairing> pairings;
  double duration = 0;  ///< s, from t = 0 also where an initial state is later
  IntegratorSettings integrator;
  OutputSettings output;
  std::optional<InitialState> initial_state;  ///< not in scene files

  double begin() const { return initial_state ? initial_state->t : 0; }  ///< s
};

/// Whether two times, s, are the same product of a whole number and an interval: each is rounded by half an ulp, and so
/// may be the interval as it was read.
inline bool same_instant(double a, double b) {
  return std::abs(a - b) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(b);
}

}  // namespace pcm::simulate
