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

/// Lines of a function's body, without what they are indented by.
std::string unindented(const std::string& lines) {
  std::string result = lines.substr(lines.find_first_not_of(' '));
  for (std::size_t at = result.find("\n  "); at != std::string::npos; at = result.find("\n  ", at + 1))
    result.erase(at + 1, 2);
  return result;
}

TEST(Readme, SurfaceFromArraysIsTheOneTheTestsRun) {
  const std::string test = contents("tests/fast/engine/surface_from_arrays_test.cpp");
  const std::size_t begin = test.find("  pcm::TriangleMesh"), end = test.find("  // clang-format on");
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  EXPECT_NE(contents("README.md").find("```cpp\n" + unindented(test.substr(begin, end - begin)) + "```"),
            std::string::npos);
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
