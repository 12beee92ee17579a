// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/table.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace pcm::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Table, CsvLeavesFieldsEmptyThatHaveNoFiniteValue) {
  const Table table{{{"a", "a", false}, {"b", "b"}, {"c", "c"}, {"d", "d"}, {"e", "e"}},
                    {{TableCell("x, \"y\""), TableCell("inf", kInfinity), TableCell("-inf", -kInfinity),
                      TableCell("nan", kNaN), empty_cell()},
                     {TableCell("z"), count_cell(3), TableCell("2.5", 2.5), TableCell("0", 0.0), count_cell(-1)}}};
  EXPECT_EQ(csv(table), "a,b,c,d,e\n\"x, \"\"y\"\"\",,,,\n\"z\",3,2.5,0.0,-1\n");
}

TEST(Table, NumbersThatAreNotFiniteHaveAShortWord) {
  EXPECT_EQ(number_cell(kInfinity, 3).text, "inf");
  EXPECT_EQ(number_cell(-kInfinity, 3).text, "-inf");
  EXPECT_EQ(number_cell(kNaN, 3).text, empty_cell().text);
  EXPECT_TRUE(number_cell(kNaN, 3).value.is_null());
  EXPECT_EQ(number_cell(-0.0123456, 3).text, "-0.0123");
  EXPECT_EQ(number_cell(0, 3).text, "0.00");
}

TEST(Table, CsvRefusesListsInACell) {
  const Table table{{{"a", "a"}}, {{TableCell("1 to 2", nlohmann::ordered_json{1, 2})}}};
  EXPECT_DEBUG_DEATH(csv(table), "is_primitive");
}

}  // namespace
}  // namespace pcm::compare
