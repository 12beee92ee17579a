// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/contact_answers.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/io/contact_json.h"
#include "compare/wrong_answers/tested_engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

/// Polygons that were not wanted are not none.
void leave_out_polygons(const Wanted& wanted, Json& json) {
  if (!wanted.polygons) json["polygons"] = json["patches"] = nullptr;
}

AnswerContact answers_of_engine(const ContactQuestion& question, TriangleMesh mesh_E, TriangleMesh mesh_F,
                                bool with_record) {
  const Engine engine = engine_named(question.engine);
  const std::shared_ptr<const TestedEngine> tested =
      make_tested_engine(engine, std::move(mesh_E), std::move(mesh_F), question.law, question.mode, question.scheme);
  auto workspace = std::make_shared<TestedEngineWorkspace>();
  return [=, wanted = question.wanted](const State& state) {
    const fast::Contact& contact = tested->evaluate(state.pose, state.velocity, wanted, *workspace);
    const bool knows_areas = engine == Engine::fast;
    ContactAnswer answer{contact_json(contact), {}};
    if (!knows_areas)
      for (const char* side : {"E", "F"}) answer.json[side]["area"] = answer.json[side]["vector_area"] = nullptr;
    leave_out_polygons(wanted, answer.json);
    if (with_record) answer.record = contact_record(contact, knows_areas);
    return answer;
  };
}

AnswerContact answers_of_oracle(const ContactQuestion& question, TriangleMesh mesh_E, TriangleMesh mesh_F,
                                bool with_record) {
  auto oracle = std::make_shared<const reference::Oracle>(std::move(mesh_E), std::move(mesh_F), question.law,
                                                          question.mode, question.scheme);
  return [=, problem = question.problem, wanted = question.wanted](const State& state) {
    const reference::Answer truth = oracle->answer(problem, state.pose, state.velocity, wanted);
    ContactAnswer answer{contact_json(truth), {}};
    leave_out_polygons(wanted, answer.json);
    if (with_record) answer.record = contact_record(truth);
    return answer;
  };
}

}  // namespace

AnswerContact contact_answers(const ContactQuestion& question, TriangleMesh mesh_E, TriangleMesh mesh_F,
                              bool with_record) {
  return question.engine == "reference"
             ? answers_of_oracle(question, std::move(mesh_E), std::move(mesh_F), with_record)
             : answers_of_engine(question, std::move(mesh_E), std::move(mesh_F), with_record);
}

}  // namespace pcm::compare
