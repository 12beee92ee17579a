// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "pcm/engine.h"

/// How near the next pose with another answer is, A not being turned.
namespace pcm::compare {

/// What counts as the answer: touch, crossings, and so which faces cross, and what lies inside. The engine decides all
/// of it exactly on the rounded problem.
struct DiscreteAnswer {
  bool touching = false;
  bool nested = false;
  bool ambiguous = false;
  std::vector<std::array<Index, 4>> crossings;           ///< side of the edge (0: E), its ends, the face
  std::array<std::vector<Index>, 2> intersected, inner;  ///< of E and F, ascending
  bool operator==(const DiscreteAnswer&) const = default;
};

/// A crossing of the engine's or of the oracle's, as DiscreteAnswer has it.
std::array<Index, 4> crossing_key(const auto& crossing) {
  return {crossing.edge_side == Side::E ? 0 : 1, crossing.edge[0], crossing.edge[1], crossing.face};
}

/// Crossings are ordered, whatever polygons they belong to. The contact must have polygons.
DiscreteAnswer discrete_answer(const fast::Contact& contact);

/// What one answer has and another one has not.
struct AnswerPart {
  std::vector<std::array<Index, 4>> crossings;
  std::array<std::vector<Index>, 2> inner;  ///< of E and F
};
AnswerPart only_in(const DiscreteAnswer& answer, const DiscreteAnswer& other);

struct NextAnswer {
  Pose pose;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of length 1: which way r was moved
  double distance = 0;                                  ///< |r - r of the pose asked about|, m
  DiscreteAnswer answer;
};

/// The nearest pose with another answer along these directions, both ways each, by bisection over the doubles: there
/// the answer is another one, and one double nearer it is the same. An upper bound on how near one is, for between the
/// pose and the first of ever greater steps, ulp, 2 ulp, 4 ulp, ... `farthest`, the answer may come and go. Nothing
/// where no step finds one. `ulp` and `farthest`: m, positive.
std::optional<NextAnswer> next_answer(const fast::Pairing& pairing, const Pose& pose, const DiscreteAnswer& answer,
                                      const std::vector<Eigen::Vector3d>& directions, double ulp, double farthest);

}  // namespace pcm::compare
