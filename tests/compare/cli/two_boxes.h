// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/io/json/exact_json.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {

/// A box of 1 m in a file, for `pcm contact` with itself.
class TwoBoxes : public testing::Test {
 protected:
  const TemporaryFolder scratch_;
  const std::string box_ = scratch_.path("box.obj");

  void SetUp() override { ASSERT_EQ(run_pcm({"mesh", "make", "box", "-o", box_}).status, 0); }

  /// The answers that `pcm contact` prints for this poses file and these options.
  std::vector<Json> contact(const std::string& poses, const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments{"contact", box_, box_, "--poses", scratch_.write("poses.txt", poses)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    std::vector<Json> answers;
    for (const std::string& line : lines_of(outcome.out)) answers.push_back(Json::parse(line));
    return answers;
  }
};

}  // namespace pcm::compare
