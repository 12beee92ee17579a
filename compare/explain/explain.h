// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "compare/explain/coincidence.h"
#include "compare/explain/next_answer.h"
#include "compare/explain/sign.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"
#include "pcm/work_counters.h"
#include "reference/vocabulary/answer.h"

namespace pcm::reference {
class ExactPose;
}

/// Why an answer is what it is: what coincides in a pose, or nearly does, who decides the signs that depend on it, and
/// how near the next pose with another answer is. All of the rounded problem, which both engine and oracle decide.
namespace pcm::compare {

struct ExplainOptions {
  double near_ulps = 8;     ///< how many ulps apart features nearly coincide, > 0
  std::size_t listed = 10;  ///< how many coincidences get their signs and are listed
};

struct ListedCoincidence {
  Coincidence coincidence;
  std::vector<Sign> signs;
};

struct CoincidenceCount {
  std::size_t exact = 0;
  std::size_t near = 0;  ///< not counting exact ones
};

struct Explanation {
  Pose pose;
  double scale = 0;  ///< S of DESIGN section 3, the greatest coordinate, m
  double ulp = 0;    ///< of the scale: what any coordinate may be off by, m
  DiscreteAnswer answer;
  Index elements = 0;          ///< contact elements, of all masters
  bool oracle_agrees = false;  ///< that its answer is the engine's, elements aside
  fast::WorkCounters work;     ///< of the engine, for all signs of the contact and its elements
  std::array<CoincidenceCount, kCoincidenceKinds> counts;
  std::vector<ListedCoincidence> listed;  ///< nearest first
  std::size_t left_out = 0;               ///< more that are not listed
  /// The nearest features, lines aside, however far apart; none where nothing is within `searched`.
  std::optional<Coincidence> nearest;
  double searched = 0;  ///< how far apart features were looked for, m
  std::optional<NextAnswer> next;
  /// No r nearer than that has another answer, A as it is; 0 where nothing is known. m.
  double free_distance = 0;

  const CoincidenceCount& count(CoincidenceKind kind) const { return counts[static_cast<std::size_t>(kind)]; }
  /// Of all kinds.
  CoincidenceCount total() const;
};

/// Whether anything coincides exactly, in either problem; of the rounded one, what `Explanation::total().exact > 0`
/// says. Where nothing does, penetration lines of all active faces are looked through, in the barycentric scheme.
bool coincident(const reference::ExactPose& pose, Mode mode, Scheme scheme);

/// Explains poses of two surfaces. Lines of penetration are those of the mode's masters, in the barycentric scheme.
class Explainer {
 public:
  /// Throws BadInput where a mesh is unfit for contact.
  Explainer(TriangleMesh mesh_E, TriangleMesh mesh_F, Mode mode, Scheme scheme);
  ~Explainer();
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;

  /// Throws BadInput where the pose is no rotation or not finite. Near linear in the number of pairs of faces whose
  /// boxes are near to each other, but for the search for another answer, which evaluates the engine some 100 times for
  /// each of 6 to 12 directions.
  Explanation explain(const Pose& pose, const ExplainOptions& options = {}) const;

  /// The same of one of its poses. Throws as `explain`.
  bool coincident(reference::Problem problem, const Pose& pose) const;

  const TriangleMesh& mesh(Side side) const;
  Mode mode() const;
  Scheme scheme() const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace pcm::compare
