// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/pose_figures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "compare/stability/condition.h"
#include "meshes/base/floating_point_environment.h"
#include "pcm/bad_input.h"

namespace pcm::compare::stability {
namespace {

using reference::Ball;

/// For differences that must only be told from a bound.
constexpr mpfr_prec_t kPrecision = 384;

bool all_finite(const fast::Contact& contact) {
  return contact.force_Me.allFinite() && contact.torque_Me.allFinite() && std::isfinite(contact.E.area) &&
         std::isfinite(contact.max_penetration);
}

Figures relative(const Figures& figures, const Figures& sizes) {
  Figures parts{};
  for (std::size_t k = 0; k < parts.size(); ++k) parts[k] = figures[k] == 0 ? 0 : figures[k] / sizes[k];
  return parts;
}

bool certainly_less(const Ball& a, const Ball& b) {
  return (b - a).sign() == 1;
}

/// The first promise of the bound that is broken.
std::string broken_promise(const fast::Contact& subj, ExactContact& truth) {
  const reference::Field<Ball> field{kPrecision};
  const Values& values = truth.values(kPrecision);
  const auto outside = [&](double computed, const Ball& exact, double bound) {
    if (std::isnan(bound)) return true;
    if (std::isinf(bound)) return false;
    const Ball error = field(computed) - exact, limit = field(bound);
    return certainly_less(limit, error) || certainly_less(error, field(-1.0) * limit);
  };
  constexpr std::array kAxes = {'x', 'y', 'z'};
  for (int i = 0; i < 3; ++i) {
    const char axis = kAxes[static_cast<std::size_t>(i)];
    if (outside(subj.force_Me[i], values.force_Me[i], subj.bound->force_Me[i]))
      return fmt::format("force {}: {:a}, bound {:a}", axis, subj.force_Me[i], subj.bound->force_Me[i]);
    if (outside(subj.torque_Me[i], values.torque_Me[i], subj.bound->torque_Me[i]))
      return fmt::format("torque {}: {:a}, bound {:a}", axis, subj.torque_Me[i], subj.bound->torque_Me[i]);
  }
  const double low = subj.bound->penetration_at_least, high = subj.bound->penetration_at_most;
  if (std::isnan(low) || std::isnan(high) || certainly_less(values.penetration, field(low)) ||
      (std::isfinite(high) && certainly_less(field(high), values.penetration)))
    return fmt::format("greatest penetration not between {:a} and {:a}", low, high);
  return {};
}

Figures bounds_of(const fast::Contact& subj) {
  const fast::ForceBound& bound = *subj.bound;
  return {
      bound.force_Me.stableNorm(), bound.torque_Me.stableNorm(), 0,
      std::max(bound.penetration_at_most - subj.max_penetration, subj.max_penetration - bound.penetration_at_least)};
}

std::vector<std::array<Index, 2>> elements_of(const fast::Contact& contact) {
  std::vector<std::array<Index, 2>> faces;
  for (const fast::Element& element : contact.elements) faces.push_back({element.master_face, element.slave_face});
  std::sort(faces.begin(), faces.end());
  return faces;
}

PublishedFigures published_figures(const TestedEngine* algorithm, const Pose& pose, ExactContact& truth,
                                   const Figures& sizes, FiguresWorkspace& workspace) {
  PublishedFigures figures;
  if (algorithm == nullptr) return figures;
  const fast::Contact* subj = nullptr;
  try {
    subj = &algorithm->evaluate(pose, {}, Wanted{}, workspace);
  } catch (const BadInput&) {
    return figures;
  }
  figures.answered = all_finite(*subj);
  if (!figures.answered) return figures;
  figures.same_elements = elements_of(*subj) == truth.elements();
  figures.error = relative(differences(truth, *subj), sizes);
  figures.error[static_cast<std::size_t>(Quantity::area)] = 0;
  return figures;
}

}  // namespace

const fast::Contact& ask_engine(const fast::Pairing& pairing, const Pose& pose, fast::Workspace& workspace) {
  constexpr Wanted kWanted{.polygons = false, .areas = true, .force = true, .elements = false, .bound = true};
  return fast::evaluate(pairing, pose, {}, kWanted, workspace);
}

Contestants::Contestants(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : exact(mesh_E, mesh_F) {
  const fast::Surface E(mesh_E), F(mesh_F);
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
    engines.emplace_back(E, F, stability_law(), Mode::E, scheme);
  for (std::size_t k = 0; k < kPublished.size(); ++k) {
    try {
      published[k] = make_tested_engine(kPublished[k], mesh_E, mesh_F, stability_law(), Mode::E, Scheme::barycentric);
    } catch (const BadInput&) {
      // It has no answers then.
    }
  }
}

PoseFigures figures_at(const Contestants& contestants, const Pose& pose, Scheme scheme, const AskEngine& ask,
                       FiguresWorkspace& workspace) {
  const DefaultFloatingPoint environment;
  PoseFigures figures;
  ExactContact truth(contestants.exact, pose, scheme);
  figures.carries_force = truth.carries_force();
  const fast::Contact* subj = nullptr;
  try {
    subj = &ask(contestants.engine(scheme), pose, workspace.fast);
    figures.answered = all_finite(*subj);
  } catch (const BadInput&) {
    // Counted as no answer.
  }
  if (!figures.answered) return figures;
  figures.outside_bound = broken_promise(*subj, truth);
  figures.flipped = subj->bound->flipped;
  if (!figures.carries_force) return figures;
  const Figures sizes = truth.sizes();
  figures.error = relative(differences(truth, *subj), sizes);
  ExactContact rounded(contestants.exact, pose, scheme, reference::Problem::rounded);
  figures.of_vertices = relative(differences(truth, rounded), sizes);
  figures.bound = relative(bounds_of(*subj), sizes);
  figures.unbounded = std::any_of(figures.bound.begin(), figures.bound.end(), [](double b) { return std::isinf(b); });
  figures.condition = relative(movement_by_an_ulp(contestants.exact, pose, scheme, truth), sizes);
  if (scheme == Scheme::barycentric)
    for (std::size_t k = 0; k < kPublished.size(); ++k)
      figures.published[k] = published_figures(contestants.published[k].get(), pose, truth, sizes, workspace);
  return figures;
}

}  // namespace pcm::compare::stability
