// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/one_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simulate/integrators/step_size.h"

namespace pcm::simulate {

namespace {

class OneStepSolver final : public Solver {
 public:
  OneStepSolver(std::unique_ptr<OneStepFormula> formula, CountedEquation& equation, const StepControl& control,
                double t, const Eigen::VectorXd& y)
      : formula_(std::move(formula)),
        equation_(equation),
        control_(control),
        sizes_(formula_->error_power()),
        end_{t, y, Eigen::VectorXd(y.size())} {}

  Outcome step(double t_end, double least_step, double& t, Eigen::VectorXd& y) override {
    if (begin_.y.size() == 0) {
      const Answer answer = start(t_end);
      if (answer != Answer::given) return outcome_of(answer);
    }
    const Eigen::VectorXd rounding = std::numeric_limits<double>::epsilon() * end_.y;
    if (in_tolerances(rounding, end_.y) > 1) return Outcome::tolerances_too_fine;
    Outcome outcome = Outcome::accepted;
    bool looked = false;
    for (int tries = 0; tries <= kMostFailuresInAStep; ++tries) {
      equation_.next_try();
      const bool looks_anew = tries > 0 || steps_since_look_ == formula_->steps_between_looks();
      if (looks_anew && !looked) {
        if (formula_->look(end_) == Answer::stop) return Outcome::other;
        looked = true;
        steps_since_look_ = 0;
      }
      const double size = next_size(t_end - end_.t, least_step);
      outcome = try_step(t_end, size);
      if (outcome == Outcome::accepted) {
        t = end_.t;
        y = end_.y;
        return outcome;
      }
      if (outcome == Outcome::other || size <= least_step) return outcome;
      wanted_ = std::max(wanted_, least_step);
    }
    return outcome;
  }

  bool interpolate(double t, Eigen::VectorXd& y) override {
    if (begin_.y.size() == 0) return false;
    y = cubic_between(begin_, end_, t);
    return true;
  }

  Counts counts() const override { return {error_test_failures_, 0, 0}; }
  int order() const override { return formula_->order(); }
  std::string message() const override { return {}; }

 private:
  static Outcome outcome_of(Answer answer) { return answer == Answer::try_smaller ? Outcome::refused : Outcome::other; }

  double in_tolerances(const Eigen::VectorXd& error, const Eigen::VectorXd& y) const {
    return error_in_tolerances(error, y, control_.relative, control_.absolute);
  }

  /// Slope, look and first size.
  Answer start(double t_end) {
    Answer answer = equation_.derivative(end_.t, end_.y.data(), end_.dydt.data());
    if (answer != Answer::given) return answer;
    answer = formula_->look(end_);
    if (answer != Answer::given) return answer;
    begin_ = end_;
    return find_first_size(t_end);
  }

  /// That at which Euler's method would err by a tenth of the tolerance, from the change of the slope along one of its
  /// steps that moves the state by one tolerance. Higher orders err by less.
  Answer find_first_size(double t_end) {
    const double greatest = std::min(control_.greatest_step, t_end - end_.t);
    const double probe = std::min(greatest, 1 / in_tolerances(end_.dydt, end_.y));
    const Eigen::VectorXd moved = end_.y + probe * end_.dydt;
    Eigen::VectorXd slope(moved.size());
    wanted_ = std::min(probe, 1e-3 * greatest);
    const Answer answer = equation_.derivative_beside(end_.t + probe, moved, slope);
    if (answer == Answer::given) {
      const double bend = in_tolerances(slope - end_.dydt, end_.y) / probe;  // tolerances a second squared
      wanted_ = std::min(greatest, std::sqrt(0.2 / bend));
    }
    return answer == Answer::stop ? answer : Answer::given;
  }

  /// Neither beyond the end nor so near to it that a sliver would remain.
  double next_size(double rest, double least_step) const {
    const double size = std::max(least_step, std::min({wanted_, control_.greatest_step, formula_->greatest_size()}));
    if (size >= rest) return rest;
    return 2 * size > rest ? rest / 2 : size;
  }

  Outcome try_step(double t_end, double size) {
    SolutionPoint next{size == t_end - end_.t ? t_end : end_.t + size, Eigen::VectorXd(end_.y.size()),
                       Eigen::VectorXd(end_.y.size())};
    Eigen::VectorXd error(end_.y.size());
    const Answer answer = formula_->step(end_, size, next, error);
    if (answer != Answer::given) {
      wanted_ = size * sizes_.after_refused();
      return outcome_of(answer);
    }
    const double in_tolerance = in_tolerances(error, end_.y.cwiseAbs().cwiseMax(next.y.cwiseAbs()));
    if (!(in_tolerance <= 1)) {
      ++error_test_failures_;
      wanted_ = size * sizes_.after_rejected(in_tolerance);
      return Outcome::error_test;
    }
    const double grown = size * sizes_.after_accepted(size, in_tolerance);
    wanted_ = size < wanted_ ? std::max(wanted_, grown) : grown;
    begin_ = std::exchange(end_, std::move(next));
    ++steps_since_look_;
    return Outcome::accepted;
  }

  std::unique_ptr<OneStepFormula> formula_;
  CountedEquation& equation_;
  const StepControl& control_;
  StepSizeControl sizes_;
  SolutionPoint begin_, end_;  ///< of the last step; `begin_` is empty before the first
  double wanted_ = 0;          ///< size of the next step
  int steps_since_look_ = 0;
  std::int64_t error_test_failures_ = 0;
};

}  // namespace

std::unique_ptr<Solver> make_one_step_solver(std::unique_ptr<OneStepFormula> formula, CountedEquation& equation,
                                             const StepControl& control, double t, const Eigen::VectorXd& y) {
  return std::make_unique<OneStepSolver>(std::move(formula), equation, control, t, y);
}

}  // namespace pcm::simulate
