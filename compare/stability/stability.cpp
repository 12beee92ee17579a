// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/stability.h"

#include <fmt/core.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "compare/stability/feature_pose.h"
#include "compare/stability/kept_figures.h"

namespace pcm::compare::stability {
namespace {

/// Where random numbers are told from those of the strata, of which there are fewer.
constexpr std::uint64_t kFirstStream = 1000;

std::int64_t poses_of(Extent extent) {
  return extent == Extent::full ? 40 : 4;
}

double quotient(double a, double b) {
  return a == 0 ? 0 : a / b;
}

}  // namespace

Spread spread_of(std::vector<double> numbers) {
  if (numbers.empty()) return {};
  std::sort(numbers.begin(), numbers.end());
  const std::size_t half = numbers.size() / 2;
  const double median = numbers.size() % 2 == 1 ? numbers[half] : numbers[half - 1] / 2 + numbers[half] / 2;
  return {median, numbers.back()};
}

namespace {

GroupFigures figures_of(const std::vector<const PoseFigures*>& poses) {
  GroupFigures figures;
  figures.poses = static_cast<std::int64_t>(poses.size());
  const auto spread = [&](const auto& number_of) {
    std::vector<double> numbers;
    for (const PoseFigures* pose : poses) numbers.push_back(number_of(*pose));
    return spread_of(std::move(numbers));
  };
  for (std::size_t k = 0; k < kQuantities.size(); ++k)
    figures.quantities[k] = {
        spread([&](const PoseFigures& p) { return p.error[k]; }),
        spread([&](const PoseFigures& p) { return p.of_vertices[k]; }),
        spread([&](const PoseFigures& p) { return p.bound[k]; }),
        spread([&](const PoseFigures& p) { return p.condition[k]; }),
        spread([&](const PoseFigures& p) { return quotient(p.error[k], p.condition[k]); }),
        spread([&](const PoseFigures& p) { return quotient(p.bound[k], p.error[k]); }),
        spread([&](const PoseFigures& p) { return quotient(p.bound[k], p.condition[k]); }),
    };
  for (std::size_t a = 0; a < kPublished.size(); ++a) {
    GroupFigures::OfPublished& algorithm = figures.published[a];
    std::array<std::vector<double>, kQuantities.size()> errors;
    for (const PoseFigures* pose : poses) {
      const PublishedFigures& published = pose->published[a];
      algorithm.unanswered += !published.answered;
      algorithm.other_elements += published.answered && !published.same_elements;
      if (!published.answered) continue;
      for (std::size_t k = 0; k < kQuantities.size(); ++k) errors[k].push_back(published.error[k]);
    }
    for (std::size_t k = 0; k < kQuantities.size(); ++k) algorithm.error[k] = spread_of(std::move(errors[k]));
  }
  return figures;
}

}  // namespace

PointFigures figures_of(const SweepPoint& point, Scheme scheme, const std::vector<PoseFigures>& poses) {
  PointFigures figures;
  figures.point = point;
  figures.scheme = scheme;
  figures.poses = static_cast<std::int64_t>(poses.size());
  std::vector<const PoseFigures*> settled, flipped;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PoseFigures& pose = poses[i];
    if (!pose.outside_bound.empty()) figures.outside_bound.push_back(fmt::format("pose {}: {}", i, pose.outside_bound));
    figures.unbounded += pose.unbounded;
    if (!pose.answered)
      ++figures.unanswered;
    else if (!pose.carries_force)
      ++figures.without_force;
    else
      (pose.flipped ? flipped : settled).push_back(&pose);
  }
  figures.settled = figures_of(settled);
  figures.flipped = figures_of(flipped);
  return figures;
}

std::array<std::vector<PoseFigures>, kSchemes.size()> figures_of_poses(const SweepPoint& point, std::int64_t poses,
                                                                       std::uint64_t seed, const AskEngine& ask) {
  const SweptBodies bodies = bodies_at(point);
  const Contestants contestants(scaled(bodies.E, bodies.scale), scaled(bodies.F, bodies.scale));
  std::array<std::vector<PoseFigures>, kSchemes.size()> figures;
  for (std::vector<PoseFigures>& of_scheme : figures) of_scheme.resize(static_cast<std::size_t>(poses));
  oneapi::tbb::enumerable_thread_specific<FiguresWorkspace> workspaces;
  oneapi::tbb::parallel_for(std::int64_t{0}, poses, [&](std::int64_t i) {
    Pose pose = draw_feature_pose(bodies, PoseRandom(seed, kFirstStream + static_cast<std::uint64_t>(point.sweep), 0,
                                                     static_cast<std::uint64_t>(i)));
    pose.r *= bodies.scale;
    for (std::size_t s = 0; s < kSchemes.size(); ++s)
      figures[s][static_cast<std::size_t>(i)] = figures_at(contestants, pose, kSchemes[s], ask, workspaces.local());
  });
  return figures;
}

std::vector<PointFigures> figures_at_point(const SweepPoint& point, std::int64_t poses, std::uint64_t seed,
                                           const AskEngine& ask, KeptValues& kept) {
  const nlohmann::ordered_json found =
      kept.get(fmt::format("{} {}, seed {}, {} poses", name(point.sweep), point.in_words(), seed, poses), [&] {
        nlohmann::ordered_json schemes = nlohmann::ordered_json::array();
        for (const std::vector<PoseFigures>& figures : figures_of_poses(point, poses, seed, ask))
          schemes.push_back(kept_figures(figures));
        return schemes;
      });
  std::vector<PointFigures> both;
  for (std::size_t s = 0; s < kSchemes.size(); ++s)
    both.push_back(figures_of(point, kSchemes[s], figures_from(found.at(s))));
  return both;
}

bool StabilityReport::met() const {
  return std::all_of(points.begin(), points.end(),
                     [](const PointFigures& point) { return point.outside_bound.empty() && point.unanswered == 0; });
}

StabilityReport run_stability(Extent extent, std::uint64_t seed, int jobs, KeptValues& kept,
                              const std::function<void(const std::string&)>& progress, const AskEngine& ask) {
  StabilityReport report;
  report.seed = seed;
  report.poses = poses_of(extent);
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    for (const Sweep sweep : kSweeps)
      for (const SweepPoint& point : sweep_points(sweep, extent)) {
        progress(fmt::format("{} {}", name(sweep), point.in_words()));
        for (PointFigures& figures : figures_at_point(point, report.poses, seed, ask, kept))
          report.points.push_back(std::move(figures));
      }
  });
  return report;
}

bool told(Scheme scheme, Quantity quantity) {
  return scheme == Scheme::clipped || quantity != Quantity::area;
}

std::vector<Flatness> flatness(const StabilityReport& report) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Flatness> all;
  for (const Sweep sweep : kSweeps)
    for (const Scheme scheme : kSchemes)
      for (const Quantity quantity : kQuantities) {
        if (!told(scheme, quantity)) continue;
        Flatness flat{sweep, scheme, quantity, kInfinity, 0, kInfinity, 0, 0, kInfinity, 0};
        bool any = false;
        for (const PointFigures& figures : report.points) {
          if (figures.point.sweep != sweep || figures.scheme != scheme || figures.settled.poses == 0) continue;
          any = true;
          const GroupFigures::OfQuantity& of = figures.settled.of(quantity);
          const auto widen = [](double& least, double& greatest, double x) {
            least = std::min(least, x);
            greatest = std::max(greatest, x);
          };
          widen(flat.least_condition, flat.greatest_condition, of.condition.median);
          widen(flat.least, flat.greatest, of.error_over_condition.median);
          widen(flat.least_bound, flat.greatest_bound, of.bound_over_condition.median);
          flat.greatest_of_all = std::max(flat.greatest_of_all, of.error_over_condition.greatest);
        }
        if (any) all.push_back(flat);
      }
  return all;
}

}  // namespace pcm::compare::stability
