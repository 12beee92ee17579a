// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/work_precision.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "compare/random/random.h"
#include "compare/verify/routes/wanted_presets.h"

namespace pcm::compare {
namespace {

constexpr double kTooLong_us = 1e3 * kLongestEvaluation_ms;

constexpr Wanted kForceAndBound{.polygons = false, .areas = false, .force = true, .elements = false, .bound = true};

/// The exact integral over one pair of meshes at every pose.
struct Integral {
  std::vector<Eigen::Vector3d> force_Me;
  std::vector<double> bound;  ///< on the length of the error of that force, N
};

/// The meshes of one level, as they are or at equal volume; the engine's surfaces are prepared once for all.
struct Meshes {
  explicit Meshes(const BudgetMeshes& bodies) : E(bodies.E), F(bodies.F) {}

  fast::Pairing pairing(Scheme scheme) const { return {E, F, stiffness(1), Mode::E, scheme}; }

  fast::Surface E, F;
};

Integral integral_over(const Meshes& meshes, const std::vector<Pose>& poses) {
  const fast::Pairing clipped = meshes.pairing(Scheme::clipped);
  fast::Workspace workspace;
  Integral integral;
  for (const Pose& pose : poses) {
    const fast::Contact& contact = fast::evaluate(clipped, pose, {}, kForceAndBound, workspace);
    integral.force_Me.push_back(contact.force_Me);
    integral.bound.push_back(contact.bound->force_Me.norm());
  }
  return integral;
}

/// Force alone.
using Evaluate = std::function<const fast::Contact&(const Pose&)>;

Evaluate evaluation(const Method& method, const Meshes& meshes) {
  if (method.engine == Engine::fast)
    return [pairing = meshes.pairing(method.scheme),
            workspace = std::make_shared<fast::Workspace>()](const Pose& pose) -> const fast::Contact& {
      return fast::evaluate(pairing, pose, {}, kForceOnly, *workspace);
    };
  return [tested = std::shared_ptr<const TestedEngine>(make_tested_engine(
              method.engine, meshes.E.mesh(), meshes.F.mesh(), stiffness(1), Mode::E, method.scheme)),
          workspace = std::make_shared<TestedEngineWorkspace>()](const Pose& pose) -> const fast::Contact& {
    return tested->evaluate(pose, {}, kForceOnly, *workspace);
  };
}

/// A method at work on the meshes of one level.
struct Runner {
  WorkPrecisionCurve* curve;
  Evaluate evaluate;
  std::vector<double> times_us = {};
  double smooth_squares = 0, integral_squares = 0;
};

void measure(Runner& runner, const WorkPrecisionProblem& problem, const Integral& integral, std::size_t i) {
  const Pose& pose = problem.poses[i];
  runner.times_us.push_back(least_time([] {}, [&] { runner.evaluate(pose); }).query_us);
  const Eigen::Vector3d force = runner.evaluate(pose).force_Me;
  const bool is_the_integral = runner.curve->method.scheme == Scheme::clipped;
  const double off = is_the_integral ? integral.bound[i] : (force - integral.force_Me[i]).norm();
  runner.integral_squares += std::pow(off / integral.force_Me[i].norm(), 2);
  runner.smooth_squares += ((force - problem.smooth_Me[i]) / problem.smooth_Me[i].norm()).squaredNorm();
}

/// All methods on the meshes of one level, as they are or at equal volume.
void measure_level(const WorkPrecisionProblem& problem, std::size_t level, bool equal_volume,
                   std::vector<WorkPrecisionCurve>& curves) {
  const Meshes meshes(equal_volume ? problem.pair.equal_volume(level) : problem.pair.meshes(level));
  std::vector<Runner> runners;
  for (WorkPrecisionCurve& curve : curves) {
    const Method& method = curve.method;
    if (method.equal_volume != equal_volume || curve.stopped_by_ms) continue;
    Runner runner{&curve, evaluation(method, meshes)};
    const double once_us = time_us([&] { runner.evaluate(problem.poses[0]); });
    // Every curve has its first point.
    if (once_us > kTooLong_us && !curve.points.empty())
      curve.stopped_by_ms = 1e-3 * once_us;
    else
      runners.push_back(std::move(runner));
  }
  if (runners.empty()) return;
  const Integral integral = integral_over(meshes, problem.poses);
  for (std::size_t i = 0; i < problem.poses.size(); ++i)
    for (Runner& runner : runners) measure(runner, problem, integral, i);
  const auto poses = static_cast<double>(problem.poses.size());
  for (const Runner& runner : runners)
    runner.curve->points.push_back({faces_of(meshes.E, meshes.F), problem.pair.edge(level),
                                    quantile(runner.times_us, 0.5), std::sqrt(runner.smooth_squares / poses),
                                    std::sqrt(runner.integral_squares / poses)});
}

/// Time and error by increasing time, as logarithms.
std::vector<std::array<double, 2>> by_time(const WorkPrecisionCurve& curve, ErrorAgainst reference) {
  std::vector<std::array<double, 2>> points;
  for (const WorkPrecisionPoint& point : curve.points)
    points.push_back({std::log(point.median_us), std::log(point.error(reference))});
  std::sort(points.begin(), points.end());
  return points;
}

/// Between two points a straight line of the logarithms; t must lie in the range of the points.
double error_at(const std::vector<std::array<double, 2>>& points, double t) {
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto [t0, e0] = points[k - 1];
    const auto [t1, e1] = points[k];
    if (t <= t1 && t1 > t0) return e0 + (e1 - e0) * (t - t0) / (t1 - t0);
  }
  return points.back()[1];
}

}  // namespace

const std::vector<Method>& work_precision_methods() {
  static const std::vector<Method> methods{
      {"pcm, barycentric scheme", Engine::fast, Scheme::barycentric, false},
      {"pcm, clipped scheme", Engine::fast, Scheme::clipped, false},
      {"algorithm as published in 2003", Engine::published_2003, Scheme::barycentric, false},
      {"pcm, barycentric, equal volume", Engine::fast, Scheme::barycentric, true},
      {"pcm, clipped, equal volume", Engine::fast, Scheme::clipped, true},
      {"variant published in 2023", Engine::published_2023, Scheme::barycentric, false},
  };
  return methods;
}

std::optional<double> WorkPrecisionCurve::order(ErrorAgainst reference) const {
  if (points.size() < 2) return {};
  std::vector<double> x, y;
  for (std::size_t k = points.size() - std::min<std::size_t>(3, points.size()); k < points.size(); ++k) {
    x.push_back(points[k].edge);
    y.push_back(points[k].error(reference));
  }
  return fitted_exponent(x, y);
}

const WorkPrecisionCurve& WorkPrecisionResult::curve(Scheme scheme, bool equal_volume) const {
  return *std::find_if(curves.begin(), curves.end(), [&](const WorkPrecisionCurve& c) {
    return c.method.engine == Engine::fast && c.method.scheme == scheme && c.method.equal_volume == equal_volume;
  });
}

std::optional<EqualTime> errors_at_equal_time(const WorkPrecisionCurve& over, const WorkPrecisionCurve& under,
                                              ErrorAgainst reference) {
  const auto a = by_time(over, reference), b = by_time(under, reference);
  if (a.empty() || b.empty()) return {};
  const double from = std::max(a.front()[0], b.front()[0]), to = std::min(a.back()[0], b.back()[0]);
  if (from > to) return {};
  // The quotient of two powers is monotonic between the points of both curves.
  std::vector<double> times{from, to}, ratios;
  for (const auto* points : {&a, &b})
    for (const auto& [t, e] : *points)
      if (t > from && t < to) times.push_back(t);
  for (const double t : times) ratios.push_back(std::exp(error_at(a, t) - error_at(b, t)));
  const auto [least, greatest] = std::minmax_element(ratios.begin(), ratios.end());
  return EqualTime{std::exp(from), std::exp(to), *least, *greatest};
}

std::vector<WorkPrecisionProblem> work_precision_problems(Extent extent) {
  std::vector<BudgetCase> cases = budget_of_spheres(extent);
  for (BudgetCase& bubbles : budget_of_bubbles(extent)) cases.push_back(std::move(bubbles));
  std::vector<WorkPrecisionProblem> problems;
  for (BudgetCase& pair : cases) {
    if (pair.id == "plane-on-sphere") continue;  // the same bodies once more
    const int orientations = budget_orientations(extent);
    WorkPrecisionProblem& problem = problems.emplace_back();
    problem.poses.resize(static_cast<std::size_t>(orientations));
    problem.smooth_Me.resize(problem.poses.size());
    oneapi::tbb::parallel_for(0, orientations, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      problem.poses[k] = pair.placement(i).pose();
      problem.smooth_Me[k] = ordered_product(problem.poses[k].A, pair.force_F(i));
    });
    problem.pair = std::move(pair);
  }
  return problems;
}

WorkPrecisionResult run_work_precision(const WorkPrecisionProblem& problem,
                                       const std::function<void(const std::string&)>& progress) {
  const BudgetCase& pair = problem.pair;
  WorkPrecisionResult result{pair.id, pair.title, pair.problem, pair.reference, problem.poses.size(), {}};
  for (const Method& method : work_precision_methods()) result.curves.push_back({method, {}, {}});
  for (std::size_t level = 0; level < pair.levels; ++level)
    for (const bool equal_volume : {false, true}) {
      progress(fmt::format("{}: {}", pair.title, pair.in_words(level)));
      measure_level(problem, level, equal_volume, result.curves);
    }
  return result;
}

}  // namespace pcm::compare
