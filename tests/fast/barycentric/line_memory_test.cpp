// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/barycentric/line_memory.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

namespace pcm::fast {
namespace {

LineTrace trace_of(std::vector<Index> slave_faces, std::vector<Index> own_faces) {
  LineTrace trace;
  trace.slave_faces = std::move(slave_faces);
  trace.own_faces = std::move(own_faces);
  trace.slave_searched = 3;
  trace.own_searched = 2;
  trace.own_listed = true;
  return trace;
}

/// Whether the faces that the line of a face may meet are known; asked about faces in their order.
bool holds(LineMemory& memory, Index face) {
  const LineMemory::Line* const line = memory.recall(face);
  return line != nullptr && memory.holds(*line);
}

std::vector<Index> slave_faces_of(const LineMemory& memory, const LineMemory::Line& line) {
  return {memory.slave_faces(line), memory.slave_faces(line) + line.slave_count};
}
std::vector<Index> own_faces_of(const LineMemory& memory, const LineMemory::Line& line) {
  return {memory.own_faces(line), memory.own_faces(line) + line.own_count};
}

TEST(LineMemory, KnowsOfThoseLinesThatItWasToldOfAtThePoseBefore) {
  LineMemory memory;
  memory.start(0, 1, 0.5);
  EXPECT_EQ(memory.recall(2), nullptr);
  memory.keep(2, 20);
  memory.keep(5, 50);
  memory.keep(9, -1);
  memory.start(0.25, 1, 0.5);
  EXPECT_EQ(memory.recall(1), nullptr);
  // The line of 2 isn't asked about.
  const LineMemory::Line* const line = memory.recall(5);
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->slave_nearby, 50);
  EXPECT_FALSE(memory.holds(*line));
  EXPECT_EQ(memory.recall(6), nullptr);
  const LineMemory::Line* const beside_none = memory.recall(9);
  ASSERT_NE(beside_none, nullptr);
  EXPECT_EQ(beside_none->slave_nearby, -1);
  EXPECT_EQ(memory.recall(10), nullptr);
  memory.start(0.5, 1, 0.5);
  EXPECT_EQ(memory.recall(5), nullptr) << "nothing was kept";
}

TEST(LineMemory, FacesThatWereSearchedForHoldUntilAllIsTravelled) {
  LineMemory memory;
  memory.start(4, 1, 0.5);
  memory.keep(0, 8, trace_of({1}, {}));
  memory.keep(3, 7, trace_of({7, 8}, {1, 4, 6}));
  for (const double travelled : {4.0, 4.5, 0x1.3ffffffffffffp2}) {
    SCOPED_TRACE(travelled);
    memory.start(travelled, 100, 50);
    const LineMemory::Line* const line = memory.recall(3);
    ASSERT_NE(line, nullptr);
    EXPECT_TRUE(memory.holds(*line));
    EXPECT_EQ(slave_faces_of(memory, *line), (std::vector<Index>{7, 8}));
    EXPECT_EQ(own_faces_of(memory, *line), (std::vector<Index>{1, 4, 6}));
    EXPECT_EQ(line->slave_searched, 3);
    EXPECT_EQ(line->own_searched, 2);
    memory.keep(2, 1);
    memory.keep(*line, 11);
  }
  memory.start(5, 1, 0.5);
  const LineMemory::Line* const line = memory.recall(3);
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->slave_nearby, 11);
  EXPECT_FALSE(memory.holds(*line));
}

TEST(LineMemory, HoldsAsLongAfterTravelIsCountedAnew) {
  LineMemory memory;
  memory.start(4, 1, 0.5);
  memory.keep(3, 7, trace_of({7}, {}));
  memory.start_travel_anew(4.5);
  memory.start(0.25, 1, 0.5);
  EXPECT_TRUE(holds(memory, 3));
  const LineMemory::Line* const line = memory.recall(3);
  ASSERT_NE(line, nullptr);
  memory.keep(*line, 7);
  memory.start(0.5, 1, 0.5);
  const LineMemory::Line* const later = memory.recall(3);
  ASSERT_NE(later, nullptr);
  EXPECT_FALSE(memory.holds(*later));
}

/// Whether the line of face 3 is settled at the next pose; goes on to remember it, if so.
bool is_settled(LineMemory& memory, double travelled) {
  memory.start(travelled, 1, 0.5);
  const LineMemory::Line* const line = memory.recall(3);
  if (line == nullptr || !memory.is_settled(*line)) return false;
  memory.keep(*line);
  return true;
}

TEST(LineMemory, WhatALineFindsIsSettledUntilFHasTravelledSoFar) {
  LineMemory memory;
  memory.start(4, 1, 0.5);
  memory.keep(3, 7);
  memory.settle(0.75, 9);
  EXPECT_TRUE(is_settled(memory, 4.5));
  EXPECT_TRUE(is_settled(memory, 4.625));
  EXPECT_EQ(memory.recall(3)->element_on, 9);
  memory.start_travel_anew(4.625);
  EXPECT_TRUE(is_settled(memory, 0));
  EXPECT_TRUE(is_settled(memory, 0.0625));
  EXPECT_FALSE(is_settled(memory, 0.125));
}

TEST(LineMemory, ALineThatIsFollowedAnewIsNotSettled) {
  LineMemory memory;
  memory.start(4, 1, 0.5);
  memory.keep(3, 7, trace_of({7}, {}));
  memory.settle(0.75, 9);
  memory.start(4.25, 1, 0.5);
  const LineMemory::Line* const line = memory.recall(3);
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(memory.held_for(*line), 0.75);
  memory.keep(*line, 8);
  EXPECT_FALSE(is_settled(memory, 4.5));
}

TEST(LineMemory, NothingIsSettledWhereVerticesAreFartherOff) {
  LineMemory memory;
  for (const double error : {1.0, 2.0, 2.5, 5.0, 1.0}) {
    memory.start(0, 1, 0.5);
    memory.note_vertex_error(error);
    const LineMemory::Line* const line = memory.recall(3);
    const bool settled = line != nullptr && memory.is_settled(*line);
    EXPECT_EQ(settled, error == 2.0 || error == 5.0 || (error == 1.0 && line != nullptr)) << error;
    EXPECT_GE(memory.vertex_error(), error);
    memory.keep(3, 7);
    memory.settle(1, 9);
  }
}

TEST(LineMemory, OtherFacesOfTheMasterThatAreNotListedHoldNowhere) {
  LineMemory memory;
  memory.start(0, 1, 0.5);
  LineTrace trace = trace_of({7}, {1});
  trace.own_listed = false;
  memory.keep(3, 7, trace);
  memory.start(0, 1, 0.5);
  const LineMemory::Line* const line = memory.recall(3);
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->own_searched, -std::numeric_limits<double>::infinity());
}

TEST(LineMemory, ALineAmongManyFacesIsToBeSearchedForAgain) {
  LineMemory memory;
  memory.start(0, 1, 0.5);
  memory.keep(3, 7, trace_of(std::vector<Index>(6, 7), std::vector<Index>(6, 1)));
  memory.keep(4, 8, trace_of(std::vector<Index>(6, 7), std::vector<Index>(7, 1)));
  memory.start(0, 1, 0.5);
  EXPECT_TRUE(holds(memory, 3));
  const LineMemory::Line* const among_many = memory.recall(4);
  ASSERT_NE(among_many, nullptr);
  EXPECT_FALSE(memory.holds(*among_many));
  EXPECT_EQ(among_many->slave_nearby, 8);
  EXPECT_EQ(among_many->slave_count + among_many->own_count, 0u);
}

TEST(LineMemory, KnowsOfNothingWhenCleared) {
  LineMemory memory;
  memory.start(0, 1, 0.5);
  memory.keep(3, 7, trace_of({7}, {1}));
  memory.clear();
  memory.start(0, 1, 0.5);
  EXPECT_EQ(memory.recall(3), nullptr);
}

}  // namespace
}  // namespace pcm::fast
