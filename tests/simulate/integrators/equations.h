// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "simulate/integrators/make_integrator.h"

namespace pcm::simulate {

inline constexpr std::array kMethods = {Method::adams,
                                        Method::bdf,
                                        Method::ida,
                                        Method::dormand_prince,
                                        Method::esdirk,
                                        Method::rkc,
                                        Method::runge_kutta_merson};
inline constexpr std::array kStiffMethods = {Method::bdf, Method::ida, Method::esdirk};

inline bool is_explicit_runge_kutta(Method method) {
  return method == Method::dormand_prince || method == Method::rkc || method == Method::runge_kutta_merson;
}

/// For tests that run once a method.
class EachMethod : public testing::TestWithParam<Method> {};
inline std::string test_name(const testing::TestParamInfo<Method>& info) {
  constexpr std::array kNames = {"adams", "bdf", "ida", "dormand_prince", "esdirk", "rkc", "runge_kutta_merson"};
  return kNames.at(static_cast<std::size_t>(info.param));
}

inline Eigen::VectorXd vector(std::initializer_list<double> values) {
  Eigen::VectorXd answer(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), answer.begin());
  return answer;
}

/// An equation that is available everywhere, from dydt = f(t, y).
template <typename Function>
DifferentialEquation everywhere(Eigen::Index size, Function f) {
  return {size,
          [f](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
            dydt = f(t, y);
            return Evaluation::available;
          },
          {}};
}

/// y = e^-t.
inline DifferentialEquation decay() {
  return everywhere(1, [](double, const Eigen::VectorXd& y) -> Eigen::VectorXd { return -y; });
}

/// y = (sin t, cos t) from (0, 1) on.
inline DifferentialEquation oscillator() {
  return everywhere(2, [](double, const Eigen::VectorXd& y) { return vector({y[1], -y[0]}); });
}

inline StepControl tolerance(double both, Eigen::Index size) {
  StepControl control;
  control.relative = both;
  control.absolute = Eigen::VectorXd::Constant(size, both);
  return control;
}

/// What the errors of the steps of some 10 s, each below the tolerance, may add up to where f is of the size of 1. RKC
/// estimates y''' h^3 / 15, and so takes steps of (15 tolerance)^(1/3): 4 tolerance^(2/3) in 10 s. Others take larger
/// ones.
inline double allowed_sum(Method method, double tolerance) {
  return method == Method::rkc ? 10 * std::pow(tolerance, 2. / 3) : 500 * tolerance;
}

/// To t_end, calling `after_step(step)`.
template <typename Function>
void run(Integrator& integrator, double t_end, const Function& after_step) {
  while (integrator.t() < t_end) after_step(integrator.step(t_end));
}
inline void run(Integrator& integrator, double t_end) {
  run(integrator, t_end, [](const Step&) {});
}

}  // namespace pcm::simulate
