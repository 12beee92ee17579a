// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/hardness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/hard_poses/least_margin.h"
#include "compare/verify/bounds/element_law.h"
#include "compare/verify/routes/wanted_presets.h"

namespace pcm::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double steps(const fast::WorkCounters& work) {
  return static_cast<double>(work.node_pairs + work.face_rows + work.predicates + work.elements + work.lines +
                             work.searches());
}

double greatest_part(const Eigen::Vector3d& subj, const Eigen::Vector3d& truth, const Eigen::Vector3d& bound) {
  double greatest = 0;
  for (int j = 0; j < 3; ++j) {
    const double error = std::abs(subj[j] - truth[j]);
    const double part = error == 0 ? 0 : error / bound[j];
    greatest = std::isnan(part) ? kInfinity : std::max(greatest, part);
  }
  return greatest;
}

/// The forces of all elements if each had all of its master face, N.
double forces_of_whole_faces(const HeldPairing& held, const ContactLaw& law, const fast::Contact& subj) {
  double forces = 0;
  for (const fast::Element& e : subj.elements) {
    const FeaturePair& features = held.features();
    const SurfaceFeatures& master = e.master == Side::E ? features.E : features.F;
    forces += greatest_force(law, 0.5 * master.face_normal(e.master_face).stableNorm(), e.penetration,
                             std::hypot(e.normal_velocity, e.tangential_velocity));
  }
  return forces;
}

double bound_over_error(const fast::Contact& subj, const Eigen::Vector3d& true_force_Me, double forces) {
  if (subj.elements.empty()) return 0;
  const double error = std::max((subj.force_Me - true_force_Me).stableNorm(), 0x1p-53 * forces);
  const double bound = subj.bound->force_Me.stableNorm();
  if (std::isnan(error) || std::isnan(bound)) return kInfinity;
  return error > 0 && std::isfinite(bound) ? bound / error : 0;
}

}  // namespace

double hardness(Goal goal, const HeldPairing& held, std::size_t mode, const HeldPairing::State& state,
                fast::Workspace& workspace) {
  if (goal == Goal::margins) return 1 / least_margin(held.features(), state.pose);
  const fast::Pairing engine = held.engine_under(state.law, held.engine(mode).mode(), state.scheme);
  if (!depends_on_law(goal)) {
    const fast::WorkCounters work = fast::evaluate(engine, state.pose, state.velocity, {}, workspace).work;
    return goal == Goal::work ? steps(work) : static_cast<double>(work.exact_predicates);
  }
  Wanted wanted = kForceOnly;
  wanted.bound = wanted.elements = true;
  const fast::Contact& subj = fast::evaluate(engine, state.pose, state.velocity, wanted, workspace);
  if (subj.bound->flipped) return 0;
  reference::Inquiry inquiry(held.oracle(), state.pose, state.velocity, kForceOnly, state.law, state.scheme);
  const reference::Answer truth = inquiry.answer(reference::Problem::exact, engine.mode());
  if (goal == Goal::bound_over_error)
    return bound_over_error(subj, truth.force_Me, forces_of_whole_faces(held, state.law, subj));
  return std::max(greatest_part(subj.force_Me, truth.force_Me, subj.bound->force_Me),
                  greatest_part(subj.torque_Me, truth.torque_Me, subj.bound->torque_Me));
}

}  // namespace pcm::compare
