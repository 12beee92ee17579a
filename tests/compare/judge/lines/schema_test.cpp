// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The schemas that are printed say what is written and read.
#include <gtest/gtest.h>

#include <fstream>

#include "compare/judge/lines/answer_lines.h"
#include "compare/judge/lines/schemas.h"
#include "pcm/bad_input.h"
#include "simulate/scenes/check_schema.h"
#include "simulate/scenes/located_json.h"
#include "tests/compare/judge/poses/posed_folder.h"

namespace pcm::compare {
namespace {

void check(const std::string& line, std::string_view schema) {
  simulate::check_schema(simulate::LocatedJson("line", line), schema);
}

TEST(Schemas, HoldForWhatIsWritten) {
  for (const Notation notation : {Notation::decimal, Notation::hexadecimal}) {
    const PosedFolder folder(24, {Scheme::barycentric, Scheme::clipped}, notation);
    std::ifstream poses(folder.path() + "/poses.jsonl");
    int lines = 0;
    for (std::string line; std::getline(poses, line); ++lines) EXPECT_NO_THROW(check(line, pose_schema())) << line;
    EXPECT_EQ(lines, 25);
    for (std::size_t k = 0; k < folder.answers.size(); ++k) {
      const std::string line = dump_exactly(answer_json(folder.posed.questions[k].id, folder.answers[k], notation));
      EXPECT_NO_THROW(check(line, answer_schema())) << line;
    }
  }
}

TEST(Schemas, ForbidWhatIsRefused) {
  for (const char* line :
       {R"({"touching":true})", R"({"id":7})", R"({"id":"a","touching":1})", R"({"id":"a","force":[1,2]})",
        R"({"id":"a","volume":"nan"})", R"({"id":"a","pairs":[]})", R"({"id":"a","crossing_pairs":[[1,2,3]]})",
        R"({"id":"a","E":{"inner":[-1]}})", R"({"id":"a","E":{"inner":[3,3]}})", R"({"id":"a","polygons":1.5})",
        R"({"id":"a","elements":[{"master_face":0}]})", R"({"format":"pcm answers 9"})"})
    EXPECT_THROW(check(line, answer_schema()), BadInput) << line;
  for (const char* line : {R"({"id":"a"})", R"({"id":"a","elements":3})", R"({"id":"a","volume":null})",
                           R"({"id":"a","force":["0x1p-3","1e5",-2]})", R"({"format":"pcm answers 1","engine":"e"})"})
    EXPECT_NO_THROW(check(line, answer_schema())) << line;
}

}  // namespace
}  // namespace pcm::compare
