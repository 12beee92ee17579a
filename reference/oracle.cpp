// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "meshes/base/floating_point_environment.h"
#include "pcm/check.h"
#include "reference/combinatorics/combinatorics.h"
#include "reference/combinatorics/proximity.h"
#include "reference/elements/barycentric_elements.h"
#include "reference/elements/clipped_elements.h"
#include "reference/force/contact_force.h"
#include "reference/force/tangent.h"
#include "reference/pose/exact_pose.h"
#include "reference/pose/surface.h"
#include "reference/report.h"
#include "reference/validate.h"

namespace pcm::reference {

namespace {

std::size_t index_of(Problem problem) {
  return problem == Problem::rounded ? 0 : 1;
}

std::size_t index_of(Side side) {
  return side == Side::E ? 0 : 1;
}

std::vector<Side> masters_of(Mode mode) {
  if (mode == Mode::both) return {Side::E, Side::F};
  return {mode == Mode::E ? Side::E : Side::F};
}

Problem other(Problem problem) {
  return problem == Problem::rounded ? Problem::exact : Problem::rounded;
}

void report_wound(const Surface& surface, const ActiveFaces& found, ActiveArea& active) {
  if (found.winding.empty()) return;
  for (const std::vector<Index>* faces : {&found.intersected, &found.inner, &found.pockets})
    for (const Index f : *faces)
      for (const Index v : surface.mesh.faces[f]) {
        const int winding = found.winding[v];
        if (winding == 0) continue;
        if (faces == &found.intersected) active.wound.push_back(v);
        active.most_wound = std::max(active.most_wound, std::abs(winding));
      }
  std::sort(active.wound.begin(), active.wound.end());
  active.wound.erase(std::unique(active.wound.begin(), active.wound.end()), active.wound.end());
}

}  // namespace

struct Oracle::Data {
  Surface E;
  Surface F;
  ContactLaw law;
  Mode mode;
  Scheme scheme;
  CandidateRegion region;
};

Oracle::Oracle(TriangleMesh mesh_E, TriangleMesh mesh_F, ContactLaw law, Mode mode, Scheme scheme,
               CandidateRegion region) {
  const DefaultFloatingPoint environment;
  require_fit(law);
  require_fit(mesh_E);
  require_fit(mesh_F);
  data_ = std::make_unique<const Data>(
      Data{make_surface(std::move(mesh_E)), make_surface(std::move(mesh_F)), law, mode, scheme, region});
}

Oracle::~Oracle() = default;

Answer Oracle::answer(Problem problem, const Pose& pose, const Velocity& velocity, const Wanted& wanted) const {
  return Inquiry(*this, pose, velocity, wanted).answer(problem);
}

namespace {

/// The elements one master carries in one problem, and what the law makes of them.
struct MasterElements {
  ClippedFindings clipped;
  std::unique_ptr<ElementSource> source;
  std::unique_ptr<MasterLoads> loads;
  std::unique_ptr<MasterTangent> tangent;
};

/// One problem as far as it has been solved.
struct Solution {
  ExactPose pose;
  Combinatorics found;
  Answer without_force;                              ///< what all modes have in common
  std::array<std::optional<ElementPairs>, 2> pairs;  ///< by master
  std::array<std::unique_ptr<MasterElements>, 2> elements;
};

}  // namespace

struct Inquiry::Data {
  const Oracle::Data& oracle;
  Pose pose;
  Velocity velocity;
  Wanted wanted;
  ContactLaw law;
  Scheme scheme;
  std::array<std::unique_ptr<Solution>, 2> solutions{};  ///< by problem

  Solution& solve(Problem problem);
  const ElementPairs& pairs(Problem problem, Side master);
  MasterElements& elements(Problem problem, Side master);
  ForceQuestion question(Problem problem, Side master);
};

Inquiry::Inquiry(const Oracle& oracle, const Pose& pose, const Velocity& velocity, const Wanted& wanted)
    : Inquiry(oracle, pose, velocity, wanted, oracle.data_->law, oracle.data_->scheme) {}

Inquiry::Inquiry(const Oracle& oracle, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                 const ContactLaw& law, Scheme scheme)
    : data_(std::make_unique<Data>(Data{*oracle.data_, pose, velocity, wanted, law, scheme})) {
  const DefaultFloatingPoint environment;
  require_fit(law);
  require_fit(pose, velocity);
}

Inquiry::~Inquiry() = default;

Solution& Inquiry::Data::solve(Problem problem) {
  std::unique_ptr<Solution>& solution = solutions[index_of(problem)];
  if (solution) return *solution;
  const Solution* known = solutions[index_of(other(problem))].get();
  ExactPose exact_pose(problem, oracle.E, oracle.F, pose);
  const std::shared_ptr<const Proximity> near =
      known ? known->found.near : std::make_shared<const Proximity>(exact_pose, oracle.region);
  Combinatorics found = find_combinatorics(exact_pose, near);
  solution = std::make_unique<Solution>(Solution{std::move(exact_pose), std::move(found), {}, {}, {}});

  const Combinatorics& facts = solution->found;
  Answer& answer = solution->without_force;
  answer.touching = !facts.crossings.ids.empty();
  answer.nested = facts.E.nested || facts.F.nested;
  answer.ambiguous = facts.E.ambiguous || facts.F.ambiguous;
  answer.E.intersected = facts.E.intersected;
  answer.E.inner = facts.E.inner;
  answer.E.pockets = facts.E.pockets;
  answer.F.intersected = facts.F.intersected;
  answer.F.inner = facts.F.inner;
  answer.F.pockets = facts.F.pockets;
  report_wound(oracle.E, facts.E, answer.E);
  report_wound(oracle.F, facts.F, answer.F);
  if (wanted.polygons) {
    const std::vector<Index> patches =
        group_into_patches(solution->pose, facts.crossings, facts.polygons, facts.E, facts.F);
    report_polygons(solution->pose, CrossingPositions(facts.crossings.ids), facts.polygons, patches, answer);
  }
  if (wanted.areas)
    report_areas(solution->pose, facts.inside_areas(solution->pose),
                 oracle.E.closed && oracle.F.closed && !answer.ambiguous, answer);
  return *solution;
}

const ElementPairs& Inquiry::Data::pairs(Problem problem, Side master) {
  Solution& solution = solve(problem);
  std::optional<ElementPairs>& pairs = solution.pairs[index_of(master)];
  if (pairs) return *pairs;
  // What is certain in one problem holds in the other one too.
  const Solution* known = solutions[index_of(other(problem))].get();
  const std::optional<ElementPairs> found = known ? known->pairs[index_of(master)] : std::nullopt;
  pairs = found && found->certified ? *found : find_elements(solution.pose, master, solution.found);
  return *pairs;
}

MasterElements& Inquiry::Data::elements(Problem problem, Side master) {
  Solution& solution = solve(problem);
  std::unique_ptr<MasterElements>& elements = solution.elements[index_of(master)];
  if (elements) return *elements;
  elements = std::make_unique<MasterElements>();
  if (scheme == Scheme::barycentric) {
    elements->source = std::make_unique<BarycentricElements>(pairs(problem, master).pairs);
  } else {
    const Solution* other_solution = solutions[index_of(other(problem))].get();
    const MasterElements* known = other_solution ? other_solution->elements[index_of(master)].get() : nullptr;
    elements->clipped =
        find_clipped_elements(solution.pose, master, solution.found, known ? known->clipped : ClippedFindings());
    elements->source = std::make_unique<ClippedElements>(elements->clipped.elements, law.max_penetration);
  }
  elements->loads = std::make_unique<MasterLoads>(ForceQuestion{solution.pose, *elements->source, law, velocity});
  return *elements;
}

ForceQuestion Inquiry::Data::question(Problem problem, Side master) {
  const ElementSource& source = *elements(problem, master).source;
  return {solve(problem).pose, source, law, velocity};
}

Answer Inquiry::answer(Problem problem) {
  return answer(problem, data_->oracle.mode);
}

Answer Inquiry::facts(Problem problem, Mode mode) {
  const DefaultFloatingPoint environment;
  Answer answer = data_->solve(problem).without_force;
  if (!data_->wanted.force) return answer;
  for (const Side master : masters_of(mode)) {
    const ElementPairs& pairs = data_->pairs(problem, master);
    answer.too_deep += pairs.too_deep;  // by the barycentres' lines in either scheme
    if (data_->scheme == Scheme::barycentric) answer.certified = answer.certified && pairs.certified;
  }
  return answer;
}

std::size_t Inquiry::candidate_pairs(Problem problem) {
  const DefaultFloatingPoint environment;
  return data_->solve(problem).found.near->candidates().size();
}

Answer Inquiry::answer(Problem problem, Mode mode) {
  const DefaultFloatingPoint environment;
  Answer answer = facts(problem, mode);
  if (!data_->wanted.force) return answer;
  std::vector<MasterLoads*> loads;
  for (const Side master : masters_of(mode)) loads.push_back(data_->elements(problem, master).loads.get());
  report_force(loads, data_->wanted, answer);
  if (data_->wanted.tangent) answer.tangent = tangent(problem, mode);
  return answer;
}

Tangent Inquiry::tangent(Problem problem, Mode mode) {
  const DefaultFloatingPoint environment;
  std::vector<const MasterTangent*> masters;
  for (const Side master : masters_of(mode)) {
    MasterElements& elements = data_->elements(problem, master);
    if (!elements.tangent) elements.tangent = std::make_unique<MasterTangent>(data_->question(problem, master));
    masters.push_back(elements.tangent.get());
  }
  return tangent_of(masters);
}

}  // namespace pcm::reference
