// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/question_range.h"

#include <fmt/format.h>

#include <cmath>

#include "fast/base/geometry.h"
#include "fast/force/law_parameters.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

std::vector<LawNumber> numbers_of(const ContactLaw& law) {
  std::vector<LawNumber> numbers{{"damping", law.damping},
                                 {"transition_depth", law.transition_depth},
                                 {"friction", law.friction},
                                 {"slip_velocity", law.slip_velocity},
                                 {"max_penetration", law.max_penetration}};
  if (law.layers) {
    numbers.push_back({"stiffness_E", law.layers->c_E});
    numbers.push_back({"stiffness_F", law.layers->c_F});
  } else {
    numbers.push_back({"stiffness", law.stiffness});
  }
  return numbers;
}

bool is_zero_infinite_or_between(double x, double least, double greatest) {
  return x == 0 || std::isinf(x) || (x >= least && x <= greatest);
}

void require_in_range(const ContactLaw& law, std::string (*name)(std::string_view key)) {
  fast::require_valid(law);
  for (const auto& [key, x] : numbers_of(law)) {
    if (is_zero_infinite_or_between(x, kLeastOfLaw, kGreatestOfLaw)) continue;
    throw BadInput(
        fmt::format("{}: {} is so {} that the verdict's bounds need not hold; from 2^-200 to 2^200 (6e-61 to 2e60) "
                    "they do",
                    name == nullptr ? std::string(key) : name(key), x, x < 1 ? "small" : "large"));
  }
}

void require_in_range(const Pose& pose, const Velocity& velocity) {
  fast::require_valid(pose, velocity);
  for (const Eigen::Vector3d& x : {velocity.v, velocity.w})
    if (x.cwiseAbs().maxCoeff() > fast::kGreatestCoordinate)
      throw BadInput("velocity: a component exceeds 2^300; choose other units");
}

}  // namespace pcm::compare
