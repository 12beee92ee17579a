// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "compare/campaign/database.h"

namespace pcm::compare {

/// What the file of a campaign is called in its folder.
inline constexpr const char* kCampaignFile = "campaign.sqlite";

/// Some neighbouring chunks of a job, from `first` to before `end`.
struct ChunkRange {
  std::int64_t first = 0, end = 0;
};

/// Part `number` of `of` parts of a job, from 1; of none: no part of its own. Products with numbers of chunks stay
/// below 2^63.
struct JobPart {
  std::int64_t number = 1, of = 1;

  bool operator==(const JobPart&) const = default;
};

/// Where chunks come from, and where what came of them goes.
template <class Result>
class Chunks {
 public:
  Chunks() = default;
  Chunks(const Chunks&) = delete;
  Chunks& operator=(const Chunks&) = delete;
  virtual ~Chunks() = default;

  /// No more than so many neighbouring chunks that nobody else is at; none where there are none now. From any thread.
  virtual std::optional<ChunkRange> claim(std::int64_t most) = 0;
  /// What came of chunks that were claimed. From any thread.
  virtual void commit(ChunkRange chunks, Result result) = 0;
  /// Chunks that were claimed and not done.
  virtual void give_back(ChunkRange chunks) = 0;
};

/// A job of many chunks done together by any number of processes, on one machine or on several that share a folder. All
/// they know of each other stands in one SQLite file: which chunks are done, who is at which, and what each has found
/// so far, by key. What a process that dies was at falls to the others. Memory and file grow with workers and keys, not
/// with chunks.
///
/// Every function may be called from any thread, and throws BadInput naming the file where that can't be read or
/// written or is damaged, and where another call has begun another job in it since.
class Campaign {
 public:
  /// Opens the file or makes it. Nothing is done yet where it is new. A worker counts as dead
  /// when its process is gone from this machine, or when it has not said for so long that it lives.
  explicit Campaign(const std::filesystem::path& file, std::chrono::milliseconds patience = std::chrono::minutes(1));
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;
  ~Campaign();

  /// What the job is, and which part of it this file is for.
  struct Job {
    std::string identity;
    std::int64_t chunks = 0;
    JobPart part;
  };
  /// Decides, before any other process goes on, whether the job that the file holds (none where it holds none) is
  /// continued, and otherwise begins the one returned; `at_work`: others may be at the held one. Then this process is
  /// one of the job's workers.
  void begin(const std::function<std::optional<Job>(const std::optional<Job>& held, bool at_work)>& decide);

  /// Neighbouring chunks that nobody is at, or whose worker is dead; no more than so many.
  std::optional<ChunkRange> claim(std::int64_t most);
  /// Whether there may be something to claim. Costs the other workers nothing.
  bool anything_to_claim();
  /// Calls `work`, which does what is to be claimed, until all chunks of this file's part are done, here or by others,
  /// or `stop` says so.
  void share_in(const std::function<void()>& work, const std::function<bool()>& stop);
  /// Replaces what this worker has found under these keys. False, and nothing is changed, where the chunks are another
  /// worker's by now: this one was taken for dead.
  bool commit(ChunkRange chunks, const std::map<std::string, std::string>& found);
  void give_back(ChunkRange chunks);

  std::int64_t chunks_done();
  /// Whether all chunks of this file's part are done.
  bool part_done();
  /// Whether all chunks of the job are.
  bool all_done();
  /// Calls `take` with every key and text that a worker has found.
  void for_each_found(const std::function<void(const std::string& key, const std::string& text)>& take);

  /// Makes this worker the only one that may publish results, unless another living one is.
  bool begin_publishing();
  void end_publishing();
  /// Notes that the job is finished.
  void finish(const std::string& note);
  /// What `finish` has noted, if anything.
  std::optional<std::string> finished();

  /// Takes over what other files hold of the same job: all of them or, where one is refused, none. One that has been
  /// taken over before is passed over. Throws BadInput where a file's part is not done, or has chunks that another one
  /// has too.
  void take_in(const std::vector<std::filesystem::path>& files);

 private:
  using Clock = std::chrono::steady_clock;
  struct Beat {
    std::int64_t number = 0;
    Clock::time_point since;
  };

  void join();
  void beat(const std::stop_token& stop);
  /// `worker`: a row (host, process, beat, id).
  bool is_dead(const Statement& worker);
  std::optional<Job> held();
  void take_in(Campaign& other, const Job& ours);
  /// Within a transaction, or before a statement alone.
  void require_own_job();

  std::mutex mutex_;
  Database database_;
  std::string host_;
  std::chrono::milliseconds patience_;
  std::string job_;                     ///< a number of the held job that no other has
  std::int64_t worker_ = 0;             ///< its number; 0 before `begin`
  std::map<std::int64_t, Beat> heard_;  ///< of other workers, by their numbers: their last beat, and since when
  std::jthread heart_;
};

/// While it lives no other worker publishes results of the job.
class Publishing {
 public:
  /// Waits for another one that does.
  explicit Publishing(Campaign& campaign);
  Publishing(const Publishing&) = delete;
  Publishing& operator=(const Publishing&) = delete;
  ~Publishing();

 private:
  Campaign& campaign_;
};

/// The chunks of a campaign in a folder. What came of them, and how it is kept, is the derived class's.
template <class Result>
class SharedChunks : public Chunks<Result> {
 public:
  std::optional<ChunkRange> claim(std::int64_t most) override { return campaign_.claim(most); }
  void give_back(ChunkRange chunks) override { campaign_.give_back(chunks); }

  /// As Campaign has them.
  void share_in(const std::function<void()>& work, const std::function<bool()>& stop) {
    campaign_.share_in(work, stop);
  }
  bool part_done() { return campaign_.part_done(); }
  bool all_done() { return campaign_.all_done(); }
  Publishing publish() { return Publishing(campaign_); }

 protected:
  explicit SharedChunks(const std::filesystem::path& folder) : campaign_(folder / kCampaignFile) {}

  Campaign campaign_;
};

}  // namespace pcm::compare
