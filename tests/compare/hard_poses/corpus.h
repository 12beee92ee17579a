// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/hard_poses/goal.h"
#include "compare/hard_poses/hard_state.h"
#include "compare/poses/pairs.h"

/// The hardest states that were found, each with the true answer beside it (corpus.json, made by write_hard_poses).
namespace pcm::compare::hard_poses_test {

/// A vertex that a climb has moved.
struct MovedVertex {
  Side side = Side::E;
  Index vertex = 0;
  Eigen::Vector3d x = Eigen::Vector3d::Zero();  ///< in the frame of its marker, m
};

/// A state of a built-in pair, the hardest or nearly so that climbs to the goal have found.
struct CorpusState {
  std::string pair;
  std::vector<MovedVertex> moved;
  Mode mode = Mode::E;
  HeldPairing::State state;
  Goal goal = Goal::margins;
  double hardness = 0;
  Eigen::Vector3d true_force_Me = Eigen::Vector3d::Zero();   ///< of the exact problem, correctly rounded, N
  Eigen::Vector3d true_torque_Me = Eigen::Vector3d::Zero();  ///< N m
};

/// All pairs that are searched, by their names.
class CorpusPairs {
 public:
  CorpusPairs();

  /// Those of the corpus, small ones of each kind.
  const std::vector<std::string>& names() const { return names_; }
  const SurfacePair& surfaces(const std::string& pair) const { return pairs_.at(pair); }
  /// As it is asked, with its vertices moved.
  HardState hard(const CorpusState& state) const;

 private:
  std::vector<std::string> names_;
  std::map<std::string, SurfacePair> pairs_;
};

/// The vertices of a state that are not the pair's own.
std::vector<MovedVertex> moved_vertices(const SurfacePair& pair, const HardState& hard);

/// One state a line, all numbers hexadecimal.
std::string corpus_text(const std::vector<CorpusState>& states);
std::vector<CorpusState> corpus_from(const std::string& text);

}  // namespace pcm::compare::hard_poses_test
