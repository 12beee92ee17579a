// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "compare/known_answers/identity_support.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

/// What identities of force and torque rest on: poses without any rounding of vertices, sums over some of the master
/// faces, and when a split master face carries what it carried whole.
namespace pcm::compare {

/// Force and torque on E about Mf, resolved in Me, and how far off they may be, component by component.
struct BoundedLoad {
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();         ///< N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();        ///< N m
  Eigen::Vector3d force_bound_Me = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque_bound_Me = Eigen::Vector3d::Zero();  ///< N m
};

/// Of an answer of the engine with its bound: off from the exact problem's load.
BoundedLoad load_of(const fast::Contact& contact);
/// Of an answer of the oracle, whose numbers are correctly rounded: off from its problem's load.
BoundedLoad load_of(const reference::Answer& answer);

/// The same of what some master faces carry, in mode E or F.
using FaceChoice = std::function<bool(Index master_face)>;
BoundedLoad load_of_faces(const fast::Contact& contact, const Pose& pose, const FaceChoice& chosen);
BoundedLoad load_of_faces(const reference::Answer& answer, const Pose& pose, const FaceChoice& chosen);

/// The load of the pair with its bodies exchanged (exchanged_pair) as one on E of the pair itself. `pose` is the pair's
/// own and turns axes into axes.
BoundedLoad seen_from_E(const BoundedLoad& exchanged, const Pose& pose);

/// Records whether both may be bounded values of one load.
void expect_one_load(Findings& findings, const std::string& what, const BoundedLoad& a, const BoundedLoad& b);

/// The same pair, its vertices in Me rounded to 51 bits of the greatest coordinate and F's frame set anew: parallel to
/// E's but for an exchange of axes, at an r of few bits. No vertex of either surface is rounded any more on its way
/// into the other's frame, nor are r and velocity: the rounded, the exact and the exchanged problem are one and the
/// same up to an isometry that turns axes into axes. May be unfit for contact, where tiny faces vanish.
Posed without_rounding(const Posed& posed);

/// The pair with its bodies exchanged: the motion is that of E relative to F, resolved in Mf.
Posed exchanged_pair(const Posed& posed);

/// F's vertices rounded into Me as PCM section 1 has them, at the identity pose: the same rounded problem.
Posed placed_beforehand(const Posed& posed);

bool fit_for_contact(const Posed& posed);

/// No border, and no face that has more in common with another one than what neighbours share: exact.
bool is_closed_and_embedded(const TriangleMesh& mesh);

/// A mesh some of whose faces are split in their planes. Faces keep their order, and parts take their face's place.
struct SplitMesh {
  TriangleMesh mesh;
  std::vector<Index> whole;  ///< of each face: the face that it is, or is part of
};

/// Whether the middles of all edges are doubles: else splitting makes another surface, which the oracle sees.
bool has_exact_middles(const TriangleMesh& mesh);

/// Every face in four (`split`).
SplitMesh quartered(const TriangleMesh& mesh);

/// Faces halved at the middles of edges, which must be doubles: of edges in an order drawn from `random`, each whose
/// faces are not yet split.
SplitMesh halved(const TriangleMesh& mesh, PoseRandom& random);

/// Which faces of master E carry in the clipped scheme, elastically, what their parts carry together.
///
/// The load of a face is the integral of u(x) over it, if it is active (PCM section 6). But for points on finitely many
/// lines, u(x) is a matter of both surfaces as sets of oriented points, and of the order of faces that lie on one
/// another in one plane; splitting changes neither, for parts of different faces keep their faces' order, and a part's
/// line, at right angles to it, meets none of its face's other parts. So the loads agree of
/// 1. a face that is active and whose parts are: the integrals add up;
/// 2. a face that is not active, and none of whose parts is: both carry nothing;
/// 3. any face, if the slave is closed and no face of it touches another one but as neighbours. A fit surface has its
///    cavities within bodies, so its winding number is then nowhere negative. Where u(x) > 0 the line leaves the slave
///    at f, where the number falls by 1, so it is at least 1 at x, inside; so the part of the face that x lies in
///    crosses the slave or has its vertices inside, and is active, and so is the face. What is not active has u = 0 all
///    over.
/// No more holds. Activity goes by whole faces: an open slave has no inside, and a closed one that folds over has
/// points of u > 0 outside it (before a pocket of winding number -1, or before sheets in one plane of which the first
/// one is left and the next one entered). A part whose face is active may have such points, be crossed by nothing, and
/// carry nothing.
class SplitMasterFaces {
 public:
  /// Active faces of E whole and in parts; of the latter `whole_of` says what they are parts of.
  template <class ActiveArea>
  SplitMasterFaces(const TriangleMesh& slave, const std::vector<Index>& whole_of, const ActiveArea& whole,
                   const ActiveArea& parts)
      : SplitMasterFaces(slave, whole_of, {&whole.intersected, &whole.inner}, {&parts.intersected, &parts.inner}) {}

  bool carries_the_same(Index whole_face) const { return same_[static_cast<std::size_t>(whole_face)]; }

 private:
  using Lists = std::array<const std::vector<Index>*, 2>;
  SplitMasterFaces(const TriangleMesh& slave, const std::vector<Index>& whole_of, const Lists& whole,
                   const Lists& parts);

  std::vector<bool> same_;  ///< by whole face
};

}  // namespace pcm::compare
