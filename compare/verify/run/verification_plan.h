// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/poses/pairs.h"
#include "compare/verify/routes/held_pairing.h"

namespace pcm::compare {

struct RecordedState {
  Pose pose;
  Velocity velocity;
  std::int64_t line = 0;  ///< of the file that it is from; names the pose
};

/// What a pair is asked in place of drawn poses, with the pair's own law.
struct RecordedPoses {
  HeldPairing::Modes modes;  ///< every pose is answered in each; as many for every pair of a plan
  Scheme scheme = Scheme::barycentric;
  std::filesystem::path file;
  std::vector<RecordedState> states;  ///< all that the file has, in the order of time
  std::vector<std::size_t> chosen;    ///< those of them that are asked about, ascending
};

/// What a run is; the same plan gives the same tables, whatever the number of threads.
struct VerificationPlan {
  std::int64_t poses = 20160;
  std::uint64_t seed = 1;
  std::vector<Stratum> strata{kStrata.begin(), kStrata.end()};
  HeldPairing::Modes modes{Mode::both};  ///< every pose is answered in each
  /// With both, one pose in three is answered in the clipped scheme, the others in the barycentric one.
  std::vector<Scheme> schemes{Scheme::barycentric};
  std::vector<SurfacePair> pairs;
  /// That of all poses, and then of each pair too; otherwise one is drawn for each pose.
  std::optional<ContactLaw> law;
  /// Of each pair, or empty: then poses are drawn. `poses`, `strata`, `modes` and `schemes` say what is in them
  /// (read_trajectory), and no seed, no drawn law and no share of a pair has a part in the run.
  std::vector<RecordedPoses> recorded;
  /// Asked for by name: each of these must then get a pose. What else gets none is an omission.
  bool strata_named = false, schemes_named = false, pairs_named = false;
  std::string build;  ///< which program answers; by default the hash of the one that runs
};

}  // namespace pcm::compare
