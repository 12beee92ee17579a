// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sched.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// How `pcm bench` measures: one thread on one core, each question asked several times, the least time counts.
namespace pcm::compare {

/// Keeps this thread on the core where it runs. Returns that core as "core 1", or why it isn't kept there.
std::string stay_on_one_core();

/// Lets this thread, and those that it starts, run on any core, as long as this lives.
class OnAnyCore {
 public:
  OnAnyCore();
  ~OnAnyCore();
  OnAnyCore(const OnAnyCore&) = delete;
  OnAnyCore& operator=(const OnAnyCore&) = delete;

 private:
  cpu_set_t before_;
};

/// Microseconds that the work took: the thread's processor time where that is half a millisecond and more, which leaves
/// out when others had the core; else the wall clock, which is read faster.
double time_us(const std::function<void()>& work);

/// How many times as fast `other` is: each asked in turn, once without measuring and then five times, the least time of
/// each by the wall clock, as both may have several threads.
double times_as_fast(const std::function<void()>& one, const std::function<void()>& other);

/// Times of one question.
struct Timing {
  double preparation_us = 0;
  double query_us = 0;
};

/// Asks once without measuring, which warms the caches, then up to five times, and no more once 50 ms are spent; the
/// least time of each counts: whatever disturbs a machine adds time.
Timing least_time(const std::function<void()>& prepare, const std::function<void()>& query);

/// The least of up to five times, no more asked for once 50 ms are spent, of work that is done anew each time: the
/// first counts too.
double least_time_us(const std::function<void()>& work);

/// The value below which this part of the values lies, by the nearest rank; 0 where there are none.
double quantile(std::vector<double> values, double part);

/// Exponent p of y ~ x^p, by least squares of log y over log x. Needs two different x; all positive.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

/// What the figures were measured on.
struct Machine {
  std::string processor;
  std::string compiler;
  std::string flags;
  std::string core;  ///< what `stay_on_one_core` said
};
Machine this_machine(std::string core);
std::string describe(const Machine& machine);

}  // namespace pcm::compare
