// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/campaign/campaign.h"

#include <signal.h>
#include <unistd.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <condition_variable>
#include <exception>
#include <random>
#include <system_error>

#include "compare/io/provenance/sha256.h"
#include "compare/io/provenance/this_host.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// A worker says so often that it lives.
constexpr std::chrono::seconds kBeat{5};
/// The beat of one that has left.
constexpr std::int64_t kGone = -1;

/// Another number where the tables are others.
constexpr std::int64_t kVersion = 1;

/// job: one row, or none yet. range: of the chunks of this file, those before `next` are claimed or done. claim: what
/// workers are at; no worker has the number 0. found: by worker and key, with the SHA-256 of both. publisher: the
/// worker that may publish. taken: jobs of other files that have been taken in.
constexpr const char* kTables = R"(
  CREATE TABLE IF NOT EXISTS job (identity TEXT, chunks INTEGER, part INTEGER, parts INTEGER, number TEXT, sha256 TEXT,
                                  finished TEXT, finished_sha256 TEXT);
  CREATE TABLE IF NOT EXISTS range (first INTEGER PRIMARY KEY, next INTEGER, end INTEGER);
  CREATE TABLE IF NOT EXISTS worker (id INTEGER PRIMARY KEY, host TEXT, process INTEGER, beat INTEGER);
  CREATE TABLE IF NOT EXISTS claim (first INTEGER PRIMARY KEY, end INTEGER, worker INTEGER);
  CREATE TABLE IF NOT EXISTS found (worker INTEGER, key TEXT, text TEXT, sha256 TEXT,
                                    PRIMARY KEY (worker, key)) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS publisher (worker INTEGER);
  CREATE TABLE IF NOT EXISTS taken (number TEXT PRIMARY KEY);)";

constexpr const char* kNothing = R"(
  DELETE FROM job; DELETE FROM range; DELETE FROM worker; DELETE FROM claim; DELETE FROM found; DELETE FROM publisher;
  DELETE FROM taken;)";

std::string random_number() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device());
}

std::string hash_of(const Campaign::Job& job, const std::string& number) {
  return sha256(fmt::format("{}\n{}\n{}/{}\n{}", job.identity, job.chunks, job.part.number, job.part.of, number));
}

std::string hash_of(const std::string& key, const std::string& text) {
  return sha256(key + '\n' + text);
}

std::int64_t count_of(Database& database, const char* sql) {
  Statement count(database, sql);
  count.step();
  return count.integer(0);
}

}  // namespace

Campaign::Campaign(const std::filesystem::path& file, std::chrono::milliseconds patience)
    : database_(file), host_(this_host()), patience_(patience) {
  Transaction transaction(database_);
  const std::int64_t version = count_of(database_, "PRAGMA user_version");
  if (version == 0 && count_of(database_, "SELECT count(*) FROM sqlite_master") > 0)
    throw BadInput(file.string() + ": this is a database of others; choose another folder");
  if (version == 0) database_.run(("PRAGMA user_version = " + std::to_string(kVersion)).c_str());
  if (version != 0 && version != kVersion)
    throw BadInput(file.string() + ": another version of pcm has written it; choose another folder");
  database_.run(kTables);
  transaction.commit();
}

Campaign::~Campaign() {
  heart_ = {};
  try {
    if (worker_ > 0) {
      require_own_job();
      Statement(database_, "UPDATE worker SET beat = ? WHERE id = ?", kGone, worker_).run();
    }
  } catch (const std::exception&) {
    // It counts as dead a while later.
  }
}

std::optional<Campaign::Job> Campaign::held() {
  Statement row(database_, "SELECT identity, chunks, part, parts, number, sha256 FROM job");
  if (!row.step()) return std::nullopt;
  Job job{row.text(0), row.integer(1), {row.integer(2), row.integer(3)}};
  job_ = row.text(4);
  if (row.text(5) != hash_of(job, job_)) throw_damaged(database_.file());
  Statement ranges(
      database_,
      "SELECT (SELECT count(*) FROM range WHERE NOT (0 <= first AND first <= next AND next <= end AND end <= "
      "?1)) + (SELECT count(*) FROM claim WHERE NOT (0 <= first AND first < end AND end <= ?1))",
      job.chunks);
  ranges.step();
  if (ranges.integer(0) > 0) throw_damaged(database_.file());
  return job;
}

void Campaign::begin(const std::function<std::optional<Job>(const std::optional<Job>&, bool)>& decide) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  const std::optional<Job> before = held();
  bool at_work = false;
  {
    Statement workers(database_, "SELECT host, process, beat, id FROM worker");
    while (workers.step()) at_work = at_work || !is_dead(workers);
  }
  if (const std::optional<Job> job = decide(before, at_work)) {
    database_.run(kNothing);
    job_ = random_number();
    Statement(database_, "INSERT INTO job VALUES (?, ?, ?, ?, ?, ?, NULL, NULL)", job->identity, job->chunks,
              job->part.number, job->part.of, job_, hash_of(*job, job_))
        .run();
    if (job->part.of > 0) {
      const std::int64_t first = job->chunks * (job->part.number - 1) / job->part.of;
      const std::int64_t end = job->chunks * job->part.number / job->part.of;
      if (first < end) Statement(database_, "INSERT INTO range VALUES (?, ?, ?)", first, first, end).run();
    }
  }
  join();
  transaction.commit();
  heart_ = std::jthread([this](const std::stop_token& stop) { beat(stop); });
}

void Campaign::join() {
  Statement(database_, "INSERT INTO worker (host, process, beat) VALUES (?, ?, 1)", host_,
            static_cast<std::int64_t>(getpid()))
      .run();
  worker_ = count_of(database_, "SELECT max(id) FROM worker");
}

void Campaign::beat(const std::stop_token& stop) {
  std::mutex sleeping;
  std::condition_variable_any woken;
  std::unique_lock sleep(sleeping);
  while (!woken.wait_for(sleep, stop, kBeat, [&] { return stop.stop_requested(); })) {
    try {
      const std::lock_guard lock(mutex_);
      require_own_job();
      Statement(database_, "UPDATE worker SET beat = beat + 1 WHERE id = ?", worker_).run();
    } catch (const std::exception&) {
      // Whoever claims or commits next meets the same, and says it.
    }
  }
}

void Campaign::require_own_job() {
  Statement row(database_, "SELECT number FROM job");
  if (!row.step() || row.text(0) != job_)
    throw BadInput(database_.file().string() + ": another call has begun another run here; choose another folder");
}

bool Campaign::is_dead(const Statement& worker) {
  const std::int64_t beat = worker.integer(2), id = worker.integer(3);
  // None has this number, or it has left.
  if (id == 0 || beat == kGone) return true;
  if (worker.text(0) == host_ && kill(static_cast<pid_t>(worker.integer(1)), 0) != 0 && errno == ESRCH) return true;
  // Another process may have its number by now. Clocks of machines differ: what counts is for how long this one has
  // heard nothing new.
  const auto [heard, is_new] = heard_.try_emplace(id, Beat{beat, Clock::now()});
  if (!is_new && heard->second.number != beat) heard->second = {beat, Clock::now()};
  return Clock::now() - heard->second.since > patience_;
}

std::optional<ChunkRange> Campaign::claim(std::int64_t most) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  require_own_job();
  std::optional<ChunkRange> claimed;
  {
    Statement others(database_,
                     "SELECT host, process, beat, worker.id, claim.first, claim.end FROM claim LEFT JOIN worker ON "
                     "worker.id = claim.worker WHERE claim.worker <> ? ORDER BY claim.first",
                     worker_);
    while (!claimed && others.step())
      if (is_dead(others)) claimed = {others.integer(4), others.integer(5)};
  }
  if (claimed) {
    const ChunkRange rest{std::min(claimed->first + most, claimed->end), claimed->end};
    claimed->end = rest.first;
    Statement(database_, "UPDATE claim SET worker = ?, end = ? WHERE first = ?", worker_, claimed->end, claimed->first)
        .run();
    if (rest.first < rest.end) Statement(database_, "INSERT INTO claim VALUES (?, ?, 0)", rest.first, rest.end).run();
  } else {
    Statement open(database_, "SELECT first, next, end FROM range WHERE next < end ORDER BY first LIMIT 1");
    if (!open.step()) return std::nullopt;
    claimed = {open.integer(1), std::min(open.integer(1) + most, open.integer(2))};
    Statement(database_, "UPDATE range SET next = ? WHERE first = ?", claimed->end, open.integer(0)).run();
    Statement(database_, "INSERT INTO claim VALUES (?, ?, ?)", claimed->first, claimed->end, worker_).run();
  }
  transaction.commit();
  return claimed;
}

bool Campaign::anything_to_claim() {
  const std::lock_guard lock(mutex_);
  if (count_of(database_, "SELECT count(*) FROM range WHERE next < end") > 0) return true;
  Statement others(
      database_,
      "SELECT host, process, beat, worker.id FROM claim LEFT JOIN worker ON worker.id = claim.worker WHERE "
      "claim.worker <> ?",
      worker_);
  while (others.step())
    if (is_dead(others)) return true;
  return false;
}

void Campaign::share_in(const std::function<void()>& work, const std::function<bool()>& stop) {
  std::chrono::milliseconds pause(50);
  while (!part_done() && !stop()) {
    if (anything_to_claim()) {
      work();
    } else {
      // The others are at the rest, and may die.
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, std::chrono::milliseconds(1000));
    }
  }
}

bool Campaign::commit(ChunkRange chunks, const std::map<std::string, std::string>& found) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  require_own_job();
  Statement(database_, "DELETE FROM claim WHERE first = ? AND end = ? AND worker = ?", chunks.first, chunks.end,
            worker_)
      .run();
  if (database_.changes() == 0) return false;
  for (const auto& [key, text] : found)
    Statement(database_, "REPLACE INTO found VALUES (?, ?, ?, ?)", worker_, key, text, hash_of(key, text)).run();
  transaction.commit();
  return true;
}

void Campaign::give_back(ChunkRange chunks) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  require_own_job();
  Statement(database_, "UPDATE claim SET worker = 0 WHERE first = ? AND end = ? AND worker = ?", chunks.first,
            chunks.end, worker_)
      .run();
  transaction.commit();
}

std::int64_t Campaign::chunks_done() {
  const std::lock_guard lock(mutex_);
  require_own_job();
  return count_of(
      database_,
      "SELECT (SELECT coalesce(sum(next - first), 0) FROM range) - (SELECT coalesce(sum(end - first), 0) FROM "
      "claim)");
}

bool Campaign::part_done() {
  const std::lock_guard lock(mutex_);
  require_own_job();
  return count_of(database_, "SELECT (SELECT count(*) FROM claim) + (SELECT count(*) FROM range WHERE next < end)") ==
         0;
}

bool Campaign::all_done() {
  const std::int64_t done = chunks_done();
  const std::lock_guard lock(mutex_);
  return done == count_of(database_, "SELECT chunks FROM job");
}

void Campaign::for_each_found(const std::function<void(const std::string&, const std::string&)>& take) {
  std::vector<std::int64_t> workers;
  {
    const std::lock_guard lock(mutex_);
    require_own_job();
    Statement ids(database_, "SELECT DISTINCT worker FROM found");
    while (ids.step()) workers.push_back(ids.integer(0));
  }
  for (const std::int64_t worker : workers) {
    // Nobody can write while a statement is open, nor this worker say that it lives: first all rows of a worker, then
    // what takes long.
    std::map<std::string, std::array<std::string, 2>> found;
    {
      const std::lock_guard lock(mutex_);
      require_own_job();
      Statement rows(database_, "SELECT key, text, sha256 FROM found WHERE worker = ?", worker);
      while (rows.step()) found[rows.text(0)] = {rows.text(1), rows.text(2)};
    }
    for (const auto& [key, text] : found) {
      if (text[1] != hash_of(key, text[0])) throw_damaged(database_.file());
      take(key, text[0]);
    }
  }
}

bool Campaign::begin_publishing() {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  require_own_job();
  {
    Statement other(
        database_,
        "SELECT host, process, beat, worker.id FROM publisher LEFT JOIN worker ON worker.id = publisher.worker");
    while (other.step())
      if (!is_dead(other)) return false;
  }
  database_.run("DELETE FROM publisher");
  Statement(database_, "INSERT INTO publisher VALUES (?)", worker_).run();
  transaction.commit();
  return true;
}

void Campaign::end_publishing() {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  require_own_job();
  Statement(database_, "DELETE FROM publisher WHERE worker = ?", worker_).run();
  transaction.commit();
}

Publishing::Publishing(Campaign& campaign) : campaign_(campaign) {
  while (!campaign_.begin_publishing()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

Publishing::~Publishing() {
  try {
    campaign_.end_publishing();
  } catch (const std::exception&) {
    // The others take over when this process is gone.
  }
}

void Campaign::finish(const std::string& note) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  require_own_job();
  Statement(database_, "UPDATE job SET finished = ?, finished_sha256 = ?", note, sha256(job_ + note)).run();
  transaction.commit();
}

std::optional<std::string> Campaign::finished() {
  const std::lock_guard lock(mutex_);
  require_own_job();
  Statement row(database_, "SELECT finished, finished_sha256 FROM job WHERE finished IS NOT NULL");
  if (!row.step()) return std::nullopt;
  if (row.text(1) != sha256(job_ + row.text(0))) throw_damaged(database_.file());
  return row.text(0);
}

void Campaign::take_in(const std::vector<std::filesystem::path>& files) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  require_own_job();
  const Job ours = *held();
  for (const std::filesystem::path& file : files) {
    if (!std::filesystem::exists(file)) throw BadInput(file.string() + ": there is no run in this folder");
    if (std::filesystem::equivalent(file, database_.file())) continue;
    Campaign other(file);
    take_in(other, ours);
  }
  transaction.commit();
}

void Campaign::take_in(Campaign& other, const Job& ours) {
  const std::string file = other.database_.file().string();
  const std::optional<Job> theirs = other.held();
  if (!theirs || theirs->identity != ours.identity || theirs->chunks != ours.chunks)
    throw BadInput(file + ": of another run than the one that the arguments describe, or of another build");
  Statement(database_, "INSERT OR IGNORE INTO taken VALUES (?)", other.job_).run();
  if (database_.changes() == 0) return;
  if (!other.part_done()) throw BadInput(file + ": its part is not done; finish it first");
  Statement ranges(other.database_, "SELECT first, end FROM range");
  while (ranges.step()) {
    const std::int64_t first = ranges.integer(0), end = ranges.integer(1);
    Statement shared(database_, "SELECT count(*) FROM range WHERE first < ? AND end > ?", end, first);
    shared.step();
    if (shared.integer(0) > 0) throw BadInput(file + ": holds poses that another folder holds too");
    Statement(database_, "INSERT INTO range VALUES (?, ?, ?)", first, end, end).run();
  }
  // Its workers get numbers that nobody else has.
  const std::int64_t before = count_of(database_, "SELECT max(id) FROM worker");
  Statement found(other.database_, "SELECT worker, key, text, sha256 FROM found");
  while (found.step())
    Statement(database_, "INSERT INTO found VALUES (?, ?, ?, ?)", before + found.integer(0), found.text(1),
              found.text(2), found.text(3))
        .run();
  const std::int64_t newest = before + count_of(other.database_, "SELECT coalesce(max(id), 0) FROM worker");
  Statement(database_, "INSERT OR IGNORE INTO worker VALUES (?, '', 0, ?)", newest, kGone).run();
}

}  // namespace pcm::compare
