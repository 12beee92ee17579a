// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "simulate/integrators/counted_equation.h"
#include "simulate/integrators/solution_point.h"
#include "simulate/integrators/solver.h"

namespace pcm::simulate {

/// Goes from one point of the solution to the next and estimates the error, knowing nothing of steps before. Answers
/// other than `given` are those of the equation.
class OneStepFormula {
 public:
  virtual ~OneStepFormula() = default;
  virtual int order() const = 0;
  virtual int error_power() const = 0;  ///< the error estimate falls with this power of the size

  /// Looks at the equation around `begin`, where steps are to begin: how stiff it is. `try_smaller` where that can't be
  /// had; what was seen before then holds on.
  virtual Answer look(const SolutionPoint& begin) = 0;
  virtual int steps_between_looks() const = 0;  ///< at most: a step that fails is a reason to look anew
  virtual double greatest_size() const = 0;     ///< that the formula can do, by what was seen

  /// Fills `end`, which has its t, and the error estimate.
  virtual Answer step(const SolutionPoint& begin, double size, SolutionPoint& end, Eigen::VectorXd& error) = 0;
};

/// Steps by such a formula, their size controlled; within them the cubic through states and slopes at both ends.
std::unique_ptr<Solver> make_one_step_solver(std::unique_ptr<OneStepFormula> formula, CountedEquation& equation,
                                             const StepControl& control, double t, const Eigen::VectorXd& y);

}  // namespace pcm::simulate
