// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "compare/judge/lines/given_answer.h"
#include "compare/judge/lines/posed_question.h"

/// Engines of others as contestants of `pcm judge --command`: each a program of its own, so that none can bring another
/// one down, and none is linked with what judges it but for the lines that both write and read.
///
/// A new one takes a file NAME.cpp here, with its surfaces set up in a header of compare/peers; pcm_add_contestant in
/// CMakeLists.txt; its package in `run`; a line in judge_contestants.sh, without which it is built and not judged; what
/// is expected of it in tests/compare/contestants/contestants_test.cpp; its rows in docs/peers.md.
namespace pcm::compare {

/// An engine set up for two surfaces.
class Contestant {
 public:
  Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;
  virtual ~Contestant() = default;

  /// What it knows of the contact, in the conventions of docs/judge.md.
  virtual GivenAnswer answer(const PosedQuestion& question) = 0;
};

using MakeContestant =
    std::function<std::unique_ptr<Contestant>(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)>;

/// One end of the conversation: reads the lines of poses.jsonl from standard input and answers each pose before it
/// reads the next. Returns the exit status: 2, with a line on standard error, for what is no such line.
int converse(const MakeContestant& make);

/// The same for a class whose constructor takes the two surfaces.
template <class Engine>
int converse_as() {
  return converse(
      [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) { return std::make_unique<Engine>(mesh_E, mesh_F); });
}

/// An engine that promises no pair of faces a contact point: only whether there are any is held.
template <class Pair>
class TouchContestant final : public Contestant {
 public:
  TouchContestant(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  GivenAnswer answer(const PosedQuestion& question) override {
    GivenAnswer answer;
    answer.touching = pair_.collide(question.pose) > 0;
    return answer;
  }

 private:
  Pair pair_;
};

/// Facts that follow from the pairs of faces that cross: these, sorted, and whether there is any.
GivenAnswer answer_of_pairs(std::vector<FacePair> pairs);

}  // namespace pcm::compare
