// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compare/judge/judgement/fact.h"

namespace pcm::compare {

/// How far off a value may be beyond what a right evaluation in doubles may be off (rounding_bounds.h,
/// clipped_bounds.h): by what the user of an engine states, nothing otherwise.
struct Tolerance {
  double relative = 0;  ///< of what the fact's error is measured against (DESIGN section 3)
  double absolute = 0;  ///< in the fact's SI unit

  /// The bound to hold a value to; `scale` is what its error is measured against.
  double widen(double derived, double scale) const;
};

class Tolerances {
 public:
  const Tolerance& of(Fact fact) const { return all_[static_cast<std::size_t>(fact)]; }
  /// Adds words such as "force=1e-6", values by name with "_" for blanks. `option` names them in messages. Throws
  /// BadInput for another form, an unknown value or a number that is none or negative.
  void add(const std::string& option, const std::vector<std::string>& words, double Tolerance::*which);
  /// A line for people; empty where none is stated.
  std::string text() const;

 private:
  std::array<Tolerance, kFacts> all_{};
};

}  // namespace pcm::compare
