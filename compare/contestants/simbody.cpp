// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "compare/contestants/contestant.h"
#include "compare/peers/simbody_foundation.h"

namespace {

using namespace pcm;
using namespace pcm::compare;

/// Of 1 N/m^3: elastic forces are proportional to it.
ContactLaw unit_law() {
  ContactLaw law;
  law.stiffness = 1;
  return law;
}

/// Whether Simbody has a law for it at all: springs at the faces of E alone, elastic and without friction.
bool is_comparable(const PosedQuestion& question) {
  const ContactLaw& law = question.law;
  return question.mode == Mode::E && question.scheme == Scheme::barycentric && law.damping == 0 && law.friction == 0 &&
         !law.layers && std::isinf(law.max_penetration);
}

class Simbody final : public Contestant {
 public:
  Simbody(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : foundation_(mesh_E, mesh_F, unit_law()) {}

  GivenAnswer answer(const PosedQuestion& question) override {
    foundation_.place(question.pose, {});
    GivenAnswer answer;
    answer.E.active.emplace();
    answer.F.active.emplace();
    if (const auto faces = foundation_.faces()) {
      answer.E.active->assign(faces->E.begin(), faces->E.end());
      answer.F.active->assign(faces->F.begin(), faces->F.end());
    }
    // Where one body is wholly inside the other, only one of them has faces in contact.
    answer.touching = !answer.E.active->empty() && !answer.F.active->empty();
    if (is_comparable(question)) {
      const SimbodyFoundation::Load load = foundation_.load_on_F();
      answer.force_Me = -question.law.stiffness * load.force;
      answer.torque_Me = -question.law.stiffness * load.torque;
    }
    return answer;
  }

 private:
  SimbodyFoundation foundation_;
};

}  // namespace

int main() {
  return pcm::compare::converse_as<Simbody>();
}
