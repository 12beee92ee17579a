// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/next_answer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <type_traits>

#include "fast/base/geometry.h"
#include "pcm/workspace.h"

namespace pcm::compare {
namespace {

constexpr Wanted kDiscrete{.polygons = true, .areas = false, .force = false, .elements = false};

/// Asks the engine about poses along one direction.
class Walk {
 public:
  Walk(const fast::Pairing& pairing, const Pose& pose, const DiscreteAnswer& answer, const Eigen::Vector3d& direction)
      : pairing_(pairing), pose_(pose), answer_(answer), direction_(direction) {}

  Pose at(double distance) const {
    Pose moved = pose_;
    moved.r += distance * direction_;
    return moved;
  }
  DiscreteAnswer answer_at(double distance) {
    return discrete_answer(fast::evaluate(pairing_, at(distance), {}, kDiscrete, workspace_));
  }
  bool differs_at(double distance) { return !(answer_at(distance) == answer_); }

 private:
  const fast::Pairing& pairing_;
  const Pose& pose_;
  const DiscreteAnswer& answer_;
  Eigen::Vector3d direction_;
  fast::Workspace workspace_;
};

/// Halves the doubles between two that are not negative: their bits, read as integers, are in their order.
double halfway(double low, double high) {
  const auto a = std::bit_cast<std::uint64_t>(low), b = std::bit_cast<std::uint64_t>(high);
  return std::bit_cast<double>(a + (b - a) / 2);
}

/// The first step with another answer, no farther than `farthest`, and then the least double where it is another one.
std::optional<double> nearest_difference(Walk& walk, double ulp, double farthest) {
  double same = 0, other = ulp;
  while (!walk.differs_at(other)) {
    if (other >= farthest) return std::nullopt;
    same = other;
    other = std::min(2 * other, farthest);
  }
  for (double middle = halfway(same, other); middle != same; middle = halfway(same, other))
    (walk.differs_at(middle) ? other : same) = middle;
  return other;
}

}  // namespace

AnswerPart only_in(const DiscreteAnswer& answer, const DiscreteAnswer& other) {
  const auto difference = [](const auto& a, const auto& b) {
    std::decay_t<decltype(a)> only;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
    return only;
  };
  return {difference(answer.crossings, other.crossings),
          {difference(answer.inner[0], other.inner[0]), difference(answer.inner[1], other.inner[1])}};
}

DiscreteAnswer discrete_answer(const fast::Contact& contact) {
  DiscreteAnswer answer{contact.touching, contact.nested, contact.ambiguous, {}, {}, {}};
  for (const fast::Crossing& x : contact.crossings) answer.crossings.push_back(crossing_key(x));
  std::sort(answer.crossings.begin(), answer.crossings.end());
  answer.intersected = {contact.E.intersected, contact.F.intersected};
  answer.inner = {contact.E.inner, contact.F.inner};
  return answer;
}

std::optional<NextAnswer> next_answer(const fast::Pairing& pairing, const Pose& pose, const DiscreteAnswer& answer,
                                      const std::vector<Eigen::Vector3d>& directions, double ulp, double farthest) {
  // The engine takes no poses farther out than that.
  farthest = std::min(farthest, fast::kGreatestCoordinate - pose.r.cwiseAbs().maxCoeff());
  std::optional<NextAnswer> nearest;
  if (farthest < ulp) return nearest;
  for (const Eigen::Vector3d& line : directions)
    for (const double way : {1.0, -1.0}) {
      const Eigen::Vector3d direction = way * line;
      Walk walk(pairing, pose, answer, direction);
      // What is farther than what is known by now is of no interest.
      const std::optional<double> step = nearest_difference(walk, nearest ? std::min(ulp, nearest->distance) : ulp,
                                                            nearest ? nearest->distance : farthest);
      if (!step) continue;
      const Pose moved = walk.at(*step);
      const double distance = (moved.r - pose.r).stableNorm();
      if (!nearest || distance < nearest->distance) nearest = {moved, direction, distance, walk.answer_at(*step)};
    }
  return nearest;
}

}  // namespace pcm::compare
