// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"
#include "reference/pose/candidate_region.h"
#include "reference/vocabulary/answer.h"

/// The oracle: the same computation as the engine, over exact numbers, in code and method of its own. Like the
/// engine's, its answers do not depend on the caller's floating-point environment, which it leaves as it was.
namespace pcm::reference {

/// A pairing as the oracle sees it. Immutable; `answer` may be called from any number of threads at once.
class Oracle {
 public:
  /// Throws BadInput where a mesh is unfit for contact or a parameter of the law is out of its range. `region` changes
  /// no answer, only what it costs.
  Oracle(TriangleMesh mesh_E, TriangleMesh mesh_F, ContactLaw law = {}, Mode mode = Mode::E,
         Scheme scheme = Scheme::barycentric, CandidateRegion region = CandidateRegion::near);
  ~Oracle();

  /// Throws BadInput where the pose is no rotation or anything is not finite.
  Answer answer(Problem problem, const Pose& pose, const Velocity& velocity = {}, const Wanted& wanted = {}) const;

  struct Data;

 private:
  friend class Inquiry;
  std::unique_ptr<const Data> data_;
};

/// One state put to the oracle. Both problems share what does not depend on rounding, so asking for both costs less
/// than twice; and all modes of a problem share geometry, elements and tangents, so all three cost little more than
/// mode `both`. For one thread.
class Inquiry {
 public:
  /// The oracle must outlive this. Throws as Oracle::answer.
  Inquiry(const Oracle& oracle, const Pose& pose, const Velocity& velocity = {}, const Wanted& wanted = {});
  /// The same of an oracle of another law and scheme. Throws BadInput where a parameter of the law is out of its range.
  Inquiry(const Oracle& oracle, const Pose& pose, const Velocity& velocity, const Wanted& wanted, const ContactLaw& law,
          Scheme scheme);
  ~Inquiry();
  Inquiry(const Inquiry&) = delete;
  Inquiry& operator=(const Inquiry&) = delete;

  /// In the oracle's mode.
  Answer answer(Problem problem);
  /// In any mode: the answer is that of an oracle of this mode.
  Answer answer(Problem problem, Mode mode);
  /// The same but for the elements and all that is summed over them; of these only how many lines are too deep.
  Answer facts(Problem problem, Mode mode);
  /// The derivatives of force and torque, whether wanted or not; also of the clipped scheme's.
  Tangent tangent(Problem problem, Mode mode);
  /// How many pairs of faces got an exact look for crossings.
  std::size_t candidate_pairs(Problem problem);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace pcm::reference
