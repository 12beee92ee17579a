// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contestants/contestant.h"
#include "compare/peers/bullet_pair.h"

namespace {

using namespace pcm;
using namespace pcm::compare;

/// No pair of faces is promised a contact point: only that there are any is held.
class Bullet final : public Contestant {
 public:
  Bullet(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  GivenAnswer answer(const PosedQuestion& question) override {
    GivenAnswer answer;
    answer.touching = pair_.collide(question.pose) > 0;
    return answer;
  }

 private:
  BulletPair pair_;
};

}  // namespace

int main() {
  return pcm::compare::converse_as<Bullet>();
}
