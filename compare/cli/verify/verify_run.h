// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/frame/noted_interrupt.h"
#include "compare/cli/verify/verify_options.h"
#include "compare/verify/run/kept_run.h"
#include "compare/verify/run/verify.h"

/// What runs over poses share, whoever is held against the oracle.
namespace pcm::compare {

/// While it lives the first interrupt is only noted, and progress is shown on a terminal.
class Interruptible {
 public:
  /// `what` is counted.
  explicit Interruptible(std::int64_t whole, const char* what = "poses");
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible();

  bool interrupted() const;
  void show(std::int64_t done) const;

 private:
  NotedInterrupt interrupt_;
  std::int64_t whole_;
  const char* what_;
  bool terminal_;
};

int number_of_jobs(const VerifyOptions& options);
std::uint64_t seed_of(const VerifyOptions& options);

/// The pairs that --pair names. `notices` gets lines on what is odd about them. Throws BadInput where a file is no
/// surface, or one that is unfit for contact.
std::vector<SurfacePair> pairs_named(const VerifyOptions& options, std::vector<std::string>& notices);

/// The one that --scheme names, or both.
std::vector<Scheme> schemes_of(const VerifyOptions& options);

/// What --part or --merge say.
JobPart part_of(const VerifyOptions& options);

/// What the options ask for. `notices` gets lines on what is left out or odd.
VerificationPlan plan_from(const VerifyOptions& options, std::vector<std::string>& notices);

/// The same where they name a trajectory.
VerificationPlan plan_from_trajectory(const VerifyOptions& options, std::vector<std::string>& notices);

/// The folder that --out names, made if need be; none where it is not given. Throws BadInput where nothing can be
/// written there.
std::optional<std::filesystem::path> prepared_folder(const VerifyOptions& options);

}  // namespace pcm::compare
