// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/dormand_prince_interpolant.h"

namespace pcm::simulate {

void DormandPrinceInterpolant::add_slope(const Eigen::Ref<const Eigen::VectorXd>& dydt) {
  if (first_.size() == 0) {
    first_ = dydt;
    return;
  }
  last_[next_] = dydt;
  next_ = (next_ + 1) % kStages;
}

void DormandPrinceInterpolant::accept(double size, const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
  const auto stage = [&](std::size_t number) -> const Eigen::VectorXd& {
    return number == 1 ? first_ : last_[(next_ + number - 2) % kStages];
  };
  const Eigen::VectorXd change = after - before;
  const Eigen::VectorXd bend = size * stage(1) - change;
  terms_[0] = before;
  terms_[1] = change;
  terms_[2] = bend;
  terms_[3] = change - size * stage(7) - bend;
  terms_[4] = size * (-12715105075. / 11282082432. * stage(1) + 87487479700. / 32700410799. * stage(3) -
                      10690763975. / 1880347072. * stage(4) + 701980252875. / 199316789632. * stage(5) -
                      1453857185. / 822651844. * stage(6) + 69997945. / 29380423. * stage(7));
  first_ = stage(7);
}

Eigen::VectorXd DormandPrinceInterpolant::state_at(double part) const {
  const double rest = 1 - part;
  return terms_[0] + part * (terms_[1] + rest * (terms_[2] + part * (terms_[3] + rest * terms_[4])));
}

}  // namespace pcm::simulate
