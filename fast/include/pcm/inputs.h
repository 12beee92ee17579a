// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>

/// The question both engine and oracle answer: plain structs, no algorithm. SI units throughout.
namespace pcm {

/// The two surfaces of a pairing, and the bodies that carry them.
enum class Side : std::uint8_t { E, F };

inline Side opposite(Side side) {
  return side == Side::E ? Side::F : Side::E;
}

/// Position and orientation of marker Mf seen from marker Me: x_E = A x_F + r.
/// A is a rotation to 1e-9: max |A^T A - I| <= 1e-9 and det A > 0; it is used as given, never orthogonalised. r is no
/// farther than 2^300 m along any axis.
struct Pose {
  /// A_MeMf. By columns, whatever a caller's EIGEN_DEFAULT_TO_ROW_MAJOR makes of Matrix3d.
  Eigen::Matrix<double, 3, 3, Eigen::ColMajor> A = Eigen::Matrix3d::Identity();
  Eigen::Vector3d r = Eigen::Vector3d::Zero();  ///< r_MeMf in Me, m
};

/// Motion of Mf relative to Me, resolved in Me. No component is greater than 2^700.
struct Velocity {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< dr/dt seen in Me, m/s
  Eigen::Vector3d w = Eigen::Vector3d::Zero();  ///< angular velocity of F relative to E, rad/s
};

/// Whose faces carry the contact elements; `both`: each in turn, force and torque averaged.
enum class Mode : std::uint8_t { E, F, both };

/// How the elastic foundation of a master face is sampled (PCM section 6).
enum class Scheme : std::uint8_t {
  barycentric,  ///< the paper's: the penetration at the face's barycentre counts for the whole face
  clipped,      ///< the integral of the penetration over the face, exact on the given meshes
};

/// What damping may do to the normal force F_n of an element (PCM (18) and section 9).
enum class DampingMode : std::uint8_t {
  no_tension,   ///< F_n = max(F_c + F_d, 0), the paper's (18)
  full,         ///< F_n = F_c + F_d, tension allowed; friction acts on max(F_n, 0)
  compression,  ///< F_d counts only while approaching (v_n > 0)
};

/// Stiffness c = K / b of each body's elastic layer (3), N/m^3 (`fast::layer_stiffness`): 2^-1022 at least, infinite
/// for a rigid body, but not for both, as they are unless one is given.
struct LayerStiffness {
  double c_E = std::numeric_limits<double>::infinity();
  double c_F = std::numeric_limits<double>::infinity();
};

/// Parameters of the force law, PCM (1)-(4), (12)-(24). All finite and not negative unless said.
struct ContactLaw {
  double stiffness = 1e6;  ///< c_l, N/m^3 > 0; both layers count as equal. Ignored where `layers` is given.
  std::optional<LayerStiffness> layers;  ///< in series: c_l = c_E c_F / (c_E + c_F) (12)
  double damping = 0;                    ///< d_l, N s/m^3
  double transition_depth = 0;           ///< u_d, m: damping fades in up to this penetration (15); 0 turns the fade off
  double friction = 0;                   ///< mu
  double slip_velocity = 0;              ///< v_eps, m/s: friction is regularised below it (20); at 0 it jumps there
  /// u_max, m > 0: deeper is clamped, point by point, and flagged. The barycentric scheme takes min(u, u_max) at a
  /// face's barycentre, the clipped scheme integrates it.
  double max_penetration = std::numeric_limits<double>::infinity();
  DampingMode damping_mode = DampingMode::no_tension;
};

/// What the caller wants; nothing else is computed.
struct Wanted {
  bool polygons = true;     ///< intersection polygons with the positions of their points, and patches
  bool areas = true;        ///< clipped active areas and the intersection volume
  bool force = true;        ///< contact elements, force and torque
  bool elements = true;     ///< keep all contact elements in the result, with their statistics; implies force
  bool bound = false;       ///< rigorous bounds on the rounding errors of force and torque; implies force
  bool statistics = false;  ///< the summary over the elements; implies force, implied by elements
  bool tangent = false;     ///< derivatives of force and torque by pose and velocity; implies force
};

inline bool wants_force(const Wanted& wanted) {
  return wanted.force || wanted.elements || wanted.bound || wanted.statistics || wanted.tangent;
}
inline bool wants_only_touch(const Wanted& wanted) {
  return !wanted.polygons && !wanted.areas && !wants_force(wanted);
}

}  // namespace pcm
