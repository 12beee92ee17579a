// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/contact_answers.h"

#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/contact/contact_json.h"
#include "compare/wrong_answers/tested_engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

/// What the algorithms that engines stand for have (published/algorithm_2003.h, algorithm_2023.h).
Knowledge knowledge_of(Engine engine) {
  return {engine == Engine::fast, engine != Engine::published_2023};
}

/// What is not known, or was not wanted, is not none.
void leave_out(const Knowledge& known, const Wanted& wanted, Json& json) {
  const auto leave_out_of_sides = [&](std::initializer_list<const char*> keys) {
    for (const char* side : {"E", "F"})
      for (const char* key : keys) json[side][key] = nullptr;
  };
  if (!known.areas) {
    for (const char* key : {"nested", "ambiguous", "volume", "too_deep", "undefined_areas"}) json[key] = nullptr;
    leave_out_of_sides({"area", "vector_area"});
  }
  if (!known.faces) leave_out_of_sides({"intersected", "inner"});
  if (!known.faces || !wanted.polygons) json["polygons"] = json["patches"] = nullptr;
}

AnswerContact answers_of_engine(const ContactQuestion& question, TriangleMesh mesh_E, TriangleMesh mesh_F,
                                bool with_record) {
  const Engine engine = engine_named(question.engine);
  const std::shared_ptr<const TestedEngine> tested =
      make_tested_engine(engine, std::move(mesh_E), std::move(mesh_F), question.law, question.mode, question.scheme);
  auto workspace = std::make_shared<TestedEngineWorkspace>();
  return [=, wanted = question.wanted, known = knowledge_of(engine)](const State& state) {
    const fast::Contact& contact = tested->evaluate(state.pose, state.velocity, wanted, *workspace);
    ContactAnswer answer{contact_json(contact), {}};
    leave_out(known, wanted, answer.json);
    if (with_record) answer.record = contact_record(contact, known);
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
    leave_out({}, wanted, answer.json);
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
