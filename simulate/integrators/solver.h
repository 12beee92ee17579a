// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>

#include "simulate/integrators/counted_equation.h"
#include "simulate/integrators/integrator.h"

namespace pcm::simulate {

/// How a solver's step ended.
enum class Outcome : std::uint8_t {
  accepted,
  error_test,           ///< failed too often, or at the least step
  nonlinear,            ///< the same
  refused,              ///< derivative or Jacobian could not be had, too often or at the least step
  tolerances_too_fine,  ///< finer than rounding
  other,                ///< `Solver::message` says what
};

/// A step is tried again at most this often for one cause. A kink of the contact force takes about ten tries; each at
/// least halves the step, so that a hundred mean that no size works.
inline constexpr int kMostFailuresInAStep = 100;

/// One integrator from one start on; made anew at each start, so that nothing of the past is in it.
/// Exceptions of the equation wait in it.
class Solver {
 public:
  struct Counts {  ///< since the start
    std::int64_t error_test_failures = 0;
    std::int64_t solve_failures = 0;  ///< tries given up by the nonlinear solver, refusals included
    std::int64_t nonlinear_iterations = 0;
  };

  virtual ~Solver() = default;
  /// Moves t and y if accepted.
  virtual Outcome step(double t_end, double least_step, double& t, Eigen::VectorXd& y) = 0;
  virtual bool interpolate(double t, Eigen::VectorXd& y) = 0;  ///< within the last step
  virtual Counts counts() const = 0;
  virtual int order() const = 0;            ///< of the last step
  virtual std::string message() const = 0;  ///< the library's last error, empty if there was none
};

std::unique_ptr<Solver> make_cvode(Method method, CountedEquation& equation, const StepControl& control, double t,
                                   const Eigen::VectorXd& y);
std::unique_ptr<Solver> make_ida(CountedEquation& equation, const StepControl& control, double t,
                                 const Eigen::VectorXd& y);
std::unique_ptr<Solver> make_arkode(Method method, CountedEquation& equation, const StepControl& control, double t,
                                    const Eigen::VectorXd& y);
std::unique_ptr<Solver> make_rkc(CountedEquation& equation, const StepControl& control, double t,
                                 const Eigen::VectorXd& y);
std::unique_ptr<Solver> make_runge_kutta_merson(CountedEquation& equation, const StepControl& control, double t,
                                                const Eigen::VectorXd& y);

}  // namespace pcm::simulate
