// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints hashes over every bit of the engine's answers, bounds included: what must not differ between builds for
// different instructions (`./run check`), and a quick way to see what a change leaves as it was. First 13,440 answers
// with all figures, a line for each scheme and law; then 16,128 at the poses of `pcm verify`, a line for each scheme
// and stratum, over all modes and everything that may be wanted.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "compare/poses/pairs.h"
#include "compare/poses/strata.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"
#include "tests/fast/answer_hash.h"
#include "tests/fast/exact_draw.h"
#include "tests/fast/varied_questions.h"

namespace pcm::fast {
namespace {

struct Pair {
  TriangleMesh E, F;
  double extent;  ///< of offsets drawn, m
  int poses;      ///< of each kind
};

std::vector<Pair> pairs() {
  using Eigen::Vector3d;
  const TriangleMesh box = generate::gridded_box(Vector3d(1, 1, 1), {2, 3, 2});
  return {{generate::bubble(), generate::bubble(), 0.2, 60},
          {generate::pyramid(), generate::bubble(), 0.2, 60},
          {generate::icosphere(1, 2), generate::icosphere(1, 2), 1.1, 200},
          {generate::torus(1, 0.3, 16, 8), generate::box(Vector3d(2, 1, 0.5)), 1, 200},
          {box, box, 0.7, 300},
          {generate::plate(4, 4, 1), generate::box(Vector3d(1, 1, 1)), 1, 300}};
}

const char* name(Scheme scheme) {
  return scheme == Scheme::clipped ? "clipped" : "barycentric";
}

struct Tally {
  test::Hash hash;
  int answers = 0;
  std::int64_t elements = 0;
};

void add_pair(const Pair& pair, const ContactLaw& law, Scheme scheme, Workspace& workspace, Tally& tally) {
  const Pairing pairing{Surface(pair.E), Surface(pair.F), law, Mode::both, scheme};
  test::ExactDraw draw;
  for (int i = 0; i < 2 * pair.poses; ++i) {
    const bool generic = i % 2 == 0;
    const Pose pose{generic ? draw.rotation() : Eigen::Matrix3d::Identity(),
                    generic ? draw.vector(pair.extent) : draw.lattice_vector()};
    const Velocity velocity{draw.vector(1), draw.vector(2)};
    Wanted wanted;
    wanted.bound = i % 4 >= 2;
    const Contact& contact = evaluate(pairing, pose, velocity, wanted, workspace);
    add(tally.hash, contact);
    ++tally.answers;
    tally.elements += contact.element_count;
  }
}

void print_hashes() {
  Workspace workspace;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    for (const test::Law& law : test::laws()) {
      Tally tally;
      for (const Pair& pair : pairs()) add_pair(pair, law.law, scheme, workspace, tally);
      std::printf("%016" PRIx64 "  %s, %s: %d answers, %" PRId64 " elements\n", tally.hash.value(), name(scheme),
                  law.name, tally.answers, tally.elements);
    }
  }
}

/// A pair as a stratum sees it, with each body as master and both. Features refer to the pair's meshes.
struct StratumPair {
  StratumPair(const compare::SurfacePair& pair, compare::Stratum stratum, Scheme scheme)
      : nested(stratum == compare::Stratum::nested ? compare::nested_meshes(pair.E, pair.F) : std::nullopt),
        features(stratum == compare::Stratum::nested ? compare::FeaturePair(nested.value())
                                                     : compare::FeaturePair(pair.E, pair.F)) {
    const Surface E(features.E.mesh), F(features.F.mesh);
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) by_mode.emplace_back(E, F, pair.law, mode, scheme);
  }
  StratumPair(const StratumPair&) = delete;
  StratumPair& operator=(const StratumPair&) = delete;

  std::optional<compare::NestedMeshes> nested;
  compare::FeaturePair features;
  std::vector<Pairing> by_mode;
};

/// A pose of the stratum for each subset of what may be wanted, answered in each mode.
void add_stratum_pair(const compare::SurfacePair& pair, compare::Stratum stratum, Scheme scheme, std::uint64_t number,
                      Workspace& workspace, Tally& tally) {
  const StratumPair prepared(pair, stratum, scheme);
  for (int i = 0; i < test::kAllWanted; ++i) {
    const compare::PoseRandom random(2003, static_cast<std::uint64_t>(stratum), number, static_cast<std::uint64_t>(i));
    const compare::DrawnPose drawn = compare::draw_pose(stratum, prepared.features, random);
    for (const Pairing& pairing : prepared.by_mode) {
      const Contact& contact = evaluate(pairing, drawn.pose, drawn.velocity,
                                        test::wanted_by_number(static_cast<std::uint64_t>(i)), workspace);
      add_lengths(tally.hash, contact);
      add(tally.hash, contact);
      ++tally.answers;
      tally.elements += contact.element_count;
    }
  }
}

void print_stratum_hashes() {
  const std::vector<compare::SurfacePair> pairs = test::varied_pairs();
  Workspace workspace;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    for (const compare::Stratum stratum : compare::kStrata) {
      Tally tally;
      std::uint64_t number = 0;
      for (const compare::SurfacePair& pair : pairs)
        add_stratum_pair(pair, stratum, scheme, number++, workspace, tally);
      std::printf("%016" PRIx64 "  %s, %s: %d answers, %" PRId64 " elements\n", tally.hash.value(), name(scheme),
                  compare::name(stratum).data(), tally.answers, tally.elements);
    }
  }
}

}  // namespace
}  // namespace pcm::fast

int main() {
  pcm::fast::print_hashes();
  pcm::fast::print_stratum_hashes();
}
