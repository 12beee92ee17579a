// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/judge.h"

#include <oneapi/tbb/parallel_for_each.h>

#include <algorithm>

#include "compare/explain/explain.h"
#include "compare/judge/judgement/moved_poses.h"
#include "compare/judge/judgement/true_facts.h"
#include "compare/poses/rounded_vertices.h"
#include "pcm/bad_input.h"
#include "reference/pose/exact_pose.h"

namespace pcm::compare {
namespace {

Question as_question(const SurfaceFeatures& E, const SurfaceFeatures& F, const PosedQuestion& posed, const Pose& pose) {
  return {E, F, posed.law, posed.mode, posed.scheme, pose, posed.velocity};
}

}  // namespace

bool PoseVerdict::has(Verdict verdict) const {
  return std::any_of(facts.begin(), facts.end(), [verdict](const FactVerdict& f) { return f.verdict == verdict; });
}

Judge::Pairing::Pairing(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
    : E(mesh_E),
      F(mesh_F),
      oracle(mesh_E, mesh_F),
      exact_E(reference::make_surface(mesh_E)),
      exact_F(reference::make_surface(mesh_F)) {}

Judge::Judge(const PosedQuestions& posed, const Tolerances& tolerances, std::int64_t near_ulps)
    : posed_(posed), tolerances_(tolerances), near_ulps_(near_ulps) {
  for (const PosedQuestion& question : posed.questions) pairings_.try_emplace({question.E, question.F});
  oneapi::tbb::parallel_for_each(pairings_.begin(), pairings_.end(), [&](auto& entry) {
    const auto [E, F] = entry.first;
    entry.second = std::make_unique<const Pairing>(posed_.surfaces[E].mesh, posed_.surfaces[F].mesh);
  });
}

reference::Answer Judge::ask(const PosedQuestion& question, const Pose& pose, const Wanted& wanted) const {
  try {
    reference::Inquiry inquiry(pairing(question).oracle, pose, question.velocity, wanted, question.law,
                               question.scheme);
    return inquiry.answer(reference::Problem::rounded, question.mode);
  } catch (const BadInput& error) {
    throw BadInput("the pose '" + question.id + "': " + error.what());
  }
}

bool Judge::is_tie(const PosedQuestion& question) const {
  const Pairing& surfaces = pairing(question);
  const reference::ExactPose pose(reference::Problem::rounded, surfaces.exact_E, surfaces.exact_F, question.pose);
  return coincident(pose, question.mode, question.scheme);
}

reference::Answer Judge::truth(const PosedQuestion& question) const {
  return ask(question, question.pose, {});
}

PoseVerdict Judge::judge(const PosedQuestion& question, const GivenAnswer& answer) const {
  const Pairing& surfaces = pairing(question);
  const reference::Answer truth = ask(question, question.pose, wanted_for(answer));
  const Question asked = as_question(surfaces.E, surfaces.F, question, question.pose);
  const std::vector<FactJudged> judged = judge_facts(asked, answer, truth, tolerances_);
  PoseVerdict verdict;
  for (const FactJudged& fact : judged)
    verdict.facts.push_back(
        {fact.fact, fact.right ? Verdict::right : Verdict::wrong, fact.text, fact.lost, fact.spurious});
  for (std::size_t k = 0; k < kFacts; ++k) {
    const auto fact = static_cast<Fact>(k);
    if (gives(answer, fact) &&
        std::none_of(judged.begin(), judged.end(), [fact](const FactJudged& f) { return f.fact == fact; }))
      verdict.no_truth.push_back(fact);
  }
  if (!verdict.has(Verdict::wrong)) return verdict;
  look_around(question, answer, truth, verdict.facts);
  verdict.conventions = told_by(asked, answer, truth, tolerances_, judged);
  return verdict;
}

void Judge::look_around(const PosedQuestion& question, const GivenAnswer& answer, const reference::Answer& truth,
                        std::vector<FactVerdict>& facts) const {
  const Pairing& surfaces = pairing(question);
  const double scale = coordinate_scale(surfaces.E.mesh, surfaces.F.mesh, question.pose);
  for (const Pose& pose : moved_poses(question.pose, scale, near_ulps_)) {
    const reference::Answer there = ask(question, pose, wanted_for(answer));
    if (same_discrete_facts(truth, there)) continue;
    for (const FactJudged& judged :
         judge_facts(as_question(surfaces.E, surfaces.F, question, pose), answer, there, tolerances_))
      for (FactVerdict& fact : facts)
        if (fact.fact == judged.fact && judged.right && fact.verdict == Verdict::wrong) fact.verdict = Verdict::near;
    if (std::none_of(facts.begin(), facts.end(), [](const FactVerdict& f) { return f.verdict == Verdict::wrong; }))
      return;
  }
}

}  // namespace pcm::compare
