// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The stabilised explicit method RKC (chebyshev_stages.h has the paper).
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simulate/integrators/chebyshev_stages.h"
#include "simulate/integrators/one_step.h"
#include "simulate/integrators/spectral_radius.h"

namespace pcm::simulate {

namespace {

/// As many stages as the size of the step times the spectral radius takes to be stable.
class RungeKuttaChebyshev final : public OneStepFormula {
 public:
  RungeKuttaChebyshev(CountedEquation& equation, const StepControl& control)
      : equation_(equation), radius_(control.absolute), most_stages_(most_stages(control.relative)) {}

  int order() const override { return 2; }
  int error_power() const override { return 3; }
  Answer look(const SolutionPoint& begin) override { return radius_.estimate(equation_, begin); }
  int steps_between_looks() const override { return 25; }  // as in the paper
  double greatest_size() const override { return chebyshev_limit(most_stages_) / radius_.value(); }

  Answer step(const SolutionPoint& begin, double size, SolutionPoint& end, Eigen::VectorXd& error) override {
    const int number = std::min(most_stages_, chebyshev_stages_for(size * radius_.value()));
    const std::vector<ChebyshevStage> stages = chebyshev_stages(number);
    Eigen::VectorXd before = begin.y, y = begin.y + stages[0].c * size * begin.dydt, dydt(y.size());
    for (std::size_t j = 1; j < stages.size(); ++j) {
      const Answer answer = equation_.derivative(begin.t + stages[j - 1].c * size, y.data(), dydt.data());
      if (answer != Answer::given) return answer;
      const ChebyshevStage& stage = stages[j];
      Eigen::VectorXd next = (1 - stage.mu - stage.nu) * begin.y + stage.mu * y + stage.nu * before +
                             size * (stage.mu_slope * dydt + stage.gamma_slope * begin.dydt);
      before = std::exchange(y, std::move(next));
    }
    end.y = y;
    const Answer answer = equation_.derivative(end.t, end.y.data(), end.dydt.data());
    // To leading order y''' h^3 / 15, which the error is for many stages.
    error = 0.8 * (begin.y - end.y) + 0.4 * size * (begin.dydt + end.dydt);
    return answer;
  }

 private:
  /// Rounding grows with the square of the stages, some 10 s^2 eps, and is to stay below the tolerance.
  static int most_stages(double relative) {
    const double most = std::sqrt(relative / (10 * std::numeric_limits<double>::epsilon()));
    return static_cast<int>(std::clamp(most, 2.0, 1e6));
  }

  CountedEquation& equation_;
  SpectralRadius radius_;
  int most_stages_;
};

}  // namespace

std::unique_ptr<Solver> make_rkc(CountedEquation& equation, const StepControl& control, double t,
                                 const Eigen::VectorXd& y) {
  return make_one_step_solver(std::make_unique<RungeKuttaChebyshev>(equation, control), equation, control, t, y);
}

}  // namespace pcm::simulate
