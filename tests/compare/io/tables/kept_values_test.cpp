// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/kept_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using Json = nlohmann::ordered_json;

class KeptValuesTest : public testing::Test {
 protected:
  double asked(KeptValues& kept, const std::string& name, double value) {
    return kept.number(name, [&] {
      ++found_;
      return value;
    });
  }

  const TemporaryFolder scratch_;
  const std::string file_ = scratch_.path("some.kept");
  const Json ours_{{"format", "kept"}, {"program", "1"}};
  int found_ = 0;
};

TEST_F(KeptValuesTest, AreThereForTheNextCallBitForBit) {
  const std::vector<double> numbers{0.1, -0.0, 5e-324, 1e308, std::numeric_limits<double>::infinity()};
  for (int call = 0; call < 3; ++call) {
    KeptValues kept(file_, ours_);
    EXPECT_EQ(kept.size(), call == 0 ? 0U : numbers.size() + 1);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const double x = asked(kept, std::to_string(k), numbers[k]);
      EXPECT_EQ(x, numbers[k]);
      EXPECT_EQ(std::signbit(x), std::signbit(numbers[k]));
    }
    EXPECT_TRUE(std::isnan(asked(kept, "none", std::numeric_limits<double>::quiet_NaN())));
  }
  EXPECT_EQ(found_, 6);
}

TEST_F(KeptValuesTest, OfAnotherProgramAreLeftAndLinesThatWereCutOffAreFoundAgain) {
  {
    KeptValues kept(file_, ours_);
    asked(kept, "a", 1);
    asked(kept, "b", 2);
  }
  const std::string whole = read_text_file(file_);
  write_text_file(file_, whole.substr(0, whole.size() - 4));
  {
    KeptValues kept(file_, ours_);
    EXPECT_EQ(kept.size(), 1U);
    EXPECT_EQ(asked(kept, "b", 3), 3);
  }
  EXPECT_EQ(KeptValues(file_, ours_).size(), 2U);
  EXPECT_EQ(KeptValues(file_, {{"format", "kept"}, {"program", "2"}}).size(), 0U);
  EXPECT_EQ(KeptValues(file_, ours_).size(), 0U);
}

TEST_F(KeptValuesTest, AreKeptNowhereWithoutAFileAndNotBeyondTheEnd) {
  KeptValues none;
  EXPECT_EQ(asked(none, "a", 1), 1);
  EXPECT_EQ(asked(none, "a", 2), 2);
  KeptValues kept(file_, ours_);
  asked(kept, "a", 1);
  kept.finish();
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_THROW(KeptValues(scratch_.path("nowhere/some.kept"), ours_), BadInput);
}

TEST_F(KeptValuesTest, AreNotKeptInPlaceOfAFileOfOthers) {
  for (const char* mine : {"my notes\n", "{}\n", "[\"a\", 1]\n", "{\"format\": \"another\"}\n"}) {
    write_text_file(file_, mine);
    EXPECT_THROW(KeptValues(file_, ours_), BadInput);
    EXPECT_EQ(read_text_file(file_), mine);
  }
  write_text_file(file_, "");  // of a run that the machine ended
  EXPECT_EQ(KeptValues(file_, ours_).size(), 0U);
}

}  // namespace
}  // namespace pcm::compare
