// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace pcm::simulate {

/// The continuous extension of a step of Dormand and Prince's method of order 5(4), which DOPRI5 has and ARKODE lacks:
/// of order 4 from the slopes of the stages, without further ones (Hairer, Norsett, Wanner, Solving Ordinary
/// Differential Equations I, section II.6).
class DormandPrinceInterpolant {
 public:
  /// Takes every slope that the method asks for, in the order of evaluation; the first is that of the start. When a
  /// step is accepted, the last six are those of its stages 2 to 7, whatever was rejected before; stage 7 is stage 1 of
  /// the next step.
  void add_slope(const Eigen::Ref<const Eigen::VectorXd>& dydt);

  /// A step of this size from `before` to `after`.
  void accept(double size, const Eigen::VectorXd& before, const Eigen::VectorXd& after);

  /// At `part` of the step, 0 at its beginning and 1 at its end.
  Eigen::VectorXd state_at(double part) const;

 private:
  static constexpr std::size_t kStages = 6;    ///< but for the first
  Eigen::VectorXd first_;                      ///< of the step to come; empty before the first slope
  std::array<Eigen::VectorXd, kStages> last_;  ///< a ring
  std::size_t next_ = 0;
  std::array<Eigen::VectorXd, 5> terms_;
};

}  // namespace pcm::simulate
