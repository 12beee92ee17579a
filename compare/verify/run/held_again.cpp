// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/held_again.h"

#include <exception>
#include <nlohmann/json.hpp>

namespace pcm::compare {

PoseOutcome held_again(const Case& posed, const EngineSeam& seam) {
  const HeldPairing held(posed.E, posed.F, posed.law, posed.mode, posed.scheme);
  fast::Workspace workspace;
  return held.hold({posed.pose, posed.velocity, posed.law, posed.scheme, posed.before}, workspace, seam).front();
}

std::string case_file_text(const HeldPairing& held, const Case& posed, fast::Workspace& workspace) {
  const Wanted everything;
  nlohmann::ordered_json engine, oracle;
  try {
    const fast::Pairing pairing = held.engine_under(posed.law, posed.mode, posed.scheme);
    engine = decided(fast::evaluate(pairing, posed.pose, posed.velocity, everything, workspace));
    reference::Inquiry inquiry(held.oracle(), posed.pose, posed.velocity, everything, posed.law, posed.scheme);
    oracle = decided(inquiry.answer(reference::Problem::rounded, posed.mode));
  } catch (const std::exception&) {
    // The disagreement itself says which side failed, and how.
  }
  return format_case(posed, engine, oracle);
}

}  // namespace pcm::compare
