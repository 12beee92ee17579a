// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/json/question_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/meshes/expect_bad_input.h"

namespace pcm::compare {
namespace {

Json ones(std::size_t count) {
  return Json(std::vector<std::string>(count, "0x1p+0"));
}

TEST(QuestionJson, VectorsOfThreeAndMatricesOfNineNumbersAreRead) {
  EXPECT_EQ(vector_from(ones(3)), Eigen::Vector3d::Ones());
  EXPECT_EQ(matrix_from(ones(9)), Eigen::Matrix3d::Ones());
}

TEST(QuestionJson, VectorsAndMatricesOfOtherLengthsAreRefused) {
  for (const std::size_t count : {0U, 2U, 4U, 9U})
    expect_bad_input([&] { vector_from(ones(count)); },
                     "a list of 3 numbers is wanted, not of " + std::to_string(count));
  for (const std::size_t count : {0U, 3U, 8U, 10U})
    expect_bad_input([&] { matrix_from(ones(count)); },
                     "a list of 9 numbers is wanted, not of " + std::to_string(count));
  expect_bad_input([] { vector_from(Json("0x1p+0")); }, "a list of 3 numbers is wanted; this is of type string");
  expect_bad_input(
      [] {
        matrix_from(Json{{"0", 1}, {"1", 2}});
      },
      "a list of 9 numbers is wanted; this is of type object");
}

TEST(QuestionJson, NestedListInPlaceOfANumberIsRefusedHoweverDeep) {
  Json nested = ones(3);
  nested[0] = Json::parse(std::string(200000, '[') + std::string(200000, ']'));
  expect_bad_input([&] { vector_from(nested); }, "a number in quotes is wanted");
}

}  // namespace
}  // namespace pcm::compare
