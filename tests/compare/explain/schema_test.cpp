// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is printed as JSON is what its schema says.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "compare/explain/explanation_json.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "pcm/bad_input.h"
#include "simulate/scenes/check_schema.h"
#include "simulate/scenes/located_json.h"

namespace pcm::compare {
namespace {

void check(const Json& explanation) {
  simulate::check_schema(simulate::LocatedJson("line", dump_exactly(explanation)), explanation_schema());
}

Json explained(const degenerate::Case& named, const Eigen::Vector3d& moved) {
  const Explainer explainer(named.E, named.F, Mode::both, Scheme::barycentric);
  const ExplainOptions options{.listed = std::numeric_limits<std::size_t>::max()};
  return explanation_json(explainer.explain({named.A, named.r + moved}, options), explainer, options, named.name);
}

TEST(ExplanationSchema, HoldsForTheCatalogue) {
  for (const degenerate::Case& named : degenerate::catalogue()) {
    EXPECT_NO_THROW(check(explained(named, {0, 0, 0}))) << named.name;
    EXPECT_NO_THROW(check(explained(named, {0, 0, 0x1p-9}))) << named.name;
  }
}

TEST(ExplanationSchema, ForbidsAnythingElse) {
  const Json explanation = explained(degenerate::find_case("vertex_on_face"), {0, 0, 0});
  Json more = explanation, less = explanation, wrong = explanation;
  more["word"] = 1;
  less.erase("coincident");
  wrong["coincidences"][0]["kind"] = "near_miss";
  for (const Json& json : {more, less, wrong}) EXPECT_THROW(check(json), BadInput) << json;
}

}  // namespace
}  // namespace pcm::compare
