// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/error_budget/error_budget.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "compare/random/random.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

Wanted force_only() {
  Wanted wanted;
  wanted.polygons = wanted.areas = wanted.elements = false;
  return wanted;
}

/// Engine and oracle over one pair of meshes.
struct Solvers {
  Solvers(const BudgetMeshes& meshes, const BudgetMeshes& filled) : E(meshes.E), F(meshes.F) {
    for (const Scheme scheme : kSchemes) {
      engines.emplace_back(E, F, stiffness(1), Mode::E, scheme);
      oracles.push_back(std::make_unique<reference::Oracle>(meshes.E, meshes.F, stiffness(1), Mode::E, scheme));
    }
    engines.emplace_back(fast::Surface(filled.E), fast::Surface(filled.F), stiffness(1), Mode::E, Scheme::clipped);
  }

  const fast::Pairing& engine(Scheme scheme) const { return engines[scheme == Scheme::barycentric ? 0 : 1]; }
  const fast::Pairing& filled() const { return engines[2]; }
  const reference::Oracle& oracle(Scheme scheme) const { return *oracles[scheme == Scheme::barycentric ? 0 : 1]; }

  fast::Surface E;
  fast::Surface F;
  std::vector<fast::Pairing> engines;
  std::vector<std::unique_ptr<reference::Oracle>> oracles;
};

/// All levels and poses of a case.
struct Stage {
  Stage(const BudgetCase& pair, int orientations) : poses(orientations), smooth_F(orientations) {
    oneapi::tbb::parallel_for(0, orientations, [&](int i) {
      poses[i] = pair.placement(i).pose();
      smooth_F[i] = pair.force_F(i);
    });
    for (std::size_t level = 0; level < pair.levels; ++level)
      levels.push_back(std::make_unique<Solvers>(pair.meshes(level), pair.equal_volume(level)));
  }

  /// Force on E relative to the smooth bodies', along it, and the same as a vector in the frame of E.
  double along(const Eigen::Vector3d& force_Me, int i) const {
    return ordered_dot(ordered_product(poses[i].A, smooth_F[i]), force_Me) / ordered_dot(smooth_F[i], smooth_F[i]);
  }
  double size(const Eigen::Vector3d& force_Me, int i) const { return force_Me.norm() / smooth_F[i].norm(); }

  std::vector<Pose> poses;
  std::vector<Eigen::Vector3d> smooth_F;
  std::vector<std::unique_ptr<Solvers>> levels;
};

Eigen::Vector3d force_Me(const fast::Pairing& pairing, const Pose& pose, fast::Workspace& workspace) {
  return fast::evaluate(pairing, pose, {}, force_only(), workspace).force_Me;
}

double rounding_error(const Solvers& solvers, Scheme scheme, const Pose& pose, fast::Workspace& workspace) {
  const reference::Answer truth = solvers.oracle(scheme).answer(reference::Problem::exact, pose, {}, force_only());
  const double error = (force_Me(solvers.engine(scheme), pose, workspace) - truth.force_Me).norm();
  return error == 0 ? 0 : error / truth.force_scale;
}

/// The greatest coordinate over the mean thickness of the intersection, S / p (DESIGN section 3).
double size_over_thickness(const Solvers& solvers, const Pose& pose) {
  Wanted areas;
  areas.polygons = areas.elements = areas.force = false;
  fast::Workspace workspace;
  const fast::Contact& contact = fast::evaluate(solvers.engine(Scheme::clipped), pose, {}, areas, workspace);
  double size = pose.r.cwiseAbs().maxCoeff();
  for (const Eigen::Vector3d& x : solvers.E.mesh().vertices) size = std::max(size, x.cwiseAbs().maxCoeff());
  for (const Eigen::Vector3d& x : solvers.F.mesh().vertices) size = std::max(size, x.cwiseAbs().maxCoeff());
  return size * std::max(contact.E.area, contact.F.area) / contact.volume;
}

Series empty_row(const BudgetCase& pair, const Stage& stage, const std::string& quantity, Scheme scheme,
                 int orientations) {
  Series row;
  row.quantity = quantity;
  row.scheme = scheme;
  row.orientations = orientations;
  for (std::size_t level = 0; level < pair.levels; ++level) {
    const double edge = pair.edge(level);
    const Solvers& solvers = *stage.levels[level];
    row.levels.push_back({pair.in_words(level), edge, faces_of(solvers.E, solvers.F), pair.width / edge, {}});
  }
  return row;
}

void expect(Series& row, const Expectation& expected) {
  row.levels.back().deviation = expected.finest;
  row.order = expected.order;
  row.reason = expected.reason;
}

}  // namespace

KnownAnswer budget_problem(const BudgetCase& pair, Extent extent) {
  const int orientations = budget_orientations(extent);
  const int orientations_of_oracle = extent == Extent::full ? 4 : 2;
  const auto stage = std::make_shared<const Stage>(pair, orientations);

  KnownAnswer problem;
  problem.id = pair.id;
  problem.title = pair.title;
  problem.problem =
      fmt::format("{}; K = 1 N/m^3, the first body is the master. Mean over {} orientations (rounding: the first {}).",
                  pair.problem, orientations, orientations_of_oracle);
  problem.reference = pair.reference;

  for (const Scheme scheme : kSchemes) {
    Series& row = problem.series.emplace_back(empty_row(pair, *stage, "rounding", scheme, orientations_of_oracle));
    for (std::size_t level = 0; level < pair.levels; ++level)
      row.levels[level].deviation = within(0x1p-50 * size_over_thickness(*stage->levels[level], stage->poses[0]));
    row.reason = "2^-50 S/p: greatest coordinate over mean thickness of the intersection";
    row.measure = [stage, scheme](std::size_t level, int i, fast::Workspace& workspace) {
      return rounding_error(*stage->levels[level], scheme, stage->poses[i], workspace);
    };
  }
  const auto difference_Me = [stage](std::size_t level, int i, fast::Workspace& workspace) -> Eigen::Vector3d {
    const Solvers& solvers = *stage->levels[level];
    return force_Me(solvers.engine(Scheme::barycentric), stage->poses[i], workspace) -
           force_Me(solvers.engine(Scheme::clipped), stage->poses[i], workspace);
  };
  Series& discretisation = problem.series.emplace_back(
      empty_row(pair, *stage, "discretisation: barycentric - clipped", Scheme::barycentric, orientations));
  expect(discretisation, pair.discretisation);
  discretisation.measure = [stage, difference_Me](std::size_t level, int i, fast::Workspace& workspace) {
    return stage->along(difference_Me(level, i, workspace), i);
  };
  Series& one_pose = problem.series.emplace_back(
      empty_row(pair, *stage, "discretisation: length of the difference", Scheme::barycentric, orientations));
  expect(one_pose, pair.one_pose);
  one_pose.measure = [stage, difference_Me](std::size_t level, int i, fast::Workspace& workspace) {
    return stage->size(difference_Me(level, i, workspace), i);
  };
  for (const bool filled : {false, true}) {
    Series& row = problem.series.emplace_back(
        empty_row(pair, *stage, filled ? "geometry: equal volume / smooth" : "geometry: clipped / smooth",
                  Scheme::clipped, orientations));
    row.reference = 1;
    expect(row, filled ? pair.geometry_equal_volume : pair.geometry);
    row.measure = [stage, filled](std::size_t level, int i, fast::Workspace& workspace) {
      const Solvers& solvers = *stage->levels[level];
      const fast::Pairing& pairing = filled ? solvers.filled() : solvers.engine(Scheme::clipped);
      return stage->along(force_Me(pairing, stage->poses[i], workspace), i);
    };
  }
  return problem;
}

const SeriesResult& row_of(const KnownAnswerResult& result, BudgetRow row) {
  return result.series[static_cast<std::size_t>(row)];
}

std::vector<KnownAnswerResult> error_budget(Extent extent, int jobs, KeptValues& kept,
                                            const std::function<void(const std::string&)>& progress) {
  std::vector<KnownAnswerResult> budget;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    for (const auto family : {budget_of_spheres, budget_of_cylinders, budget_of_bubbles})
      for (const BudgetCase& pair : family(extent)) {
        progress(pair.title);
        budget.push_back(run(budget_problem(pair, extent), kept));
      }
  });
  return budget;
}

}  // namespace pcm::compare
