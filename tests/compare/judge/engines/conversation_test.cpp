// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An engine that is asked pose by pose, and whatever it may do instead of answering.
#include "compare/judge/engines/conversation.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "compare/judge/engines/asked_engine.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "tests/compare/judge/poses/posed_folder.h"

namespace pcm::compare {
namespace {

using Words = std::vector<std::string>;

TEST(WordsOfCommand, AreSplitWithoutAShell) {
  EXPECT_EQ(words_of_command("engine --fast  -x\t1 "), (Words{"engine", "--fast", "-x", "1"}));
  EXPECT_EQ(words_of_command("'my engine' \"a 'b'\" c\\ d \"\\\"\""), (Words{"my engine", "a 'b'", "c d", "\""}));
  EXPECT_EQ(words_of_command("e '' $HOME *;ls"), (Words{"e", "", "$HOME", "*;ls"}));
  EXPECT_EQ(words_of_command("e'\\n'"), (Words{"e\\n"}));
  EXPECT_THROW(words_of_command("engine 'open"), BadInput);
  EXPECT_THROW(words_of_command("  "), BadInput);
}

Conversation::Said ask_once(const std::string& script, const std::string& line = "what?", double limit = 20) {
  Conversation conversation({"/bin/sh", "-c", script}, "hello", Conversation::Seconds(limit));
  return conversation.ask(line).value();
}

TEST(Conversation, TellsTheGreetingOnceAndALineEachTime) {
  Conversation conversation({"/bin/sh", "-c", "read -r g; while read -r l; do echo \"$g $l\"; done"}, "hello",
                            Conversation::Seconds(20));
  for (const char* line : {"one", "two", "three"}) {
    const Conversation::Said said = conversation.ask(line).value();
    EXPECT_FALSE(said.breakdown) << said.failure;
    EXPECT_EQ(said.line, std::string("hello ") + line);
  }
}

TEST(Conversation, ALineLongerThanAPipeHoldsGetsThrough) {
  const Conversation::Said said = ask_once("exec cat", std::string(1 << 20, 'x'));
  EXPECT_EQ(said.line, "hello");
  Conversation echo({"/bin/sh", "-c", "read -r g; exec cat"}, "hello", Conversation::Seconds(20));
  const std::string longer(1 << 20, 'y');
  EXPECT_EQ(echo.ask(longer)->line, longer);
  EXPECT_EQ(echo.ask("short")->line, "short");
}

TEST(Conversation, BreakdownsAreToldApart) {
  const auto expect = [](const Conversation::Said& said, Breakdown kind, const std::string& words) {
    ASSERT_TRUE(said.breakdown) << said.line;
    EXPECT_EQ(*said.breakdown, kind);
    EXPECT_NE(said.failure.find(words), std::string::npos) << said.failure;
  };
  expect(ask_once("read -r l; exit 3"), Breakdown::crash, "status 3");
  expect(ask_once("exit 0"), Breakdown::crash, "status 0");
  expect(ask_once("kill -SEGV $$"), Breakdown::crash, "signal 11");
  expect(ask_once("printf half; exit 0"), Breakdown::crash, "status 0");
  expect(ask_once("exec >&-; sleep 60"), Breakdown::crash, "closed its output");
  expect(ask_once("sleep 60", "what?", 0.3), Breakdown::hang, "no answer within 0.3 s");
  expect(ask_once("sleep 60", std::string(1 << 20, 'x'), 0.3), Breakdown::hang, "no answer");
}

TEST(Conversation, GoesOnAfterABreakdown) {
  const TemporaryFolder scratch;
  const std::string file = scratch.path("started");
  Conversation conversation(
      {"/bin/sh", "-c",
       "read -r g; read -r l; [ -e " + file + " ] || { : > " + file + "; exit 1; }; echo \"$l\"; read -r l"},
      "hello", Conversation::Seconds(20));
  EXPECT_EQ(conversation.ask("one")->breakdown, Breakdown::crash);
  EXPECT_EQ(conversation.ask("two")->line, "two");
}

TEST(Conversation, WhatItStartedEndsWithIt) {
  const TemporaryFolder scratch;
  const std::string file = scratch.path("late");
  EXPECT_EQ(ask_once("(sleep 1; : > " + file + ") & wait", "what?", 0.3).breakdown, Breakdown::hang);
  EXPECT_EQ(system("sleep 1.2"), 0);
  EXPECT_FALSE(std::filesystem::exists(file));
}

// As where the user has interrupted the judgement: neither the user nor the engine waits for the time limit.
TEST(Conversation, OfOneThatHangsIsEndedWhereNobodyWaits) {
  const TemporaryFolder scratch;
  const std::string file = scratch.path("process");
  int looks = 0;
  Conversation conversation(
      {"/bin/sh", "-c", "echo $$ > " + file + ".new; mv " + file + ".new " + file + "; exec sleep 1000"}, "hello",
      Conversation::Seconds(1000), [&] { return ++looks > 3 && std::filesystem::exists(file); });
  EXPECT_FALSE(conversation.ask("what?"));
  EXPECT_EQ(kill(std::stoi(read_text_file(file)), 0), -1) << "it still runs";
}

TEST(Conversation, WhatCannotBeStartedIsBadInput) {
  Conversation conversation({"/no/such/engine"}, "hello", Conversation::Seconds(20));
  EXPECT_THROW(conversation.ask("what?"), BadInput);
}

/// Answers most poses by their id, and each of the first ones otherwise.
constexpr const char* kToyEngine = R"(#!/bin/sh
read -r greeting
while read -r line; do
  id=${line#'{"id":"'}
  id=${id%%'"'*}
  case $id in
    */generic/0/*) exit 3 ;;
    */generic/1/*) sleep 60 ;;
    */generic/2/*) echo 'I do not know' ;;
    */generic/3/*) echo '{"id":"another","touching":true}' ;;
    */generic/4/*) echo '{"id":"'"$id"'","touching":"yes"}' ;;
    *) echo '{"id":"'"$id"'","touching":true}' ;;
  esac
done
)";

TEST(AskedEngine, IsAskedEveryPoseWhateverItDoes) {
  const PosedFolder folder(36);
  const std::string engine = folder.folder.write("engine.sh", kToyEngine);
  AskedEngine asked("/bin/sh " + engine, folder.posed, folder.path(), Conversation::Seconds(2));
  for (std::size_t k = 0; k < folder.posed.questions.size(); ++k) {
    const std::string& id = folder.posed.questions[k].id;
    const Reply reply = asked.ask(k).value();
    EXPECT_EQ(reply.question, k);
    const auto is_pose = [&](const char* word) { return id.find(word) != std::string::npos; };
    const std::optional<Breakdown> expected =
        is_pose("/generic/0/")                                                       ? std::optional(Breakdown::crash)
        : is_pose("/generic/1/")                                                     ? std::optional(Breakdown::hang)
        : is_pose("/generic/2/") || is_pose("/generic/3/") || is_pose("/generic/4/") ? std::optional(Breakdown::garbage)
                                                                                     : std::nullopt;
    EXPECT_EQ(reply.breakdown, expected) << id << ": " << reply.failure;
    EXPECT_EQ(reply.answer.touching.has_value(), !expected) << id;
  }
}

}  // namespace
}  // namespace pcm::compare
