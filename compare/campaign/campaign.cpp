// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/campaign/campaign.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <stop_token>

#include "compare/io/sha256.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// A worker says so often that it lives, and counts as dead when it has not for so long.
constexpr std::chrono::seconds kBeat{5};
constexpr std::int64_t kSilence_s = 60;

/// jobs: one row, or none yet. ranges: of the chunks of this file, those before `next` are claimed or done. claims:
/// what workers are at. found: by worker and key, with the SHA-256 of the text.
constexpr const char* kTables = R"(
  CREATE TABLE IF NOT EXISTS job (identity TEXT, chunks INTEGER, part INTEGER, parts INTEGER, sha256 TEXT, finished TEXT);
  CREATE TABLE IF NOT EXISTS range (first INTEGER PRIMARY KEY, next INTEGER, end INTEGER);
  CREATE TABLE IF NOT EXISTS worker (id INTEGER PRIMARY KEY, host TEXT, process INTEGER, beat INTEGER);
  CREATE TABLE IF NOT EXISTS claim (first INTEGER PRIMARY KEY, end INTEGER, worker INTEGER);
  CREATE TABLE IF NOT EXISTS found (worker INTEGER, key TEXT, text TEXT, sha256 TEXT,
                                    PRIMARY KEY (worker, key)) WITHOUT ROWID;)";

std::int64_t now_s() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string host_name() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::string hash_of(const std::string& identity, std::int64_t chunks, JobPart part) {
  return sha256(identity + '\n' + std::to_string(chunks) + '\n' + std::to_string(part.number) + '/' +
                std::to_string(part.of));
}

}  // namespace

Campaign::Campaign(const std::filesystem::path& file) : database_(file), host_(host_name()) {
  Transaction transaction(database_);
  database_.run(kTables);
  transaction.commit();
}

Campaign::~Campaign() {
  heart_ = {};
}

std::optional<Campaign::Job> Campaign::held() {
  Statement job(database_, "SELECT identity, chunks, part, parts, sha256 FROM job");
  if (!job.step()) return std::nullopt;
  Job held{job.text(0), job.integer(1), {job.integer(2), job.integer(3)}};
  if (job.text(4) != hash_of(held.identity, held.chunks, held.part))
    throw BadInput(database_.file().string() + ": it is damaged; choose another folder");
  return held;
}

void Campaign::begin(const std::function<std::optional<Job>(const std::optional<Job>&)>& decide) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  if (const std::optional<Job> job = decide(held())) {
    database_.run("DELETE FROM job; DELETE FROM range; DELETE FROM worker; DELETE FROM claim; DELETE FROM found");
    Statement(database_, "INSERT INTO job VALUES (?, ?, ?, ?, ?, NULL)", job->identity, job->chunks, job->part.number,
              job->part.of, hash_of(job->identity, job->chunks, job->part))
        .run();
    if (job->part.of > 0) {
      const std::int64_t first = job->chunks * (job->part.number - 1) / job->part.of;
      const std::int64_t end = job->chunks * job->part.number / job->part.of;
      Statement(database_, "INSERT INTO range VALUES (?, ?, ?)", first, first, end).run();
    }
  }
  join();
  transaction.commit();
  heart_ = std::jthread([this](const std::stop_token& stop) { beat(stop); });
}

void Campaign::join() {
  Statement(database_, "INSERT INTO worker (host, process, beat) VALUES (?, ?, ?)", host_,
            static_cast<std::int64_t>(getpid()), now_s())
      .run();
  Statement newest(database_, "SELECT max(id) FROM worker");
  newest.step();
  worker_ = newest.integer(0);
}

void Campaign::beat(const std::stop_token& stop) {
  std::mutex sleeping;
  std::condition_variable_any woken;
  std::unique_lock sleep(sleeping);
  while (!woken.wait_for(sleep, stop, kBeat, [&] { return stop.stop_requested(); })) {
    if (stop.stop_requested()) return;
    try {
      const std::lock_guard lock(mutex_);
      Statement(database_, "UPDATE worker SET beat = ? WHERE id = ?", now_s(), worker_).run();
    } catch (const std::exception&) {
      // Whoever claims or commits next meets the same, and says it.
    }
  }
}

/// Of a row (host, process, beat).
bool Campaign::is_dead(const Statement& worker) const {
  if (worker.text(0) == host_ && kill(static_cast<pid_t>(worker.integer(1)), 0) != 0 && errno == ESRCH) return true;
  return worker.integer(2) < now_s() - kSilence_s;
}

std::optional<ChunkRange> Campaign::claim(std::int64_t most) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  std::optional<ChunkRange> claimed;
  {
    Statement others(database_,
                     "SELECT host, process, beat, claim.first, claim.end FROM claim LEFT JOIN worker ON worker.id = "
                     "claim.worker WHERE claim.worker <> ? ORDER BY claim.first",
                     worker_);
    while (!claimed && others.step())
      if (is_dead(others)) claimed = {others.integer(3), others.integer(4)};
  }
  if (claimed) {
    Statement(database_, "UPDATE claim SET worker = ? WHERE first = ?", worker_, claimed->first).run();
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

bool Campaign::commit(ChunkRange chunks, const std::map<std::string, std::string>& found) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  Statement(database_, "DELETE FROM claim WHERE first = ? AND end = ? AND worker = ?", chunks.first, chunks.end,
            worker_)
      .run();
  if (database_.changes() == 0) return false;
  for (const auto& [key, text] : found)
    Statement(database_, "REPLACE INTO found VALUES (?, ?, ?, ?)", worker_, key, text, sha256(key + '\n' + text)).run();
  transaction.commit();
  return true;
}

void Campaign::give_back(ChunkRange chunks) {
  const std::lock_guard lock(mutex_);
  // No worker has the number 0: it is dead to all others.
  Statement(database_, "UPDATE claim SET worker = 0 WHERE first = ? AND end = ? AND worker = ?", chunks.first,
            chunks.end, worker_)
      .run();
}

bool Campaign::part_done() {
  const std::lock_guard lock(mutex_);
  Statement left(database_, "SELECT (SELECT count(*) FROM claim) + (SELECT count(*) FROM range WHERE next < end)");
  left.step();
  return left.integer(0) == 0;
}

bool Campaign::all_done() {
  if (!part_done()) return false;
  const std::lock_guard lock(mutex_);
  Statement missing(database_, "SELECT (SELECT chunks FROM job) - (SELECT coalesce(sum(end - first), 0) FROM range)");
  missing.step();
  return missing.integer(0) == 0;
}

void Campaign::for_each_found(const std::function<void(const std::string&, const std::string&)>& take) {
  const std::lock_guard lock(mutex_);
  Statement rows(database_, "SELECT key, text, sha256 FROM found ORDER BY worker, key");
  while (rows.step()) {
    const std::string key = rows.text(0), text = rows.text(1);
    if (rows.text(2) != sha256(key + '\n' + text))
      throw BadInput(database_.file().string() + ": it is damaged; choose another folder");
    take(key, text);
  }
}

bool Campaign::finish(const std::string& note) {
  const std::lock_guard lock(mutex_);
  Statement(database_, "UPDATE job SET finished = ? WHERE finished IS NULL", note).run();
  return database_.changes() > 0;
}

std::optional<std::string> Campaign::finished() {
  const std::lock_guard lock(mutex_);
  Statement job(database_, "SELECT finished FROM job WHERE finished IS NOT NULL");
  if (!job.step()) return std::nullopt;
  return job.text(0);
}

void Campaign::take_in(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw BadInput(file.string() + ": there is no run in this folder");
  Campaign other(file);
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  const std::optional<Job> ours = held(), theirs = other.held();
  if (!theirs || theirs->identity != ours->identity || theirs->chunks != ours->chunks)
    throw BadInput(file.string() + ": of another run than the one that the arguments describe, or of another build");
  if (!other.part_done()) throw BadInput(file.string() + ": its part is not done; finish it first");
  Statement ranges(other.database_, "SELECT first, end FROM range");
  while (ranges.step()) {
    const std::int64_t first = ranges.integer(0), end = ranges.integer(1);
    Statement shared(database_, "SELECT count(*) FROM range WHERE first < ? AND end > ?", end, first);
    shared.step();
    if (shared.integer(0) > 0) throw BadInput(file.string() + ": holds poses that another folder holds too");
    Statement(database_, "INSERT INTO range VALUES (?, ?, ?)", first, end, end).run();
  }
  Statement greatest(database_, "SELECT max(id) FROM worker");
  greatest.step();
  const std::int64_t before = greatest.integer(0);
  std::int64_t newest = before;
  Statement found(other.database_, "SELECT worker, key, text, sha256 FROM found");
  while (found.step()) {
    newest = std::max(newest, before + found.integer(0));
    Statement(database_, "INSERT INTO found VALUES (?, ?, ?, ?)", before + found.integer(0), found.text(1),
              found.text(2), found.text(3))
        .run();
  }
  // Its workers have numbers here that nobody else gets.
  Statement(database_, "INSERT OR IGNORE INTO worker VALUES (?, '', 0, 0)", newest).run();
  transaction.commit();
}

}  // namespace pcm::compare
