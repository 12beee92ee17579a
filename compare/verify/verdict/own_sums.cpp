// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/own_sums.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {
namespace {

using roundoff::u;

/// A product that underflows is off by half the least denormal number. A term of a sum has up to four products, its
/// vector three components, and both sums have it: 4 sqrt(3) of these at most.
constexpr double kUnderflowOfTerm = 8 * std::numeric_limits<double>::denorm_min();

/// A sum, and that of the terms' sizes: n terms added up in any order are off by n u times these.
template <class Value>
struct Sum {
  Value value;
  double sizes = 0;
  double terms = 0;

  void add(const Value& term, double size) {
    value += term;
    sizes += size;
    ++terms;
  }
  /// Of a sum of doubles like this one; both are off. `roundings`: of a term.
  double bound(double roundings) const {
    return kHigherOrder * 2 * (terms + roundings) * u * sizes + terms * kUnderflowOfTerm;
  }
};
using NumberSum = Sum<double>;
using VectorSum = Sum<Eigen::Vector3d>;

NumberSum no_numbers() {
  return {0};
}
VectorSum no_vectors() {
  return {Eigen::Vector3d::Zero()};
}

/// a / b, both off by their bounds; infinite where b may be 0.
double bound_of_quotient(double a, double a_bound, double b, double b_bound) {
  if (!(std::abs(b) > b_bound)) return std::numeric_limits<double>::infinity();
  return (a_bound + std::abs(a / b) * b_bound) / (std::abs(b) - b_bound) + 2 * u * std::abs(a / b);
}

void check_statistics(const fast::Contact& subj, Checks& checks) {
  NumberSum area = no_numbers(), volume = area, force = area;
  VectorSum moment = no_vectors();
  double pressure = 0, v_n = 0, v_t = 0;
  for (const fast::Element& e : subj.elements) {
    area.add(e.area, std::abs(e.area));
    volume.add(e.area * e.penetration, std::abs(e.area * e.penetration));
    force.add(e.normal_force, std::abs(e.normal_force));
    moment.add(e.normal_force * e.position_Me, std::abs(e.normal_force) * e.position_Me.stableNorm());
    if (e.area > 0) pressure = std::max(pressure, e.normal_force / e.area);
    v_n = std::max(v_n, std::abs(e.normal_velocity));
    v_t = std::max(v_t, e.tangential_velocity);
  }
  const fast::Statistics& s = subj.statistics;
  const auto check = [&](const char* what, double value, double truth, double bound) {
    checks.check_value(Kind::statistics, what, value, truth, bound, truth);
  };
  check("patch area", s.patch_area, area.value, area.bound(0));
  check("greatest pressure", s.max_pressure, pressure, 0);
  check("greatest normal velocity", s.max_normal_velocity, v_n, 0);
  check("greatest tangential velocity", s.max_tangential_velocity, v_t, 0);
  const bool has_area = area.value > 0;
  check("mean penetration", s.mean_penetration, has_area ? volume.value / area.value : 0,
        has_area ? bound_of_quotient(volume.value, volume.bound(1), area.value, area.bound(0)) : 0);
  check("mean pressure", s.mean_pressure, has_area ? force.value / area.value : 0,
        has_area ? bound_of_quotient(force.value, force.bound(0), area.value, area.bound(0)) : 0);
  // Where tension cancels pressure there may be no centre.
  const double bound =
      force.sizes > 0 ? bound_of_quotient(moment.value.stableNorm(), moment.bound(2), force.value, force.bound(0)) : 0;
  const Eigen::Vector3d centre =
      force.value > 0 ? Eigen::Vector3d(moment.value / force.value) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  checks.check_vector(Kind::statistics, "centre of pressure", s.centre_of_pressure_Me, centre, bound,
                      force.value > 0 ? moment.sizes / force.value : 1);
}

/// Each closed polygon's crossings begin one segment each, an open one's all but the last, and a crossing pair of faces
/// has one segment.
std::int64_t segments_of(const fast::Contact& subj) {
  std::int64_t segments = 0;
  for (const fast::Polygon& polygon : subj.polygons) segments += polygon.closed ? polygon.count : polygon.count - 1;
  return segments;
}

void check_work(const Question& question, const fast::Contact& subj, Checks& checks) {
  const fast::WorkCounters& work = subj.work;
  const auto check = [&](const char* what, bool holds) {
    checks.checked(Kind::work);
    if (!holds) checks.add(Kind::work, "{}", what);
  };
  check("crossing pairs counted are not the polygons' segments", work.crossing_pairs == segments_of(subj));
  check("elements counted are not those of the answer", work.elements == subj.element_count);
  check("velocities counted are not those of the elements", work.velocities == subj.element_count);
  check("fewer candidate pairs than crossing ones", work.candidate_pairs >= work.crossing_pairs);
  check("live lanes, candidate pairs and unsure ones are not in this order",
        work.live_lanes >= work.candidate_pairs && work.candidate_pairs >= work.unsure_pairs && work.unsure_pairs >= 0);
  check("more lanes are live than rows have", 8 * work.face_rows >= work.live_lanes);
  check("pairs of nodes are not as many as boxes tested, or fewer",
        work.node_pairs >= 0 && work.node_pairs <= work.box_tests);
  check("more lines searched for than there are", work.lines >= work.searches());
  check("less than no line searched for",
        std::min({work.searches_unseen, work.searches_oblique, work.searches_slave, work.searches_master}) >= 0);
  check("a line is settled without a past", work.lines_settled == 0);
  check("more vertices transformed than F has",
        work.vertices_transformed >= 0 &&
            work.vertices_transformed <= static_cast<std::int64_t>(question.F.mesh.vertices.size()));
  check("predicates, exact ones and ties are not in this order",
        work.predicates >= work.exact_predicates && work.exact_predicates >= work.tie_breaks && work.tie_breaks >= 0);
  check("no box tested", work.box_tests > 0);
  check("a whole evaluation is counted as the law alone", work.law_only == 0);
}

/// The greatest penetration is no less than any element's, and barycentric, where an element has one depth, the
/// greatest of theirs but for the clamp; the flag compares it with the law's. Comparisons do not round.
void check_greatest_penetration(const Question& question, const fast::Contact& subj, Checks& checks) {
  const double clamp = question.law.max_penetration;
  double greatest = 0;
  for (const fast::Element& e : subj.elements) greatest = std::max(greatest, e.penetration);
  checks.checked(Kind::sums);
  // Clipped parts that underflow keeps from being elements are deep all the same.
  const bool one_depth = question.scheme == Scheme::barycentric;
  if (!(subj.max_penetration >= greatest) || (one_depth && std::min(subj.max_penetration, clamp) != greatest))
    checks.add(Kind::sums, "greatest penetration {}, of elements {}, of the law {}", subj.max_penetration, greatest,
               clamp);
  checks.checked(Kind::exceeded);
  if (subj.penetration_exceeded != (subj.max_penetration > clamp))
    checks.add(Kind::exceeded, "penetration exceeded: {}, greatest penetration {}, of the law {}",
               subj.penetration_exceeded, subj.max_penetration, clamp);
}

}  // namespace

void check_own_sums(const Question& question, const fast::Contact& subj, Checks& checks) {
  checks.checked(Kind::sums);
  if (static_cast<std::size_t>(subj.element_count) != subj.elements.size())
    checks.add(Kind::sums, "element count {}, elements {}", subj.element_count, subj.elements.size());
  const double share = question.mode == Mode::both ? 0.5 : 1;
  VectorSum force = no_vectors(), torque = force;
  for (const fast::Element& e : subj.elements) {
    const Eigen::Vector3d arm = e.position_Me - question.pose.r;
    force.add(share * e.force_Me, share * e.force_Me.stableNorm());
    torque.add(share * arm.cross(e.force_Me), share * arm.stableNorm() * e.force_Me.stableNorm());
  }
  checks.check_vector(Kind::sums, "force", subj.force_Me, force.value, force.bound(0), force.sizes);
  checks.check_vector(Kind::sums, "torque", subj.torque_Me, torque.value, torque.bound(8), torque.sizes);
  check_greatest_penetration(question, subj, checks);
  check_statistics(subj, checks);
  check_work(question, subj, checks);
}

}  // namespace pcm::compare
