// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/io/json/question_json.h"
#include "compare/judge/lines/given_answer.h"
#include "compare/judge/lines/posed_question.h"

/// Answers as lines of JSON (answer.schema.json).
namespace pcm::compare {

inline constexpr const char* kAnswersFormat = "pcm answers 1";

/// Throws BadInput, without file and line, for an unknown key, a value of the wrong type, a number that is none, a face
/// that a surface does not have, or one that is listed twice.
GivenAnswer answer_from(const Json& json, const PosedQuestions& posed, const PosedQuestion& question);

/// The same the other way round, with the pose's id.
Json answer_json(const std::string& id, const GivenAnswer& answer, Notation notation);

/// The line that answers may begin with says which format they have, and may say of what files the engine has read the
/// surfaces: throws BadInput where that is another format, a surface is unknown, or its SHA-256 another one.
void check_answers_header(const Json& json, const PosedQuestions& posed);

}  // namespace pcm::compare
