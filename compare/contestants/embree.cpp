// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contestants/contestant.h"
#include "compare/peers/embree_pair.h"

namespace {

using namespace pcm;
using namespace pcm::compare;

class Embree final : public Contestant {
 public:
  Embree(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  GivenAnswer answer(const PosedQuestion& question) override {
    pair_.place(question.pose);
    return answer_of_pairs(pair_.collide());
  }

 private:
  EmbreePair pair_;
};

}  // namespace

int main() {
  return pcm::compare::converse_as<Embree>();
}
