// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every draw stands in a statement of its own: the order in which a compiler evaluates arguments and operands is its
// own choice.
#include "compare/hard_poses/neighbour.h"

#include <cmath>
#include <vector>

#include "compare/verify/routes/state_draw.h"
#include "compare/verify/verdict/question_range.h"

namespace pcm::compare {
namespace {

/// Of surfaces whose vertices are moved.
constexpr std::size_t kMostFacesMoved = 200;

double& a_component(Eigen::Vector3d& x, PoseRandom& random) {
  return x[static_cast<Eigen::Index>(random.below(3))];
}

double up_to(double greatest, PoseRandom& random) {
  return greatest * random.uniform(-1, 1);
}

void move(HardState& hard, double share, PoseRandom& random) {
  a_component(hard.state.pose.r, random) += up_to(share * hard.held->features().size(), random);
}

void turn(HardState& hard, double share, PoseRandom& random) {
  const Eigen::Vector3d axis = random.direction();
  const Eigen::Vector3d half = axis * (share / 2 * random.uniform());  // the tangent of half the angle
  const Eigen::Matrix3d R = ordered_rotation(1, half.x(), half.y(), half.z());
  Eigen::Matrix3d& A = hard.state.pose.A;
  const Eigen::Matrix3d before = A;
  for (int j = 0; j < 3; ++j) A.col(j) = ordered_product(R, before.col(j));
}

void move_a_vertex(HardState& hard, double share, PoseRandom& random) {
  const FeaturePair& features = hard.held->features();
  TriangleMesh E = features.E.mesh, F = features.F.mesh;
  const bool of_E = random.coin();
  const SurfaceFeatures& surface = of_E ? features.E : features.F;
  const Index moved = surface.used_vertices[random.below(surface.used_vertices.size())];
  a_component((of_E ? E : F).vertices[static_cast<std::size_t>(moved)], random) += up_to(share * surface.size, random);
  hard.held = held_in_all_modes(E, F, hard.state.law, hard.state.scheme);
}

void change_the_mode(HardState& hard, PoseRandom& random) {
  hard.mode = (hard.mode + 1 + random.below(2)) % 3;
}

void draw_the_law(HardState& hard, PoseRandom& random) {
  const std::uint64_t seed = random.bits();
  const auto stream = [seed](Purpose purpose) { return PoseRandom(seed, 0, 0, 0, purpose); };
  DrawnPose there;
  there.pose = hard.state.pose;
  there.velocity = hard.state.velocity;
  hard.state = draw_state(*hard.held, Stratum::generic, there, hard.state.scheme, stream(Purpose::law),
                          stream(Purpose::velocity));
}

void change_the_velocity(HardState& hard, double share, PoseRandom& random) {
  const bool turns = random.coin();
  Velocity& velocity = hard.state.velocity;
  a_component(turns ? velocity.w : velocity.v, random) +=
      up_to(turns ? share : share * hard.held->features().size(), random);
}

void change_a_number_of_the_law(HardState& hard, double share, PoseRandom& random) {
  ContactLaw& law = hard.state.law;
  std::vector<double*> numbers = {&law.damping, &law.transition_depth, &law.friction, &law.slip_velocity,
                                  &law.max_penetration};
  if (law.layers)
    numbers.insert(numbers.end(), {&law.layers->c_E, &law.layers->c_F});
  else
    numbers.push_back(&law.stiffness);
  std::erase_if(numbers, [](const double* x) { return *x == 0 || std::isinf(*x); });
  double& changed = *numbers[random.below(numbers.size())];  // the stiffness at least is neither
  changed += up_to(share * changed, random);
  require_in_range(law);
}

void change_law_or_velocity(HardState& hard, double share, PoseRandom& random) {
  if (random.below(8) == 0) return draw_the_law(hard, random);
  if (random.coin()) return change_the_velocity(hard, share, random);
  change_a_number_of_the_law(hard, share, random);
}

}  // namespace

HardState neighbour(const HardState& from, Goal goal, PoseRandom& random) {
  HardState near = from;
  const FeaturePair& features = from.held->features();
  const bool is_small = features.E.mesh.faces.size() + features.F.mesh.faces.size() <= kMostFacesMoved;
  const double share = random.log_uniform(0x1p-52, 0x1p-4);
  const std::uint64_t eighth = random.below(8);
  if (eighth < 3 || (eighth == 3 && !is_small))
    move(near, share, random);
  else if (eighth == 3)
    move_a_vertex(near, share, random);
  else if (eighth == 4 && goal != Goal::margins)
    change_the_mode(near, random);
  else if (eighth <= 5 || !depends_on_law(goal))
    turn(near, share, random);
  else
    change_law_or_velocity(near, share, random);
  return near;
}

}  // namespace pcm::compare
