// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/timing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>
#include <utility>

#include "compare/io/provenance/program_provenance.h"

namespace pcm::compare {
namespace {

using Clock = std::chrono::steady_clock;

/// How often a question is asked at most, and after how long no more.
constexpr int kMeasured = 5;
constexpr std::chrono::milliseconds kEnough(50);

double microseconds(Clock::duration time) {
  return std::chrono::duration<double, std::micro>(time).count();
}

/// What this thread has been given of its processor so far.
double processor_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::string stay_on_one_core() {
  const int core = sched_getcpu();
  cpu_set_t only;
  CPU_ZERO(&only);
  if (core >= 0) CPU_SET(static_cast<std::size_t>(core), &only);
  if (core < 0 || sched_setaffinity(0, sizeof only, &only) != 0)
    return fmt::format("not kept on one core ({})", std::strerror(errno));
  return fmt::format("core {}", core);
}

OnAnyCore::OnAnyCore() {
  CPU_ZERO(&before_);
  sched_getaffinity(0, sizeof before_, &before_);
  cpu_set_t all;
  CPU_ZERO(&all);
  for (std::size_t core = 0; core < CPU_SETSIZE; ++core) CPU_SET(core, &all);
  sched_setaffinity(0, sizeof all, &all);
}

OnAnyCore::~OnAnyCore() {
  sched_setaffinity(0, sizeof before_, &before_);
}

double times_as_fast(const std::function<void()>& one, const std::function<void()>& other) {
  const auto wall_us = [](const std::function<void()>& work) {
    const Clock::time_point before = Clock::now();
    work();
    return microseconds(Clock::now() - before);
  };
  double least_of_one = std::numeric_limits<double>::infinity(), least_of_other = least_of_one;
  for (int k = 0; k <= kMeasured; ++k) {
    const double us_of_one = wall_us(one), us_of_other = wall_us(other);
    if (k == 0) continue;
    least_of_one = std::min(least_of_one, us_of_one);
    least_of_other = std::min(least_of_other, us_of_other);
  }
  return least_of_one / least_of_other;
}

double time_us(const std::function<void()>& work) {
  constexpr double kLong = 500;
  const double processor_before = processor_us();
  const Clock::time_point before = Clock::now();
  work();
  const double wall = microseconds(Clock::now() - before);
  return wall < kLong ? wall : processor_us() - processor_before;
}

Timing least_time(const std::function<void()>& prepare, const std::function<void()>& query) {
  const Clock::time_point start = Clock::now();
  Timing least;
  for (int k = 0; k <= kMeasured; ++k) {
    const double preparation = time_us(prepare);
    const Timing measured{preparation, time_us(query)};
    if (k == 1) least = measured;
    if (k > 1) {
      least.preparation_us = std::min(least.preparation_us, measured.preparation_us);
      least.query_us = std::min(least.query_us, measured.query_us);
    }
    if (k > 0 && Clock::now() - start > kEnough) break;
  }
  return least;
}

double least_time_us(const std::function<void()>& work) {
  const Clock::time_point start = Clock::now();
  double least = time_us(work);
  for (int k = 1; k < kMeasured && Clock::now() - start <= kEnough; ++k) least = std::min(least, time_us(work));
  return least;
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(values.size())));
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, values.size()) - 1);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  assert(x.size() == y.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / static_cast<double>(x.size());
    mean_y += std::log(y[i]) / static_cast<double>(x.size());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    xy += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
  }
  return xy / xx;
}

Machine this_machine(std::string core) {
  const ProgramProvenance program = this_program();
  return {program.processor, program.compiler, program.flags, std::move(core)};
}

std::string describe(const Machine& machine) {
  return fmt::format("{}, {}; {}, {}", machine.processor, machine.core, machine.compiler, machine.flags);
}

}  // namespace pcm::compare
