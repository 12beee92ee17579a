// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/known_answers.h"

#include <fmt/core.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcm::compare {
namespace {

/// Relative deviations up to this are rounding and have no order.
constexpr double kRounding = 0x1p-40;

/// One evaluation of a series.
struct Task {
  std::size_t series = 0;
  std::size_t level = 0;
  int orientation = 0;
};

/// The finest levels first: they take the longest.
std::vector<Task> tasks_of(const KnownAnswer& problem) {
  std::vector<Task> tasks;
  for (std::size_t s = 0; s < problem.series.size(); ++s)
    for (std::size_t l = 0; l < problem.series[s].levels.size(); ++l)
      for (int o = 0; o < problem.series[s].orientations; ++o) tasks.push_back({s, l, o});
  std::stable_sort(tasks.begin(), tasks.end(), [&](const Task& a, const Task& b) {
    return problem.series[a.series].levels[a.level].faces > problem.series[b.series].levels[b.level].faces;
  });
  return tasks;
}

LevelResult summarize(const Series& series, const std::vector<double>& values) {
  LevelResult result;
  long double sum = 0, squares = 0;
  result.least = std::numeric_limits<double>::infinity();
  result.greatest = -result.least;
  for (const double value : values) {
    sum += value;
    const auto deviation = static_cast<double>((value - series.reference) / series.scale);
    result.least = std::min(result.least, deviation);
    result.greatest = std::max(result.greatest, deviation);
    squares += static_cast<long double>(deviation) * deviation;
  }
  const long double mean = sum / static_cast<long double>(values.size());
  result.value = static_cast<double>(mean);
  result.deviation = static_cast<double>((mean - series.reference) / series.scale);
  result.rms = static_cast<double>(std::sqrt(squares / static_cast<long double>(values.size())));
  return result;
}

std::string out_of(const Band& band) {
  return fmt::format("out of [{:.3g}, {:.3g}]", band.least, band.greatest);
}

std::vector<std::string> misses(const Series& series, const SeriesResult& result) {
  std::vector<std::string> list;
  for (std::size_t l = 0; l < series.levels.size(); ++l) {
    const Band& band = series.levels[l].deviation;
    if (!band.contains(result.levels[l].deviation))
      list.push_back(
          fmt::format("deviation {:.3g} at {} {}", result.levels[l].deviation, series.levels[l].meshes, out_of(band)));
  }
  if (!series.order) return list;
  if (!result.convergence.order)
    list.push_back("no order: deviations of the last three levels differ in sign");
  else if (!series.order->contains(*result.convergence.order))
    list.push_back(fmt::format("order {:.3f} {}", *result.convergence.order, out_of(*series.order)));
  return list;
}

}  // namespace

std::size_t KnownAnswerResult::missed() const {
  return static_cast<std::size_t>(
      std::count_if(series.begin(), series.end(), [](const SeriesResult& s) { return !s.misses.empty(); }));
}

Convergence convergence(const std::vector<Resolution>& levels, const std::vector<LevelResult>& results, double scale) {
  Convergence c;
  const std::size_t n = levels.size();
  if (n < 3) return c;
  const LevelResult &coarse = results[n - 3], &middle = results[n - 2], &fine = results[n - 1];
  const double log_ratio = std::log(levels[n - 3].edge / levels[n - 1].edge);
  if (!(std::abs(fine.deviation) > kRounding)) return c;
  if (coarse.deviation / fine.deviation > 0) c.order = std::log(coarse.deviation / fine.deviation) / log_ratio;

  const double step = fine.value - middle.value;
  const double ratio_of_steps = (middle.value - coarse.value) / step;
  if (!(ratio_of_steps > 0) || !std::isfinite(ratio_of_steps)) return c;
  const double p = std::log(ratio_of_steps) / (log_ratio / 2);
  if (!(p >= 0.5 && p <= 4)) return c;
  const double correction = step / std::expm1(p * log_ratio / 2);
  c.order_of_values = p;
  c.richardson = fine.value + correction;
  c.grid_convergence_index = 1.25 * std::abs(correction) / scale;
  return c;
}

KnownAnswerResult run(KnownAnswer problem, KeptValues& kept) {
  std::vector<std::vector<std::vector<double>>> values;
  for (const Series& series : problem.series)
    values.emplace_back(series.levels.size(), std::vector<double>(static_cast<std::size_t>(series.orientations)));

  const std::vector<Task> tasks = tasks_of(problem);
  oneapi::tbb::enumerable_thread_specific<fast::Workspace> workspaces;
  oneapi::tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
    const Task& task = tasks[i];
    values[task.series][task.level][static_cast<std::size_t>(task.orientation)] = kept.number(
        fmt::format("{}: {}, series {}, level {}, orientation {}", problem.id, problem.title, task.series, task.level,
                    task.orientation),
        [&] { return problem.series[task.series].measure(task.level, task.orientation, workspaces.local()); });
  });

  KnownAnswerResult result;
  for (std::size_t s = 0; s < problem.series.size(); ++s) {
    const Series& series = problem.series[s];
    SeriesResult& row = result.series.emplace_back();
    for (const std::vector<double>& level : values[s]) row.levels.push_back(summarize(series, level));
    row.convergence = convergence(series.levels, row.levels, series.scale);
    row.misses = misses(series, row);
  }
  result.problem = std::move(problem);
  return result;
}

}  // namespace pcm::compare
