// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/explain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/explain/joined_features.h"
#include "compare/explain/line_coincidences.h"
#include "compare/explain/near_features.h"
#include "compare/explain/signs.h"
#include "compare/poses/rounded_vertices.h"
#include "pcm/engine.h"
#include "pcm/workspace.h"
#include "reference/combinatorics/combinatorics.h"

namespace pcm::compare {
namespace {

using reference::ExactPose;

/// Features are looked for ever farther apart until some are found, up to this part of the smaller surface's extent: so
/// far that the nearest ones of a generic contact are found, not so far that all faces are near to all others.
constexpr double kSearchedPart = 0x1p-7;
constexpr double kSearchGrowth = 1024;

/// Crossings and labels of the oracle in the form of the engine's.
DiscreteAnswer true_discrete_answer(const reference::Combinatorics& truth) {
  DiscreteAnswer answer;
  answer.touching = !truth.crossings.ids.empty();
  answer.nested = truth.E.nested || truth.F.nested;
  answer.ambiguous = truth.E.ambiguous || truth.F.ambiguous;
  for (const reference::CrossingId& x : truth.crossings.ids) answer.crossings.push_back(crossing_key(x));
  std::sort(answer.crossings.begin(), answer.crossings.end());
  answer.intersected = {truth.E.intersected, truth.F.intersected};
  answer.inner = {truth.E.inner, truth.F.inner};
  return answer;
}

/// Greatest extent of its box, m.
double extent_of(const reference::Surface& surface) {
  const reference::Box& box = surface.tree.nodes().front().box;
  return (box.upper - box.lower).maxCoeff();
}

/// The places where features are near, and how far apart they were looked for.
struct Places {
  std::vector<Coincidence> found;
  double searched = 0;
};

Places nearest_places(const ExactPose& pose, double width, double farthest) {
  Places places{near_features(pose, width), width};
  while (places.found.empty() && places.searched < farthest) {
    places.searched = std::min(kSearchGrowth * places.searched, farthest);
    places.found = near_features(pose, places.searched);
  }
  return places;
}

void add_lines(const ExactPose& pose, const reference::Combinatorics& truth, Mode mode, double width,
               std::vector<Coincidence>& found) {
  for (const Side master : {Side::E, Side::F}) {
    if (mode != Mode::both && (mode == Mode::E) != (master == Side::E)) continue;
    const std::vector<Coincidence> lines = line_coincidences(pose, master, truth.of(master).active(), width);
    found.insert(found.end(), lines.begin(), lines.end());
  }
}

/// What coincides, or nearly does, of all kinds, nearest first.
std::vector<Coincidence> coincidences(const ExactPose& pose, std::vector<Coincidence> found,
                                      const reference::Combinatorics& truth, const fast::Pairing& pairing,
                                      double width) {
  std::erase_if(found, [&](const Coincidence& c) { return c.margin > width; });
  leave_out_told_by_parts(found, pose.surface(Side::E).mesh, pose.surface(Side::F).mesh);
  const std::vector<Coincidence> joined = joined_features(pose, found, width);
  found.insert(found.end(), joined.begin(), joined.end());
  if (pairing.scheme() == Scheme::barycentric) add_lines(pose, truth, pairing.mode(), width, found);
  sort_by_margin(found);
  return found;
}

/// How much r may be moved while no features meet that are `nearest` apart or farther, and so no crossing comes or
/// goes.
///
/// Moved by d, a vertex of F is elsewhere by at most |d| and the roundings at both poses: each coordinate is a sum of
/// four terms, four roundings deep, off by at most gamma_4 M, M the sum of their absolute values. That is
/// sqrt(3) (gamma_4 M + gamma_4 (M + |d|)) < 14 u M + 7 u |d| in all, u = 2^-53. Points of edges and faces are no
/// farther from where they were than their corners. 16 u and the last factor pay for the roundings of this bound.
double free_distance(double nearest, const Explainer& surfaces, const Pose& pose) {
  Eigen::Vector3d greatest_F = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : surfaces.mesh(Side::F).vertices) greatest_F = greatest_F.cwiseMax(x.cwiseAbs());
  const double M = (pose.A.cwiseAbs() * greatest_F + pose.r.cwiseAbs()).maxCoeff();
  return std::max(0.0, (nearest - 16 * 0x1p-53 * M) * (1 - 0x1p-40));
}

/// Directions in which another answer is looked for: the axes, and how the nearest features part.
std::vector<Eigen::Vector3d> directions_of(const std::vector<Coincidence>& nearest_first) {
  constexpr std::size_t kMost = 6;
  constexpr double kSame = 1 - 0x1p-20;  // cosine: another direction is worth a look of its own
  std::vector<Eigen::Vector3d> directions{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  for (const Coincidence& c : nearest_first) {
    if (directions.size() == kMost) break;
    const bool is_new = std::all_of(directions.begin(), directions.end(), [&](const Eigen::Vector3d& other) {
      return std::abs(other.dot(c.apart_Me)) < kSame;
    });
    if (is_new && !c.apart_Me.isZero(0)) directions.push_back(c.apart_Me);
  }
  return directions;
}

}  // namespace

struct Explainer::Data {
  fast::Pairing pairing;
  reference::Surface E, F;
};

Explainer::Explainer(TriangleMesh mesh_E, TriangleMesh mesh_F, Mode mode, Scheme scheme) {
  // The engine refuses what is unfit.
  fast::Pairing pairing{fast::Surface(std::move(mesh_E)), fast::Surface(std::move(mesh_F)), {}, mode, scheme};
  reference::Surface E = reference::make_surface(pairing.surface_E().mesh());
  reference::Surface F = reference::make_surface(pairing.surface_F().mesh());
  data_ = std::make_unique<const Data>(Data{std::move(pairing), std::move(E), std::move(F)});
}

Explainer::~Explainer() = default;

const TriangleMesh& Explainer::mesh(Side side) const {
  return (side == Side::E ? data_->E : data_->F).mesh;
}
Mode Explainer::mode() const {
  return data_->pairing.mode();
}
Scheme Explainer::scheme() const {
  return data_->pairing.scheme();
}

CoincidenceCount Explanation::total() const {
  CoincidenceCount sum;
  for (const CoincidenceCount& count : counts) {
    sum.exact += count.exact;
    sum.near += count.near;
  }
  return sum;
}

Explanation Explainer::explain(const Pose& pose, const ExplainOptions& options) const {
  Explanation explanation;
  fast::Workspace workspace;
  const fast::Contact& contact = fast::evaluate(data_->pairing, pose, {}, {}, workspace);
  explanation.pose = pose;
  explanation.answer = discrete_answer(contact);
  explanation.work = contact.work;
  explanation.elements = contact.element_count;
  explanation.scale = coordinate_scale(mesh(Side::E), mesh(Side::F), pose);
  explanation.ulp = ulp_of(explanation.scale);

  const ExactPose exact(reference::Problem::rounded, data_->E, data_->F, pose);
  const reference::Combinatorics truth = find_combinatorics(exact);
  explanation.oracle_agrees = true_discrete_answer(truth) == explanation.answer;

  const double width = options.near_ulps * explanation.ulp;
  const double farthest = kSearchedPart * std::min(extent_of(data_->E), extent_of(data_->F));
  Places places = nearest_places(exact, width, std::max(width, farthest));
  sort_by_margin(places.found);
  explanation.searched = places.searched;
  if (!places.found.empty()) explanation.nearest = places.found.front();
  const double nearest = explanation.nearest ? explanation.nearest->margin : places.searched;
  explanation.free_distance = free_distance(nearest, *this, pose);
  explanation.next = next_answer(data_->pairing, pose, explanation.answer, directions_of(places.found), explanation.ulp,
                                 4 * explanation.scale);

  const std::vector<Coincidence> found = coincidences(exact, std::move(places.found), truth, data_->pairing, width);
  for (const Coincidence& c : found) {
    CoincidenceCount& count = explanation.counts[static_cast<std::size_t>(c.kind)];
    ++(c.exact() ? count.exact : count.near);
    if (explanation.listed.size() < options.listed) explanation.listed.push_back({c, signs_of(exact, c)});
  }
  explanation.left_out = found.size() - explanation.listed.size();
  return explanation;
}

bool Explainer::coincident(reference::Problem problem, const Pose& pose) const {
  return compare::coincident(ExactPose(problem, data_->E, data_->F, pose), mode(), scheme());
}

bool coincident(const ExactPose& pose, Mode mode, Scheme scheme) {
  if (!near_features(pose, 0).empty()) return true;  // all that is joined is made of these
  if (scheme != Scheme::barycentric) return false;
  std::vector<Coincidence> lines;
  add_lines(pose, find_combinatorics(pose), mode, 0, lines);
  return !lines.empty();
}

}  // namespace pcm::compare
