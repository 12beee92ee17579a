// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compare/bodies/closed_forms.h"
#include "compare/bodies/known_answer_bodies.h"
#include "compare/motion/audits.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"

namespace pcm::compare {
namespace {

std::shared_ptr<const fast::Pairing> paired(const fast::Surface& E, const fast::Surface& F, double c_l, Mode mode,
                                            Scheme scheme) {
  return std::make_shared<const fast::Pairing>(E, F, stiffness(c_l), mode, scheme);
}

Pose placed(const Eigen::Matrix3d& A, const Eigen::Vector3d& r) {
  Pose pose;
  pose.A = A;
  pose.r = r;
  return pose;
}

/// Down by the depth, along by the slide, up again and back, A constant. `top` is where F touches; `down` points
/// from F to E, m.
std::vector<Pose> press_slide_lift(const Eigen::Matrix3d& A, const Eigen::Vector3d& top, const Eigen::Vector3d& down,
                                   const Eigen::Vector3d& slide) {
  return {placed(A, top), placed(A, top + down), placed(A, top + down + slide), placed(A, top + slide), placed(A, top)};
}

double way(const std::vector<Pose>& poses) {
  return PosePath(poses).length();
}

Eigen::Vector3d force_on_F(const fast::Pairing& pairing, const Pose& pose) {
  fast::Workspace workspace;
  return -fast::evaluate(pairing, pose, {}, {}, workspace).force_Me;
}

/// Frames the work that a loop must leave by rounding: relative to the force at its deepest pose over the whole way.
Band around(double work, double size_over_depth, double force, double length) {
  const double allowed = rounding(size_over_depth) * force * length;
  return {work - allowed, work + allowed};
}

/// A9 and A10: the wedge, E, and the plate, F, which moves up by h, along by -s and down again. All positions at the
/// end of the slide are whole cells of the plate from those at its begin.
void add_wedges(double degrees, std::int64_t steps, std::vector<Audit>& list) {
  constexpr double kStiffness = 3, kHeight = 1, kDepth = 0.5, kWidth = 1, kPlateWidth = 6, kSlide = 0.5;
  const fast::Surface wedge(generate::wedge(degrees, kHeight, kWidth, 4)),
      plate(generate::plate(kPlateWidth, kPlateWidth, 5, 24, 24));
  for (const Scheme scheme : kSchemes)
    for (const Mode mode : kModes) {
      Audit& audit = list.emplace_back();
      audit.id = fmt::format("wedge {:g} deg (A10)", degrees);
      audit.bodies = "E wedge, F plate";
      audit.loop = "press, slide, lift";
      audit.normal_Me = Eigen::Vector3d::UnitZ();
      audit.pairing = paired(wedge, plate, kStiffness, mode, scheme);
      audit.poses =
          press_slide_lift(Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), {0, 0, kDepth}, {-kSlide, 0, 0});
      audit.steps = steps;
      const closed_forms::WedgeForce on_wedge = closed_forms::wedge_on_plane_wedge_master(degrees, kDepth);
      const closed_forms::WedgeForce on_plane = closed_forms::wedge_on_plane_plane_master(degrees, kDepth);
      const double wedge_share = mode == Mode::E ? 1 : mode == Mode::F ? 0 : 0.5;
      const double x = kStiffness * kWidth * wedge_share * static_cast<double>(on_wedge.x);
      const double z =
          kStiffness * kWidth * static_cast<double>(wedge_share * on_wedge.z + (1 - wedge_share) * on_plane.z);
      audit.work = around(x * kSlide, kPlateWidth / kDepth, z, way(audit.poses));
      // The plate's barycentres miss up to a^2 / (9 h^2) of F_z at the borders, cells of width a
      // (known_answers/wedges.cpp), and count as much too much at the ridge where that lies within a cell.
      const double missed = scheme == Scheme::barycentric && mode != Mode::E ? 1.0 / 16 / (9 * kDepth * kDepth) : 0;
      const double ratio = std::abs(x) / z, allowed = rounding(kPlateWidth / kDepth);
      audit.tangential = Band{ratio / (1 + missed) - allowed, ratio / (1 - missed) + allowed};
      audit.jumps = within(0);
      audit.reason = "F_x s of the closed form; barycentres enter at depth 0";
    }
}

/// Which of the plate's barycentres a box has above them while it slides, worked out apart from the engine.
struct SweptBarycentres {
  int at_start = 0, at_end = 0;
  std::size_t events = 0;  ///< places at which some come or go
  int greatest = 0;        ///< most that come less those that go at one place
};

SweptBarycentres swept(const TriangleMesh& plate, const Eigen::Vector3d& start, const Eigen::Vector3d& slide,
                       double half) {
  SweptBarycentres result;
  std::map<std::int64_t, int> net;  // by place, in 2^-40 of the slide
  for (const Triangle& face : plate.faces) {
    Eigen::Vector3d C = Eigen::Vector3d::Zero();
    bool top = true;
    for (const Index v : face) {
      C += plate.vertices[static_cast<std::size_t>(v)] / 3;
      top = top && plate.vertices[static_cast<std::size_t>(v)].z() == 0;
    }
    if (!top) continue;
    double in = -1e9, out = 1e9;
    for (int i = 0; i < 2; ++i) {
      const double a = (C[i] - half - start[i]) / slide[i], b = (C[i] + half - start[i]) / slide[i];
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    }
    if (in >= out) continue;
    if (in < 0 && out > 0) ++result.at_start;
    if (in < 1 && out > 1) ++result.at_end;
    const auto place = [](double share) { return static_cast<std::int64_t>(std::round(share * 0x1p40)); };
    if (in > 0 && in < 1) ++net[place(in)];
    if (out > 0 && out < 1) --net[place(out)];
  }
  result.events = net.size();
  for (const auto& [where, sum] : net) result.greatest = std::max(result.greatest, std::abs(sum));
  return result;
}

/// A1 and A11: the gridded plate, E, and a box, F, that slides obliquely over its cells.
void add_box(std::int64_t steps, std::vector<Audit>& list) {
  constexpr double kStiffness = 100, kHalf = 0.15, kDepth = 0.0625, kPlateWidth = 2;
  const TriangleMesh plate_mesh = generate::plate(kPlateWidth, kPlateWidth, 1, 16, 16);
  const fast::Surface plate(plate_mesh), box(generate::box({-kHalf, -kHalf, 0}, {kHalf, kHalf, 1}));
  const Eigen::Vector3d top(0.03, 0.01, 0), slide(0.43, 0.21, 0);
  const SweptBarycentres count = swept(plate_mesh, top, slide, kHalf);
  const double of_one = kStiffness * (kPlateWidth / 16) * (kPlateWidth / 16) / 2 * kDepth;
  for (const Scheme scheme : kSchemes)
    for (const Mode mode : kModes) {
      Audit& audit = list.emplace_back();
      audit.id = "box on plate (A1, A11)";
      audit.bodies = "E plate, F box";
      audit.loop = "press, slide, lift";
      audit.normal_Me = Eigen::Vector3d::UnitZ();
      audit.pairing = paired(plate, box, kStiffness, mode, scheme);
      audit.poses = press_slide_lift(Eigen::Matrix3d::Identity(), top, {0, 0, -kDepth}, slide);
      audit.steps = steps;
      const bool sampled = scheme == Scheme::barycentric && mode != Mode::F;
      const double weight = sampled ? (mode == Mode::both ? 0.5 : 1) : 0;
      const double force = force_on_F(*audit.pairing, audit.poses[1]).norm();
      audit.work = around(weight * of_one * (kDepth / 2) * (count.at_end - count.at_start), kPlateWidth / kDepth, force,
                          way(audit.poses));
      audit.tangential = within(0);
      const double events = sampled ? static_cast<double>(count.events) : 0;
      audit.jumps = Band{events, events};
      const double greatest = weight * of_one * count.greatest;
      audit.greatest_jump = between(1 - rounding(kPlateWidth / kDepth), 1 + rounding(kPlateWidth / kDepth), greatest);
      audit.reason = sampled ? "c_l A u for each barycentre that a wall passes; half of c_l A u^2 for those won or lost"
                             : "one normal, one depth: conservative, continuous";
    }
}

/// A8: the plate, E, and a bubble, F, in a skew orientation.
void add_bubble_on_plate(std::int64_t steps, std::vector<Audit>& list) {
  constexpr double kStiffness = 5.9e5, kDepth = 0.03, kPlateWidth = 2;
  const TriangleMesh mesh = generate::bubble();
  const fast::Surface plate(generate::plate(kPlateWidth, kPlateWidth, 1, 40, 40)), bubble(mesh);
  const Eigen::Matrix3d A = fixed_rotation(3);
  double lowest = 0;
  for (const Eigen::Vector3d& x : mesh.vertices) lowest = std::min(lowest, (A * x).z());
  const Eigen::Vector3d top(0.013, 0.007, -lowest + 0x1p-10), down(0, 0, -kDepth), slide(0.2, 0.07, 0);
  for (const Scheme scheme : kSchemes)
    for (const Mode mode : kModes) {
      Audit& audit = list.emplace_back();
      audit.id = "bubble on plate (A8)";
      audit.bodies = "E plate, F bubble";
      audit.loop = "press, slide, lift";
      audit.normal_Me = Eigen::Vector3d::UnitZ();
      audit.pairing = paired(plate, bubble, kStiffness, mode, scheme);
      audit.poses = press_slide_lift(A, top, down, slide);
      audit.steps = steps;
      // Against an endless plane the force does not change along the slide, unless the plane samples it.
      if (mode != Mode::F && scheme == Scheme::barycentric) {
        audit.reason = "the plate's barycentres sample the contact";
        if (mode == Mode::E) audit.tangential = within(0);
        continue;
      }
      const Eigen::Vector3d force = force_on_F(*audit.pairing, placed(A, top + down + slide / 2));
      const double work = mode == Mode::E ? 0 : force.dot(slide);
      audit.work = around(work, kPlateWidth / kDepth, force.norm(), way(audit.poses));
      if (mode == Mode::E) audit.tangential = within(0);
      audit.jumps = within(0);
      audit.reason = mode == Mode::E ? "a volume times one normal: a potential"
                                     : "the same force all along the slide, its part along the slide times that";
    }
}

/// c_l sum A_k (n_k x n_f) / (n_k . n_f) of the clipped elements; their mean in mode both.
Eigen::Vector3d rotation_of_force(const fast::Pairing& pairing, const Pose& pose, fast::Workspace& workspace) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const fast::Element& element : fast::evaluate(pairing, pose, {}, {}, workspace).elements) {
    const bool slave_is_F = element.master == Side::E;
    const TriangleMesh& slave = (slave_is_F ? pairing.surface_F() : pairing.surface_E()).mesh();
    const Triangle& f = slave.faces[static_cast<std::size_t>(element.slave_face)];
    const auto corner = [&](std::size_t i) { return slave.vertices[static_cast<std::size_t>(f[i])]; };
    Eigen::Vector3d N = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (slave_is_F) N = pose.A * N;
    sum += element.area * element.normal_Me.cross(N) / element.normal_Me.dot(N);
  }
  return pairing.law().stiffness * (pairing.mode() == Mode::both ? 0.5 : 1) * sum;
}

/// Bubble against bubble, translated around a small square whose plane is normal to rot F: Stokes' theorem.
void add_square_of_bubbles(std::int64_t steps, std::vector<Audit>& list) {
  constexpr double kStiffness = 5.9e5, kSide = 0x1p-9;
  constexpr int kCells = 8;  // of the flux's midpoint rule along each side
  const fast::Surface bubble(generate::bubble());
  const Eigen::Matrix3d A = fixed_rotation(2);
  const Eigen::Vector3d centre(0.22, 0.05, 0.10);
  fast::Workspace workspace;
  for (const Scheme scheme : kSchemes)
    for (const Mode mode : kModes) {
      Audit& audit = list.emplace_back();
      audit.id = "bubbles, square";
      audit.bodies = "E, F bubble";
      audit.loop = "around a square of 2 mm, without turning";
      audit.pairing = paired(bubble, bubble, kStiffness, mode, scheme);
      const auto clipped = paired(bubble, bubble, kStiffness, mode, Scheme::clipped);
      const Eigen::Vector3d n = rotation_of_force(*clipped, placed(A, centre), workspace).normalized();
      const Eigen::Vector3d a = kSide * n.unitOrthogonal(), b = n.cross(a);
      const Eigen::Vector3d corner = centre - (a + b) / 2;
      for (const Eigen::Vector3d& r :
           {corner, Eigen::Vector3d(corner + a), Eigen::Vector3d(corner + a + b), Eigen::Vector3d(corner + b), corner})
        audit.poses.push_back(placed(A, r));
      audit.normal_Me = force_on_F(*clipped, placed(A, centre)).normalized();
      audit.steps = steps;
      if (scheme == Scheme::barycentric) {
        audit.reason = "no expectation";
        continue;
      }
      double flux = 0;
      for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j) {
          const Eigen::Vector3d r = corner + (i + 0.5) / kCells * a + (j + 0.5) / kCells * b;
          flux += rotation_of_force(*clipped, placed(A, r), workspace).dot(n) * kSide * kSide / (kCells * kCells);
        }
      audit.work = between(0.99, 1.01, flux);
      audit.jumps = within(0);
      audit.reason = "the flux of rot F through the square, to 1 % of it; continuous";
    }
}

/// Bubble against bubble, along and about all axes.
void add_tour_of_bubbles(std::int64_t steps, std::vector<Audit>& list) {
  const fast::Surface bubble(generate::bubble());
  const Pose start = placed(fixed_rotation(2), {0.15, 0.02, 0.1});
  for (const Scheme scheme : kSchemes)
    for (const Mode mode : kModes) {
      Audit& audit = list.emplace_back();
      audit.id = "bubbles, tour";
      audit.bodies = "E, F bubble";
      audit.loop = "moved and turned by up to 180 deg over three poses";
      audit.pairing = paired(bubble, bubble, 5.9e5, mode, scheme);
      audit.poses = {start, placed(fixed_rotation(7), {0.15, -0.02, 0.1}), placed(fixed_rotation(11), {0.13, 0, 0.12}),
                     start};
      audit.steps = steps;
      if (scheme == Scheme::clipped) audit.jumps = within(0);
      audit.reason = scheme == Scheme::clipped ? "continuous" : "no expectation";
    }
}

}  // namespace

std::vector<Audit> audits(Extent extent) {
  const bool full = extent == Extent::full;
  const std::int64_t steps = full ? 64 : 16;
  std::vector<Audit> list;
  for (const double degrees : {45.0, 30.0, 15.0})
    if (full || degrees == 30) add_wedges(degrees, steps, list);
  add_box(steps, list);
  add_bubble_on_plate(steps, list);
  add_square_of_bubbles(steps, list);
  add_tour_of_bubbles(steps, list);
  return list;
}

}  // namespace pcm::compare
