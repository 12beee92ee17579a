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

/// The source without the lines that come before its first line of this kind.
std::string from(const std::string& source, const std::string& first) {
  const std::size_t begin = source.find(first);
  return begin == std::string::npos ? "no line begins with " + first : source.substr(begin);
}

TEST(Languages, ExamplesAreThoseTheTestsRun) {
  const std::string page = contents("docs/languages.md");
  const std::string folder = "bindings/examples/bubbles.";
  EXPECT_NE(page.find("```cpp\n" + from(contents("tests/fast/example.cpp"), "#include") + "```"), std::string::npos);
  EXPECT_NE(page.find("```c\n" + from(contents(folder + "c"), "#include") + "```"), std::string::npos);
  EXPECT_NE(page.find("```fortran\n" + from(contents(folder + "f90"), "program") + "```"), std::string::npos);
  EXPECT_NE(page.find("```python\n" + from(contents(folder + "py"), "import") + "```"), std::string::npos);
}

}  // namespace
