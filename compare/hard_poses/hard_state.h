// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/verdict/case_file.h"

namespace pcm::compare {

/// All that a climb may change: the surfaces, ready to be asked in modes E, F and both, and what they are asked.
struct HardState {
  std::shared_ptr<const HeldPairing> held;
  std::size_t mode = 0;  ///< number of the pairing's mode
  HeldPairing::State state;

  Mode mode_asked() const { return held->engine(mode).mode(); }
  void ask_in(Mode asked) {
    for (mode = 0; mode_asked() != asked;) ++mode;
  }
};

/// Throws BadInput where a mesh is unfit for contact.
inline std::shared_ptr<const HeldPairing> held_in_all_modes(const TriangleMesh& E, const TriangleMesh& F,
                                                            const ContactLaw& law, Scheme scheme) {
  return std::make_shared<const HeldPairing>(E, F, law, HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, scheme);
}

/// At rest in the same place, under the default law: for climbs, which draw the rest. Throws BadInput where a mesh is
/// unfit for contact.
HardState hard_state(const TriangleMesh& E, const TriangleMesh& F, Scheme scheme);
/// Of a case, without the way on which F came there. Throws BadInput where a mesh is unfit for contact.
HardState hard_state(const Case& posed);
/// With the surfaces inline, for a climb may have moved their vertices.
Case as_case(const HardState& hard, std::string origin);

}  // namespace pcm::compare
