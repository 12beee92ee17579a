// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "compare/campaign/campaign.h"
#include "compare/judge/judgement/judged.h"

namespace pcm::compare {

/// A judgement kept in a folder, which later calls of the program continue and others at the same time share in.
class KeptJudgement : public SharedChunks<Judged> {
 public:
  /// Continues what is kept in the folder, if anything is. `identity`: what is judged and how, an object. Throws
  /// BadInput where what is kept is another judgement, or damaged. The questions must outlive this.
  KeptJudgement(const std::filesystem::path& folder, const Json& identity, std::int64_t chunks,
                const PosedQuestions& posed);

  void commit(ChunkRange chunks, Judged judged) override;
  /// All that is judged.
  Judged judged();
  /// Notes which launch of processes has finished it, now that its results are published.
  void finish(const std::string& launch) { campaign_.finish(launch); }
  std::optional<std::string> finished_by() { return campaign_.finished(); }

 private:
  const PosedQuestions& posed_;
  std::mutex mutex_;
  Judged mine_;  ///< what this process has committed
};

}  // namespace pcm::compare
