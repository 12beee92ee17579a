// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints hashes over every bit of the engine's answers, bounds included: what must not differ between builds for
// different instructions (`./run check`), and a quick way to see what a change leaves as it was. First 13,440 answers
// with all figures, a line for each scheme and law; then 16,128 at the poses of `pcm verify`, a line for each scheme
// and stratum, over all modes and everything that may be wanted.
#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "compare/poses/pairs.h"
#include "compare/poses/strata.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"
#include "tests/fast/varied_questions.h"

namespace pcm::fast {
namespace {

/// FNV-1a.
class Hash {
 public:
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
    }
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const Eigen::Vector3d& x) {
    for (int k = 0; k < 3; ++k) add(x[k]);
  }
  void add(Index i) { add(static_cast<std::uint64_t>(i)); }
  void add(bool b) { add(std::uint64_t{b}); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

void add(Hash& hash, const ActiveArea& area) {
  for (const Index face : area.intersected) hash.add(face);
  for (const Index face : area.inner) hash.add(face);
  hash.add(area.area);
  hash.add(area.vector_area_Me);
}

void add(Hash& hash, const Element& element) {
  hash.add(static_cast<std::uint64_t>(element.master));
  for (const Index face : {element.master_face, element.slave_face}) hash.add(face);
  for (const double x : {element.area, element.penetration, element.normal_velocity, element.tangential_velocity,
                         element.normal_force, element.tangential_force})
    hash.add(x);
  for (const Eigen::Vector3d& x : {element.normal_Me, element.position_Me, element.force_Me}) hash.add(x);
}

void add(Hash& hash, const Statistics& statistics) {
  for (const double x : {statistics.patch_area, statistics.mean_penetration, statistics.max_pressure,
                         statistics.mean_pressure, statistics.max_normal_velocity, statistics.max_tangential_velocity})
    hash.add(x);
  hash.add(statistics.centre_of_pressure_Me);
}

void add(Hash& hash, const ForceBound& bound) {
  hash.add(bound.force_Me);
  hash.add(bound.torque_Me);
  hash.add(bound.flipped);
  hash.add(bound.penetration_at_least);
  hash.add(bound.penetration_at_most);
}

/// All but the work it took.
void add(Hash& hash, const Contact& contact) {
  for (const bool b : {contact.touching, contact.nested, contact.ambiguous, contact.has_volume,
                       contact.penetration_exceeded, contact.bound.has_value()})
    hash.add(b);
  for (const Crossing& crossing : contact.crossings) {
    hash.add(static_cast<std::uint64_t>(crossing.edge_side));
    for (const Index i : {crossing.edge[0], crossing.edge[1], crossing.face}) hash.add(i);
    hash.add(crossing.position_Me);
  }
  for (const Polygon& polygon : contact.polygons) {
    hash.add(polygon.closed);
    for (const Index i : {polygon.first, polygon.count, polygon.patch}) hash.add(i);
  }
  add(hash, contact.E);
  add(hash, contact.F);
  for (const Index i : {contact.patches, contact.undefined_areas, contact.element_count, contact.too_deep}) hash.add(i);
  hash.add(contact.volume);
  for (const Element& element : contact.elements) add(hash, element);
  hash.add(contact.max_penetration);
  hash.add(contact.force_Me);
  hash.add(contact.torque_Me);
  add(hash, contact.statistics);
  if (contact.bound) add(hash, *contact.bound);
}

/// The answer's lists, which a hash over their entries alone would not keep apart.
void add_lengths(Hash& hash, const Contact& contact) {
  for (const std::size_t length :
       {contact.crossings.size(), contact.polygons.size(), contact.E.intersected.size(), contact.E.inner.size(),
        contact.F.intersected.size(), contact.F.inner.size(), contact.elements.size()})
    hash.add(std::uint64_t{length});
}

/// Draws with correctly rounded operations alone, so that all builds draw the same.
class Draw {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  Eigen::Vector3d vector(double greatest) {
    const double x = between(-greatest, greatest), y = between(-greatest, greatest);
    return {x, y, between(-greatest, greatest)};
  }
  /// From a quaternion within the unit ball.
  Eigen::Matrix3d rotation() {
    for (;;) {
      const double a = between(-1, 1), b = between(-1, 1), c = between(-1, 1), d = between(-1, 1);
      const double square = (a * a + b * b) + (c * c + d * d);
      if (square > 1 || square < 0x1p-6) continue;
      const double k = 2 / square;
      Eigen::Matrix3d A;
      A << 1 - k * (c * c + d * d), k * (b * c - a * d), k * (b * d + a * c),  //
          k * (b * c + a * d), 1 - k * (b * b + d * d), k * (c * d - a * b),   //
          k * (b * d - a * c), k * (c * d + a * b), 1 - k * (b * b + c * c);
      return A;
    }
  }
  /// Multiples of 1/8: features coincide.
  Eigen::Vector3d lattice_vector() {
    Eigen::Vector3d x = vector(8);
    for (double& c : x) c = std::floor(c) / 8;
    return x;
  }

 private:
  std::mt19937_64 random_{2003};
};

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

struct Law {
  const char* name;
  ContactLaw law;
};

std::vector<Law> laws() {
  ContactLaw elastic, whole;
  whole.layers = LayerStiffness{3e6, 2e6};
  whole.damping = 1e4;
  whole.transition_depth = 0x1p-7;
  whole.friction = 0.25;
  whole.slip_velocity = 0.125;
  ContactLaw clamped = whole;
  clamped.max_penetration = 0x1p-5;
  return {{"elastic", elastic}, {"damped, friction", whole}, {"damped, friction, clamped", clamped}};
}

const char* name(Scheme scheme) {
  return scheme == Scheme::clipped ? "clipped" : "barycentric";
}

struct Tally {
  Hash hash;
  int answers = 0;
  std::int64_t elements = 0;
};

void add_pair(const Pair& pair, const ContactLaw& law, Scheme scheme, Workspace& workspace, Tally& tally) {
  const Pairing pairing{Surface(pair.E), Surface(pair.F), law, Mode::both, scheme};
  Draw draw;
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
    for (const Law& law : laws()) {
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
