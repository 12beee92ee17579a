// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/verify/verdict/disagreement_kind.h"

namespace pcm::compare {

/// One disagreement: its kind and what each side says.
struct Disagreement {
  Kind kind = Kind::failure;
  std::string text;
};

/// How wide a check was: its bound divided by the size of what it checks. 0 where only equality passes, infinite where
/// anything does; none where that size is 0 and the bound is positive and finite.
struct Width {
  Kind kind = Kind::failure;
  std::optional<double> relative;
};

/// Holds one value after the other; gathers the first disagreement of each kind and the width of every check.
class Checks {
 public:
  template <typename... Arguments>
  void add(Kind kind, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    if (!knows(kind)) list_.push_back({kind, fmt::format(format, std::forward<Arguments>(arguments)...)});
  }
  template <typename T>
  bool check_equal(Kind kind, std::string_view what, const T& subj, const T& truth) {
    checked(kind);
    if (subj == truth) return true;
    add(kind, "{}: engine {}, oracle {}", what, subj, truth);
    return false;
  }
  /// A value must be within `bound` of the truth. A NaN on either side disagrees, and so does one in the bound,
  /// whatever the values. Infinite values agree where they are the same. `scale` is what the bound's width is told in
  /// units of, the value itself or what its error is measured against.
  void check_value(Kind kind, std::string_view what, double subj, double truth, double bound, double scale);
  /// The same for the length of a difference.
  void check_vector(Kind kind, std::string_view what, const Eigen::Vector3d& subj, const Eigen::Vector3d& truth,
                    double bound, double scale);
  /// A check of that width was made; nothing is counted where there was nothing to hold: 0 to within 0.
  void checked(Kind kind, double bound = 0, double scale = 1);

  const std::vector<Width>& widths() const { return widths_; }
  const std::vector<Disagreement>& disagreements() const { return list_; }
  /// By kind.
  std::vector<Disagreement> sorted() const;
  /// What another one found, added.
  void merge(Checks other);

 private:
  bool knows(Kind kind) const;

  std::vector<Disagreement> list_;
  std::vector<Width> widths_;
};

}  // namespace pcm::compare
