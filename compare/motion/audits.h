// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/known_answers/known_answers.h"
#include "compare/motion/force_jumps.h"
#include "compare/motion/path_work.h"

/// Audits: closed loops of poses, walked with `walk` (force_jumps.h): the work left over, the force within the plane of
/// sliding although there is no friction, and the jumps of the force; each held against what mathematics says, where it
/// says anything.
///
/// Is the elastic foundation conservative? Let F move by r without turning. With the master's elements A_k, inward
/// normals n_k and slave normals n_f, u = ((C_f - x) . n_f) / (n_k . n_f) changes by du = n_f . dr / (n_k . n_f) where
/// F is slave, and by the same with the opposite sign where F is master; where u = 0 along the border of the contact,
/// the border's motion adds nothing. So the force on F has the Jacobian -c_l sum A_k n_k n_f^T / (n_k . n_f), and
///     rot F = c_l sum A_k (n_k x n_f) / (n_k . n_f)
/// whichever body is master. By Stokes' theorem the work over a loop is the flux of rot F through it. It is 0 where
/// every n_k is parallel to its n_f, and where the master is one plane that reaches beyond the contact: there
/// n_f / (n_k . n_f) = n_k + grad u, and the integral of grad u over the contact is 0 with u = 0 along its border; the
/// force is then the gradient of c_l times the integral of the volume over the depth. It is not 0 in general: the
/// model, clipped scheme included, is not conservative. Where the outward normals at the border enclose
/// less than a right angle, lines enter the slave there and u is not 0: then the moving border adds its share, and the
/// formula does not hold; nor where the master's border lies within the contact. The barycentric scheme samples all
/// this, and its force jumps besides.
namespace pcm::compare {

/// A pairing and a loop of poses. Expectations are bands; where there is none, the figure is reported only.
struct Audit {
  std::string id;      ///< e.g. "wedge 30 deg"
  std::string bodies;  ///< in words
  std::string loop;    ///< in words
  std::shared_ptr<const fast::Pairing> pairing;
  std::vector<Pose> poses;
  std::optional<Eigen::Vector3d> normal_Me;  ///< of the plane of sliding, where there is one
  std::int64_t steps = 64;
  std::optional<Band> work;           ///< of the contact on F, J, beside the rule's own estimate of its error
  std::optional<Band> tangential;     ///< greatest F_t to greatest F_n
  std::optional<Band> jumps;          ///< how many
  std::optional<Band> greatest_jump;  ///< N
  std::string reason;                 ///< why, in a few words
};

struct AuditResult {
  Audit audit;
  PathWork work;
  std::optional<TangentialForce> tangential;
  std::size_t jumps = 0;
  double sum_of_jumps = 0, greatest_jump = 0;  ///< N
  std::vector<std::string> misses;             ///< what is out of its band

  double relative_jump() const { return work.greatest_force > 0 ? greatest_jump / work.greatest_force : 0; }
};

/// Figures that are kept are not worked out again.
AuditResult run(Audit audit, KeptValues& kept);
inline AuditResult run(Audit audit) {
  KeptValues none;
  return run(std::move(audit), none);
}

/// The loops of audit_loops.cpp in every mode and scheme.
std::vector<Audit> audits(Extent extent);

/// Runs them all on `jobs` threads, in their order; `progress` is told how many are done. The same results whatever the
/// number of threads.
std::vector<AuditResult> run_audits(Extent extent, int jobs, KeptValues& kept,
                                    const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace pcm::compare
