// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/error_budget.h"

#include <fmt/format.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "compare/random.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

constexpr int kBudgetOrientations = 10;

Wanted force_only() {
  Wanted wanted;
  wanted.polygons = wanted.areas = wanted.elements = false;
  return wanted;
}

/// Engine and oracle over one pair of meshes in one scheme.
struct Solvers {
  Solvers(const BudgetMeshes& meshes, Scheme scheme)
      : engine(fast::Surface(meshes.E), fast::Surface(meshes.F), stiffness(1), Mode::E, scheme),
        oracle(meshes.E, meshes.F, stiffness(1), Mode::E, scheme) {}

  fast::Pairing engine;
  reference::Oracle oracle;
};

/// The engine's force and its distance from the exact problem's, relative to the sum of |F_k|.
struct Measured {
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();
  double rounding = 0;
};

Measured measured(const Solvers& solvers, const Pose& pose, fast::Workspace& workspace) {
  Measured m;
  m.force_Me = fast::evaluate(solvers.engine, pose, {}, force_only(), workspace).force_Me;
  const reference::Answer truth = solvers.oracle.answer(reference::Problem::exact, pose, {}, force_only());
  if (truth.force_scale > 0) m.rounding = (m.force_Me - truth.force_Me).norm() / truth.force_scale;
  return m;
}

/// What one orientation contributes.
struct Sample {
  Measured barycentric;
  Measured clipped;
  Eigen::Vector3d axis_Me = Eigen::Vector3d::Zero();
  double along_equal_volume = 0;
};

/// Runs `body(orientation, workspace)` on the threads of the current arena.
template <class Body>
void over_orientations(int orientations, const Body& body) {
  oneapi::tbb::enumerable_thread_specific<fast::Workspace> workspaces;
  oneapi::tbb::parallel_for(0, orientations, [&](int i) { body(i, workspaces.local()); });
}

}  // namespace

BudgetLevel error_budget(const BudgetCase& pair, std::size_t level, int orientations) {
  const BudgetMeshes meshes = pair.meshes(level);
  const Solvers barycentric(meshes, Scheme::barycentric), clipped(meshes, Scheme::clipped);
  std::vector<Sample> samples(static_cast<std::size_t>(orientations));
  over_orientations(orientations, [&](int i, fast::Workspace& workspace) {
    const Placement placement = pair.placement(i);
    Sample& sample = samples[static_cast<std::size_t>(i)];
    sample.barycentric = measured(barycentric, placement.pose(), workspace);
    sample.clipped = measured(clipped, placement.pose(), workspace);
    sample.axis_Me = pair.axis_F ? ordered_product(placement.pose().A, pair.axis_F(i))
                                 : Eigen::Vector3d(sample.clipped.force_Me.normalized());
  });
  if (pair.equal_volume) {
    const BudgetMeshes filled = pair.equal_volume(level);
    const fast::Pairing engine(fast::Surface(filled.E), fast::Surface(filled.F), stiffness(1), Mode::E,
                               Scheme::clipped);
    over_orientations(orientations, [&](int i, fast::Workspace& workspace) {
      Sample& sample = samples[static_cast<std::size_t>(i)];
      sample.along_equal_volume =
          fast::evaluate(engine, pair.placement(i).pose(), {}, force_only(), workspace).force_Me.dot(sample.axis_Me);
    });
  }

  BudgetLevel errors;
  errors.master_faces = static_cast<Index>(meshes.E.faces.size());
  errors.edge = mean_edge(meshes.E);
  errors.across = pair.width / errors.edge;
  double force = 0, filled_force = 0, difference = 0, squares = 0;
  for (const Sample& s : samples) {
    const Eigen::Vector3d step = s.barycentric.force_Me - s.clipped.force_Me;
    force += s.clipped.force_Me.dot(s.axis_Me) / orientations;
    filled_force += s.along_equal_volume / orientations;
    difference += step.dot(s.axis_Me) / orientations;
    squares += step.squaredNorm() / orientations;
    errors.rounding_barycentric += s.barycentric.rounding / orientations;
    errors.rounding_clipped += s.clipped.rounding / orientations;
  }
  errors.discretisation = difference / force;
  errors.discretisation_single = std::sqrt(squares) / force;
  if (pair.reference) {
    const auto smooth = static_cast<double>(*pair.reference);
    errors.geometry = force / smooth - 1;
    if (pair.equal_volume) errors.geometry_equal_volume = filled_force / smooth - 1;
  }
  return errors;
}

std::optional<double> observed_order(const ErrorBudget& budget,
                                     const std::function<std::optional<double>(const BudgetLevel&)>& error) {
  const std::size_t n = budget.levels.size();
  if (n < 3) return {};
  const BudgetLevel &coarse = budget.levels[n - 3], &fine = budget.levels[n - 1];
  const std::optional<double> first = error(coarse), last = error(fine);
  if (!first || !last || !(*first / *last > 0)) return {};
  return std::log(*first / *last) / std::log(coarse.edge / fine.edge);
}

std::vector<ErrorBudget> error_budgets(Extent extent, int jobs,
                                       const std::function<void(const std::string&)>& progress) {
  std::vector<ErrorBudget> budgets;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    for (const BudgetCase& pair : budget_cases(extent == Extent::full ? 4 : 3)) {
      ErrorBudget& budget = budgets.emplace_back();
      budget.pair = pair;
      budget.orientations = extent == Extent::full ? kBudgetOrientations : 5;
      for (std::size_t level = 0; level < pair.levels; ++level) {
        progress(fmt::format("{}, level {} of {}", pair.title, level + 1, pair.levels));
        budget.levels.push_back(error_budget(pair, level, budget.orientations));
      }
    }
  });
  return budgets;
}

}  // namespace pcm::compare
