// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "compare/known_answers/identity_result.h"
#include "compare/poses/strata.h"
#include "compare/random/random.h"
#include "pcm/engine.h"

/// What the identities share: posed pairs, transformations of them, and comparisons.
namespace pcm::compare {

/// A pose of two surfaces with all that the force depends on.
struct Posed {
  TriangleMesh E;
  TriangleMesh F;
  ContactLaw law;
  Pose pose;
  Velocity velocity;
  std::string where;     ///< pair, stratum, number and seed
  std::uint64_t stream;  ///< of further random numbers
};

/// Poses of the built-in pairs: `each` of every general pair in the strata generic and grazing, and as many of every
/// hard pair in generic, degenerate and near-degenerate.
std::vector<Posed> posed_pairs(std::uint64_t seed, int each);

/// A copy of the engine's whole answer.
fast::Contact answer(const Posed& posed, Mode mode, Scheme scheme, const Wanted& wanted = {});

/// Where and in what a check failed, and how close it came.
class Findings {
 public:
  explicit Findings(std::string where = {}) : where_(std::move(where)) {}

  /// One comparison: `difference` in words, empty where there is none.
  void same(const std::string& difference);
  /// One comparison of a difference with what is allowed.
  void close(const std::string& what, double difference, double allowed);
  void merge(const Findings& other);

  std::int64_t checks = 0;
  std::int64_t violations = 0;
  double worst = 0;
  std::string first;

 private:
  std::string where_;
};

/// Runs a check for each of the poses on the threads of the current arena; findings are merged in their order.
IdentityResult over_poses(std::string name, std::string statement, Sharpness sharpness, const std::vector<Posed>& poses,
                          const std::function<void(const Posed&, Findings&)>& check);

/// A change of the frame or of the unit of length under which an answer must change accordingly, bit for bit.
struct Similarity {
  double length = 1;                                ///< a power of two
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();  ///< of the axes, their product 1

  Eigen::Vector3d applied(const Eigen::Vector3d& x, double factor) const { return factor * x.cwiseProduct(signs); }
};

/// The first quantity in which b is not a under the similarity, bit for bit; empty where there is none. Stiffness per
/// area stays, so areas go with length^2, forces with length^3 and torques with length^4.
std::string difference(const fast::Contact& a, const fast::Contact& b, const Similarity& similarity = {});

/// Records whether two answers to one exact problem, whatever their rounded ones, differ by no more than their own
/// bounds together. Both must have been asked for theirs.
void expect_within_bounds(Findings& findings, const std::string& what, const fast::Contact& a, const fast::Contact& b);

/// Faces and vertices in another order, drawn from `random`; faces also start at another corner.
TriangleMesh reordered(const TriangleMesh& mesh, PoseRandom& random);

/// Every face split in four at the middles of its edges, which must be doubles: the same surface.
TriangleMesh split(const TriangleMesh& mesh);

}  // namespace pcm::compare
