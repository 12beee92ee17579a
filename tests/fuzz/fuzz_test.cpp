// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/compare/verify/routes/altering_seam.h"
#include "tests/fuzz/contact_target.h"
#include "tests/fuzz/mutation.h"
#include "tests/fuzz/target.h"
#include "tests/meshes/content_of.h"

namespace pcm::fuzz {
namespace {

std::vector<std::string> corpus(std::string_view target) {
  const std::filesystem::path folder = std::filesystem::path(PCM_SOURCE_DIR) / "tests/fuzz/corpus" / target;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const std::filesystem::path& file : files) inputs.push_back(content_of(file));
  return inputs;
}

/// The bytes as a C string literal, to put them into a test.
std::string as_literal(std::string_view bytes) {
  std::ostringstream text;
  for (const char c : bytes) text << "\\x" << std::hex << static_cast<int>(static_cast<unsigned char>(c));
  return '"' + text.str() + '"';
}

void expect_no_finding(const Target& target, const std::string& bytes) {
  try {
    target.run(bytes);
  } catch (const std::exception& finding) {
    ADD_FAILURE() << target.name << ": " << finding.what() << "\nbytes: " << as_literal(bytes);
  }
}

class Fuzz : public testing::TestWithParam<std::string> {
 protected:
  const Target& target() const { return target_named(GetParam()); }
};

TEST_P(Fuzz, CorpusIsRefusedOrAnsweredRightly) {
  const std::vector<std::string> inputs = corpus(GetParam());
  ASSERT_GE(inputs.size(), 5U);
  for (const std::string& input : inputs) expect_no_finding(target(), input);
}

TEST_P(Fuzz, MutationsOfTheCorpusAreRefusedOrAnsweredRightly) {
  const std::vector<std::string> inputs = corpus(GetParam());
  constexpr int kTries = 2000;
  constexpr std::uint64_t kSeed = 19;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < kTries && !HasFailure(); ++i) {
    expect_no_finding(target(), mutate(inputs[random() % inputs.size()], inputs, random));
  }
}

TEST(FuzzContact, DoubledForceIsFoundInHalfOfTheCorpus) {
  const compare::AlteringSeam doubled([](fast::Contact& contact) {
    contact.force_Me *= 2;
    return true;
  });
  const std::vector<std::string> inputs = corpus("contact");
  std::size_t found = 0;
  for (const std::string& input : inputs) {
    try {
      compare_contact_through(input, doubled);
    } catch (const Found& finding) {
      EXPECT_NE(std::string(finding.what()).find("force"), std::string::npos) << finding.what();
      ++found;
    }
  }
  EXPECT_GE(2 * found, inputs.size()) << found;
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const Target& target : targets()) names.emplace_back(target.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz, testing::ValuesIn(names()), [](const auto& of) { return of.param; });

}  // namespace
}  // namespace pcm::fuzz
