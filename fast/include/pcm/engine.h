// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "pcm/contact.h"
#include "pcm/inputs.h"
#include "pcm/savings.h"
#include "pcm/triangle_mesh.h"
#include "pcm/workspace.h"

/// The engine: three tasks, three interfaces (PCM section 1). Define a Pairing of two Surfaces, `evaluate` it for as
/// many poses as wanted, let it go. Floating point, but every discrete decision is exact on the rounded problem.
///
/// No answer depends on the caller's floating-point environment (rounding mode, denormals flushed, traps enabled),
/// which is as before on return, sticky exception flags included, also where something is thrown.
namespace pcm::fast {

struct PreparedSurface;

/// A surface prepared for contact: adjacency, bounding volume trees. Can be shared by any number of pairings and
/// threads. What it has near each face of its own, by which most lines of elements need no search, is computed when a
/// contact first meets that face; no answer depends on what was asked before. Copies share it. One that was moved from
/// may be destroyed or assigned to, no more; so may a Pairing.
class Surface {
 public:
  /// Throws BadInput, naming what is wrong where and what mends it, when the mesh is unfit for contact (PCM section 2)
  /// or so large or small that its volumes leave the range of doubles (2^-300 to 2^300 m). Open surfaces are fit. O(n
  /// log n) in the number of faces.
  explicit Surface(TriangleMesh mesh);

  const TriangleMesh& mesh() const;
  bool closed() const;  ///< no border edge

  /// Computes for all faces now what would wait for their first contact, some 20 us a face: for whoever prefers a
  /// longer setup to a slower first evaluation. O(n log n).
  void prepare_all_faces() const;

  /// The engine's own.
  const PreparedSurface& data() const { return *data_; }

 private:
  std::shared_ptr<const PreparedSurface> data_;
};

/// Two surfaces, the law between them and whose faces carry the elements. Immutable.
/// Throws BadInput where a parameter of the law is out of its range.
class Pairing {
 public:
  Pairing(Surface surface_E, Surface surface_F, ContactLaw law = {}, Mode mode = Mode::E,
          Scheme scheme = Scheme::barycentric);

  const Surface& surface_E() const { return surface_E_; }
  const Surface& surface_F() const { return surface_F_; }
  const ContactLaw& law() const { return law_; }
  Mode mode() const { return mode_; }
  Scheme scheme() const { return scheme_; }

 private:
  Surface surface_E_;
  Surface surface_F_;
  ContactLaw law_;
  Mode mode_;
  Scheme scheme_;
};

/// Evaluates the pairing for one state; the answer lives in `workspace` until its next use.
/// Throws BadInput where the pose is no rotation to 1e-9, r exceeds 2^300 m or a velocity 2^700 along an axis, anything
/// is not finite or what is wanted of the force, or a sum on the way to it, would not be, std::bad_alloc where memory
/// ends, and std::system_error where a workspace of several threads finds none left. Then nothing is told of the answer
/// that the workspace held; the workspace stays usable. `savings` other than all change what it costs, and no bit of an
/// answer; where one throws that otherwise would not, Savings says.
const Contact& evaluate(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                        Workspace& workspace, const Savings& savings = {});

}  // namespace pcm::fast
