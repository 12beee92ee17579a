// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string contents(const std::string& path) {
  std::ifstream in{std::string{PCM_SOURCE_DIR} + "/" + path};
  return {std::istreambuf_iterator<char>{in}, {}};
}

TEST(Readme, ExampleIsTheOneTheTestsCompile) {
  const std::string example = contents("tests/fast/example.cpp");
  const std::size_t begin = example.find("#include");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_NE(contents("README.md").find("```cpp\n" + example.substr(begin) + "```"), std::string::npos);
}

}  // namespace
