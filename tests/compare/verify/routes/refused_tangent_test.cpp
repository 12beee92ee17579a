// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Tangents beyond all doubles: who may refuse them, where, and that a refusal without need is flagged.
#include "compare/verify/routes/refused_tangent.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/routes/wanted_presets.h"
#include "meshes/generate/boxes.h"
#include "pcm/bad_input.h"
#include "pcm/engine.h"

namespace pcm::compare {
namespace {

/// Two wedges of some 2^240 m: where one slides along its own face, friction without v_eps depends on a slip that is
/// all roundings, and its derivative on the spin is beyond all doubles (`pcm verify`, seed 19, extreme pose 16759).
struct HugeWedges {
  ContactLaw law;
  HeldPairing::State state;
  TriangleMesh wedge = generate::wedge(45, 1, 1);

  HugeWedges() {
    for (Eigen::Vector3d& x : wedge.vertices) x = 0x1p240 * (0x1p-12 * (0x1p12 * x).array().round()).matrix();
    law.stiffness = 0x1.7ca37b5ddf402p+26;
    law.damping = 0x1.ba6750ba7d68fp+15;
    law.transition_depth = 0x1.bca3b03a40f6dp+225;
    law.friction = 0x1.577c1e5daf6c4p-5;
    law.max_penetration = 0x1.b6fbc05acb631p+238;
    law.damping_mode = DampingMode::compression;
    state.pose.r = {0, -0x1.8000000000001p+239, -0x1p+189};
    state.velocity.v = {-0x1.53ae900a451e1p+228, 0, -0x1.53ae900a451e1p+228};
    state.law = law;
    state.scheme = Scheme::clipped;
  }
  std::vector<Disagreement> held_by(const EngineSeam& seam) const {
    fast::Workspace workspace;
    const HeldPairing held(wedge, wedge, law, Mode::both, Scheme::clipped);
    EXPECT_THROW(fast::evaluate(held.engine(), state.pose, state.velocity, kForceAndTangent, workspace), BadInput);
    return held.hold(state, workspace, seam).front().disagreements;
  }
};

/// Does without the tangent where that is refused on a route.
class ForgivingSeam final : public EngineSeam {
 public:
  explicit ForgivingSeam(Route forgiving) : forgiving_(forgiving) {}

  const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                const Ask& ask, fast::Workspace& workspace) const override {
    return EngineSeam::evaluate(pairing, pose, velocity, forgiven(ask), workspace);
  }
  const fast::Contact& evaluate_known(fast::PairingMemory& memory, const Pose& pose, const Velocity& velocity,
                                      const Ask& ask, fast::Workspace& workspace) const override {
    return EngineSeam::evaluate_known(memory, pose, velocity, forgiven(ask), workspace);
  }
  const fast::Contact& evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const override {
    try {
      return EngineSeam::evaluate_in(scene, workspace);
    } catch (const BadInput&) {
      if (forgiving_ == Route::scene) return nothing_;
      throw;
    }
  }

 private:
  Ask forgiven(Ask ask) const {
    ask.wanted.tangent = ask.wanted.tangent && ask.route != forgiving_;
    return ask;
  }

  Route forgiving_;
  fast::Contact nothing_;
};

TEST(RefusedTangent, TangentThatMayBeBeyondAllDoublesIsRefusedOnAllRoutesOrNone) {
  const HugeWedges wedges;
  EXPECT_TRUE(wedges.held_by(EngineSeam::none()).empty());
  for (const Route route : {Route::bounded, Route::drawn, Route::known_pose, Route::scene}) {
    const std::vector<Disagreement> found = wedges.held_by(ForgivingSeam(route));
    ASSERT_FALSE(found.empty()) << name(route);
    EXPECT_EQ(found.front().kind, Kind::paths) << name(route);
  }
}

/// Refuses the tangent under every law but a weakened one.
class RefusingSeam final : public EngineSeam {
 public:
  explicit RefusingSeam(double stiffness) : stiffness_(stiffness) {}

  const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                const Ask& ask, fast::Workspace& workspace) const override {
    if (ask.wanted.tangent && pairing.law().stiffness == stiffness_) throw BadInput(kRefusal);
    return EngineSeam::evaluate(pairing, pose, velocity, ask, workspace);
  }
  const fast::Contact& evaluate_known(fast::PairingMemory& memory, const Pose& pose, const Velocity& velocity,
                                      const Ask& ask, fast::Workspace& workspace) const override {
    if (ask.wanted.tangent) throw BadInput(kRefusal);
    return EngineSeam::evaluate_known(memory, pose, velocity, ask, workspace);
  }
  const fast::Contact& evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const override {
    const fast::Contact& answer = EngineSeam::evaluate_in(scene, workspace);
    if (answer.tangent) throw BadInput(kRefusal);
    return answer;
  }

 private:
  static constexpr const char* kRefusal = "beyond all doubles";
  double stiffness_;
};

TEST(RefusedTangent, TangentThatIsNotBeyondAllDoublesMayNotBeRefused) {
  HugeWedges wedges;
  for (double* parameter : {&wedges.law.stiffness, &wedges.law.damping}) *parameter *= 0x1p-40;
  wedges.state.law = wedges.law;
  fast::Workspace workspace;
  const HeldPairing held(wedges.wedge, wedges.wedge, wedges.law, Mode::both, Scheme::clipped);
  EXPECT_TRUE(held.hold(wedges.state, workspace).front().disagreements.empty());
  const std::vector<Disagreement> found =
      held.hold(wedges.state, workspace, RefusingSeam(wedges.law.stiffness)).front().disagreements;
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().kind, Kind::tangent);
}

/// A block of some 2^243 m, sunk into a greater one whose origin is far away (`pcm verify`, seed 2030, extreme pose
/// 8449 of sunken blocks): what the torque's derivatives by the spin are summed of cancels in part.
TEST(RefusedTangent, TangentMayBeRefusedWhereOnlyASumOnTheWayIsBeyondAllDoubles) {
  TriangleMesh block = generate::box({-0.75, -0.75, -0.125}, {0.75, 0.75, 0.125});
  TriangleMesh greater = generate::box({-2, -2.125, -0.625}, {2, 2, 0.625});
  for (TriangleMesh* const mesh : {&block, &greater})
    for (Eigen::Vector3d& x : mesh->vertices) x *= 0x1p243;
  HeldPairing::State state;
  state.pose.r = {0x1.6p243, 0x1.cp243, 0x1.7p242};
  state.velocity.v = {-0x1.4p200, 0x1.4p201, -0x1p238};
  state.law.stiffness = 0x1p16;
  state.law.damping = 0x1p10;
  state.law.friction = 0x1.ep-1;
  state.law.slip_velocity = 0x1.8p201;
  fast::Workspace workspace;
  const auto evaluate = [&](const ContactLaw& law) {
    const fast::Pairing pairing(fast::Surface{block}, fast::Surface{greater}, law, Mode::both);
    return fast::evaluate(pairing, state.pose, state.velocity, kForceAndTangent, workspace);
  };
  const double greatest = evaluate(weakened(state.law)).tangent->lpNorm<Eigen::Infinity>();
  const double to_three_eighths = 0.375 * std::numeric_limits<double>::max() / greatest * 0x1p-128;
  for (double* parameter : {&state.law.stiffness, &state.law.damping}) *parameter *= to_three_eighths;
  EXPECT_THROW(evaluate(state.law), BadInput);
  const HeldPairing held(block, greater, state.law, Mode::both, Scheme::barycentric);
  EXPECT_TRUE(held.hold(state, workspace).front().disagreements.empty());
}

}  // namespace
}  // namespace pcm::compare
