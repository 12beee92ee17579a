// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every chunk is done once, by whichever worker, and what a dead one was at falls to the others.
#include "compare/campaign/campaign.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "pcm/bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::campaign_test {
namespace {

class CampaignTest : public testing::Test {
 protected:
  std::filesystem::path file(const char* name = "one") const { return scratch_.path() / name; }

  /// Continues what the file holds, if anything.
  static void begin(Campaign& campaign, std::int64_t chunks = 100, JobPart part = {}) {
    campaign.begin([&](const std::optional<Campaign::Job>& held) -> std::optional<Campaign::Job> {
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

TEST_F(CampaignTest, WhatADeadWorkerWasAtFallsToTheOthersAndNoLivingOnes) {
  Campaign dead(file()), living(file());
  begin(dead, 2);
  begin(living);
  ASSERT_TRUE(dead.claim(1));
  const std::optional<ChunkRange> own = living.claim(1);
  ASSERT_TRUE(own);
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
  Campaign dead(file()), living(file());
  begin(dead, 1);
  begin(living);
  ASSERT_TRUE(dead.claim(1));
  change("UPDATE worker SET host = 'elsewhere', process = 1 WHERE id = 1");
  EXPECT_FALSE(living.claim(1));
  change("UPDATE worker SET beat = beat - 50 WHERE id = 1");
  EXPECT_FALSE(living.claim(1));
  change("UPDATE worker SET beat = beat - 50 WHERE id = 1");
  EXPECT_TRUE(living.claim(1));
}

TEST_F(CampaignTest, AWorkerTakenForDeadCountsForNothingWhenItComesBack) {
  Campaign slow(file()), other(file());
  begin(slow, 1);
  begin(other);
  const std::optional<ChunkRange> chunk = slow.claim(1);
  change("UPDATE worker SET host = 'elsewhere', beat = 0 WHERE id = 1");
  ASSERT_TRUE(other.claim(1));
  EXPECT_FALSE(slow.commit(*chunk, {{"key", "slow"}}));
  EXPECT_TRUE(other.commit(*chunk, {{"key", "other"}}));
  EXPECT_FALSE(slow.commit(*chunk, {{"key", "slow"}}));
  EXPECT_FALSE(other.commit(*chunk, {{"key", "again"}}));
  EXPECT_EQ(found_in(slow), (std::map<std::string, std::string>{{"key", "other"}}));
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
  EXPECT_TRUE(second.finish("once"));
  EXPECT_FALSE(second.finish("twice"));
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
  whole.take_in(file("2"));
  whole.take_in(file("1"));
  EXPECT_FALSE(whole.all_done());
  EXPECT_THROW(whole.take_in(file("1")), BadInput) << "twice";
  EXPECT_THROW(whole.take_in(file("3")), BadInput) << "not done";
  EXPECT_THROW(whole.take_in(file("4")), BadInput) << "not there";
  EXPECT_FALSE(std::filesystem::exists(file("4")));
  Campaign other(file("other"));
  begin(other, 11);
  EXPECT_THROW(whole.take_in(file("other")), BadInput) << "another job";
  EXPECT_EQ(found_in(whole), (std::map<std::string, std::string>{{"of 1", "3"}, {"of 2", "6"}}));
  {
    Campaign last(file("3"));
    begin(last);
    while (const auto chunks = last.claim(2)) ASSERT_TRUE(last.commit(*chunks, {}));
  }
  whole.take_in(file("3"));
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
  for (const char* sql : {"UPDATE job SET chunks = 3", "UPDATE job SET parts = 2", "UPDATE job SET identity = 'x'"}) {
    SCOPED_TRACE(sql);
    std::filesystem::remove(file());
    {
      Campaign campaign(file());
      begin(campaign, 2);
    }
    change(sql);
    expect_damaged(nothing);
  }
  scratch_.write("one", std::string(5000, 'x'));
  expect_damaged(nothing);
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
