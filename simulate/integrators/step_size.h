// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace pcm::simulate {

/// Root mean square over the components of `error`, each divided by its tolerance, relative |y_i| + absolute_i.
double error_in_tolerances(const Eigen::VectorXd& error, const Eigen::VectorXd& y, double relative,
                           const Eigen::VectorXd& absolute);

/// By how much steps grow or shrink, from their errors in tolerances: 1 is the greatest that is accepted. A step is
/// predicted from the two before it (Gustafsson; Hairer, Wanner, Solving Ordinary Differential Equations II, section
/// IV.8), but never greater than from the last one alone.
class StepSizeControl {
 public:
  /// The error of a step falls with this power of its size.
  explicit StepSizeControl(int error_power) : error_power_(error_power) {}

  /// What the next step is of this one, which was accepted.
  double after_accepted(double size, double error);
  /// What the next try is of this one, whose error was too large.
  double after_rejected(double error) const;
  /// What the next try is of one that met a state without a derivative; the next two steps don't grow, or every other
  /// try would meet it again.
  double after_refused();

 private:
  /// The size that would have an error of 1, of the one that had this error.
  double to_tolerance(double error) const;

  int error_power_;
  double last_size_ = 0, last_error_ = 0;  ///< of the last accepted step; size 0: there was none
  int steps_without_growth_ = 0;
};

}  // namespace pcm::simulate
