// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/difference_quotients.h"

#include <cmath>
#include <limits>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

TEST(DifferenceQuotients, TakeTheGreaterOfTheRootOfEpsAndTheTolerance) {
  const double root_of_eps = std::sqrt(std::numeric_limits<double>::epsilon());
  EXPECT_NEAR(difference_increment(-1e3, 1e-12), 1e3 * root_of_eps, 1e-12);
  EXPECT_NEAR(difference_increment(0, 1e-4), 1e-5, 1e-20);
  EXPECT_NEAR(difference_increment(1, 1e-4), 1e-5, 1e-15);
  for (const double y : {0.1, -3.7, 1e9}) {
    const double change = difference_increment(y, 1e-4);
    EXPECT_EQ((y + change) - y, change);
  }
}

TEST(DifferenceQuotients, AreTheDerivative) {
  const auto equation = everywhere(2, [](double t, const Eigen::VectorXd& y) {
    return vector({t * y[0] * y[1], std::sin(y[0]) - 3 * y[1]});
  });
  const Eigen::VectorXd y = vector({0.5, 2});
  Eigen::VectorXd dydt(2);
  (void)equation.derivative(2, y, dydt);
  Eigen::MatrixXd J(2, 2), expected(2, 2);
  EXPECT_EQ(difference_quotients(equation.derivative, vector({1e-9, 1e-9}), 2, y, dydt, J), Evaluation::available);
  expected << 4, 1, std::cos(0.5), -3;
  EXPECT_LT((J - expected).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(DifferenceQuotients, AreTakenBackwardsWhereAheadIsNotHere) {
  const auto below_one = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
    dydt = y.array().square();
    return y[0] > 1 ? Evaluation::not_here : Evaluation::available;
  };
  Eigen::MatrixXd J(1, 1);
  EXPECT_EQ(difference_quotients(below_one, vector({1e-9}), 0, vector({1}), vector({1}), J), Evaluation::available);
  EXPECT_NEAR(J(0, 0), 2, 1e-6);
  EXPECT_EQ(difference_quotients(below_one, vector({1e-9}), 0, vector({2}), vector({4}), J), Evaluation::not_here);
}

}  // namespace
}  // namespace pcm::simulate
