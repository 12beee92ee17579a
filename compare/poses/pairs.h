// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "compare/poses/recorded_motion.h"
#include "compare/poses/strata.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// The share of a pair that costs little; so many that what costs a thousand times as much is not rounded up to more.
inline constexpr std::int64_t kWholeShare = 4096;

/// Processor time of a pose of a pair, ms: engine by all its routes, oracle and comparison, one mode; as measured,
/// roughly. 0 where it is not known.
struct PoseCost {
  double usual = 0;
  double nested = 0;  ///< of one of the stratum nested
};

/// Two surfaces to verify on, with the law between them.
struct SurfacePair {
  std::string name;  ///< names the pair in tables and, with the seed, its random numbers
  TriangleMesh E;
  TriangleMesh F;
  /// Further surfaces E and F of the same kind: with n of them pose i is that of number i modulo n + 1, the pair's own
  /// surfaces being number 0. Hard strata only.
  std::vector<std::array<TriangleMesh, 2>> variants;
  /// What a simulation took it through: with that, the pair has a part in the stratum trajectory and in no other.
  std::vector<RecordedStretch> motion;
  std::filesystem::path file_E;  ///< where it was read from; empty where it was generated
  std::filesystem::path file_F;
  ContactLaw law;
  bool for_hard_strata = false;               ///< takes the bulk of degenerate and near-degenerate
  bool for_all_strata = true;                 ///< takes part in the others, and in one of fifty poses of the hard ones
  std::int64_t greatest_share = kWholeShare;  ///< in the strata that are not hard
  /// Has needles, folds, coplanar faces of its own or parts far smaller than the body, of whose errors S / p says
  /// little: the measure of generic poses is not demanded of it. All else is.
  bool made_to_hurt = false;

  /// Its part of the poses of a stratum beside that of the other pairs, kWholeShare for most: costly pairs take less,
  /// or a run's time would be theirs alone, pairs with variants more.
  ///
  /// In inverse proportion to what a pose costs, where that is known and more than 35 ms (clipped or nested: 1.5 ms),
  /// for it spreads over a factor of a thousand (a deep pose of two gears has 15,000 clipped elements). Of other pairs
  /// in both schemes a quarter above 8,000 faces together, a sixteenth above 20,000; of nested poses, where every face
  /// of the guest is active, an eighth of that above 2,000.
  std::int64_t share(Stratum stratum, Scheme scheme) const;

  /// Of one of its poses, ms; 0 where it is not known.
  double cost(Stratum stratum, Scheme scheme) const;

  PoseCost barycentric_cost;
  PoseCost clipped_cost;

  std::size_t faces() const { return E.faces.size() + F.faces.size(); }
};

/// A law that uses as many of its parameters as it can, with lengths in proportion to the smaller body: four of them in
/// turn (all of the paper's; elastic only; one body rigid, damping in full, dry friction; two layers, damping in
/// compression, deep elements clamped).
ContactLaw verification_law(std::size_t turn, const TriangleMesh& mesh_E, const TriangleMesh& mesh_F);

/// The built-in pairs: generated ones, those of the real surfaces found in `real_surfaces` (a folder of OFF files),
/// then generated ones made to hurt (meshes/generate/degenerate/hard_bodies.h), most of them in both orders. Their
/// order and names never change with what is installed, so neither do their poses. The small pairs of the hard strata
/// have at most 200 faces together, and coordinates on a dyadic grid, so that coincidences are exact. The name of every
/// file missed is added to `missing`.
std::vector<SurfacePair> built_in_pairs(const std::filesystem::path& real_surfaces, std::vector<std::string>& missing);

/// Where `./run` unpacks the real surfaces: beside the folder of the executable, wherever the program is called from.
std::filesystem::path installed_real_surfaces();

/// The name of a pair of surfaces with these names, fit for tables and for names of files.
std::string pair_name(const std::string& name_E, const std::string& name_F);
/// Renames pairs that have the name of one before them: they would draw the same random numbers, and could not be told
/// apart in the tables.
void tell_apart(std::vector<SurfacePair>& pairs);

/// A pair read from two files (OBJ or OFF). Throws BadInput where a file is no surface.
SurfacePair pair_from_files(const std::filesystem::path& file_E, const std::filesystem::path& file_F);

}  // namespace pcm::compare
