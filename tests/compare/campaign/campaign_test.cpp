// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every chunk is done once, by whichever worker, and what a dead one was at falls to the others.
#include "compare/campaign/campaign.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "pcm/bad_input.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::campaign_test {
namespace {

class CampaignTest : public testing::Test {
 protected:
  std::filesystem::path file(const char* name = "one") const { return scratch_.path() / name; }

  /// Continues what the file holds, if anything.
  static void begin(Campaign& campaign, std::int64_t chunks = 100, JobPart part = {}) {
    campaign.begin([&](const std::optional<Campaign::Job>& held, bool) -> std::optional<Campaign::Job> {
      if (held) return std::nullopt;
      return Campaign::Job{"job", chunks, part};
    });
  }

  /// A number of a process that is no more.
  static std::int64_t dead_process() {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    waitpid(child, nullptr, 0);
    return child;
  }

  void change(const char* sql) const {
    Database database(file());
    database.run(sql);
  }

  TemporaryFolder scratch_;
};

std::map<std::string, std::string> found_in(Campaign& campaign) {
  std::map<std::string, std::string> found;
  campaign.for_each_found([&](const std::string& key, const std::string& text) { found[key] += text; });
  return found;
}

TEST_F(CampaignTest, RefusesADatabaseOfOthersAndLeavesItAsItIs) {
  change("CREATE TABLE mine (x)");
  const std::string before = content_of(file());
  expect_bad_input([&] { Campaign campaign(file()); }, "this is a database of others; choose another folder");
  EXPECT_EQ(content_of(file()), before);
}

TEST_F(CampaignTest, HandsOutEveryChunkOnceToAnyNumberOfThreadsAndWorkers) {
  Campaign first(file()), second(file());
  begin(first, 1000);
  begin(second);
  std::mutex mutex;
  std::multiset<std::int64_t> done;
  const auto work = [&](Campaign& campaign, std::int64_t most) {
    while (const std::optional<ChunkRange> chunks = campaign.claim(most)) {
      EXPECT_LE(chunks->end - chunks->first, most);
      EXPECT_TRUE(campaign.commit(*chunks, {}));
      const std::lock_guard lock(mutex);
      for (std::int64_t chunk = chunks->first; chunk < chunks->end; ++chunk) done.insert(chunk);
    }
  };
  {
    std::vector<std::jthread> threads;
    for (Campaign* campaign : {&first, &second})
      for (const std::int64_t most : {1, 7}) threads.emplace_back([&, campaign, most] { work(*campaign, most); });
  }
  EXPECT_EQ(done.size(), 1000U);
  EXPECT_EQ(std::set<std::int64_t>(done.begin(), done.end()).size(), 1000U);
  EXPECT_TRUE(first.part_done());
  EXPECT_TRUE(first.all_done());
}

TEST_F(CampaignTest, StaysAtWorkWhileWhatWasFoundIsTaken) {
  // Taking may be long, and a worker that is not heard meanwhile counts as dead.
  Campaign campaign(file());
  begin(campaign, 2);
  const std::optional<ChunkRange> first = campaign.claim(1);
  ASSERT_TRUE(first);
  ASSERT_TRUE(campaign.commit(*first, {{"key", "text"}}));
  std::future<bool> asked;
  campaign.for_each_found([&](const std::string&, const std::string&) {
    asked = std::async(std::launch::async, [&] { return campaign.anything_to_claim(); });
    EXPECT_EQ(asked.wait_for(std::chrono::seconds(20)), std::future_status::ready);
  });
  ASSERT_TRUE(asked.valid());
  EXPECT_TRUE(asked.get());
}

TEST_F(CampaignTest, NoMoreIsInheritedAtATimeThanIsAskedFor) {
  Campaign dead(file()), living(file());
  begin(dead, 5);
  begin(living);
  const std::optional<ChunkRange> all = dead.claim(9);
  dead.give_back(*all);
  for (const std::int64_t first : {0, 2, 4}) {
    const std::optional<ChunkRange> some = living.claim(2);
    ASSERT_TRUE(some);
    EXPECT_EQ(some->first, first);
    EXPECT_EQ(some->end, std::min<std::int64_t>(first + 2, 5));
    EXPECT_TRUE(living.commit(*some, {}));
  }
  EXPECT_TRUE(living.all_done());
}

TEST_F(CampaignTest, WhatADeadWorkerWasAtFallsToTheOthersAndNoLivingOnes) {
  Campaign dead(file()), living(file());
  begin(dead, 2);
  begin(living);
  ASSERT_TRUE(dead.claim(1));
  const std::optional<ChunkRange> own = living.claim(1);
  ASSERT_TRUE(own);
  EXPECT_FALSE(living.anything_to_claim());
  EXPECT_FALSE(living.claim(1)) << "the other worker is alive";
  EXPECT_FALSE(living.part_done());
  const std::string kill = "UPDATE worker SET process = " + std::to_string(dead_process()) + " WHERE id = 1";
  change(kill.c_str());
  const std::optional<ChunkRange> inherited = living.claim(1);
  ASSERT_TRUE(inherited);
  EXPECT_EQ(inherited->first, 0);
  EXPECT_FALSE(living.claim(1)) << "its own claims are not dead";
  EXPECT_TRUE(living.commit(*inherited, {}));
  EXPECT_TRUE(living.commit(*own, {}));
  EXPECT_TRUE(living.all_done());
}

TEST_F(CampaignTest, AWorkerOnAnotherMachineIsDeadWhenItHasBeenSilentForLong) {
  Campaign dead(file()), living(file(), std::chrono::milliseconds(100));
  begin(dead, 1);
  begin(living);
  ASSERT_TRUE(dead.claim(1));
  change("UPDATE worker SET host = 'elsewhere', process = 1 WHERE id = 1");
  EXPECT_FALSE(living.claim(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  change("UPDATE worker SET beat = beat + 1 WHERE id = 1");
  EXPECT_FALSE(living.claim(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_FALSE(living.claim(1)) << "it was heard since";
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_TRUE(living.anything_to_claim());
  EXPECT_TRUE(living.claim(1));
}

TEST_F(CampaignTest, AWorkerThatHasLeftIsDeadAtOnceWhereverItWas) {
  Campaign living(file());
  begin(living, 2);
  {
    Campaign gone(file());
    begin(gone);
    ASSERT_TRUE(gone.claim(1));
    ASSERT_TRUE(gone.begin_publishing());
    EXPECT_FALSE(living.begin_publishing());
  }
  change("UPDATE worker SET host = 'elsewhere' WHERE id = 2");
  EXPECT_TRUE(living.begin_publishing());
  EXPECT_EQ(living.claim(1)->first, 0);
}

TEST_F(CampaignTest, AWorkerTakenForDeadCountsForNothingWhenItComesBack) {
  Campaign slow(file()), other(file(), std::chrono::milliseconds(2000));
  begin(slow, 1);
  begin(other);
  const std::optional<ChunkRange> chunk = slow.claim(1);
  change("UPDATE worker SET host = 'elsewhere' WHERE id = 1");
  EXPECT_FALSE(other.claim(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(2200));
  ASSERT_TRUE(other.claim(1));
  EXPECT_FALSE(slow.commit(*chunk, {{"key", "slow"}}));
  EXPECT_TRUE(other.commit(*chunk, {{"key", "other"}}));
  EXPECT_FALSE(slow.commit(*chunk, {{"key", "slow"}}));
  EXPECT_FALSE(other.commit(*chunk, {{"key", "again"}}));
  EXPECT_EQ(found_in(slow), (std::map<std::string, std::string>{{"key", "other"}}));
}

/// Its process may have ended, and another one have its number by now.
TEST_F(CampaignTest, AWorkerOfThisMachineThatIsSilentIsTakenForDeadThoughItsProcessIsThere) {
  Campaign silent(file()), other(file(), std::chrono::milliseconds(2000));
  begin(silent, 1);
  begin(other);
  ASSERT_TRUE(silent.claim(1));
  EXPECT_FALSE(other.claim(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(2200));
  EXPECT_TRUE(other.claim(1));
}

TEST_F(CampaignTest, AWorkerOfAJobThatIsNoMoreIsStopped) {
  Campaign former(file());
  begin(former, 2);
  const std::optional<ChunkRange> chunk = former.claim(1);
  Campaign latter(file());
  bool others = false;
  latter.begin([&](const std::optional<Campaign::Job>&, bool at_work) {
    others = at_work;
    return std::optional<Campaign::Job>({"another", 2, {}});
  });
  EXPECT_TRUE(others);
  EXPECT_THROW(former.commit(*chunk, {}), BadInput);
  EXPECT_THROW(former.claim(1), BadInput);
  EXPECT_THROW(former.give_back(*chunk), BadInput);
  EXPECT_THROW(former.finish("x"), BadInput);
  EXPECT_THROW(found_in(former), BadInput);
  EXPECT_THROW(former.part_done(), BadInput);
  EXPECT_THROW(former.begin_publishing(), BadInput);
  EXPECT_EQ(latter.claim(5)->end, 2);
}

TEST_F(CampaignTest, AtABeginningNobodyIsAtWorkWhoHasLeftOrDied) {
  const auto at_work = [this] {
    Campaign campaign(file());
    bool others = false;
    campaign.begin([&](const std::optional<Campaign::Job>&, bool are) {
      others = are;
      return std::optional<Campaign::Job>({"job", 2, {}});
    });
    return others;
  };
  EXPECT_FALSE(at_work());
  EXPECT_FALSE(at_work());
  const std::string died = "UPDATE worker SET beat = 7, process = " + std::to_string(dead_process());
  change(died.c_str());
  EXPECT_FALSE(at_work());
  change("UPDATE worker SET beat = 7, host = 'elsewhere'");
  EXPECT_TRUE(at_work());
}

TEST_F(CampaignTest, WhatIsGivenBackIsHandedOutAgain) {
  Campaign campaign(file()), other(file());
  begin(campaign, 1);
  begin(other);
  const std::optional<ChunkRange> chunk = campaign.claim(1);
  campaign.give_back(*chunk);
  EXPECT_FALSE(campaign.commit(*chunk, {}));
  EXPECT_TRUE(other.claim(1));
  EXPECT_FALSE(campaign.claim(1));
}

TEST_F(CampaignTest, WhatWorkersHaveFoundIsReplacedByTheirOwnAlone) {
  {
    Campaign first(file());
    begin(first, 3);
    EXPECT_TRUE(first.commit(*first.claim(1), {{"a", "1"}, {"b", "2"}}));
    EXPECT_TRUE(first.commit(*first.claim(1), {{"a", "3"}}));
  }
  Campaign second(file());
  begin(second);
  EXPECT_TRUE(second.commit(*second.claim(5), {{"a", "4"}}));
  EXPECT_EQ(found_in(second), (std::map<std::string, std::string>{{"a", "34"}, {"b", "2"}}));
  EXPECT_TRUE(second.all_done());
  EXPECT_FALSE(second.finished());
  second.finish("once");
  EXPECT_EQ(second.finished(), "once");
}

TEST_F(CampaignTest, SharesAreTakenInOnceEachWhenTheyAreDone) {
  for (std::int64_t k = 1; k <= 3; ++k) {
    Campaign part(file(std::to_string(k).c_str()));
    begin(part, 10, {k, 3});
    EXPECT_FALSE(part.part_done());
    if (k == 3) break;
    while (const auto chunks = part.claim(2))
      ASSERT_TRUE(part.commit(*chunks, {{"of " + std::to_string(k), std::to_string(chunks->end)}}));
    EXPECT_TRUE(part.part_done());
    EXPECT_FALSE(part.all_done());
  }
  Campaign whole(file("whole"));
  begin(whole, 10, {0, 0});
  EXPECT_TRUE(whole.part_done());
  EXPECT_FALSE(whole.all_done());
  whole.take_in({file("2")});
  EXPECT_THROW(whole.take_in({file("1"), file("3")}), BadInput) << "not done";
  EXPECT_EQ(whole.chunks_done(), 3) << "all or none";
  whole.take_in({file("1"), file("2"), file("1"), file("whole")});
  EXPECT_EQ(whole.chunks_done(), 6) << "each once";
  EXPECT_FALSE(whole.all_done());
  EXPECT_THROW(whole.take_in({file("4")}), BadInput) << "not there";
  EXPECT_FALSE(std::filesystem::exists(file("4")));
  {
    Campaign again(file("again"));
    begin(again, 10, {1, 5});
    ASSERT_TRUE(again.commit(*again.claim(9), {}));
    EXPECT_THROW(whole.take_in({file("again")}), BadInput) << "some of these are held already";
  }
  Campaign other(file("other"));
  begin(other, 11);
  EXPECT_THROW(whole.take_in({file("other")}), BadInput) << "another job";
  EXPECT_EQ(found_in(whole), (std::map<std::string, std::string>{{"of 1", "3"}, {"of 2", "6"}}));
  {
    Campaign last(file("3"));
    begin(last);
    while (const auto chunks = last.claim(2)) ASSERT_TRUE(last.commit(*chunks, {}));
  }
  whole.take_in({file("3")});
  EXPECT_TRUE(whole.all_done());
}

TEST_F(CampaignTest, PartsOfLessThanAChunkAreTakenInToo) {
  Campaign whole(file("whole"));
  begin(whole, 1, {0, 0});
  for (std::int64_t k = 1; k <= 3; ++k) {
    const std::filesystem::path part_file = file(std::to_string(k).c_str());
    Campaign part(part_file);
    begin(part, 1, {k, 3});
    while (const auto chunks = part.claim(2)) ASSERT_TRUE(part.commit(*chunks, {}));
    EXPECT_TRUE(part.part_done());
    whole.take_in({part_file});
  }
  EXPECT_TRUE(whole.all_done());
}

TEST_F(CampaignTest, DamageIsNoticed) {
  const auto expect_damaged = [this](const std::function<void(Campaign&)>& use) {
    try {
      Campaign campaign(file());
      begin(campaign);
      use(campaign);
      FAIL() << "not noticed";
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find("damaged"), std::string::npos) << error.what();
    }
  };
  {
    Campaign campaign(file());
    begin(campaign, 2);
    ASSERT_TRUE(campaign.commit(*campaign.claim(1), {{"key", "text"}}));
  }
  const auto nothing = [](Campaign&) {};
  change("UPDATE found SET key = 'other'");
  expect_damaged([](Campaign& campaign) { found_in(campaign); });
  for (const char* sql : {"UPDATE job SET chunks = 3", "UPDATE job SET parts = 2", "UPDATE job SET identity = 'x'",
                          "UPDATE range SET next = -1", "UPDATE range SET end = 3", "UPDATE range SET next = 3",
                          "INSERT INTO claim VALUES (1, 3, 1)"}) {
    SCOPED_TRACE(sql);
    std::filesystem::remove(file());
    {
      Campaign campaign(file());
      begin(campaign, 2);
    }
    change(sql);
    expect_damaged(nothing);
  }
  std::filesystem::remove(file());
  {
    Campaign campaign(file());
    begin(campaign, 1);
    campaign.finish("note");
  }
  change("UPDATE job SET finished = 'other'");
  expect_damaged([](Campaign& campaign) { campaign.finished(); });
  scratch_.write("one", std::string(5000, 'x'));
  expect_damaged(nothing);
}

TEST_F(CampaignTest, OfAnotherVersionIsRefused) {
  { const Campaign campaign(file()); }
  change("PRAGMA user_version = 99");
  EXPECT_THROW(Campaign{file()}, BadInput);
}

TEST_F(CampaignTest, AFolderThatIsNoneIsNamed) {
  try {
    const Campaign campaign(scratch_.path() / "nowhere" / "one");
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere/one"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace pcm::compare::campaign_test
