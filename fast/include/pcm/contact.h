// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// A crossing: an edge of one surface passes through a face of the other (PCM section 4).
struct Crossing {
  Side edge_side = Side::E;     ///< the surface the edge belongs to; the face belongs to the other
  std::array<Index, 2> edge{};  ///< its end vertices, the smaller index first
  Index face = 0;               ///< the face it passes through
  Eigen::Vector3d position_Me = Eigen::Vector3d::Zero();  ///< where the edge meets the plane of the face, m
};

/// An intersection polygon: `count` crossings from `first` on in Contact::crossings, in the circulation of (5): the
/// part of E inside F lies on the left seen from outside E. It starts at its smallest crossing (side, edge, face) if
/// closed, and where the circulation starts if open. A closed polygon's first point is not repeated.
struct Polygon {
  bool closed = true;
  Index first = 0;
  Index count = 0;
  Index patch = 0;  ///< which contact patch it bounds, from 0
};

/// What the contact is on one of the surfaces. Nested faces count as inner (PCM section 5). Faces are known wherever
/// anything but touch is wanted.
struct ActiveArea {
  std::vector<Index> intersected;  ///< faces in a crossing pair, ascending
  std::vector<Index> inner;        ///< uncrossed faces inside the other body, ascending
  /// Of the clipped active area, m^2; parts the other surface winds about w times count w times. What lies in one plane
  /// with the other's faces counts where the tie rule moves it inside (PCM section 4); the volume does not feel that.
  double area = 0;
  Eigen::Vector3d vector_area_Me = Eigen::Vector3d::Zero();  ///< integral of the outward normal over it, m^2
};

/// A contact element: a master face and the slave face its penetration lines leave through. Barycentric scheme: the
/// whole face, with the penetration of its barycentre; clipped scheme: the part of the face that sees the slave face,
/// with the mean penetration there. Both are clamped to max_penetration: at the barycentre, or at every point before
/// the mean is taken.
struct Element {
  Side master = Side::E;
  Index master_face = 0;
  Index slave_face = 0;
  double area = 0;                 ///< A_k (6), m^2
  double penetration = 0;          ///< u_k (11) or mean u, clamped, m, >= 0: 0 where roundings take it all
  double normal_velocity = 0;      ///< v_n (16), m/s, positive when approaching
  double tangential_velocity = 0;  ///< v_t (19), m/s
  double normal_force = 0;         ///< F_n (18), N
  double tangential_force = 0;     ///< F_t (20), N
  Eigen::Vector3d normal_Me = Eigen::Vector3d::Zero();    ///< n_k = -n of the master face
  Eigen::Vector3d position_Me = Eigen::Vector3d::Zero();  ///< C_k (13), from C_e or the centroid of u, clamped, m
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();     ///< on body E, N (not halved in mode `both`)
};

/// Summary over the elements (PCM section 9), in mode `both` those of both masters, so that areas count twice; all zero
/// where there is none.
struct Statistics {
  double patch_area = 0;               ///< sum of A_k, m^2
  double mean_penetration = 0;         ///< area-weighted, m
  double max_pressure = 0;             ///< greatest F_n / A_k, Pa; 0 where all elements pull
  double mean_pressure = 0;            ///< area-weighted, Pa
  double max_normal_velocity = 0;      ///< greatest |v_n|, m/s
  double max_tangential_velocity = 0;  ///< greatest v_t, m/s
  /// C_k weighted by F_n, m; 0 unless these sum to > 0.
  Eigen::Vector3d centre_of_pressure_Me = Eigen::Vector3d::Zero();
};

/// Rigorous bounds on |computed - true|, component by component, the truth being the exact problem's force and torque
/// in the same scheme (PCM section 1): the rounding of F's vertices is included. Infinite only where numbers leave the
/// range of doubles.
struct ForceBound {
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< N m
  /// A discrete decision may be another one in the exact problem, and the force with it by a finite amount. Barycentric
  /// scheme: it may have other elements. Clipped scheme: a master face with elements may not be active, one that is not
  /// active may have some of more than roundings, a face is seen nearly flush, or a master face's normal is not known.
  bool flipped = false;
  /// The exact problem's greatest penetration lies between these, m. Whether it exceeds the law's bound is certain
  /// where that does not. The upper one may be infinite. In the clipped scheme they are apart by more than roundings
  /// where what is deepest is only seen through a gap as narrow as roundings, or next to a face seen edgewise, or where
  /// the search for it ends undecided, after 256 pieces of what a face sees.
  double penetration_at_least = 0;
  double penetration_at_most = 0;
};

/// Derivatives of force and torque. Rows: force_Me, then torque_Me. Columns, all resolved in Me: r, m; a turn a of F
/// about Mf, dA = [a x] A, rad; v, m/s; w, rad/s.
///
/// Discrete facts stay as they are: which faces are elements and which slave faces they meet. The barycentric force
/// jumps where these change, and no derivative tells of that. At a kink of the law it is the derivative of one side: of
/// penetrations from max_penetration and from u_d on, approaching (v_n >= 0) where damping is `compression`, forces
/// that press, slip velocities from v_eps on; at rest without v_eps friction counts as constant. The clipped scheme's
/// force has a kink as well where outlines of faces lie on one another as the master sees them: each stretch of what
/// parts an element from others moves then as one of the lines there does. Where one of these is an edge of the slave
/// and another the border of the master face, it is the edge where the slave's sheet ends there, as seen, and the
/// border where it goes on: so for flush grids on one another, to the last digits. What a face that is seen edgewise
/// may show has no area yet, or one of rounding size, and is no part of it: turned out of the vertical, the walls of a
/// box in a plane see some of that, and the derivative by such a turn lacks it. Where roundings leave nothing of the
/// angle between a penetration line and the slave face that it meets, that element's depth counts as constant, and so
/// does a number of an element's place whose derivative is beyond all doubles (depths of 2^-1030 m and less).
///
/// Of no alignment of its own: what a caller compiles with must not decide where answers have their members.
using Tangent = Eigen::Matrix<double, 6, 12, Eigen::DontAlign>;

/// The engine's answer for one pose. Lives in the workspace and is overwritten by the next evaluation. What was not
/// wanted is empty, 0 or false: nothing but `touching` is known where only that was asked for.
struct Contact {
  bool touching = false;   ///< the surfaces cross
  bool nested = false;     ///< a component of one lies in the other without crossing; not known where only touch is
                           ///< wanted
  bool ambiguous = false;  ///< an open surface labels a set of faces both ways (PCM section 5); not known there either
  std::vector<Crossing> crossings;  ///< of all polygons, one polygon after the other; where `polygons` are wanted
  std::vector<Polygon> polygons;    ///< ordered by their first crossing; likewise
  Index patches = 0;                ///< polygons that vertices and edges in active areas join share one; likewise
  ActiveArea E;                     ///< its areas where `areas` are wanted
  ActiveArea F;
  Index undefined_areas = 0;  ///< intersected faces in which a border of the other surface ends: their area counts as 0
  bool has_volume = false;    ///< both surfaces are closed; false where no `areas` are wanted
  double volume = 0;          ///< of the intersection, m^3
  std::vector<Element> elements;  ///< by master (E first), then master face, then slave face; empty unless wanted
  Index element_count = 0;        ///< over all masters evaluated
  /// Active faces of the masters evaluated whose penetration line leaves the master before it leaves the other body
  /// (PCM section 6): the master is thinner there than the penetration, and has no force.
  Index too_deep = 0;
  double max_penetration = 0;  ///< greatest u (clipped: anywhere) over all masters evaluated, before clamping, m
  /// max_penetration > that of the law. Either depends on an ulp where only parts of rounding size lie so deep:
  /// ForceBound tells what is certain.
  bool penetration_exceeded = false;
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on body E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on body E about Mf, N m
  std::optional<ForceBound> bound;                      ///< where wanted
  std::optional<Tangent> tangent;                       ///< where wanted
  Statistics statistics;
  WorkCounters work;

  /// Empties the answer and keeps its memory.
  void clear();
};

static_assert(alignof(Contact) == alignof(std::int64_t), "flags such as -mavx must not move the members of answers");

}  // namespace pcm::fast
