// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "fast/inputs.h"
#include "meshes/triangle_mesh.h"
#include "reference/answer.h"

/// The oracle: the same computation as the engine, over exact numbers, in code and method of its own.
namespace pcm::reference {

/// A pairing as the oracle sees it. Immutable; `answer` may be called from any number of threads at once.
class Oracle {
 public:
  /// Throws BadInput where a mesh is unfit for contact or a parameter of the law is out of its range.
  Oracle(TriangleMesh mesh_E, TriangleMesh mesh_F, ContactLaw law = {}, Mode mode = Mode::E,
         Scheme scheme = Scheme::barycentric);
  ~Oracle();

  /// Throws BadInput where the pose is no rotation or anything is not finite.
  Answer answer(Problem problem, const Pose& pose, const Velocity& velocity = {}, const Wanted& wanted = {}) const;

  struct Data;

 private:
  std::unique_ptr<const Data> data_;
};

}  // namespace pcm::reference
