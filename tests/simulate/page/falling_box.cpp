// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/page/falling_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "meshes/generate/boxes.h"

namespace pcm::simulate {
namespace {

constexpr double kMass = 8, kGravity = 9.81, kStiffness = 4e4, kDamping = 60, kStep = 2.5e-4;  // SI units
constexpr int kStepsPerFrame = 40, kFrames = 151;

struct State {
  double t = 0, height = 0.5, speed = 0;  // of the box's lower face over the plate
  double lost = 0;                        // energy that damping took
};

double force_up(const State& state) {
  return state.height < 0 ? std::max(0.0, -kStiffness * state.height - kDamping * state.speed) : 0;
}

/// Semi-implicit Euler.
void advance(State& state) {
  const double force = force_up(state);
  if (state.height < 0) state.lost += kDamping * state.speed * state.speed * kStep;
  state.speed += (force / kMass - kGravity) * kStep;
  state.height += state.speed * kStep;
  state.t += kStep;
}

Pose box_pose(const State& state) {
  Pose pose;
  pose.A = Eigen::AngleAxisd(0.3 + 0.5 * state.t, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.r = {-0.55 + 0.8 * state.t, 0.1, state.height + kBoxEdge / 2};
  return pose;
}

/// The box's lower faces, more and more pressed towards its front.
std::vector<RecordedElement> elements_of(const TriangleMesh& box, const State& state) {
  std::vector<RecordedElement> elements;
  for (std::size_t i = 0; i < box.faces.size(); ++i) {
    Eigen::Vector3d barycentre = Eigen::Vector3d::Zero();
    for (const Index vertex : box.faces[i]) barycentre += box.vertices[static_cast<std::size_t>(vertex)] / 3;
    if (barycentre.z() > -0.499 * kBoxEdge) continue;
    const double mean = force_up(state) / (kBoxEdge * kBoxEdge);
    const double share = 1 + 0.8 * barycentre.x() / (kBoxEdge / 2) + 0.15 * barycentre.y() / (kBoxEdge / 2);
    elements.push_back({0, Side::E, static_cast<Index>(i), mean * share});
  }
  return elements;
}

Frame frame_of(const Recording& recording, const State& state) {
  Frame frame;
  frame.t = state.t;
  frame.poses_W = {Pose{}, box_pose(state)};
  const double force = force_up(state);
  if (force > 0) {
    frame.elements = elements_of(recording.surfaces[1].mesh, state);
    frame.contacts.push_back({0,
                              frame.poses_W[1].A * Eigen::Vector3d{0.08, 0.01, -kBoxEdge / 2} + frame.poses_W[1].r,
                              {-0.25 * force, 0, force}});
  }
  return frame;
}

void add(Series& series, double t, double value) {
  series.t.push_back(t);
  series.value.push_back(value);
}

}  // namespace

Recording falling_box() {
  Recording recording;
  recording.title = "A box falls on a plate";
  recording.surfaces = {{"plate", generate::plate(2.4, 1.2, 0.05, 24, 12), {168, 178, 188}},
                        {"box", generate::gridded_box(kBoxEdge, 8), {214, 69, 65}}};
  recording.pairings = {{"box on plate", 1, 0}};
  Series kinetic{"kinetic", "J", "Energy", {}, {}, false}, gravity{"gravity", "J", "Energy", {}, {}, false};
  Series elastic{"elastic", "J", "Energy", {}, {}, false}, dissipated{"dissipated", "J", "Energy", {}, {}, false};
  Series normal{"normal", "N", "Force on the box", {}, {}, false};
  Series friction{"friction", "N", "Force on the box", {}, {}, false};
  Series height{"height of the box", "m", "Motion", {}, {}, false};
  Series step_size{"step size", "s", "Step size", {}, {}, true};
  State state;
  for (int i = 0; i < kFrames; ++i) {
    state.t = 0.01 * i;  // not the sum of steps, so that the last instant is 1.5 s
    recording.frames.push_back(frame_of(recording, state));
    for (int k = 0; k < kStepsPerFrame; ++k) {
      if (i + 1 == kFrames && k > 0) break;
      const double force = force_up(state);
      add(kinetic, state.t, 0.5 * kMass * state.speed * state.speed);
      add(gravity, state.t, kMass * kGravity * state.height);
      add(elastic, state.t, state.height < 0 ? 0.5 * kStiffness * state.height * state.height : 0);
      add(dissipated, state.t, state.lost);
      add(normal, state.t, force);
      add(friction, state.t, -0.25 * force);
      add(height, state.t, state.height);
      if (k % 4 == 0) add(step_size, state.t, force > 0 ? 3e-5 * (1.2 + std::sin(300 * state.t)) : 5e-3);
      advance(state);
    }
  }
  recording.series = {kinetic, gravity, elastic, dissipated, normal, friction, height, step_size};
  return recording;
}

Eigen::Vector3d box_point_W(const Recording& recording, std::size_t frame, const Eigen::Vector3d& point) {
  const Pose& pose = recording.frames[frame].poses_W[1];
  return pose.A * point + pose.r;
}

PressedFace most_pressed(const Recording& recording) {
  PressedFace most;
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    for (const RecordedElement& element : recording.frames[i].elements) {
      if (element.pressure > most.element.pressure) most = {i, element};
    }
  }
  return most;
}

}  // namespace pcm::simulate
