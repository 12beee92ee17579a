// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/question_range.h"

#include <fmt/format.h>

#include <cmath>

#include "compare/poses/law_thresholds.h"
#include "fast/base/geometry.h"
#include "fast/force/law_parameters.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

std::vector<LawNumber> numbers_of(const ContactLaw& law) {
  const auto threshold = [](std::string_view key, double value) {
    return LawNumber{key, value, kLeastThreshold, kGreatestThreshold};
  };
  std::vector<LawNumber> numbers{{"damping", law.damping},
                                 threshold("transition_depth", law.transition_depth),
                                 {"friction", law.friction},
                                 threshold("slip_velocity", law.slip_velocity),
                                 threshold("max_penetration", law.max_penetration)};
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
  for (const LawNumber& number : numbers_of(law)) {
    if (is_zero_infinite_or_between(number.value, number.least, number.greatest)) continue;
    throw BadInput(
        fmt::format("{}: {} is so {} that the verdict's bounds need not hold; from 2^{} to 2^{} ({:.0e} to {:.0e}) "
                    "they do",
                    name == nullptr ? std::string(number.key) : name(number.key), number.value,
                    number.value < 1 ? "small" : "large", std::ilogb(number.least), std::ilogb(number.greatest),
                    number.least, number.greatest));
  }
}

void require_in_range(const Pose& pose, const Velocity& velocity) {
  fast::require_valid(pose, velocity);
  for (const Eigen::Vector3d& x : {velocity.v, velocity.w})
    if (x.cwiseAbs().maxCoeff() > fast::kGreatestCoordinate)
      throw BadInput("velocity: a component exceeds 2^300; choose other units");
}

}  // namespace pcm::compare
