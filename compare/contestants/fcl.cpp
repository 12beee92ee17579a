// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "compare/contestants/contestant.h"
#include "compare/peers/fcl_pair.h"

namespace {

using namespace pcm;
using namespace pcm::compare;

class Fcl final : public Contestant {
 public:
  Fcl(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  GivenAnswer answer(const PosedQuestion& question) override {
    std::vector<fcl::Contactd> contacts;
    pair_.collide(question.pose, std::numeric_limits<std::size_t>::max()).getContacts(contacts);
    std::vector<FacePair> pairs;
    for (const fcl::Contactd& contact : contacts)
      pairs.push_back({static_cast<Index>(contact.b1), static_cast<Index>(contact.b2)});
    return answer_of_pairs(std::move(pairs));
  }

 private:
  FclPair pair_;
};

}  // namespace

int main() {
  return pcm::compare::converse_as<Fcl>();
}
