// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "compare/io/names.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/verify/bounds/element_law.h"
#include "compare/verify/bounds/rounded_faces.h"
#include "compare/verify/bounds/rounding_bounds.h"
#include "compare/verify/verdict/clipped_verdict.h"
#include "compare/verify/verdict/element_key.h"
#include "compare/verify/verdict/own_sums.h"

namespace pcm::compare {
namespace {

char letter(Side side) {
  return side == Side::E ? 'E' : 'F';
}

std::string describe(Side edge_side, const std::array<Index, 2>& edge, Index face) {
  return fmt::format("{} edge ({}, {}) through face {}", letter(edge_side), edge[0], edge[1], face);
}

/// The polygons' ranges follow each other and make up all crossings.
void check_ranges(const fast::Contact& subj, Checks& checks) {
  std::int64_t next = 0;
  for (const fast::Polygon& p : subj.polygons) {
    if (p.first != next)
      checks.add(Kind::polygon_cycle, "polygon from {} on, those before it end at {}", p.first, next);
    next = std::int64_t{p.first} + p.count;
  }
  if (next != static_cast<std::int64_t>(subj.crossings.size()))
    checks.add(Kind::polygon_cycle, "{} crossings, polygons of {}", subj.crossings.size(), next);
}

/// Whether the polygons' ranges and the elements' faces exist: all else relies on that.
bool is_sound(const Question& question, const fast::Contact& subj, Checks& checks) {
  const auto crossings = static_cast<std::int64_t>(subj.crossings.size());
  for (const fast::Polygon& p : subj.polygons)
    if (p.first < 0 || p.count < 0 || std::int64_t{p.first} + p.count > crossings)
      checks.add(Kind::polygon_cycle, "polygon of {} crossings from {} on, of {}", p.count, p.first, crossings);
  const auto exists = [&](Side side, Index face) {
    const SurfaceFeatures& surface = side == Side::E ? question.E : question.F;
    return face >= 0 && static_cast<std::size_t>(face) < surface.mesh.faces.size();
  };
  for (const fast::Element& e : subj.elements)
    if ((e.master != Side::E && e.master != Side::F) || !exists(e.master, e.master_face) ||
        !exists(opposite(e.master), e.slave_face))
      checks.add(Kind::elements, "an element of faces {} and {}, which do not exist", e.master_face, e.slave_face);
  return checks.disagreements().empty();
}

/// True if all polygons are the same cycles in the same order.
bool check_polygons(const fast::Contact& subj, const reference::Answer& truth, Checks& checks) {
  if (!checks.check_equal(Kind::polygon_count, "polygons", subj.polygons.size(), truth.polygons.size())) return false;
  checks.checked(Kind::polygon_cycle);
  for (std::size_t i = 0; i < truth.polygons.size(); ++i) {
    const fast::Polygon& ours = subj.polygons[i];
    const reference::Polygon& theirs = truth.polygons[i];
    if (ours.closed != theirs.closed || static_cast<std::size_t>(ours.count) != theirs.points.size()) {
      checks.add(Kind::polygon_cycle, "polygon {}: engine {} {} points, oracle {} {}", i,
                 ours.closed ? "closed," : "open,", ours.count, theirs.closed ? "closed," : "open,",
                 theirs.points.size());
      return false;
    }
    for (std::size_t k = 0; k < theirs.points.size(); ++k) {
      const fast::Crossing& s = subj.crossings[static_cast<std::size_t>(ours.first) + k];
      const reference::Crossing& t = theirs.points[k];
      if (std::tie(s.edge_side, s.edge, s.face) != std::tie(t.edge_side, t.edge, t.face)) {
        checks.add(Kind::polygon_cycle, "polygon {} point {}: engine {}, oracle {}", i, k,
                   describe(s.edge_side, s.edge, s.face), describe(t.edge_side, t.edge, t.face));
        return false;
      }
    }
  }
  checks.check_equal(Kind::patches, "patches", subj.patches, truth.patches);
  for (std::size_t i = 0; i < truth.polygons.size(); ++i)
    if (subj.polygons[i].patch != truth.polygons[i].patch)
      checks.add(Kind::patches, "polygon {}: engine patch {}, oracle {}", i, subj.polygons[i].patch,
                 truth.polygons[i].patch);
  return true;
}

void check_faces(Kind kind, Side side, const std::vector<Index>& subj, const std::vector<Index>& truth,
                 Checks& checks) {
  checks.checked(kind);
  if (subj == truth) return;
  const auto [s, t] = std::mismatch(subj.begin(), subj.end(), truth.begin(), truth.end());
  checks.add(kind, "{}: engine {} faces, oracle {}, first different: engine {}, oracle {}", letter(side), subj.size(),
             truth.size(), s == subj.end() ? "none" : fmt::to_string(*s),
             t == truth.end() ? "none" : fmt::to_string(*t));
}

bool check_elements(const fast::Contact& subj, const reference::Answer& truth, Checks& checks) {
  if (!checks.check_equal(Kind::elements, "elements", subj.elements.size(), truth.elements.size())) return false;
  for (std::size_t k = 0; k < truth.elements.size(); ++k) {
    const fast::Element& s = subj.elements[k];
    const reference::Element& t = truth.elements[k];
    if (key(s) == key(t)) continue;
    checks.add(Kind::elements, "element {}: engine {} face {} on {}, oracle {} face {} on {}", k, letter(s.master),
               s.master_face, s.slave_face, letter(t.master), t.master_face, t.slave_face);
    return false;
  }
  return true;
}

void check_areas(const fast::Contact& subj, const reference::Answer& truth, const RoundingBounds& rounding,
                 Checks& checks) {
  const AreaBounds bounds = rounding.area();
  for (std::size_t i = 0; i < truth.polygons.size(); ++i)
    for (std::size_t k = 0; k < truth.polygons[i].points.size(); ++k)
      checks.check_vector(Kind::crossing_position, fmt::format("polygon {} point {}", i, k),
                          subj.crossings[static_cast<std::size_t>(subj.polygons[i].first) + k].position_Me,
                          truth.polygons[i].points[k].position_Me, bounds.positions[i][k], rounding.max_coordinate());
  for (const Side side : {Side::E, Side::F}) {
    const fast::ActiveArea& s = side == Side::E ? subj.E : subj.F;
    const reference::ActiveArea& t = side == Side::E ? truth.E : truth.F;
    const double bound = side == Side::E ? bounds.area_E : bounds.area_F;
    const double vector_bound = side == Side::E ? bounds.vector_area_E : bounds.vector_area_F;
    // Also where faces are coplanar: the tie rule that decides the engine's polygons decides what they enclose.
    checks.check_value(Kind::area, side == Side::E ? "E" : "F", s.area, t.limit_area, bound, t.area_interval.closed);
    checks.check_vector(Kind::vector_area, side == Side::E ? "E" : "F", s.vector_area_Me, t.limit_vector_area_Me,
                        vector_bound, t.area_interval.closed);
  }
  if (checks.check_equal(Kind::has_volume, "whether there is a volume", subj.has_volume, truth.volume.has_value()) &&
      truth.volume)
    checks.check_value(Kind::volume, "volume", subj.volume, *truth.volume, bounds.volume, *truth.volume);
}

void check_barycentric_forces(const Question& question, const fast::Contact& subj, const reference::Answer& truth,
                              const RoundingBounds& rounding, Checks& checks) {
  const ForceBounds bounds = rounding.force();
  for (std::size_t k = 0; k < truth.elements.size(); ++k)
    check_element(question, subj.elements[k], truth.elements[k], bounds.elements[k], rounding.max_coordinate(), checks);
  checks.check_value(Kind::penetration, "greatest penetration", subj.max_penetration, truth.max_penetration,
                     bounds.penetration, truth.max_penetration);
  checks.check_vector(Kind::force, "force", subj.force_Me, truth.force_Me, bounds.force, truth.force_scale);
  checks.check_vector(Kind::torque, "torque", subj.torque_Me, truth.torque_Me, bounds.torque, truth.torque_scale);
}

void check_clipped_forces(const Question& question, const fast::Contact& subj, const reference::Answer& truth,
                          Checks& checks) {
  const ClippedTotals bounds = check_clipped_elements(question, subj, truth, checks);
  // The tighter check is that of the engine's own bound (check_penetration_bound).
  if (!(bounds.greatest_at_least <= subj.max_penetration && subj.max_penetration <= bounds.greatest_at_most))
    checks.add(Kind::penetration, "greatest penetration: engine {}, oracle {}, bounds {} and {}", subj.max_penetration,
               truth.max_penetration, bounds.greatest_at_least, bounds.greatest_at_most);
  checks.check_vector(Kind::force, "force", subj.force_Me, truth.force_Me, bounds.force, truth.force_scale);
  checks.check_vector(Kind::torque, "torque", subj.torque_Me, truth.torque_Me, bounds.torque, truth.torque_scale);
}

/// One component of what the engine promises: |computed - true| <= bound, where the oracle's double is the true number
/// rounded once.
bool keeps_promise(double subj, double truth, double bound) {
  const double half_ulp = 0x1p-53 * std::abs(truth) + std::numeric_limits<double>::denorm_min();
  return std::abs(subj - truth) <= bound + 2 * half_ulp;  // one half for the bound's own sum
}

/// Whether numbers may leave the range of doubles on the way to a bound, which may then be infinite
/// (fast/include/pcm/contact.h). With no two points farther apart than L, lengths of |v| + |w| L a second and n
/// elements of areas up to L^2, forces go up to n (1 + mu) (c_l L^3 + d_l L^2 V) and torques to L times that; geometry
/// takes products of six lengths, as in the square of a height over a face that is not yet divided by its area. What is
/// no more than 2^900 of all these has 2^123 left for the factors of error terms, which are counts of roundings and
/// ratios of errors that are capped.
bool may_overflow(const Question& question) {
  const RoundedFaces faces(question);
  const double L = 4 * faces.placed_max_coordinate();
  const double V = question.velocity.v.stableNorm() + question.velocity.w.stableNorm() * L;
  const auto n = static_cast<double>(question.E.mesh.faces.size() * question.F.mesh.faces.size());
  const double torque = n * greatest_force(question.law, L * L, L, V) * L;
  return !(std::max(torque, L * L * L * L * L * L) <= 0x1p900);
}

/// The exact problem's greatest penetration lies between both. So does the engine's own: in the barycentric scheme but
/// for the upper one, since an element that surely exists, in both problems, has its computed depth above the lower
/// one; in the clipped scheme but for slivers and sharp tips, which are then what its own bound holds
/// (clipped_verdict.h).
void check_penetration_bound(const Question& question, const fast::Contact& subj, const reference::Answer& true_rounded,
                             const reference::Answer& true_exact, Checks& checks) {
  const double own = subj.max_penetration, truth = true_exact.max_penetration;
  const double at_least = subj.bound->penetration_at_least, at_most = subj.bound->penetration_at_most;
  checks.checked(Kind::penetration_bound, at_most - at_least, truth);
  const double half_ulp = 0x1p-53 * truth;
  if (!(at_least <= truth + half_ulp && truth <= at_most + half_ulp))
    checks.add(Kind::penetration_bound, "greatest penetration: engine {} to {}, oracle {}", at_least, at_most, truth);
  if (!(0 <= at_least && at_least <= at_most))
    checks.add(Kind::penetration_bound, "greatest penetration: engine says {} to {}", at_least, at_most);
  const bool is_clipped = question.scheme == Scheme::clipped;
  const bool too_small = !(at_least <= own), too_great = is_clipped && !(own <= at_most);
  const bool is_outside =
      is_clipped && (too_small || too_great) && may_lie_outside(question, subj, true_rounded, true_exact);
  if (is_clipped)
    checks.checked(Kind::penetration, is_outside ? std::numeric_limits<double>::infinity() : at_most - at_least, truth);
  if (is_outside) return;
  if (too_small)
    checks.add(Kind::penetration_bound, "greatest penetration: engine has {}, and says {} to {}", own, at_least,
               at_most);
  if (too_small || too_great)
    checks.add(Kind::penetration, "greatest penetration: engine {}, certainly between {} and {}, oracle {}", own,
               at_least, at_most, truth);
}

double length_of(const reference::Polygon& polygon) {
  double length = 0;
  for (std::size_t k = polygon.closed ? 0 : 1; k < polygon.points.size(); ++k) {
    const reference::Crossing& before = polygon.points[k == 0 ? polygon.points.size() - 1 : k - 1];
    length += (polygon.points[k].position_Me - before.position_Me).stableNorm();
  }
  return length;
}

}  // namespace

double mean_thickness(const reference::Answer& truth) {
  if (truth.volume) {
    const double area = (truth.E.area + truth.F.area) / 2;
    return area > 0 ? *truth.volume / area : 0;
  }
  double outline = 0;
  for (const reference::Polygon& polygon : truth.polygons) outline += length_of(polygon);
  double volume = 0, surface = 0;
  for (const Side master : {Side::E, Side::F}) {
    double area = 0, below = 0;
    for (const reference::Element& element : truth.elements) {
      if (element.master != master) continue;
      area += element.area;
      below += element.area * element.penetration;
    }
    if (!(area > 0)) continue;
    volume += below;
    surface += 2 * area + outline * (below / area);
  }
  return surface > 0 ? 2 * volume / surface : 0;
}

Checks hold_answer(const Question& question, const fast::Contact& subj, const reference::Answer& true_rounded) {
  const reference::Answer& truth = true_rounded;
  Checks checks;
  if (!is_sound(question, subj, checks)) return checks;
  checks.check_equal(Kind::touching, "touching", subj.touching, truth.touching);
  checks.check_equal(Kind::nested, "nested", subj.nested, truth.nested);
  checks.check_equal(Kind::ambiguous, "ambiguous", subj.ambiguous, truth.ambiguous);
  check_ranges(subj, checks);
  const bool same_polygons = check_polygons(subj, truth, checks);
  check_faces(Kind::intersected_faces, Side::E, subj.E.intersected, truth.E.intersected, checks);
  check_faces(Kind::intersected_faces, Side::F, subj.F.intersected, truth.F.intersected, checks);
  check_faces(Kind::inner_faces, Side::E, subj.E.inner, truth.E.inner, checks);
  check_faces(Kind::inner_faces, Side::F, subj.F.inner, truth.F.inner, checks);
  checks.check_equal(Kind::undefined_areas, "undefined areas", subj.undefined_areas, truth.undefined_areas);
  const bool same_faces = subj.E.intersected == truth.E.intersected && subj.F.intersected == truth.F.intersected &&
                          subj.E.inner == truth.E.inner && subj.F.inner == truth.F.inner;
  checks.check_equal(Kind::too_deep, "too deep", subj.too_deep, truth.too_deep);
  const RoundingBounds rounding(question, truth);
  if (same_polygons && same_faces) check_areas(subj, truth, rounding, checks);
  if (question.scheme == Scheme::clipped)
    check_clipped_forces(question, subj, truth, checks);
  else if (check_elements(subj, truth, checks))
    check_barycentric_forces(question, subj, truth, rounding, checks);
  check_own_sums(question, subj, checks);
  return checks;
}

std::vector<Disagreement> disagreements(const Question& question, const fast::Contact& subj,
                                        const reference::Answer& true_rounded) {
  return hold_answer(question, subj, true_rounded).sorted();
}

namespace {

/// Of the clipped scheme, where the engine calls its decisions certain: the master faces of its elements are active in
/// the exact problem, too. Other faces may be active there alone, with elements as small as roundings, which its bounds
/// have to cover.
void check_masters_active(const fast::Contact& subj, const reference::Answer& true_exact, Checks& checks) {
  for (const fast::Element& element : subj.elements) {
    const reference::ActiveArea& area = element.master == Side::E ? true_exact.E : true_exact.F;
    const auto is_among = [&](const std::vector<Index>& faces) {
      return std::binary_search(faces.begin(), faces.end(), element.master_face);
    };
    if (!is_among(area.intersected) && !is_among(area.inner))
      checks.add(Kind::bound,
                 "face {} of {} has elements, and is not active in the exact problem: the engine calls it certain",
                 element.master_face, name(element.master));
  }
}

}  // namespace

Checks broken_bounds(const Question& question, const fast::Contact& subj, const reference::Answer& true_rounded,
                     const reference::Answer& true_exact) {
  Checks checks;
  if (!subj.bound) return checks;
  checks.checked(Kind::bound, subj.bound->force_Me.stableNorm(), true_exact.force_scale);
  checks.checked(Kind::bound, subj.bound->torque_Me.stableNorm(), true_exact.torque_scale);
  for (int i = 0; i < 3; ++i) {
    if (!keeps_promise(subj.force_Me[i], true_exact.force_Me[i], subj.bound->force_Me[i]))
      checks.add(Kind::bound, "force component {}: engine {} within {:.3g}, oracle {}", i, subj.force_Me[i],
                 subj.bound->force_Me[i], true_exact.force_Me[i]);
    if (!keeps_promise(subj.torque_Me[i], true_exact.torque_Me[i], subj.bound->torque_Me[i]))
      checks.add(Kind::bound, "torque component {}: engine {} within {:.3g}, oracle {}", i, subj.torque_Me[i],
                 subj.bound->torque_Me[i], true_exact.torque_Me[i]);
  }
  if (!(subj.bound->force_Me.allFinite() && subj.bound->torque_Me.allFinite()) && !may_overflow(question))
    checks.add(Kind::bound, "an infinite bound on a force of {:.3g} and a torque of {:.3g}", subj.force_Me.stableNorm(),
               subj.torque_Me.stableNorm());
  check_penetration_bound(question, subj, true_rounded, true_exact, checks);
  if (question.scheme == Scheme::barycentric && !subj.bound->flipped &&
      !same_elements(true_rounded.elements, true_exact.elements))
    checks.add(Kind::bound, "the exact problem has other elements, the engine calls them certain");
  if (question.scheme == Scheme::clipped && !subj.bound->flipped) check_masters_active(subj, true_exact, checks);
  return checks;
}

Checks hold_history(const reference::Answer& true_exact, const reference::Answer& true_afresh) {
  Checks checks;
  checks.checked(Kind::history);
  if (true_exact != true_afresh)
    checks.add(Kind::history,
               "the exact problem asked after the rounded one: {} elements, force ({}, {}, {}); asked alone: {} "
               "elements, force ({}, {}, {})",
               true_exact.elements.size(), true_exact.force_Me.x(), true_exact.force_Me.y(), true_exact.force_Me.z(),
               true_afresh.elements.size(), true_afresh.force_Me.x(), true_afresh.force_Me.y(),
               true_afresh.force_Me.z());
  return checks;
}

bool flipped(const reference::Answer& true_rounded, const reference::Answer& true_exact) {
  return !true_rounded.certified || !true_exact.certified || !same_elements(true_rounded.elements, true_exact.elements);
}

RelativeErrors relative_errors(const Question& question, const fast::Contact& subj, const reference::Answer& true_exact,
                               bool pose_is_flipped) {
  RelativeErrors errors;
  const reference::Answer& truth = true_exact;
  const double area = (truth.E.area + truth.F.area) / 2;
  if (!(area > 0)) return errors;
  const double p = mean_thickness(truth);
  if (!(p > 0)) return errors;
  const double S = coordinate_scale(question.E.mesh, question.F.mesh, question.pose);
  const auto in_units = [&](double error, double scale) { return error / scale * (p / S); };

  const auto unique = [](const reference::ActiveArea& a) { return a.area_interval.open == a.area_interval.closed; };
  if (unique(truth.E) && unique(truth.F) && truth.E.area > 0 && truth.F.area > 0) {
    errors.area = std::max(in_units(std::abs(subj.E.area - truth.E.area), truth.E.area),
                           in_units(std::abs(subj.F.area - truth.F.area), truth.F.area));
    errors.vector_area =
        std::max(in_units((subj.E.vector_area_Me - truth.E.vector_area_Me).stableNorm(), truth.E.area),
                 in_units((subj.F.vector_area_Me - truth.F.vector_area_Me).stableNorm(), truth.F.area));
  }
  if (truth.volume && subj.has_volume) errors.volume = in_units(std::abs(subj.volume - *truth.volume), area * p);
  if (pose_is_flipped || truth.elements.empty()) return errors;
  errors.penetration = in_units(std::abs(subj.max_penetration - truth.max_penetration), truth.max_penetration);
  if (truth.force_scale > 0) errors.force = in_units((subj.force_Me - truth.force_Me).stableNorm(), truth.force_scale);
  if (truth.torque_scale > 0)
    errors.torque = in_units((subj.torque_Me - truth.torque_Me).stableNorm(), truth.torque_scale);
  if (subj.bound && subj.bound->force_Me.allFinite() && truth.force_scale > 0)
    errors.force_bound = in_units(subj.bound->force_Me.stableNorm(), truth.force_scale);
  if (subj.bound && subj.bound->torque_Me.allFinite() && truth.torque_scale > 0)
    errors.torque_bound = in_units(subj.bound->torque_Me.stableNorm(), truth.torque_scale);
  return errors;
}

}  // namespace pcm::compare
