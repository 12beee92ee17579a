// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/contact/contact_record.h"
#include "compare/io/json/exact_json.h"
#include "compare/poses/poses_file.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"
#include "reference/vocabulary/answer.h"

/// Who answers `pcm contact`: the engine, the oracle or a published algorithm, all in one form.
namespace pcm::compare {

struct ContactQuestion {
  std::string engine = "fast";  ///< the word of --engine
  reference::Problem problem = reference::Problem::rounded;
  ContactLaw law;
  Mode mode = Mode::E;
  Scheme scheme = Scheme::barycentric;
  Wanted wanted;
};

struct ContactAnswer {
  Json json;  ///< as contact_json.h has it; what is not known or not wanted is null
  std::optional<ContactRecord> record;
};

/// The answer to one state of a pairing; for one thread.
using AnswerContact = std::function<ContactAnswer(const State&)>;

/// With `with_record`, answers have theirs. Throws BadInput where a mesh is unfit for contact, a parameter of the law
/// out of its range, or the engine does not know the scheme.
AnswerContact contact_answers(const ContactQuestion& question, TriangleMesh mesh_E, TriangleMesh mesh_F,
                              bool with_record);

}  // namespace pcm::compare
