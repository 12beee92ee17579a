// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/campaign/campaign.h"
#include "compare/verify/run/verify.h"

namespace pcm::compare {

/// The part of a run that is put together from those of others.
inline constexpr JobPart kNoPart{0, 0};

/// What a process that was killed while it wrote the tables left.
void remove_unfinished_tables(const std::filesystem::path& folder);

/// A verification kept in a folder, which later calls of the program continue and others at the same time share in.
class KeptRun : public SharedChunks<Outcomes> {
 public:
  /// Continues what is kept in the folder, if anything is.
  ///
  /// A run of another build of the program or on other surfaces says nothing about this one: it is not continued, and
  /// its tables and cases are removed, so that nothing of it is left beside the new ones; so are tables and cases
  /// without a campaign. Throws BadInput, and removes nothing, where what is kept is damaged, or of a run with other
  /// arguments (poses, seed, strata, modes, schemes, part; also where it lacks one of them or has one more), which the
  /// caller may want to keep, or where others may be at a run that this one is not. `run` must outlive this.
  KeptRun(std::filesystem::path folder, const Verification& run, JobPart part = {});

  /// What became of what was kept, as a line for standard error; empty where there is nothing to say.
  const std::string& notice() const { return notice_; }
  /// Of a run that is finished: when, what the call that finished it said of itself, and which launch of several
  /// processes it was one of.
  struct Finished {
    std::string at;
    nlohmann::ordered_json by;
    std::string launch;
  };
  std::optional<Finished> finished();

  void commit(ChunkRange chunks, Outcomes outcomes) override;
  /// All that is done.
  Outcomes outcomes();
  /// Of the whole run, from 0 to 1.
  double done() { return static_cast<double>(campaign_.chunks_done()) / static_cast<double>(run_.chunks()); }
  /// Notes who finished the run, now that its results are published.
  void finish(const nlohmann::ordered_json& program, const std::string& launch);
  /// Takes over the finished parts of the same run that other folders hold, all of them or none.
  void merge(const std::vector<std::filesystem::path>& folders);

 private:
  std::optional<Campaign::Job> decide(const std::optional<Campaign::Job>& held, bool at_work, JobPart part);

  std::filesystem::path folder_;
  const Verification& run_;
  std::string notice_;
  std::mutex mutex_;
  Outcomes mine_;  ///< what this process has committed
};

}  // namespace pcm::compare
