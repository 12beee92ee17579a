// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/state_draw.h"

#include <vector>

#include "compare/poses/law_draw.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

struct Figures {
  std::vector<double> penetrations;
  std::vector<double> speeds;
};

/// Of the elements under the state's law; none where the engine refuses.
Figures figures_at(const EngineSeam& seam, const HeldPairing& held, const HeldPairing::State& state) {
  Wanted elements{.polygons = false, .areas = false, .force = true, .elements = true};
  const fast::Pairing pairing = held.engine_under(state.law, Mode::both, state.scheme);
  fast::Workspace workspace;
  Figures figures;
  try {
    for (const fast::Element& e :
         seam.evaluate_for_draw(pairing, state.pose, state.velocity, elements, workspace).elements) {
      figures.penetrations.push_back(e.penetration);
      figures.speeds.push_back(e.tangential_velocity);
    }
  } catch (const BadInput&) {
  } catch (const std::exception& error) {
    throw DrawFailure(std::string("engine: ") + error.what(), state);
  }
  return figures;
}

}  // namespace

HeldPairing::State state_under_law(const HeldPairing& held, Stratum stratum, const DrawnPose& drawn, Scheme scheme,
                                   const ContactLaw& law, PoseRandom for_velocity) {
  HeldPairing::State state{drawn.pose, drawn.velocity, law, scheme, {}};
  if (hard(stratum)) state.velocity = draw_velocity(for_velocity, held.features(), drawn.pose);
  return state;
}

HeldPairing::State draw_state(const HeldPairing& held, Stratum stratum, const DrawnPose& drawn, Scheme scheme,
                              PoseRandom for_law, PoseRandom for_velocity, const EngineSeam& seam) {
  HeldPairing::State state =
      state_under_law(held, stratum, drawn, scheme, draw_law_without_thresholds(for_law), for_velocity);
  const double size = held.features().size();
  draw_depths(for_law, size, figures_at(seam, held, state).penetrations, state.law);
  draw_slip_velocity(for_law, size, figures_at(seam, held, state).speeds, state.law);
  return state;
}

}  // namespace pcm::compare
