// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/engines/own_answers.h"

#include <algorithm>

#include "compare/judge/judgement/true_facts.h"

namespace pcm::compare {

OwnAnswers::OwnAnswers(Engine engine, const std::vector<PosedSurface>& surfaces)
    : engine_(engine), surfaces_(surfaces) {}

const fast::Surface& OwnAnswers::prepared(std::size_t surface) {
  const auto known = prepared_.find(surface);
  return known != prepared_.end() ? known->second
                                  : prepared_.emplace(surface, fast::Surface(surfaces_[surface].mesh)).first->second;
}

const SurfaceFeatures& OwnAnswers::features(std::size_t surface) {
  return features_.try_emplace(surface, surfaces_[surface].mesh).first->second;
}

const fast::Contact& OwnAnswers::evaluate(const PosedQuestion& question) {
  if (engine_ == Engine::fast) {
    const fast::Pairing pairing(prepared(question.E), prepared(question.F), question.law, question.mode,
                                question.scheme);
    return fast::evaluate(pairing, question.pose, question.velocity, {}, workspace_.fast);
  }
  tested_ = make_tested_engine(engine_, surfaces_[question.E].mesh, surfaces_[question.F].mesh, question.law,
                               question.mode, question.scheme);
  return tested_->evaluate(question.pose, question.velocity, {}, workspace_);
}

GivenAnswer OwnAnswers::answer(const PosedQuestion& question) {
  const fast::Contact& contact = evaluate(question);
  GivenAnswer answer;
  answer.force_Me = contact.force_Me;
  answer.torque_Me = contact.torque_Me;
  answer.elements.emplace();
  for (const fast::Element& e : contact.elements)
    answer.elements->push_back({e.master, e.master_face, e.slave_face, e.area, e.penetration});
  if (engine_ == Engine::published_2023) return answer;
  answer.touching = contact.touching;
  answer.crossing_pairs = crossing_pairs(features(question.E), features(question.F), contact.crossings);
  answer.polygons = std::ssize(contact.polygons);
  answer.closed_polygons = std::count_if(contact.polygons.begin(), contact.polygons.end(),
                                         [](const fast::Polygon& polygon) { return polygon.closed; });
  for (const auto& [given, active] : {std::pair(&answer.E, &contact.E), std::pair(&answer.F, &contact.F)}) {
    given->intersected = active->intersected;
    given->inner = active->inner;
    given->active = active_faces(active->intersected, active->inner);
    if (engine_ == Engine::fast) given->area = active->area;
  }
  if (engine_ == Engine::fast && contact.has_volume) answer.volume = contact.volume;
  return answer;
}

}  // namespace pcm::compare
