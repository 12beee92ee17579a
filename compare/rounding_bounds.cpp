// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/rounding_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "compare/rounded_vertices.h"

namespace pcm::compare {
namespace {

/// Unit roundoff: |fl(x op y) - (x op y)| <= u |x op y|.
constexpr double u = 0x1p-53;

/// Terms of second order in u, and the rounding of the bounds themselves, are covered by doubling.
constexpr double kHigherOrder = 2;

constexpr Side other(Side side) {
  return side == Side::E ? Side::F : Side::E;
}

/// a b for bounds, of which one may be infinite where the other is exactly 0: nothing, however often, is nothing.
double times(double a, double b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

double harmonic(double c_E, double c_F) {
  if (std::isinf(c_E)) return c_F;
  if (std::isinf(c_F)) return c_E;
  return c_E * c_F / (c_E + c_F);
}

double stiffness(const ContactLaw& law) {
  return law.layers ? harmonic(law.layers->c_E, law.layers->c_F) : law.stiffness;
}

}  // namespace

RoundingBounds::RoundingBounds(const Question& question, const reference::Answer& true_rounded)
    : question_(question), true_(true_rounded), vertices_F_Me_(rounded_vertices(question.F.mesh, question.pose)) {}

const Eigen::Vector3d& RoundingBounds::vertex(Side side, Index v) const {
  const auto i = static_cast<std::size_t>(v);
  return side == Side::E ? question_.E.mesh.vertices[i] : vertices_F_Me_[i];
}

const Eigen::Vector3d& RoundingBounds::corner(Side side, Index face, std::size_t k) const {
  return vertex(side, surface(side).mesh.faces[static_cast<std::size_t>(face)][k]);
}

// N = d1 x d2 with d1, d2 two sides. A difference has the relative error u in each component, each product of two
// of them 3 u, each component of N so at most 4 u (|d1_i d2_j| + |d1_j d2_i|) to first order; the length of the vector
// of these sums is at most sqrt(2) |d1| |d2|. Hence |dN| <= 4 sqrt(2) u |d1| |d2| < 6 u L1 L2 with the two longest
// sides, whichever two the evaluation takes. The area |N| / 2 takes half of that and 3 roundings more; the unit normal
// |dN| / |N| twice (direction and length) and 4 roundings more.
RoundingBounds::Face RoundingBounds::face(Side side, Index index) const {
  const Eigen::Vector3d &p = corner(side, index, 0), &q = corner(side, index, 1), &s = corner(side, index, 2);
  Face face;
  std::array<double, 3> sides = {(q - p).stableNorm(), (s - q).stableNorm(), (p - s).stableNorm()};
  std::sort(sides.begin(), sides.end());
  const double N_error = 6 * u * sides[1] * sides[2];
  const Eigen::Vector3d N = (q - p).cross(s - p);
  const double length = N.stableNorm();
  face.area = length / 2;
  face.area_error = N_error / 2 + 3 * u * face.area;
  face.normal_error = length > N_error ? std::min(2.0, 2 * N_error / length + 4 * u) : 2;
  if (length > 0) face.normal_Me = N / length;
  face.longest = sides[2];
  face.farthest = std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), s.cwiseAbs().maxCoeff()});
  return face;
}

ElementBounds RoundingBounds::element(const reference::Element& e) const {
  const ContactLaw& law = question_.law;
  const Face master = face(e.master, e.master_face), slave = face(other(e.master), e.slave_face);
  const Eigen::Vector3d C =
      (corner(e.master, e.master_face, 0) + corner(e.master, e.master_face, 1) + corner(e.master, e.master_face, 2)) /
      3;
  ElementBounds bounds;
  bounds.area = master.area_error + u * e.area;

  // Barycentre (8): two additions of at most 3 M, a division: |dC| <= (2 u 3 M) / 3 + u M = 3 u M a component, where
  // each corner is exact; sqrt(3) for the length.
  const double barycentre_error = std::sqrt(3.0) * 3 * u * master.farthest;

  // Penetration (11), u_k = h / c with h = -(C_f - C) . n_f and c = |n_e . n_f|:
  // |dh| <= |dC| + D (|dn_f| + 4 u), D the distance from C to the point of f taken (a corner, at worst the farthest),
  // |dc| <= |dn_e| + |dn_f| + 4 u, |du| <= (|dh| + u_k |dc|) / (c - |dc|) and one rounding.
  double D = 0;
  for (std::size_t k = 0; k < 3; ++k) D = std::max(D, (corner(other(e.master), e.slave_face, k) - C).stableNorm());
  const double deepest = std::max(e.penetration, std::min(true_.max_penetration, 2 * D));
  const double cosine_error = master.normal_error + slave.normal_error + 4 * u;
  const double height_error = barycentre_error + D * (slave.normal_error + 5 * u);
  const double cosine = std::abs(e.cosine) - cosine_error;
  bounds.penetration = cosine > 0 ? (height_error + deepest * cosine_error) / cosine + 2 * u * deepest
                                  : std::numeric_limits<double>::infinity();

  // Clamping to max_penetration magnifies no error, and leaves none greater than what it clamps to.
  const double clamped_error = std::min(bounds.penetration, law.max_penetration);

  // Position (13), C_k = C + w u_k n_k, 0 <= w <= 1.
  bounds.position = barycentre_error + clamped_error + e.penetration * (master.normal_error + 4 * u) +
                    std::sqrt(3.0) * u * (2 * e.position_Me.cwiseAbs().maxCoeff());

  // Velocity (17), v_k = v + w x (C_k - r), and its parts (16), (19).
  const Eigen::Vector3d arm = e.position_Me - question_.pose.r;
  const Velocity& velocity = question_.velocity;
  const Eigen::Vector3d v_k = velocity.v + velocity.w.cross(arm);
  const double arm_error = bounds.position + 2 * u * arm.stableNorm();
  const double velocity_error = times(velocity.w.stableNorm(), arm_error + 6 * u * arm.stableNorm()) +
                                2 * u * (velocity.v.stableNorm() + velocity.w.stableNorm() * arm.stableNorm());
  const Eigen::Vector3d n = master.normal_Me;
  const double v_n = v_k.dot(n);
  const double v_t = (v_k - v_n * n).stableNorm();
  const double normal_velocity_error = velocity_error + v_k.stableNorm() * (master.normal_error + 4 * u);
  const double tangential_velocity_error = velocity_error + 2 * v_k.stableNorm() * (master.normal_error + 6 * u);

  // Normal force: F_c = c_l A u_k (14); F_d = d_l A v_n fade (15), fade = min(1, u_k / u_d) is Lipschitz with 1 / u_d;
  // what damping may do to F_n (18) never magnifies an error.
  const double c_l = stiffness(law);
  const double elastic = c_l * e.area * e.penetration;
  const double elastic_error =
      c_l * (bounds.area * e.penetration + times(e.area, clamped_error)) + 6 * u * elastic;  // c_l (12) has 3 roundings
  const double damping = law.damping * e.area * std::abs(v_n);
  const double fade_error = law.transition_depth > 0 && e.penetration < law.transition_depth + clamped_error
                                ? std::min(1.0, clamped_error / law.transition_depth + u)
                                : 0;
  const double damping_error = times(law.damping, bounds.area * std::abs(v_n) + times(e.area, normal_velocity_error)) +
                               damping * (fade_error + 4 * u);
  const double normal_force = elastic + damping;  // an upper bound of F_n
  const double normal_force_error = elastic_error + damping_error + u * normal_force;

  // Friction (20), (21): mu F_n g with g = t (2 - t) v_T / v_t, t = min(1, v_t / v_eps). |g| <= 1, and g is Lipschitz
  // with 2 / max(v_eps, v_t): twice 1 / v_t where it is a unit vector, 2 / v_eps at rest.
  const double slip = std::max(law.slip_velocity, v_t);
  const double direction_error = slip > 0 ? std::min(2.0, 2 * tangential_velocity_error / slip + 8 * u) : 2;
  const double friction_error =
      v_k.stableNorm() > 0 ? times(law.friction, normal_force_error + normal_force * direction_error) : 0;

  // F_k = F_n n_k + friction, M_k = (C_k - r) x F_k.
  const double magnitude = normal_force * (1 + law.friction);
  bounds.force = normal_force_error + normal_force * (master.normal_error + 3 * u) + friction_error + 3 * u * magnitude;
  bounds.torque = times(arm.stableNorm(), bounds.force) + times(arm_error + 4 * u * arm.stableNorm(), magnitude);
  bounds.area *= kHigherOrder;
  bounds.penetration *= kHigherOrder;
  bounds.position *= kHigherOrder;
  bounds.force *= kHigherOrder;
  bounds.torque *= kHigherOrder;
  return bounds;
}

// A sum of n terms, each in error by its own bound, adds at most n u times the sum of their sizes.
ForceBounds RoundingBounds::force() const {
  ForceBounds bounds;
  double force_size = 0, torque_size = 0;
  for (const reference::Element& e : true_.elements) {
    bounds.elements.push_back(element(e));
    bounds.force += bounds.elements.back().force;
    bounds.torque += bounds.elements.back().torque;
    bounds.penetration = std::max(bounds.penetration, bounds.elements.back().penetration);
    force_size += e.force_Me.stableNorm();
    torque_size += (e.position_Me - question_.pose.r).stableNorm() * e.force_Me.stableNorm();
  }
  const double terms = kHigherOrder * u * static_cast<double>(true_.elements.size() + 2);
  bounds.force += terms * force_size;
  bounds.torque += terms * torque_size;
  if (question_.mode == Mode::both) {
    bounds.force /= 2;
    bounds.torque /= 2;
  }
  return bounds;
}

// x = a + t (b - a), t = d_a / (d_a - d_b), d = n_f . (x - f_0). |dd| <= D (|dn_f| + 4 u) with D the farthest end's
// distance from the farthest corner; |d_a| + |d_b| = |d_a - d_b| since the ends lie on different sides, so |dt| <=
// 2 |dd| / |d_a - d_b| and |dx| <= 2 |dd| / sine along the edge, sine = |n_f . (b - a)| / |b - a|. Both true and
// computed crossing lie on the edge, which caps it; off the edge only the 2 roundings of a + t (b - a) show.
double RoundingBounds::position_error(const reference::Crossing& crossing) const {
  const Eigen::Vector3d& a = vertex(crossing.edge_side, crossing.edge[0]);
  const Eigen::Vector3d& b = vertex(crossing.edge_side, crossing.edge[1]);
  const Face crossed = face(other(crossing.edge_side), crossing.face);
  double D = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& f = corner(other(crossing.edge_side), crossing.face, k);
    D = std::max({D, (a - f).stableNorm(), (b - f).stableNorm()});
  }
  const double length = (b - a).stableNorm();
  if (length == 0) return 0;
  const double sine = std::abs(crossed.normal_Me.dot(b - a)) / length - (crossed.normal_error + 4 * u);
  const double along = sine > 0 ? 2 * D * (crossed.normal_error + 4 * u) / sine : length;
  return kHigherOrder * std::min(length, along);
}

// The clipped area of a face is a sum of (p - o) x (q - o) / 2 over a closed boundary, linear in each boundary point. A
// crossing x moved by s along its edge's direction d, its neighbours p and q on the polygon unmoved, changes
// - the area of the face it passes through, whose boundary runs p, x, q, by s |d x (q - p)| / 2;
// - those of its edge's two faces, whose boundaries leave x along the edge, by s |d x (p - x)| / 2 and the same with q;
// two neighbours moved together by s s' |d x d'| / 2 more. Where an edge lies in the plane of the face, s is as long as
// the edge but d is parallel to the boundary: the area does not feel it.
AreaBounds RoundingBounds::area() const {
  AreaBounds bounds;
  std::array<double, 2> moved{};                 // area errors by side, from crossings moved
  std::array<std::map<Index, double>, 2> terms;  // boundary points by side and face
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const reference::Polygon& polygon : true_.polygons) {
    const std::size_t n = polygon.points.size();
    std::vector<double>& s = bounds.positions.emplace_back();
    std::vector<Eigen::Vector3d> d;
    std::vector<double> edge_length;
    for (const reference::Crossing& x : polygon.points) {
      s.push_back(position_error(x));
      const Eigen::Vector3d along = vertex(x.edge_side, x.edge[1]) - vertex(x.edge_side, x.edge[0]);
      edge_length.push_back(along.stableNorm());
      d.push_back(along.stableNorm() > 0 ? (along / along.stableNorm()).eval() : along);
      low = low.cwiseMin(x.position_Me);
      high = high.cwiseMax(x.position_Me);
    }
    for (std::size_t k = 0; k < n; ++k) {
      const reference::Crossing& x = polygon.points[k];
      const auto own = static_cast<std::size_t>(x.edge_side == Side::E ? 0 : 1), crossed = 1 - own;
      const bool has_p = polygon.closed || k > 0, has_q = polygon.closed || k + 1 < n;
      const Eigen::Vector3d p = has_p ? polygon.points[(k + n - 1) % n].position_Me : x.position_Me;
      const Eigen::Vector3d q = has_q ? polygon.points[(k + 1) % n].position_Me : x.position_Me;
      moved[crossed] += s[k] * d[k].cross(q - p).stableNorm() / 2;
      moved[own] +=
          s[k] * (d[k].cross(p - x.position_Me).stableNorm() + d[k].cross(q - x.position_Me).stableNorm()) / 2;
      // The point as stored is off its edge by two roundings, the oracle's by one.
      const double stored = 4 * u * x.position_Me.cwiseAbs().maxCoeff();
      const double reach = (q - p).stableNorm() + (p - x.position_Me).stableNorm() + (q - x.position_Me).stableNorm();
      // The neighbours as stored are off as well, and move with it.
      for (double& m : moved) m += stored * (reach + 4 * (stored + s[k]));
      // Beside the edge rather than on it, it bends the boundary from its face's corner: s (b - x) / 2 on both faces.
      moved[own] += stored * edge_length[k];
      if (has_q) {
        const std::size_t next = (k + 1) % n;
        for (double& m : moved) m += s[k] * s[next] * d[k].cross(d[next]).stableNorm() / 2;
      }
      s[k] += kHigherOrder * stored;
      terms[crossed][x.face] += 2;
      const SurfaceFeatures& edges = surface(x.edge_side);
      for (const Index f : edges.faces_at(x.edge)) terms[own][f] += 3;
    }
  }
  for (const Side side : {Side::E, Side::F}) {
    const reference::ActiveArea& active = side == Side::E ? true_.E : true_.F;
    for (const Index f : active.inner)
      for (std::size_t k = 0; k < 3; ++k) {
        low = low.cwiseMin(corner(side, f, k));
        high = high.cwiseMax(corner(side, f, k));
      }
  }
  const double patch = (high - low).cwiseMax(0).stableNorm();

  // Each cross product of the sum has 4 roundings of |p - o| |q - o| <= L^2, the origin o taken in the face; projecting
  // on n_e costs the normal's error once more; face after face is then added up. The volume is the sum of
  // (x_e - o) . n_e area_e / 3 with o near the patch, so |x_e - o| <= patch + L.
  for (const Side side : {Side::E, Side::F}) {
    const auto i = static_cast<std::size_t>(side == Side::E ? 0 : 1);
    const reference::ActiveArea& active = side == Side::E ? true_.E : true_.F;
    double area_error = moved[i], normal_error = 0, volume_error = patch * moved[i], size = 0;
    const auto add = [&](Index f, double sum_terms) {
      const Face e = face(side, f);
      const double value_error = e.area_error + 4 * u * sum_terms * e.longest * e.longest;
      // A sliver's normal may be wrong altogether; its area is then no larger than its error. The total area bounds
      // no face's clipped one: where the other surface folds over, areas count negative.
      const double turned = std::min(e.area * e.normal_error, 2 * e.area_error + 6 * u * e.longest * e.longest);
      size += e.area;
      area_error += value_error;
      normal_error += turned;
      volume_error += (patch + e.longest) * (value_error + turned + 6 * u * e.area);
    };
    for (const Index f : active.inner) add(f, 0);
    for (const Index f : active.intersected) {
      const auto found = terms[i].find(f);
      add(f, 3 + (found == terms[i].end() ? 0 : found->second));
    }
    const double summing = u * static_cast<double>(active.inner.size() + active.intersected.size() + 1) * size;
    (side == Side::E ? bounds.area_E : bounds.area_F) = kHigherOrder * (area_error + summing);
    (side == Side::E ? bounds.vector_area_E : bounds.vector_area_F) =
        kHigherOrder * (area_error + normal_error + 2 * summing);
    bounds.volume += kHigherOrder * (volume_error + 2 * patch * summing) / 3;
  }
  return bounds;
}

}  // namespace pcm::compare
