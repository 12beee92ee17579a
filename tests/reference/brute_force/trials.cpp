// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_force/trials.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/round.h"
#include "pcm/check.h"

namespace pcm::brute_force {
namespace {

class Draw {
 public:
  Draw(Kind kind, std::uint64_t seed, int number)
      : engine_(seed * 1000003 + static_cast<std::uint64_t>(number) * 16 + static_cast<std::uint64_t>(kind)) {}

  /// An integer of [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// A number of [low, high).
  double number(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  Eigen::Vector3d lattice_point(int low, int high) {
    const int x = integer(low, high);
    const int y = integer(low, high);
    const int z = integer(low, high);
    return {double(x), double(y), double(z)};
  }
  Eigen::Vector3d point(double size) {
    const double x = number(-size, size);
    const double y = number(-size, size);
    const double z = number(-size, size);
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

TriangleMesh tetrahedron(std::array<Eigen::Vector3d, 4> x) {
  if ((x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) > 0) std::swap(x[0], x[1]);
  return {{x.begin(), x.end()}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}, "tetrahedron"};
}

TriangleMesh octahedron(double size) {
  TriangleMesh mesh{{{size, 0, 0}, {-size, 0, 0}, {0, size, 0}, {0, -size, 0}, {0, 0, size}, {0, 0, -size}},
                    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
                    "octahedron"};
  return mesh;
}

TriangleMesh lattice_body(Draw& draw) {
  if (draw.integer(0, 2) == 0) {
    const Eigen::Vector3d corner = draw.lattice_point(0, 2);
    return generate::box(corner, corner + draw.lattice_point(1, 3));
  }
  if (draw.integer(0, 3) == 0) return octahedron(draw.integer(1, 2));
  for (;;) {
    std::array<Eigen::Vector3d, 4> x;
    for (auto& corner : x) corner = draw.lattice_point(0, 3);
    if ((x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) != 0) return tetrahedron(x);
  }
}

TriangleMesh generic_body(Draw& draw) {
  const int shape = draw.integer(0, 9);
  if (shape < 4) {
    std::array<Eigen::Vector3d, 4> x;
    for (auto& corner : x) corner = draw.point(1);
    return tetrahedron(x);
  }
  if (shape < 6) {
    const Eigen::Vector3d extents = draw.point(0.4) + Eigen::Vector3d::Constant(0.9);
    return generate::box(extents);
  }
  if (shape < 8) return octahedron(draw.number(0.5, 1.5));
  if (shape < 9) return generate::icosphere(draw.number(0.5, 1.2), 0);
  return generate::icosphere(draw.number(0.5, 1.2), 1);
}

TriangleMesh open_body(Draw& draw) {
  const int shape = draw.integer(0, 3);
  if (shape == 0) return generate::pyramid(draw.integer(1, 3), draw.integer(1, 2));
  if (shape == 1) return generate::rectangle(draw.integer(1, 3), draw.integer(1, 3), draw.integer(1, 3), 2);
  TriangleMesh mesh = lattice_body(draw);
  mesh.faces.erase(mesh.faces.begin() + draw.integer(0, static_cast<int>(mesh.faces.size()) - 1));
  return mesh;
}

/// A box or an octahedron with corners anywhere on a lattice, at times another body beside it in one surface: it may
/// wind about what it encloses several times, or less than no times.
TriangleMesh folded_body(Draw& draw) {
  for (;;) {
    TriangleMesh mesh = draw.integer(0, 2) == 0 ? generate::box(Eigen::Vector3d(1, 1, 1)) : octahedron(1);
    for (Eigen::Vector3d& x : mesh.vertices) x = draw.lattice_point(-3, 3);
    if (draw.integer(0, 5) == 0) mesh = degenerate::joined(std::move(mesh), lattice_body(draw));
    if (check(mesh).fit()) return mesh;
  }
}

/// A quarter of the size, so that some lie wholly in what a folded body encloses.
TriangleMesh small_body(Draw& draw) {
  TriangleMesh mesh = draw.integer(0, 1) == 0 ? generate::gridded_box(1.0, draw.integer(1, 2)) : lattice_body(draw);
  for (Eigen::Vector3d& x : mesh.vertices) x /= 4;
  return mesh;
}

Eigen::Matrix3d any_rotation(Draw& draw) {
  for (;;) {
    const double w = draw.number(-1, 1);
    const Eigen::Vector3d axis = draw.point(1);
    const Eigen::Quaterniond q(w, axis[0], axis[1], axis[2]);
    if (q.norm() > 0.1 && q.norm() < 1) return q.normalized().toRotationMatrix();
  }
}

Eigen::Matrix3d right_angles(Draw& draw) {
  Eigen::Matrix3d quarter_x;
  quarter_x << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  Eigen::Matrix3d quarter_z;
  quarter_z << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  for (int turns = draw.integer(0, 6); turns > 0; --turns) A = (draw.integer(0, 1) == 0 ? quarter_x : quarter_z) * A;
  return A;
}

Eigen::Vector3d any_vertex(const TriangleMesh& mesh, Draw& draw) {
  return mesh.vertices[draw.integer(0, static_cast<int>(mesh.vertices.size()) - 1)];
}

void move_by_ulps(double& x, Draw& draw) {
  const double towards =
      draw.integer(0, 1) == 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  // From zero, ulps are those of the body's size.
  const double offset = x == 0 ? 1 : 0;
  x += offset;
  for (int ulps = draw.integer(0, 8); ulps > 0; --ulps) x = std::nextafter(x, towards);
  x -= offset;
}

}  // namespace

std::string name_of(Kind kind) {
  static constexpr const char* kNames[] = {"Generic", "Lattice", "NearLattice", "Grids", "Open", "Folded"};
  return kNames[static_cast<int>(kind)];
}

Trial draw_trial(Kind kind, std::uint64_t seed, int number) {
  Draw draw(kind, seed, number);
  Trial trial;
  trial.description = name_of(kind) + ", seed " + std::to_string(seed) + ", number " + std::to_string(number);
  switch (kind) {
    case Kind::generic:
      trial.E = generic_body(draw);
      trial.F = generic_body(draw);
      trial.pose = {any_rotation(draw), draw.point(1.2)};
      break;
    case Kind::lattice:
    case Kind::near_lattice:
      trial.E = lattice_body(draw);
      trial.F = draw.integer(0, 9) == 0 ? trial.E : lattice_body(draw);
      trial.pose.A = right_angles(draw);
      trial.pose.r = any_vertex(trial.E, draw) - trial.pose.A * any_vertex(trial.F, draw) + draw.lattice_point(-1, 1);
      if (kind == Kind::near_lattice)
        for (auto& x : trial.F.vertices)
          for (double& c : x) move_by_ulps(c, draw);
      break;
    case Kind::grids: {
      const Index n = draw.integer(1, 2);
      const Index m = draw.integer(1, 2);
      trial.E = generate::gridded_box(2.0, n);
      trial.F = generate::gridded_box(1.0, m);
      const double parts = draw.integer(2, 6);
      trial.pose.A = right_angles(draw);
      trial.pose.r =
          any_vertex(trial.E, draw) - trial.pose.A * any_vertex(trial.F, draw) + draw.lattice_point(-4, 4) / parts;
      break;
    }
    case Kind::open:
      trial.E = draw.integer(0, 1) == 0 ? open_body(draw) : lattice_body(draw);
      trial.F = open_body(draw);
      trial.pose.A = draw.integer(0, 1) == 0 ? right_angles(draw) : any_rotation(draw);
      trial.pose.r = any_vertex(trial.E, draw) - trial.pose.A * any_vertex(trial.F, draw);
      trial.pose.r += draw.integer(0, 2) == 0 ? draw.lattice_point(-1, 1) : draw.point(0.5);
      break;
    case Kind::folded:
      trial.E = draw.integer(0, 1) == 0 ? folded_body(draw) : small_body(draw);
      trial.F = folded_body(draw);
      if (draw.integer(0, 1) == 0) std::swap(trial.E, trial.F);
      trial.pose.A = draw.integer(0, 1) == 0 ? right_angles(draw) : any_rotation(draw);
      trial.pose.r = draw.integer(0, 1) == 0 ? draw.lattice_point(-2, 2) : draw.point(2);
      break;
  }
  return trial;
}

}  // namespace pcm::brute_force
