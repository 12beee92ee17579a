// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Right answers are right, and every planted fault is found.
#include "compare/judge/judgement/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "compare/explain/explain.h"
#include "compare/judge/judgement/judging.h"
#include "compare/judge/poses/catalogue_poses.h"
#include "meshes/generate/boxes.h"
#include "tests/compare/judge/poses/posed_folder.h"

namespace pcm::compare {
namespace {

Verdict verdict_on(Fact fact, const PoseVerdict& verdict) {
  const auto found = std::find_if(verdict.facts.begin(), verdict.facts.end(),
                                  [fact](const FactVerdict& judged) { return judged.fact == fact; });
  EXPECT_NE(found, verdict.facts.end()) << name(fact) << " was not judged";
  return found == verdict.facts.end() ? Verdict::right : found->verdict;
}

/// The question of docs/judge.md: a block half as large as the cube that it stands in.
PosedQuestions worked_example() {
  PosedQuestions posed;
  posed.surfaces = {{"plate", "", "", generate::box({1, 1, 1})}, {"block", "", "", generate::box({0.5, 0.5, 0.5})}};
  PosedQuestion question;
  question.id = "plate-block/generic/0/E/clipped";
  question.stratum = "generic";
  question.F = 1;
  question.pose.r = {0.1, 0, 0.7};
  question.law.stiffness = 1e6;
  question.mode = Mode::E;
  question.scheme = Scheme::clipped;
  posed.questions = {question};
  return posed;
}

GivenAnswer answer_by_hand() {
  GivenAnswer answer;
  answer.touching = true;
  answer.polygons = answer.closed_polygons = 1;
  answer.E.area = 0.25;
  answer.F.area = 0.35;
  answer.volume = 0.0125;
  answer.force_Me = {0, 0, -12500};
  answer.torque_Me = Eigen::Vector3d::Zero();
  return answer;
}

TEST(Judge, AgreesWithTheWorkedExample) {
  const PosedQuestions posed = worked_example();
  const Tolerances none;
  const Judge judge(posed, none, 0);
  GivenAnswer answer = answer_by_hand();
  const PoseVerdict verdict = judge.judge(posed.questions[0], answer);
  EXPECT_EQ(verdict.facts.size(), 7U);
  for (const FactVerdict& fact : verdict.facts) EXPECT_EQ(fact.verdict, Verdict::right) << name(fact.fact) << fact.text;
  EXPECT_TRUE(verdict.conventions.told.none());

  *answer.force_Me *= -1;
  *answer.torque_Me = {0, 1250, 0};
  const PoseVerdict others = judge.judge(posed.questions[0], answer);
  EXPECT_EQ(verdict_on(Fact::force, others), Verdict::wrong);
  EXPECT_EQ(verdict_on(Fact::torque, others), Verdict::wrong);
  EXPECT_TRUE(others.conventions.followed[static_cast<std::size_t>(OtherConvention::force_sign)]);
}

class Answers : public testing::Test {
 protected:
  static const PosedFolder& folder() {
    static const PosedFolder folder(120, {Scheme::barycentric, Scheme::clipped});
    return folder;
  }
  const Tolerances none_{};
  const Judge judge_{folder().posed, none_, 0};

  /// How many answers with that fault are judged wrong in the fact, of those in which it can be planted; any other fact
  /// may be wrong too.
  std::pair<int, int> found(Fact fact, const std::function<bool(const PosedQuestion&, GivenAnswer&)>& plant) const {
    int planted = 0, found = 0;
    for (std::size_t k = 0; k < folder().answers.size(); ++k) {
      GivenAnswer answer = folder().answers[k];
      const PosedQuestion& question = folder().posed.questions[k];
      if (!plant(question, answer)) continue;
      ++planted;
      found += verdict_on(fact, judge_.judge(question, answer)) == Verdict::wrong;
    }
    return {found, planted};
  }
  void expect_found(Fact fact, const std::function<bool(const PosedQuestion&, GivenAnswer&)>& plant) const {
    const auto [count, planted] = found(fact, plant);
    EXPECT_EQ(count, planted) << name(fact);
    EXPECT_GT(planted, 20) << name(fact);
  }
};

TEST_F(Answers, OfTheEngineAreRight) {
  std::map<Fact, int> judged;
  for (std::size_t k = 0; k < folder().answers.size(); ++k)
    for (const FactVerdict& fact : judge_.judge(folder().posed.questions[k], folder().answers[k]).facts) {
      ++judged[fact.fact];
      EXPECT_EQ(fact.verdict, Verdict::right)
          << folder().posed.questions[k].id << ": " << name(fact.fact) << ": " << fact.text;
    }
  for (std::size_t k = 0; k < kFacts; ++k) EXPECT_GT(judged[static_cast<Fact>(k)], 20) << kFactNames[k];
}

TEST_F(Answers, WithDiscreteFaultsAreWrong) {
  expect_found(Fact::touching, [](const PosedQuestion&, GivenAnswer& a) {
    a.touching = !*a.touching;
    return true;
  });
  expect_found(Fact::crossing_pairs, [](const PosedQuestion&, GivenAnswer& a) {
    if (a.crossing_pairs->empty()) return false;
    a.crossing_pairs->pop_back();
    return true;
  });
  const auto lose = [](std::optional<std::vector<Index>>& faces) {
    if (faces->empty()) return false;
    faces->erase(faces->begin());
    return true;
  };
  expect_found(Fact::intersected_faces, [&](const PosedQuestion&, GivenAnswer& a) { return lose(a.E.intersected); });
  expect_found(Fact::inner_faces, [&](const PosedQuestion&, GivenAnswer& a) { return lose(a.E.inner); });
  expect_found(Fact::active_faces, [&](const PosedQuestion&, GivenAnswer& a) { return lose(a.F.active); });
  expect_found(Fact::polygons, [](const PosedQuestion&, GivenAnswer& a) {
    ++*a.polygons;
    return true;
  });
  expect_found(Fact::elements, [](const PosedQuestion& question, GivenAnswer& a) {
    if (question.scheme == Scheme::clipped || a.elements->empty()) return false;
    a.elements->pop_back();
    return true;
  });
  expect_found(Fact::elements, [](const PosedQuestion& question, GivenAnswer& a) {
    if (question.scheme == Scheme::clipped) return false;
    a.element_count = std::ssize(*a.elements) + 1;
    a.elements.reset();
    return true;
  });
}

/// In the clipped scheme an element of its own may be a sliver, but not one of less than nothing, whose area would
/// widen what the sums may be off.
TEST_F(Answers, WithElementsOfNegativeAreaOrPenetrationAreWrong) {
  for (const bool of_area : {true, false}) {
    const auto [count, planted] = found(Fact::elements, [&](const PosedQuestion& question, GivenAnswer& a) {
      if (question.scheme != Scheme::clipped || a.elements->empty()) return false;
      GivenElement none = a.elements->front();
      const auto is_listed = [&] {
        return std::any_of(a.elements->begin(), a.elements->end(), [&](const GivenElement& e) {
          return e.master == none.master && e.master_face == none.master_face && e.slave_face == none.slave_face;
        });
      };
      for (none.slave_face = 0; is_listed();) ++none.slave_face;
      none.area = of_area ? -1e30 : 0;
      none.penetration = of_area ? 0 : -1e30;
      a.elements->push_back(none);
      return true;
    });
    EXPECT_EQ(count, planted);
    EXPECT_GT(planted, 10);
  }
}

TEST_F(Answers, WithBodiesSwappedAreWrong) {
  expect_found(Fact::crossing_pairs, [](const PosedQuestion&, GivenAnswer& a) {
    std::swap(a.E, a.F);
    for (FacePair& pair : *a.crossing_pairs) std::swap(pair[0], pair[1]);
    std::sort(a.crossing_pairs->begin(), a.crossing_pairs->end());
    return !a.crossing_pairs->empty();
  });
  expect_found(Fact::area, [](const PosedQuestion& question, GivenAnswer& a) {
    std::swap(a.E, a.F);
    return question.stratum == "generic" || question.stratum == "nested";
  });
}

/// An element's area is known to some roundings; other values depend on how shallow the contact is, and the derived
/// bound is wider than this at some poses.
TEST_F(Answers, WithValuesOffInTheNinthDigitAreWrong) {
  const auto off = [](double& x) {
    x *= 1 + 1e-9;
    return x != 0;
  };
  expect_found(Fact::element_area, [&](const PosedQuestion& question, GivenAnswer& a) {
    return question.scheme == Scheme::barycentric && !a.elements->empty() && off(*a.elements->front().area);
  });
  for (const Fact fact : {Fact::force, Fact::torque, Fact::area, Fact::volume, Fact::element_penetration}) {
    const auto [count, planted] = found(fact, [&](const PosedQuestion& question, GivenAnswer& a) {
      if (question.stratum != "generic" || question.scheme == Scheme::clipped || a.elements->empty()) return false;
      if (fact == Fact::area) return off(*a.F.area);
      if (fact == Fact::volume) return off(*a.volume);
      if (fact == Fact::element_penetration) return off(*a.elements->front().penetration);
      (fact == Fact::force ? *a.force_Me : *a.torque_Me) *= 1 + 1e-9;
      return true;
    });
    EXPECT_GE(4 * count, 3 * planted) << name(fact);
    EXPECT_GT(planted, 5) << name(fact);
  }
}

TEST_F(Answers, AreRightWithinTheToleranceThatIsStated) {
  Tolerances stated;
  stated.add("--tolerance", {"force=1e-6"}, &Tolerance::relative);
  stated.add("--absolute", {"torque=1e300"}, &Tolerance::absolute);
  const Judge lenient(folder().posed, stated, 0);
  for (std::size_t k = 0; k < folder().answers.size(); ++k) {
    GivenAnswer answer = folder().answers[k];
    if (answer.force_Me->isZero()) continue;
    *answer.force_Me *= 1 + 1e-7;
    *answer.torque_Me *= -3;
    const PoseVerdict verdict = lenient.judge(folder().posed.questions[k], answer);
    EXPECT_EQ(verdict_on(Fact::force, verdict), Verdict::right);
    EXPECT_EQ(verdict_on(Fact::torque, verdict), Verdict::right);
  }
}

TEST_F(Answers, GiveWhatTheyKnowAndNothingElseIsJudged) {
  GivenAnswer answer;
  EXPECT_TRUE(judge_.judge(folder().posed.questions[0], answer).facts.empty());
  answer.touching = folder().answers[0].touching;
  EXPECT_EQ(judge_.judge(folder().posed.questions[0], answer).facts.size(), 1U);
}

TEST(Judge, FindsTheVolumesOfTheCatalogueAsTheyWereWorkedOutByHand) {
  const TemporaryFolder folder;
  const std::int64_t poses = write_catalogue_poses(folder.path(), Notation::decimal);
  const PosedQuestions posed = read_poses_folder(folder.path());
  EXPECT_EQ(std::ssize(posed.questions), poses);
  const Tolerances none;
  const Judge judge(posed, none, 0);
  int known = 0;
  for (const PosedQuestion& question : posed.questions) {
    if (!question.known_volume) continue;
    ++known;
    GivenAnswer answer;
    answer.volume = question.known_volume;
    EXPECT_EQ(verdict_on(Fact::volume, judge.judge(question, answer)), Verdict::right) << question.id;
  }
  EXPECT_GT(known, 40);
}

/// One cube on top of another: whether they touch depends on a tie, which moving either way by an ulp decides.
TEST(Near, IsWhatIsRightAnUlpAway) {
  PosedQuestions posed = worked_example();
  posed.surfaces[1].mesh = posed.surfaces[0].mesh;
  PosedQuestion& question = posed.questions[0];
  const Tolerances none;
  const auto verdicts = [&](const Eigen::Vector3d& r, std::int64_t ulps) {
    question.pose.r = r;
    const Judge judge(posed, none, ulps);
    std::set<Verdict> both;
    for (const bool touching : {false, true}) {
      GivenAnswer answer;
      answer.touching = touching;
      both.insert(verdict_on(Fact::touching, judge.judge(question, answer)));
    }
    return both;
  };
  EXPECT_EQ(verdicts({0, 0, 1}, 8), (std::set{Verdict::right, Verdict::near}));
  EXPECT_EQ(verdicts({0, 0, 1}, 0), (std::set{Verdict::right, Verdict::wrong}));
  EXPECT_EQ(verdicts({0, 0, 1 + 6 * 0x1p-52}, 8), (std::set{Verdict::right, Verdict::near}));
  EXPECT_EQ(verdicts({0, 0, 1 + 0x1p-40}, 8), (std::set{Verdict::right, Verdict::wrong}));
  // Within 8 ulps of single precision.
  constexpr std::int64_t kSingle = std::int64_t{8} << 29;
  EXPECT_EQ(verdicts({0, 0, 1 + 6 * 0x1p-23}, kSingle), (std::set{Verdict::right, Verdict::near}));
  EXPECT_EQ(verdicts({0, 0, 1 + 0x1p-19}, kSingle), (std::set{Verdict::right, Verdict::wrong}));
}

std::vector<Reply> replies(const PosedFolder& folder,
                           const std::function<void(const PosedQuestion&, GivenAnswer&)>& alter) {
  std::vector<Reply> all;
  for (std::size_t k = 0; k < folder.answers.size(); ++k) {
    Reply reply;
    reply.question = k;
    reply.line = static_cast<std::int64_t>(k) + 1;
    reply.answer = folder.answers[k];
    alter(folder.posed.questions[k], reply.answer);
    all.push_back(reply);
  }
  return all;
}

TEST_F(Answers, OfOtherConventionsAreToldApart) {
  const auto told = [&](const std::function<void(const PosedQuestion&, GivenAnswer&)>& alter) {
    Judging run(judge_);
    run.add(
        replies(folder(), alter), 2, [] { return false; }, [](std::int64_t) {});
    return run.conventions().found().text;
  };
  EXPECT_EQ(told([](const PosedQuestion&, GivenAnswer&) {}), "");
  const auto expect = [&](const char* words, const std::function<void(const PosedQuestion&, GivenAnswer&)>& alter) {
    EXPECT_NE(told(alter).find(words), std::string::npos) << words << ": " << told(alter);
  };
  expect("the force has the opposite sign", [](const PosedQuestion&, GivenAnswer& a) { *a.force_Me *= -1; });
  expect("the torque has the opposite sign", [](const PosedQuestion&, GivenAnswer& a) { *a.torque_Me *= -1; });
  expect("the torque is about Me's origin",
         [](const PosedQuestion& question, GivenAnswer& a) { *a.torque_Me += question.pose.r.cross(*a.force_Me); });
  expect("mm^2", [](const PosedQuestion&, GivenAnswer& a) {
    *a.E.area *= 1e6;
    *a.F.area *= 1e6;
  });
  expect("mm^3", [](const PosedQuestion&, GivenAnswer& a) { a.volume = *a.volume * 1e9; });
  expect("N mm", [](const PosedQuestion&, GivenAnswer& a) { *a.torque_Me *= 1e3; });
  expect("stiffness is in N/m^3", [](const PosedQuestion&, GivenAnswer& a) { *a.force_Me *= 1e9; });
}

TEST_F(Answers, AreCountedByStratumWithACaseForEachWrongOne) {
  Judging run(judge_);
  run.add(
      replies(folder(),
              [](const PosedQuestion& question, GivenAnswer& a) {
                if (question.stratum == "separated") a.touching = true;
              }),
      2, [] { return false; }, [](std::int64_t) {});
  for (const auto& [stratum, tally] : run.strata()) {
    EXPECT_EQ(tally.wrong, stratum == "separated" ? tally.poses : 0) << stratum;
    EXPECT_EQ(tally.of(Fact::touching).wrong, tally.wrong) << stratum;
  }
  EXPECT_EQ(run.total().poses, std::ssize(folder().answers));
  ASSERT_EQ(std::ssize(run.wrong_answers()), run.total().wrong);
  ASSERT_GT(run.total().wrong, 0);

  const TemporaryFolder scratch;
  const std::string file = scratch.write("case.json", run.case_text(run.wrong_answers()[0]));
  const Case replayed = read_case(file);
  const PosedQuestion& question = folder().posed.questions[run.wrong_answers()[0].reply.question];
  EXPECT_EQ(replayed.origin, question.id);
  EXPECT_EQ(replayed.pose.r, question.pose.r);
  EXPECT_EQ(replayed.pose.A, question.pose.A);
  ASSERT_EQ(replayed.disagreements.size(), 1U);
  EXPECT_EQ(replayed.disagreements[0][0], "touching");
}

TEST_F(Answers, ThatAreWrongAreToldApartByTies) {
  Judging run(judge_);
  run.add(
      replies(folder(), [](const PosedQuestion&, GivenAnswer& a) { a.touching = !*a.touching; }), 2,
      [] { return false; }, [](std::int64_t) {});
  for (const auto& [stratum, tally] : run.strata()) {
    EXPECT_EQ(tally.wrong, tally.poses) << stratum;
    if (stratum == "generic" || stratum == "nested") {
      EXPECT_EQ(tally.ties, 0) << stratum;
    } else if (stratum == "degenerate") {
      EXPECT_EQ(tally.ties, tally.poses) << stratum;
    }
  }
  std::int64_t ties = 0;
  for (const WrongAnswer& wrong : run.wrong_answers()) {
    ties += wrong.tie;
    const PosedQuestion& question = folder().posed.questions[wrong.reply.question];
    const Explainer explainer(folder().posed.surfaces[question.E].mesh, folder().posed.surfaces[question.F].mesh,
                              question.mode, question.scheme);
    EXPECT_EQ(wrong.tie, explainer.coincident(reference::Problem::rounded, question.pose)) << question.id;
  }
  EXPECT_EQ(ties, run.total().ties);
  EXPECT_GT(ties, 0);
  EXPECT_LT(ties, run.total().wrong);
}

TEST(GivenAnswers, GiveWhatTheySayAndNothingElse) {
  std::map<Fact, GivenAnswer> of_one;
  of_one[Fact::touching].touching = false;
  of_one[Fact::crossing_pairs].crossing_pairs.emplace();
  of_one[Fact::intersected_faces].E.intersected.emplace();
  of_one[Fact::inner_faces].F.inner.emplace();
  of_one[Fact::active_faces].E.active.emplace();
  of_one[Fact::polygons].polygons = 0;
  of_one[Fact::closed_polygons].closed_polygons = 0;
  of_one[Fact::elements].element_count = 0;
  of_one[Fact::area].F.area = 0;
  of_one[Fact::volume].volume = 0;
  of_one[Fact::force].force_Me = Eigen::Vector3d::Zero();
  of_one[Fact::torque].torque_Me = Eigen::Vector3d::Zero();
  for (const auto& [given, answer] : of_one)
    for (std::size_t k = 0; k < kFacts; ++k)
      EXPECT_EQ(gives(answer, static_cast<Fact>(k)), static_cast<Fact>(k) == given) << name(given) << kFactNames[k];
  GivenAnswer elements;
  elements.elements = {{Side::E, 0, 0, 1.0, {}}, {Side::E, 1, 0, 2.0, {}}};
  for (const Fact fact : {Fact::elements, Fact::element_area}) EXPECT_TRUE(gives(elements, fact)) << name(fact);
  EXPECT_FALSE(gives(elements, Fact::element_penetration));
  elements.elements->clear();
  EXPECT_TRUE(gives(elements, Fact::element_penetration)) << "of none";
}

TEST(JudgedTallies, ReadBackAsTheyWereWritten) {
  JudgedTally tally{9, 4, 3, 2, 1, {1, 2, 3}, {}};
  std::int64_t number = 10;
  for (FactTally& fact : tally.facts)
    fact = {number, number + 1, number + 2, number + 3, number + 4, number + 5}, number += 6;
  EXPECT_EQ(JudgedTally::from_json(tally.to_json()).to_json(), tally.to_json());
  const JudgedTally read = JudgedTally::from_json(tally.to_json());
  EXPECT_EQ(std::tie(read.poses, read.wrong, read.ties, read.near, read.empty), std::tuple(9, 4, 3, 2, 1));
  const FactTally& touching = read.of(Fact::touching);
  EXPECT_EQ(
      std::tie(touching.right, touching.near, touching.wrong, touching.lost, touching.spurious, touching.no_truth),
      std::tuple(10, 11, 12, 13, 14, 15));
}

TEST_F(Answers, WithoutATruthAreToldApartFromWhatIsNotGiven) {
  Judging run(judge_);
  run.add(
      replies(folder(),
              [](const PosedQuestion& question, GivenAnswer& a) {
                if (question.stratum == "separated") a = {};
                if (!a.elements) return;
                a.element_count = std::ssize(*a.elements);  // a mere number, which is not held in the clipped scheme
                a.elements.reset();
              }),
      2, [] { return false; }, [](std::int64_t) {});
  std::map<std::string, std::int64_t> clipped;
  for (const PosedQuestion& question : folder().posed.questions)
    clipped[question.stratum] += question.scheme == Scheme::clipped;
  for (const auto& [stratum, tally] : run.strata()) {
    const bool given = stratum != "separated";
    const FactTally& elements = tally.of(Fact::elements);
    EXPECT_EQ(elements.no_truth, given ? clipped[stratum] : 0) << stratum;
    EXPECT_EQ(elements.judged(), given ? tally.poses - clipped[stratum] : 0) << stratum;
    EXPECT_EQ(tally.of(Fact::force).judged() + tally.of(Fact::force).no_truth, given ? tally.poses : 0) << stratum;
    EXPECT_EQ(tally.of(Fact::touching).no_truth, 0) << stratum;
  }
}

/// A pair lost, faces of both surfaces lost and a spurious one: of each of E and F, and of wrong answers alone.
TEST_F(Answers, LostAndSpuriousMembersAreCounted) {
  std::int64_t altered = 0;
  Judging run(judge_);
  run.add(
      replies(folder(),
              [&](const PosedQuestion& question, GivenAnswer& a) {
                const auto faces_E = std::ssize(folder().posed.surfaces[question.E].mesh.faces);
                if (a.crossing_pairs->empty() || a.E.active->back() + 1 == faces_E) return;
                ++altered;
                a.crossing_pairs->pop_back();
                a.E.active->push_back(a.E.active->back() + 1);
                a.E.active->erase(a.E.active->begin());
                a.F.active->pop_back();
              }),
      2, [] { return false; }, [](std::int64_t) {});
  ASSERT_GT(altered, 20);
  const JudgedTally total = run.total();
  EXPECT_EQ(total.of(Fact::crossing_pairs).lost, altered);
  EXPECT_EQ(total.of(Fact::crossing_pairs).spurious, 0);
  EXPECT_EQ(total.of(Fact::active_faces).lost, 2 * altered);
  EXPECT_EQ(total.of(Fact::active_faces).spurious, altered);
  EXPECT_EQ(total.of(Fact::inner_faces).lost, 0);
}

}  // namespace
}  // namespace pcm::compare
