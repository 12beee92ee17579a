// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/identity_support.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "compare/poses/pairs.h"

namespace pcm::compare {
namespace {

/// Compares quantities one after the other until one differs.
class BitComparison {
 public:
  explicit BitComparison(const Similarity& similarity) : similarity_(similarity) {}

  void number(const char* what, double a, double b, int power) {
    compare(what, a * std::pow(similarity_.length, power), b);
  }
  void vector(const char* what, const Eigen::Vector3d& a, const Eigen::Vector3d& b, int power) {
    const Eigen::Vector3d expected = similarity_.applied(a, std::pow(similarity_.length, power));
    for (Eigen::Index i = 0; i < 3; ++i) compare(what, expected[i], b[i]);
  }
  template <class T>
  void equal(const char* what, const T& a, const T& b) {
    if (first_.empty() && !(a == b)) first_ = what;
  }
  const std::string& first() const { return first_; }

 private:
  /// Zeros are equal whatever their sign: a negated axis turns +0 into -0.
  void compare(const char* what, double expected, double found) {
    if (first_.empty() && !(expected == found)) first_ = fmt::format("{}: {} instead of {}", what, found, expected);
  }

  const Similarity& similarity_;
  std::string first_;
};

void compare_area(BitComparison& compare, const fast::ActiveArea& a, const fast::ActiveArea& b) {
  compare.equal("intersected faces", a.intersected, b.intersected);
  compare.equal("inner faces", a.inner, b.inner);
  compare.number("area", a.area, b.area, 2);
  compare.vector("vector area", a.vector_area_Me, b.vector_area_Me, 2);
}

void compare_elements(BitComparison& compare, const fast::Element& a, const fast::Element& b) {
  compare.equal("element", std::array{a.master_face, a.slave_face}, std::array{b.master_face, b.slave_face});
  compare.number("element's area", a.area, b.area, 2);
  compare.number("element's penetration", a.penetration, b.penetration, 1);
  compare.number("element's normal force", a.normal_force, b.normal_force, 3);
  compare.number("element's tangential force", a.tangential_force, b.tangential_force, 3);
  compare.vector("element's normal", a.normal_Me, b.normal_Me, 0);
  compare.vector("element's position", a.position_Me, b.position_Me, 1);
  compare.vector("element's force", a.force_Me, b.force_Me, 3);
}

}  // namespace

std::vector<Posed> posed_pairs(std::uint64_t seed, int each) {
  std::vector<std::string> missing;
  const std::vector<SurfacePair> pairs = built_in_pairs({}, missing);
  std::vector<Posed> poses;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const SurfacePair& pair = pairs[k];
    const FeaturePair features(pair.E, pair.F);
    const std::vector<Stratum> strata =
        pair.for_hard_strata ? std::vector{Stratum::generic, Stratum::degenerate, Stratum::near_degenerate}
                             : std::vector{Stratum::generic, Stratum::grazing};
    for (const Stratum stratum : strata)
      for (int i = 0; i < each; ++i) {
        const DrawnPose drawn =
            draw_pose(stratum, features, PoseRandom(seed, static_cast<std::uint64_t>(stratum), k, i));
        poses.push_back({pair.E, pair.F, pair.law, drawn.pose, drawn.velocity,
                         fmt::format("{}/{}/{}, seed {}", pair.name, name(stratum), i, seed), poses.size()});
      }
  }
  return poses;
}

fast::Contact answer(const Posed& posed, Mode mode, Scheme scheme, const Wanted& wanted) {
  const fast::Pairing pairing(fast::Surface(posed.E), fast::Surface(posed.F), posed.law, mode, scheme);
  fast::Workspace workspace;
  return fast::evaluate(pairing, posed.pose, posed.velocity, wanted, workspace);
}

void Findings::same(const std::string& difference) {
  ++checks;
  if (difference.empty()) return;
  ++violations;
  if (first.empty()) first = where_ + ": " + difference;
}

void Findings::close(const std::string& what, double off, double allowed) {
  const bool within = off <= allowed;
  if (allowed > 0) worst = std::max(worst, off / allowed);
  same(within ? "" : fmt::format("{} differs by {:.3g}, allowed {:.3g}", what, off, allowed));
}

void Findings::merge(const Findings& other) {
  checks += other.checks;
  violations += other.violations;
  worst = std::max(worst, other.worst);
  if (first.empty()) first = other.first;
}

IdentityResult over_poses(std::string name, std::string statement, Sharpness sharpness, const std::vector<Posed>& poses,
                          const std::function<void(const Posed&, Findings&)>& check) {
  std::vector<Findings> findings;
  for (const Posed& posed : poses) findings.emplace_back(posed.where);
  oneapi::tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t i) { check(poses[i], findings[i]); });
  Findings all;
  for (const Findings& one : findings) all.merge(one);
  return {std::move(name), std::move(statement), sharpness, all.checks, all.violations, all.worst, all.first};
}

std::string difference(const fast::Contact& a, const fast::Contact& b, const Similarity& similarity) {
  BitComparison compare(similarity);
  compare.equal("touching", a.touching, b.touching);
  compare.equal("nested", a.nested, b.nested);
  compare.equal("ambiguous", a.ambiguous, b.ambiguous);
  compare.equal("number of crossings", a.crossings.size(), b.crossings.size());
  compare.equal("number of polygons", a.polygons.size(), b.polygons.size());
  compare.equal("patches", a.patches, b.patches);
  compare.equal("number of elements", a.element_count, b.element_count);
  compare.equal("number of listed elements", a.elements.size(), b.elements.size());
  compare.equal("too deep", a.too_deep, b.too_deep);
  if (!compare.first().empty()) return compare.first();
  for (std::size_t i = 0; i < a.crossings.size(); ++i)
    compare.vector("crossing", a.crossings[i].position_Me, b.crossings[i].position_Me, 1);
  compare_area(compare, a.E, b.E);
  compare_area(compare, a.F, b.F);
  compare.number("volume", a.volume, b.volume, 3);
  for (std::size_t i = 0; i < a.elements.size(); ++i) compare_elements(compare, a.elements[i], b.elements[i]);
  compare.number("greatest penetration", a.max_penetration, b.max_penetration, 1);
  compare.vector("force", a.force_Me, b.force_Me, 3);
  compare.vector("torque", a.torque_Me, b.torque_Me, 4);
  compare.number("patch area", a.statistics.patch_area, b.statistics.patch_area, 2);
  compare.number("greatest pressure", a.statistics.max_pressure, b.statistics.max_pressure, 1);
  compare.vector("centre of pressure", a.statistics.centre_of_pressure_Me, b.statistics.centre_of_pressure_Me, 1);
  return compare.first();
}

void expect_within_bounds(Findings& findings, const std::string& what, const fast::Contact& a, const fast::Contact& b) {
  findings.close(what + ", force", (a.force_Me - b.force_Me).norm(), (a.bound->force_Me + b.bound->force_Me).norm());
  findings.close(what + ", torque", (a.torque_Me - b.torque_Me).norm(),
                 (a.bound->torque_Me + b.bound->torque_Me).norm());
}

TriangleMesh reordered(const TriangleMesh& mesh, PoseRandom& random) {
  const auto shuffle = [&](auto& list) {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
  };
  std::vector<Index> place(mesh.vertices.size());
  std::iota(place.begin(), place.end(), 0);
  shuffle(place);
  TriangleMesh result = mesh;
  for (std::size_t v = 0; v < place.size(); ++v) result.vertices[static_cast<std::size_t>(place[v])] = mesh.vertices[v];
  for (Triangle& face : result.faces) {
    for (Index& v : face) v = place[static_cast<std::size_t>(v)];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random.below(3)), face.end());
  }
  shuffle(result.faces);
  return result;
}

TriangleMesh split(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.vertices = mesh.vertices;
  result.name = mesh.name + ", split";
  std::map<std::array<Index, 2>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, is_new] =
        middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<Index>(result.vertices.size()));
    if (is_new) result.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Triangle& part : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
      result.faces.push_back(part);
  }
  return result;
}

}  // namespace pcm::compare
