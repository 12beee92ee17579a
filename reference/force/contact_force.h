// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "reference/force/force_question.h"
#include "reference/vocabulary/answer.h"

namespace pcm::reference {

/// What the law makes of one master's elements, each computed once, when first asked for: any number of totals share
/// it.
///
/// Every value is enclosed first, in DoubleDouble and to 240 bits. Where an enclosure does not round to one double, or
/// does not decide a case of the law, the value is computed exactly, as a sum of square roots of rationals
/// (exact_sums.h, numbers/radical_sum.h). So all values are correctly rounded, ties to even and zero as +0, with two
/// exceptions, where a number that kTiePrecision bits do not tell from a tie may go to either neighbour: the scales,
/// and roots of roots, which v_t is with w != 0 where an element is clamped, if only in part, and which friction brings
/// into forces there.
class MasterLoads {
 public:
  /// All that the question refers to must outlive this.
  explicit MasterLoads(const ForceQuestion& question);
  ~MasterLoads();

  /// The elements in numbers.
  std::vector<Element> elements();

 private:
  friend void report_force(const std::vector<MasterLoads*>& masters, const Wanted& wanted, Answer& answer);
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Writes elements (where `wanted.elements`), force, torque, their scales and the greatest penetration: PCM (1)-(24).
/// With two masters, E's first (mode `both`), force, torque and scales are halved, the elements listed are not. All of
/// the masters are of one pose and one law.
void report_force(const std::vector<MasterLoads*>& masters, const Wanted& wanted, Answer& answer);

}  // namespace pcm::reference
