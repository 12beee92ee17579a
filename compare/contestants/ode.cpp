// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contestants/contestant.h"
#include "compare/peers/ode_pair.h"

namespace {

using namespace pcm;
using namespace pcm::compare;

/// Contact points are merged where they are alike, and no pair of faces is promised one: only that there are any is
/// held.
class Ode final : public Contestant {
 public:
  Ode(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  GivenAnswer answer(const PosedQuestion& question) override {
    GivenAnswer answer;
    answer.touching = pair_.collide(question.pose) > 0;
    return answer;
  }

 private:
  OdePair pair_;
};

}  // namespace

int main() {
  const pcm::compare::OpenOde open;
  return pcm::compare::converse_as<Ode>();
}
