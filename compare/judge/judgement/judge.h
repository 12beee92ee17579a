// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "compare/judge/judgement/conventions.h"
#include "compare/judge/judgement/judgement.h"
#include "compare/judge/lines/posed_question.h"
#include "compare/judge/lines/reply.h"
#include "compare/poses/surface_features.h"
#include "reference/oracle.h"
#include "reference/pose/surface.h"

namespace pcm::compare {

/// `near`: wrong, and right by the same measure at a pose a few ulps away (moved_poses.h) where the oracle's answer is
/// another one in something discrete.
enum class Verdict : std::uint8_t { right, near, wrong };

struct FactVerdict {
  Fact fact = Fact::touching;
  Verdict verdict = Verdict::right;
  std::string text;                     ///< what each side says, where not right
  std::int64_t lost = 0, spurious = 0;  ///< as FactJudged has them
};

struct PoseVerdict {
  std::vector<FactVerdict> facts;
  std::vector<Fact> no_truth;  ///< given, without anything that they could be held against
  ConventionsTold conventions;

  bool has(Verdict verdict) const;
};

/// The oracle before whom answers to posed questions are brought. Immutable; `judge` may be called from any number of
/// threads.
class Judge {
 public:
  /// Prepares every pair of surfaces that is asked about, on all cores. `near_ulps`: how far away another answer may
  /// be. Question and tolerances must outlive this. Throws BadInput where a surface is unfit for contact.
  Judge(const PosedQuestions& posed, const Tolerances& tolerances, std::int64_t near_ulps);

  const PosedQuestions& posed() const { return posed_; }
  PoseVerdict judge(const PosedQuestion& question, const GivenAnswer& answer) const;
  /// Whether features coincide exactly in the pose, so that the tie rule decides something.
  bool is_tie(const PosedQuestion& question) const;
  /// The oracle's whole answer, for the reader of a case file.
  reference::Answer truth(const PosedQuestion& question) const;

 private:
  /// Two surfaces as the oracle and the bounds see them.
  struct Pairing {
    Pairing(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F);

    SurfaceFeatures E;
    SurfaceFeatures F;
    reference::Oracle oracle;
    reference::Surface exact_E, exact_F;
  };
  const Pairing& pairing(const PosedQuestion& question) const { return *pairings_.at({question.E, question.F}); }
  reference::Answer ask(const PosedQuestion& question, const Pose& pose, const Wanted& wanted) const;
  /// Gives wrong facts a second look at moved poses.
  void look_around(const PosedQuestion& question, const GivenAnswer& answer, const reference::Answer& truth,
                   std::vector<FactVerdict>& facts) const;

  const PosedQuestions& posed_;
  const Tolerances& tolerances_;
  std::int64_t near_ulps_;
  std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<const Pairing>> pairings_;
};

}  // namespace pcm::compare
