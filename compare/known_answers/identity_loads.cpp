// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/identity_loads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/poses/surface_features.h"
#include "compare/verify/bounds/bound_arithmetic.h"
#include "pcm/bad_input.h"
#include "reference/proofs/self_intersections.h"

namespace pcm::compare {
namespace {

using roundoff::u;

/// Bounds are sums of a few rounded terms of one sign: twice covers their own roundings, and those of higher order.
Eigen::Vector3d with_higher_order(const Eigen::Vector3d& bound) {
  return kHigherOrder * bound;
}

/// Greatest components of x x f, and so of its roundings: each component is a difference of two products.
Eigen::Vector3d cross_size(const Eigen::Vector3d& x, const Eigen::Vector3d& f) {
  const Eigen::Vector3d a = x.cwiseAbs(), b = f.cwiseAbs();
  return {a.y() * b.z() + a.z() * b.y(), a.z() * b.x() + a.x() * b.z(), a.x() * b.y() + a.y() * b.x()};
}

/// The loads of the chosen elements added up. Their bounds are those of the sums alone: n terms are off by n u times
/// the sum of their sizes; a torque (C - r) x F by a rounding of C - r and two of the products' difference, and where
/// C and F are themselves rounded (`values`) by one of each.
template <class Element>
BoundedLoad sum_of_faces(const std::vector<Element>& elements, const Pose& pose, const FaceChoice& chosen,
                         bool values_are_rounded) {
  BoundedLoad sum;
  double terms = values_are_rounded ? 5 : 3;
  Eigen::Vector3d forces = Eigen::Vector3d::Zero(), torques = forces;
  for (const Element& e : elements) {
    if (!chosen(e.master_face)) continue;
    const Eigen::Vector3d arm = e.position_Me - pose.r;
    sum.force_Me += e.force_Me;
    sum.torque_Me += ordered_cross(arm, e.force_Me);
    forces += e.force_Me.cwiseAbs();
    torques += cross_size(arm.cwiseAbs() + e.position_Me.cwiseAbs(), e.force_Me);
    ++terms;
  }
  sum.force_bound_Me = with_higher_order(terms * u * forces);
  sum.torque_bound_Me = with_higher_order(terms * u * torques);
  return sum;
}

/// The exponent k of the least power of two 2^k above all of them.
int exponent_above(double greatest) {
  int exponent = 0;
  std::frexp(greatest, &exponent);
  return exponent;
}

/// Rounded to multiples of 2^exponent.
Eigen::Vector3d on_grid(const Eigen::Vector3d& x, int exponent) {
  return x.unaryExpr([exponent](double c) { return std::ldexp(std::nearbyint(std::ldexp(c, -exponent)), exponent); });
}

/// Rotations that turn axes into axes, one of them none.
Eigen::Matrix3d axes_turned(std::uint64_t number) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  if (number % 3 == 1) A << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  if (number % 3 == 2) A << 0, -1, 0, 0, 0, 1, -1, 0, 0;
  return A;
}

}  // namespace

BoundedLoad load_of(const fast::Contact& contact) {
  return {contact.force_Me, contact.torque_Me, contact.bound->force_Me, contact.bound->torque_Me};
}

BoundedLoad load_of(const reference::Answer& answer) {
  return {answer.force_Me, answer.torque_Me, with_higher_order(u * answer.force_Me.cwiseAbs()),
          with_higher_order(u * answer.torque_Me.cwiseAbs())};
}

// The engine's bound is a sum of shares of its elements and of faces without any, none of them negative: it bounds the
// error of what any of the faces carry together.
BoundedLoad load_of_faces(const fast::Contact& contact, const Pose& pose, const FaceChoice& chosen) {
  BoundedLoad load = sum_of_faces(contact.elements, pose, chosen, false);
  load.force_bound_Me += contact.bound->force_Me;
  load.torque_bound_Me += contact.bound->torque_Me;
  return load;
}

BoundedLoad load_of_faces(const reference::Answer& answer, const Pose& pose, const FaceChoice& chosen) {
  return sum_of_faces(answer.elements, pose, chosen, true);
}

// F_E = -A F_F, and T about Mf from T_Me = -A T_F about Me: T_Me - r x F_E. A exchanges axes and signs only.
BoundedLoad seen_from_E(const BoundedLoad& exchanged, const Pose& pose) {
  const Eigen::Matrix3d sizes = pose.A.cwiseAbs();
  BoundedLoad load;
  load.force_Me = -ordered_product(pose.A, exchanged.force_Me);
  load.force_bound_Me = ordered_product(sizes, exchanged.force_bound_Me);
  const Eigen::Vector3d torque_about_Me = -ordered_product(pose.A, exchanged.torque_Me);
  load.torque_Me = torque_about_Me - ordered_cross(pose.r, load.force_Me);
  // Two roundings of r x F and one of the difference.
  const Eigen::Vector3d rounded = u * (torque_about_Me.cwiseAbs() + 3 * cross_size(pose.r, load.force_Me));
  load.torque_bound_Me = ordered_product(sizes, exchanged.torque_bound_Me) +
                         with_higher_order(cross_size(pose.r, load.force_bound_Me) + rounded);
  return load;
}

void expect_one_load(Findings& findings, const std::string& what, const BoundedLoad& a, const BoundedLoad& b) {
  findings.close(what + ", force", (a.force_Me - b.force_Me).norm(), (a.force_bound_Me + b.force_bound_Me).norm());
  findings.close(what + ", torque", (a.torque_Me - b.torque_Me).norm(), (a.torque_bound_Me + b.torque_bound_Me).norm());
}

// With every coordinate below 2^k: those in Me are multiples of 2^(k - 51), r is one of 2^(k - 10) and below 2^k, so
// differences are below 2^(k + 1), of 52 bits. With |v| and |w| 2^k below 2^m, v of multiples of 2^(m - 16) and w of
// 2^(m - 16 - k), w x r and v - w x r are multiples of 2^(m - 26) below 2^(m + 2).
Posed without_rounding(const Posed& posed) {
  Posed result = placed_beforehand(posed);
  double greatest = posed.pose.r.cwiseAbs().maxCoeff();
  for (const TriangleMesh* mesh : {&result.E, &result.F})
    for (const Eigen::Vector3d& x : mesh->vertices) greatest = std::max(greatest, x.cwiseAbs().maxCoeff());
  const int k = exponent_above(greatest);
  result.pose = {axes_turned(posed.stream), on_grid(posed.pose.r, k - 10)};
  for (Eigen::Vector3d& x : result.E.vertices) x = on_grid(x, k - 51);
  for (Eigen::Vector3d& x : result.F.vertices)
    x = ordered_product(result.pose.A.transpose(), on_grid(x, k - 51) - result.pose.r);
  const double speed =
      std::max(posed.velocity.v.cwiseAbs().maxCoeff(), std::ldexp(posed.velocity.w.cwiseAbs().maxCoeff(), k));
  const int m = exponent_above(speed);
  result.velocity.v = on_grid(posed.velocity.v, m - 16);
  result.velocity.w = on_grid(posed.velocity.w, m - 16 - k);
  return result;
}

Posed exchanged_pair(const Posed& posed) {
  Posed other = posed;
  std::swap(other.E, other.F);
  if (other.law.layers) std::swap(other.law.layers->c_E, other.law.layers->c_F);
  const Eigen::Matrix3d back = posed.pose.A.transpose();
  other.pose.A = back;
  other.pose.r = -ordered_product(back, posed.pose.r);
  other.velocity.w = -ordered_product(back, posed.velocity.w);
  other.velocity.v = -ordered_product(back, posed.velocity.v - ordered_cross(posed.velocity.w, posed.pose.r));
  return other;
}

Posed placed_beforehand(const Posed& posed) {
  Posed result = posed;
  for (Eigen::Vector3d& x : result.F.vertices) x = ordered_product(posed.pose.A, x) + posed.pose.r;
  result.pose = Pose();
  return result;
}

bool fit_for_contact(const Posed& posed) {
  try {
    for (const TriangleMesh* mesh : {&posed.E, &posed.F}) static_cast<void>(fast::Surface(*mesh));
  } catch (const BadInput&) {
    return false;
  }
  return true;
}

bool is_closed_and_embedded(const TriangleMesh& mesh) {
  return SurfaceFeatures(mesh).closed && reference::self_intersections(mesh).empty();
}

// a + b is a double if what it rounds off is 0 (Knuth's sum); halving it is exact.
bool has_exact_middles(const TriangleMesh& mesh) {
  const auto is_exact = [](double a, double b) {
    const double sum = a + b, b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part) == 0;
  };
  for (const Triangle& face : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        if (!is_exact(mesh.vertices[face[k]][j], mesh.vertices[face[(k + 1) % 3]][j])) return false;
  return true;
}

SplitMesh quartered(const TriangleMesh& mesh) {
  SplitMesh result{split(mesh), {}};
  for (std::size_t part = 0; part < result.mesh.faces.size(); ++part)
    result.whole.push_back(static_cast<Index>(part / 4));
  return result;
}

SplitMesh halved(const TriangleMesh& mesh, PoseRandom& random) {
  const SurfaceFeatures features(mesh);
  std::vector<std::array<Index, 2>> edges;
  for (const Triangle& face : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({face[k], face[(k + 1) % 3]});
  for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random.below(i)]);

  struct Cut {
    std::array<Index, 2> edge{};
    Index middle = -1;
  };
  SplitMesh result;
  result.mesh.name = mesh.name + ", halved";
  result.mesh.vertices = mesh.vertices;
  std::vector<Cut> cuts(mesh.faces.size());
  for (const auto& [a, b] : edges) {
    const std::vector<Index>& faces = features.faces_at({std::min(a, b), std::max(a, b)});
    const auto is_cut = [&](Index f) { return cuts[static_cast<std::size_t>(f)].middle >= 0; };
    if (std::any_of(faces.begin(), faces.end(), is_cut)) continue;
    for (const Index f : faces)
      cuts[static_cast<std::size_t>(f)] = {{a, b}, static_cast<Index>(result.mesh.vertices.size())};
    result.mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Cut& cut = cuts[f];
    for (const Index replaced : cut.edge) {
      Triangle part = mesh.faces[f];
      if (cut.middle >= 0) std::replace(part.begin(), part.end(), replaced, cut.middle);
      result.mesh.faces.push_back(part);
      result.whole.push_back(static_cast<Index>(f));
      if (cut.middle < 0) break;
    }
  }
  return result;
}

SplitMasterFaces::SplitMasterFaces(const TriangleMesh& slave, const std::vector<Index>& whole_of, const Lists& whole,
                                   const Lists& parts)
    : same_(static_cast<std::size_t>(whole_of.back()) + 1, true) {
  if (is_closed_and_embedded(slave)) return;
  const auto is_in = [](const Lists& lists, Index face) {
    return std::any_of(lists.begin(), lists.end(), [face](const std::vector<Index>* list) {
      return std::binary_search(list->begin(), list->end(), face);
    });
  };
  for (std::size_t part = 0; part < whole_of.size(); ++part)
    if (is_in(parts, static_cast<Index>(part)) != is_in(whole, whole_of[part]))
      same_[static_cast<std::size_t>(whole_of[part])] = false;
}

}  // namespace pcm::compare
