// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::reference {

/// Which problem the doubles pose (PCM section 1).
enum class Problem : std::uint8_t {
  rounded,  ///< F's vertices rounded into Me, as the engine has them
  exact,    ///< all numbers taken as the reals they are
};

/// An edge of one surface passes through a face of the other.
struct Crossing {
  Side edge_side = Side::E;
  std::array<Index, 2> edge{};  ///< smaller vertex index first
  Index face = 0;
  Eigen::Vector3d position_Me = Eigen::Vector3d::Zero();  ///< correctly rounded, m

  bool operator==(const Crossing&) const = default;
};

/// An intersection polygon in the circulation of (5); a closed one starts at its smallest crossing.
struct Polygon {
  bool closed = true;
  std::vector<Crossing> points;
  Index patch = 0;

  bool operator==(const Polygon&) const = default;
};

/// Bounds between which the area lies where faces are coplanar: coplanar overlaps left out and counted in; against an
/// open surface, which bounds no body, faces with an overlap left out and counted in whole. They coincide where no
/// faces of the two surfaces are coplanar and overlap.
struct AreaInterval {
  double open = 0;
  double closed = 0;

  bool operator==(const AreaInterval&) const = default;
};

/// The active area on one surface. In `area` and `vector_area_Me`, opposite coplanar faces count on neither surface,
/// equal ones on E only, a convention that knows no axes; against an open surface the tie rule decides.
struct ActiveArea {
  std::vector<Index> intersected;  ///< ascending
  std::vector<Index> inner;        ///< ascending, nested ones included
  /// Uncrossed faces about which the other surface winds a negative number of times, being folded over: not active, but
  /// they count in areas; ascending.
  std::vector<Index> pockets;
  /// Vertices of intersected faces about which the other surface, where it is closed, winds; ascending.
  std::vector<Index> wound;
  int most_wound = 0;  ///< how often at most it winds about a corner of any of these faces, either way round
  double area = 0;     ///< m^2, correctly rounded
  AreaInterval area_interval;
  Eigen::Vector3d vector_area_Me = Eigen::Vector3d::Zero();
  /// Area and vector area of the surfaces moved by the tie rule (PCM section 4) as its eps -> 0: coplanar overlaps
  /// count where they are moved into the other body. The rounded problem's are the engine's but for rounding. The
  /// volume is the same either way, for it is continuous in the vertices.
  double limit_area = 0;  ///< m^2, correctly rounded
  Eigen::Vector3d limit_vector_area_Me = Eigen::Vector3d::Zero();

  bool operator==(const ActiveArea&) const = default;
};

/// A contact element of either scheme (fast/include/pcm/contact.h says what they are).
struct Element {
  Side master = Side::E;
  Index master_face = 0;
  Index slave_face = 0;
  double area = 0;                  ///< A_k (6), m^2
  double penetration = 0;           ///< u_k (11), m, clamped; clipped: the mean of u clamped point by point
  double greatest_penetration = 0;  ///< greatest u over the element (barycentric: u of the barycentre), before clamping
  double perimeter = 0;             ///< m, of the part of the master face that is the element; barycentric: 0
  double cosine = 0;                ///< n_master . n_slave, < 0: 1/|cosine| is the condition of u_k
  double normal_velocity = 0;       ///< v_n (16), m/s, positive when approaching
  double tangential_velocity = 0;   ///< v_t (19), m/s
  double normal_force = 0;          ///< F_n (18), N
  double tangential_force = 0;      ///< F_t (20), N
  Eigen::Vector3d normal_Me = Eigen::Vector3d::Zero();    ///< n_k (7): -n of the master face
  Eigen::Vector3d position_Me = Eigen::Vector3d::Zero();  ///< C_k (13), m, from C_e or the centre of clamped pressure
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();     ///< on body E, N

  bool operator==(const Element&) const = default;
};

/// How an element changes as F moves: rows area, m^2; penetration, m; position C_k, m, as the master sees it. Columns
/// r, m, and a turn of F about Mf, rad, resolved in Me.
struct ElementMotion {
  Eigen::Matrix<double, 5, 6> slope = Eigen::Matrix<double, 5, 6>::Zero();
  Eigen::Matrix<double, 5, 6> error = Eigen::Matrix<double, 5, 6>::Zero();  ///< at most; infinite: nothing known

  bool operator==(const ElementMotion&) const = default;
};

/// Derivatives of force and torque, where the discrete facts stay as they are (fast/include/pcm/contact.h says by
/// what). Enclosed, not correctly rounded: many entries are 0 by cancellation.
struct Tangent {
  Eigen::Matrix<double, 6, 12> slope = Eigen::Matrix<double, 6, 12>::Zero();
  Eigen::Matrix<double, 6, 12> error = Eigen::Matrix<double, 6, 12>::Zero();  ///< at most; infinite: nothing known
  std::vector<ElementMotion> elements;  ///< of those of the answer in the same mode, in their order

  bool operator==(const Tangent&) const = default;
};

/// The oracle's answer to one problem. Every number is the true value, correctly rounded (ties to even, zero as +0):
/// positions, areas, volume, and all of elements, force, torque and penetration, with two exceptions (contact_force.h).
/// The scales may go to either neighbour where they are halfway between two doubles, or as good as that. And where an
/// element is clamped to max_penetration, if only in part, while F turns (w != 0), its v_t is a root of a root, and
/// with friction so are forces and torque: of those, too, what 4096 bits do not tell from a tie may go to either
/// neighbour.
struct Answer {
  bool touching = false;
  bool nested = false;
  bool ambiguous = false;
  std::vector<Polygon> polygons;  ///< ordered by their first crossing
  Index patches = 0;
  ActiveArea E;
  ActiveArea F;
  std::optional<double> volume;   ///< none where a surface is open or the answer is ambiguous
  std::vector<Element> elements;  ///< by master (E first), then master face, then slave face
  Index undefined_areas = 0;      ///< faces a border of the other, open surface ends in: their clipped area counts as 0
  Index too_deep = 0;
  double max_penetration = 0;  ///< greatest u before clamping
  bool penetration_exceeded = false;
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();
  double force_scale = 0;          ///< sum of |F_k|: what a force error is measured against (DESIGN section 3)
  double torque_scale = 0;         ///< sum of |C_k - r| |F_k|
  std::optional<Tangent> tangent;  ///< where wanted
  /// Barycentric scheme: every decision about the elements holds for all vertices within their rounding boxes. Clipped
  /// scheme: always true, for small changes of the vertices change its elements by slivers.
  bool certified = true;

  bool operator==(const Answer&) const = default;
};

}  // namespace pcm::reference
