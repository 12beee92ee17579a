// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/counted_equation.h"

#include <cassert>
#include <string>
#include <utility>

#include "pcm/bad_input.h"
#include "simulate/integrators/difference_quotients.h"

namespace pcm::simulate {

namespace {

using Map = Eigen::Map<Eigen::VectorXd>;
using ConstMap = Eigen::Map<const Eigen::VectorXd>;

/// Functions are handed vectors that they might resize.
void expect_size(Eigen::Index rows, Eigen::Index columns, const Eigen::Ref<const Eigen::MatrixXd>& answer,
                 const char* what) {
  if (answer.rows() == rows && answer.cols() == columns) return;
  throw BadInput(std::string("differential equation: its ") + what + " was made " + std::to_string(answer.rows()) +
                 " x " + std::to_string(answer.cols()) + ", where " + std::to_string(rows) + " x " +
                 std::to_string(columns) + " was asked for: don't resize it");
}

}  // namespace

CountedEquation::CountedEquation(DifferentialEquation equation, Eigen::VectorXd absolute)
    : equation_(std::move(equation)),
      absolute_(std::move(absolute)),
      y_(equation_.size),
      dydt_(equation_.size),
      J_(equation_.size, equation_.size) {}

/// An exception may not pass through C functions: it waits until SUNDIALS has returned.
template <typename Function>
Answer CountedEquation::guarded(const Function& function) {
  refused_last_ = false;
  try {
    return function();
  } catch (...) {
    thrown_ = std::current_exception();
    return Answer::stop;
  }
}

Answer CountedEquation::refuse(double t, std::int64_t& tries) {
  if (refused_at_ != t) ++tries;
  refused_at_ = t;
  refused_last_ = true;
  refused_last_not_finite_ = &tries == &tries_not_finite_;
  return Answer::try_smaller;
}

Evaluation CountedEquation::evaluate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt,
                                     std::int64_t& calls) const {
  ++calls;
  const Evaluation evaluation = equation_.derivative(t, y, dydt);
  expect_size(equation_.size, 1, dydt, "derivative");
  return evaluation;
}

Answer CountedEquation::derivative(double t, const double* y, double* dydt) {
  return guarded([&] {
    t_ = t;
    y_ = ConstMap(y, size());
    if (!y_.allFinite()) return refuse(t, tries_not_finite_);
    if (evaluate(t, y_, dydt_, derivatives_) == Evaluation::not_here) return refuse(t, tries_not_here_);
    if (!dydt_.allFinite()) return refuse(t, tries_not_finite_);
    Map(dydt, size()) = dydt_;
    return Answer::given;
  });
}

Answer CountedEquation::derivative_beside(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
  return guarded([&] {
    const bool can_be_had =
        y.allFinite() && evaluate(t, y, dydt, derivatives_) == Evaluation::available && dydt.allFinite();
    return can_be_had ? Answer::given : Answer::try_smaller;
  });
}

/// Into J_.
Evaluation CountedEquation::differences(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& dydt) {
  Linearisation linear;
  if (equation_.linearise) linear = equation_.linearise(t, y);
  derivatives_for_jacobians_ += linear.cost;
  const auto asked = [&](double at, const Eigen::VectorXd& changed, Eigen::VectorXd& answer) {
    if (!linear.derivative) return evaluate(at, changed, answer, derivatives_for_jacobians_);
    ++linear_derivatives_;
    linear.derivative(at, changed, answer);
    expect_size(equation_.size, 1, answer, "linearised derivative");
    return Evaluation::available;
  };
  return difference_quotients(asked, absolute_, t, y, dydt, J_);
}

Answer CountedEquation::jacobian(double t, const double* y, const double* dydt, double* J) {
  return guarded([&] {
    assert(dydt || (t == t_ && y_ == ConstMap(y, size())));
    const Eigen::VectorXd state = ConstMap(y, size());
    const Eigen::VectorXd slope = dydt ? Eigen::VectorXd(ConstMap(dydt, size())) : dydt_;
    ++jacobians_;
    Evaluation evaluation;
    if (equation_.jacobian) {
      evaluation = equation_.jacobian(t, state, slope, J_);
      expect_size(size(), size(), J_, "Jacobian");
    } else {
      evaluation = differences(t, state, slope);
    }
    if (evaluation == Evaluation::not_here) return refuse(t, tries_not_here_);
    if (!J_.allFinite()) return refuse(t, tries_not_finite_);
    Eigen::Map<Eigen::MatrixXd>(J, size(), size()) = J_;
    return Answer::given;
  });
}

void CountedEquation::rethrow() {
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

}  // namespace pcm::simulate
