// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/wrong_answers/wrong_answers.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "compare/verify/verdict/element_key.h"

namespace pcm::compare {
namespace {

bool same_polygons(const fast::Contact& subj, const reference::Answer& truth) {
  if (subj.polygons.size() != truth.polygons.size()) return false;
  for (std::size_t i = 0; i < truth.polygons.size(); ++i) {
    const fast::Polygon& ours = subj.polygons[i];
    const reference::Polygon& theirs = truth.polygons[i];
    const auto first = subj.crossings.begin() + ours.first;
    const bool same =
        ours.closed == theirs.closed && static_cast<std::size_t>(ours.count) == theirs.points.size() &&
        std::equal(theirs.points.begin(), theirs.points.end(), first,
                   [](const reference::Crossing& t, const fast::Crossing& s) {
                     return std::tie(t.edge_side, t.edge, t.face) == std::tie(s.edge_side, s.edge, s.face);
                   });
    if (!same) return false;
  }
  return true;
}

bool same_force(const Question& question, const fast::Contact& subj, const reference::Answer& truth) {
  const double force_error = (subj.force_Me - truth.force_Me).stableNorm();
  const double torque_error = (subj.torque_Me - truth.torque_Me).stableNorm();
  if (force_error <= kForceTolerance * truth.force_scale && torque_error <= kForceTolerance * truth.torque_scale)
    return true;
  const ForceBounds rounding = RoundingBounds(question, truth).force();
  return force_error <= std::max(kForceTolerance * truth.force_scale, rounding.force) &&
         torque_error <= std::max(kForceTolerance * truth.torque_scale, rounding.torque);
}

}  // namespace

std::string_view name(Wrong wrong) {
  constexpr std::array<std::string_view, kWrongs> kNames = {"failure",      "touching", "open chains", "polygons",
                                                            "active faces", "elements", "force"};
  return kNames[static_cast<std::size_t>(wrong)];
}

bool answers(Engine engine, Wrong wrong) {
  return engine != Engine::published_2023 || wrong == Wrong::failure || wrong == Wrong::elements ||
         wrong == Wrong::force;
}

bool without_rule(const reference::Answer& truth) {
  return truth.nested || truth.ambiguous || truth.too_deep > 0;
}

Wrongs wrongs(const Question& question, Engine engine, const fast::Contact* contact, const reference::Answer& truth) {
  Wrongs found;
  const auto note = [&](Wrong wrong, bool is_wrong) {
    found[static_cast<std::size_t>(wrong)] = is_wrong && answers(engine, wrong);
  };
  note(Wrong::failure, contact == nullptr);
  if (contact == nullptr) return found;
  const fast::Contact& subj = *contact;
  const bool open = std::any_of(subj.polygons.begin(), subj.polygons.end(),
                                [](const fast::Polygon& polygon) { return !polygon.closed; });
  const bool ruled = engine == Engine::fast || !(truth.nested || truth.ambiguous);
  note(Wrong::touching, subj.touching != truth.touching);
  note(Wrong::open_chains, open && question.E.closed && question.F.closed);
  note(Wrong::polygons, !same_polygons(subj, truth));
  note(Wrong::active_faces, subj.E.intersected != truth.E.intersected || subj.F.intersected != truth.F.intersected ||
                                (ruled && (subj.E.inner != truth.E.inner || subj.F.inner != truth.F.inner)));
  note(Wrong::elements, !same_elements(subj.elements, truth.elements));
  note(Wrong::force, !same_force(question, subj, truth));
  return found;
}

}  // namespace pcm::compare
