// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "meshes/generate/boxes.h"
#include "tests/fast/engine_support.h"
#include "tests/force_law.h"

/// The clipped scheme's bounds where the law clamps point by point, against the exact problem in numbers of 2048 bits:
/// a thick plate as master, a convex body as slave. The truth is made without the engine's steps: what a line from the
/// plate sees is told by the one interval in which it is inside the body.
namespace pcm::fast::clipped_clamp_bound_test {
namespace {

using namespace test;

/// Which way a face is seen, a polynomial of input coordinates, is exact.
constexpr mp_bitcnt_t kBits = 2048;

class Number : public mpf_class {
 public:
  Number(double x = 0) : mpf_class(x, kBits) {}
  template <class T, class U>
  Number(const __gmp_expr<T, U>& x) : mpf_class(x, kBits) {}
};

using Vector = std::array<Number, 3>;

Vector vector(const Eigen::Vector3d& x) {
  return {x[0], x[1], x[2]};
}
Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(const Number& k, const Vector& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
Number dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Number length(const Vector& a) {
  return sqrt(dot(a, a));
}

struct Body {
  std::vector<Vector> vertices;
  std::vector<Triangle> faces;

  std::array<Vector, 3> face(std::size_t f) const {
    const auto corner = [&](std::size_t k) { return vertices[static_cast<std::size_t>(faces[f][k])]; };
    return {corner(0), corner(1), corner(2)};
  }
};

Body placed(const TriangleMesh& mesh, const Pose& pose) {
  Body body;
  body.faces = mesh.faces;
  for (const Eigen::Vector3d& x : mesh.vertices) {
    Vector y = vector(pose.r);
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j) y[static_cast<std::size_t>(i)] += Number(pose.A(i, j)) * Number(x[j]);
    body.vertices.push_back(y);
  }
  return body;
}

/// In a master face's plane, by its corners: p0 + s (p1 - p0) + t (p2 - p0).
struct Point {
  Number s, t;
};
using Polygon = std::vector<Point>;
using Linear = std::function<Number(const Point&)>;

Polygon where_not_negative(const Polygon& polygon, const Linear& f) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const Number f_a = f(a), f_b = f(b);
    if (f_a >= 0) kept.push_back(a);
    if ((f_a < 0 && f_b > 0) || (f_a > 0 && f_b < 0)) {
      const Number way = f_a / (f_a - f_b);
      kept.push_back({a.s + way * (b.s - a.s), a.t + way * (b.t - a.t)});
    }
  }
  return kept;
}

/// What a master face sees of another one.
struct Seen {
  std::array<Point, 3> corners;
  std::array<Number, 3> depths;
  int facing;         ///< -1: the lines leave the face's body there, +1: they enter, 0: it is seen edgewise
  Number twice_area;  ///< in (s, t), signed

  Number depth(const Point& x) const {
    const Point a{corners[1].s - corners[0].s, corners[1].t - corners[0].t};
    const Point b{corners[2].s - corners[0].s, corners[2].t - corners[0].t};
    const Point d{x.s - corners[0].s, x.t - corners[0].t};
    const Number of_a = (d.s * b.t - d.t * b.s) / twice_area, of_b = (a.s * d.t - a.t * d.s) / twice_area;
    return depths[0] + of_a * (depths[1] - depths[0]) + of_b * (depths[2] - depths[0]);
  }
  Polygon within(Polygon polygon) const {
    const Number sign = facing;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& a = corners[k];
      const Point& b = corners[(k + 1) % 3];
      if (polygon.empty()) return polygon;
      polygon = where_not_negative(polygon, [&](const Point& x) -> Number {
        return sign * ((b.s - a.s) * (x.t - a.t) - (b.t - a.t) * (x.s - a.s));
      });
    }
    return polygon;
  }
};

struct TrueElement {
  Number area, volume;
  Vector moment;  ///< of the foot, times the volume
};

struct TrueLoad {
  Vector force, torque;
};

class TrueMaster {
 public:
  TrueMaster(const std::array<Vector, 3>& face, double greatest) : p_(face), greatest_(greatest) {
    a_ = p_[1] - p_[0];
    b_ = p_[2] - p_[0];
    N_ = cross(a_, b_);
    length_ = length(N_);
  }
  Vector inward() const { return Number(-1 / length_) * N_; }

  Seen see(const std::array<Vector, 3>& f) const {
    Seen seen;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector d = f[k] - p_[0];
      seen.corners[k] = {dot(cross(d, b_), N_) / dot(N_, N_), dot(cross(a_, d), N_) / dot(N_, N_)};
      seen.depths[k] = -dot(d, N_) / length_;
    }
    const auto& c = seen.corners;
    seen.facing = sgn(dot(cross(f[1] - f[0], f[2] - f[0]), N_));
    seen.twice_area = (c[1].s - c[0].s) * (c[2].t - c[0].t) - (c[1].t - c[0].t) * (c[2].s - c[0].s);
    return seen;
  }

  /// All that f covers of the master face.
  Polygon under(const Seen& f) const {
    Polygon seen = f.within({{0, 0}, {1, 0}, {0, 1}});
    return where_not_negative(seen, [&](const Point& x) { return f.depth(x); });
  }
  /// Over points of it where the body is entered above the face's plane, through g, and left beneath it, through f: the
  /// integrals of the depth, less those of what exceeds the clamp.
  void add(const Polygon& under_f, const Seen& f, const Seen& g, TrueElement& element) const {
    const Polygon seen = where_not_negative(g.within(under_f), [&](const Point& x) -> Number { return -g.depth(x); });
    if (seen.empty()) return;
    element.area += integrate(
        seen, [&](const Point& x) { return f.depth(x); }, element);
    if (std::isinf(greatest_)) return;
    const Number u_max = greatest_;
    const Linear allowed = [&](const Point& x) -> Number { return u_max - f.depth(x); };
    integrate(where_not_negative(seen, [&](const Point& x) -> Number { return -allowed(x); }), allowed, element);
  }

 private:
  /// Of the depth; returns the area.
  Number integrate(const Polygon& polygon, const Linear& depth, TrueElement& element) const {
    Number sum;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const std::array<Point, 3> x{polygon[0], polygon[i], polygon[i + 1]};
      const Number twice = (x[1].s - x[0].s) * (x[2].t - x[0].t) - (x[1].t - x[0].t) * (x[2].s - x[0].s);
      const Number area = twice * length_ / 2;
      sum += area;
      std::array<Number, 3> d;
      for (std::size_t k = 0; k < 3; ++k) d[k] = depth(x[k]);
      element.volume += area * (d[0] + d[1] + d[2]) / 3;
      // Of two linear functions: the product of the sums and the sum of the products, over 12.
      for (std::size_t k = 0; k < 3; ++k) {
        const Number weight = area / 12 * (d[0] + d[1] + d[2] + d[k]);
        element.moment = element.moment + weight * (p_[0] + x[k].s * a_ + x[k].t * b_);
      }
    }
    return sum;
  }

  std::array<Vector, 3> p_;
  double greatest_;
  Vector a_, b_, N_;
  Number length_;
};

/// (12)-(22) without friction.
void add_load(const ContactLaw& law, const Pose& pose, const Velocity& velocity, Side master, const Vector& n,
              const TrueElement& element, TrueLoad& load) {
  if (!(element.volume > 0)) return;
  const Number u_k = element.volume / element.area;
  const Vector foot = Number(1 / element.volume) * element.moment;
  const auto [c_l, share] = written_law::layers<Number>(law, master);
  const Vector lever = foot + Number(share * u_k) * n - vector(pose.r);
  Number v_n = dot(n, vector(velocity.v) + cross(vector(velocity.w), lever));
  if (master == Side::F) v_n = -v_n;
  const Number F_n = written_law::forces<Number>(law, c_l, element.area, u_k, v_n, 0).normal;
  const Vector force = Number(master == Side::E ? F_n : Number(-F_n)) * n;
  load.force = load.force + force;
  load.torque = load.torque + cross(lever, force);
}

struct Case {
  TriangleMesh plate;  ///< its surface are the first faces
  std::size_t surface_faces;
  TriangleMesh body;
  Mode mode;  ///< the plate's
  Pose pose;
  Velocity velocity;
  ContactLaw law;

  const TriangleMesh& mesh_E() const { return mode == Mode::E ? plate : body; }
  const TriangleMesh& mesh_F() const { return mode == Mode::E ? body : plate; }
};

TrueLoad truth(const Case& c) {
  const bool plate_is_E = c.mode == Mode::E;
  const Body plate = placed(c.plate, plate_is_E ? Pose{} : c.pose), body = placed(c.body, plate_is_E ? c.pose : Pose{});
  TrueLoad load;
  for (std::size_t e = 0; e < c.surface_faces; ++e) {
    const TrueMaster master(plate.face(e), c.law.max_penetration);
    std::vector<Seen> left, entered;
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      const Seen seen = master.see(body.face(f));
      if (seen.facing < 0) left.push_back(seen);
      if (seen.facing > 0) entered.push_back(seen);
    }
    for (const Seen& f : left) {
      TrueElement element;
      const Polygon under_f = master.under(f);
      if (under_f.empty()) continue;
      for (const Seen& g : entered) master.add(under_f, f, g, element);
      add_load(c.law, c.pose, c.velocity, plate_is_E ? Side::E : Side::F, master.inward(), element, load);
    }
  }
  return load;
}

/// How far the answers are from the truth, and what was promised.
struct Widths {
  int answers = 0, clamped = 0, flipped = 0;
  double greatest_share = 0;     ///< of an error in its bound
  std::vector<double> relative;  ///< greatest bound of a force over the force

  double median() {
    std::nth_element(relative.begin(), relative.begin() + static_cast<std::ptrdiff_t>(relative.size() / 2),
                     relative.end());
    return relative[relative.size() / 2];
  }
};

void check(const Case& c, Workspace& workspace, Widths& widths) {
  const Pairing pairing(Surface(c.mesh_E()), Surface(c.mesh_F()), c.law, c.mode, Scheme::clipped);
  Wanted wanted;
  wanted.bound = true;
  const Contact& contact = evaluate(pairing, c.pose, c.velocity, wanted, workspace);
  const TrueLoad load = truth(c);
  ++widths.answers;
  widths.clamped += contact.penetration_exceeded ? 1 : 0;
  widths.flipped += contact.bound->flipped ? 1 : 0;
  const auto hold = [&](const Vector& true_value, const Eigen::Vector3d& value, const Eigen::Vector3d& bound) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double off = std::abs(Number(true_value[static_cast<std::size_t>(k)] - Number(value[k])).get_d());
      ASSERT_LE(off, bound[k]) << "component " << k << " of " << value.transpose();
      if (off > 0) widths.greatest_share = std::max(widths.greatest_share, off / bound[k]);
    }
  };
  hold(load.force, contact.force_Me, contact.bound->force_Me);
  hold(load.torque, contact.torque_Me, contact.bound->torque_Me);
  EXPECT_LE(contact.bound->penetration_at_least, contact.max_penetration);
  EXPECT_GE(contact.bound->penetration_at_most, contact.max_penetration);
  if (contact.force_Me.norm() > 0)
    widths.relative.push_back(contact.bound->force_Me.maxCoeff() / contact.force_Me.norm());
}

ContactLaw law_of(int i) {
  ContactLaw law = stiffness(1000);
  if (i % 3 == 0) return law;
  law.damping = 200;
  law.transition_depth = i % 3 == 1 ? 0.05 : 0;
  return law;
}

class Random {
 public:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1; }
  Eigen::Vector3d vector() {
    const double x = unit(), y = unit();
    return {x, y, unit()};
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 random_{1906};
};

/// A plate whose surface, in z = 0, are its first faces.
TriangleMesh plate_with_surface_first(std::size_t& surface_faces) {
  TriangleMesh plate = generate::plate(8, 8, 6, 2, 2);
  const auto end = std::partition(plate.faces.begin(), plate.faces.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index v) { return plate.vertices[static_cast<std::size_t>(v)].z() == 0; });
  });
  surface_faces = static_cast<std::size_t>(end - plate.faces.begin());
  return plate;
}

/// A triangle below, a larger one above: convex whatever rounding does to its vertices.
TriangleMesh antiprism() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0.5, 0}, {-0.45, -0.25, 0}, {0.45, -0.25, 0}, {0, -1, 1}, {0.9, 0.5, 1}, {-0.9, 0.5, 1}};
  mesh.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 5}, {1, 2, 3}, {2, 0, 4}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};
  return mesh;
}

/// The body turned by A, its lowest point so deep in the plate, as Me of the plate or of the body sees it.
Pose pose_of(const TriangleMesh& body, const Eigen::Matrix3d& A, double depth, const Eigen::Vector3d& beside,
             Mode mode) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& x : body.vertices) lowest = std::min(lowest, (A * x).z());
  Pose pose{A, {beside.x(), beside.y(), -lowest - depth}};
  if (mode == Mode::F) pose = {A.transpose(), -(A.transpose() * pose.r)};
  return pose;
}

Case drawn(const TriangleMesh& body, const Eigen::Matrix3d& A, double depth, Random& random) {
  Case c;
  c.plate = plate_with_surface_first(c.surface_faces);
  c.body = body;
  c.mode = random.below(2) == 0 ? Mode::E : Mode::F;
  c.pose = pose_of(body, A, depth, random.vector(), c.mode);
  c.velocity = {random.vector(), random.vector()};
  c.law = law_of(random.below(3));
  return c;
}

Eigen::Matrix3d any_rotation(Random& random) {
  return Eigen::Quaterniond(random.unit(), random.unit(), random.unit(), random.unit()).normalized().toRotationMatrix();
}

/// The same with both bodies turned, so that nothing lies along an axis any more.
void turn(Case& c, const Eigen::Matrix3d& turn) {
  TriangleMesh& E = c.mode == Mode::E ? c.plate : c.body;
  for (Eigen::Vector3d& x : E.vertices) x = turn * x;
  c.pose = {turn * c.pose.A, turn * c.pose.r};
}

void report(Widths& widths) {
  std::printf(
      "  %d answers, %d clamped, %d flipped; greatest error over its bound %.3f, median bound over force %.2g\n",
      widths.answers, widths.clamped, widths.flipped, widths.greatest_share, widths.median());
  EXPECT_EQ(widths.flipped, 0);
  EXPECT_GT(widths.greatest_share, 0.001);
  EXPECT_LT(widths.median(), 1e-11);
}

TEST(ClippedClampBound, HoldsForConvexBodiesInAPlateAtAnyClamp) {
  const TriangleMesh bodies[] = {generate::icosphere(1, 1), antiprism(), generate::box(Eigen::Vector3d(1, 0.8, 1.2)),
                                 generate::gridded_box(Eigen::Vector3d(1, 1.25, 0.75), {2, 1, 2})};
  Random random;
  Workspace workspace;
  Widths widths;
  for (int i = 0; i < 80; ++i) {
    SCOPED_TRACE(i);
    const double depth = std::exp2(-1 - 5 * std::abs(random.unit()));
    Case c = drawn(bodies[i % 4], any_rotation(random), depth, random);
    c.law.max_penetration = depth * std::abs(random.unit());
    check(c, workspace, widths);
    if (HasFatalFailure()) return;
  }
  report(widths);
  EXPECT_GT(widths.clamped, widths.answers / 2);
}

TEST(ClippedClampBound, HoldsWhereFlatDepthsLieWithinUlpsOfTheClamp) {
  Random random;
  Workspace workspace;
  Widths widths;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE(i);
    // Parallel to the plate but for roundings, or tilted by little more than these.
    const double depth = std::exp2(-1 - 5 * std::abs(random.unit()));
    const double tilt = random.below(2) == 0 ? 0 : std::exp2(-45 - 8 * std::abs(random.unit()));
    const Eigen::Matrix3d A = (Eigen::AngleAxisd(3 * random.unit(), Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(tilt, Eigen::Vector3d(1, 2, 0).normalized()))
                                  .toRotationMatrix();
    Case c = drawn(antiprism(), A, depth, random);
    if (i % 4 != 0) turn(c, any_rotation(random));
    const Contact unclamped = answer(c.mesh_E(), c.mesh_F(), c.pose, c.law, c.mode, {}, {}, Scheme::clipped);
    c.law.max_penetration = unclamped.max_penetration;
    for (int ulps = random.below(12) - 8; ulps != 0; ulps -= ulps > 0 ? 1 : -1)
      c.law.max_penetration = std::nextafter(c.law.max_penetration, ulps > 0 ? 1.0 : 0.0);
    check(c, workspace, widths);
    if (HasFatalFailure()) return;
  }
  report(widths);
  EXPECT_GT(widths.clamped, widths.answers / 2);
}

}  // namespace
}  // namespace pcm::fast::clipped_clamp_bound_test
