// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/clipped_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fast/bounds/uncertain_strips.h"
#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {
namespace {

constexpr double u = kUnitRoundoff;

/// Shifts beyond this are no longer small (fast/bounds/prism_error.cpp).
constexpr double kGreatestPositionError = 0x1p-6;

bool is_small(const PrismPositionError& error) {
  return error.s < kGreatestPositionError && error.t < kGreatestPositionError;
}

/// Integrals over a fan of five triangles are off by as much as a shift of its border by 6 u times its width would
/// make.
constexpr double kFanRoundings = 6;

/// An element's area is a sum over triangles, ten a part at most, times 2 and the master's area: 12 roundings, 4 to
/// spare. What triangles' own areas round counts as a position error of their border (kFanRoundings,
/// ClippingError::add_piece); so does what sums over several parts round besides, of which ClippingError::cut_area has
/// 40 u of each part's widths.
constexpr double kAreaRoundings = 16;

/// A foot's s is a quotient of two sums S / D over triangles, none of whose terms exceeds T, the triangle's area times
/// the greatest depth: 10 roundings of a term of S, 8 of D's, 10 of either sum for each part, and 1 of the quotient. As
/// s <= 1 that makes 39 u T / D, and 20 more for each part beyond the first. Only where 64 of these are less than 1 do
/// they tell anything: then D is off by less than 18 / 64, and 39 / (1 - 18 / 64) < 64.
constexpr double kFootRoundings = 64;

/// How far off f's depth may be from g's plane, or g's from f's, by roundings where the line they meet in is cut.
double rounding_of_crossing(const FaceEnclosure& f, const FaceEnclosure& g, const PrismError& error) {
  double farthest = 0, highest = 0;
  for (const PrismPoint& c : f.corners) {
    const PrismPoint from_g = c - g.corners[0];
    farthest = std::max(farthest, error.distance(std::abs(from_g[kS]), std::abs(from_g[kT]), std::abs(from_g[kDepth])));
    const double plane =
        g.depth.value + (g.depth.per_s * (c[kS] - g.depth.s_0) + g.depth.per_t * (c[kT] - g.depth.t_0));
    highest = std::max(highest, std::abs(plane - c[kDepth]));
  }
  return g.crossing_rounding * farthest + f.relative_rounding * highest;
}

/// The face is nowhere seen less deep over the box, in both problems.
double least_depth(const FaceEnclosure& f, const BoxST& box) {
  const double at_corners = std::min({f.corners[0][kDepth], f.corners[1][kDepth], f.corners[2][kDepth]});
  return std::max(at_corners - f.position_error.depth, f.depth.middle(box) - f.depth.half_range(box) - f.depth_error);
}

struct AreaAndVolume {
  double area, volume;
};

/// What an element's integrals are off by where its polygons, within this box, are cut at u_max.
struct ClampRoundings {
  double area = 0;   ///< over which what is integrated may be missing or counted twice, in (s, t)
  int cuts = 0;      ///< of a polygon, that would put the depth off its plane by as much
  double sums = 1;   ///< how many times more roundings the sums have
  double least = 0;  ///< and what underflow may add, m

  ClampRoundings() = default;
  ClampRoundings(const BoxST& box, int polygons);
};

/// What roundings make of the cuts along the master's sides, where the depth ends with a jump, and of the integrals
/// over the part `seen`. Such a side of it, and no other but for slivers, lies within f's position error and a cut's
/// roundings of the master's; what is between both is known. Where nothing was cut: what such cuts may have made
/// nothing of.
AreaAndVolume errors_of_cuts(const FaceEnclosure& f, const ConvexPolygon* seen) {
  const double width_s = f.box.width_s(), width_t = f.box.width_t();
  if (seen == nullptr) {
    const double third = f.third_side_error * (std::min(width_s, width_t) + 2 * f.third_side_error);
    const double area = strip_along_border(f.box, f.cut_error.s, f.cut_error.t) + third;
    return {area, area * f.greatest};
  }
  const double near =
      4 * (f.position_error.s + f.position_error.t + f.cut_error.s + f.cut_error.t + f.third_side_error);
  AreaAndVolume sum{strip_along_border(f.box, kFanRoundings * u * width_s, kFanRoundings * u * width_t) +
                        area_about_corners(f.cut_error.s + f.third_side_error, f.cut_error.t + f.third_side_error),
                    0};
  sum.volume = sum.area * f.greatest;
  for (int i = 0; i < seen->count; ++i) {
    const PrismPoint& a = (*seen)[i];
    const PrismPoint& b = (*seen)[seen->next(i)];
    const double along_s = std::abs(b[kS] - a[kS]), along_t = std::abs(b[kT] - a[kT]);
    const double third_a = std::abs(1 - a[kS] - a[kT]) + 2 * u, third_b = std::abs(1 - b[kS] - b[kT]) + 2 * u;
    double between = 0;
    if (std::max(std::abs(a[kS]), std::abs(b[kS])) < near)
      between += std::max(std::abs(a[kS]), std::abs(b[kS])) * along_t;
    if (std::max(std::abs(a[kT]), std::abs(b[kT])) < near)
      between += std::max(std::abs(a[kT]), std::abs(b[kT])) * along_s;
    if (std::max(third_a, third_b) < near) between += std::max(third_a, third_b) * std::min(along_s, along_t);
    sum.area += between;
    sum.volume += between * std::max(a[kDepth], b[kDepth]);
  }
  return sum;
}

// A polygon has a fan of five triangles; u is the linear depth that it carries. Where the edge from a to b of a
// triangle passes u_max, the share of the way from the nearer end has 4 roundings, and the point 2 of the way and one
// of itself: it is off the edge by delta = 1.01 roundings of (width + 1), in either piece its own way, and the depth
// there is off by less than 4 roundings of the greatest depth and of what u changes by over the master.
//
//   - Field: so each piece carries min(u, u_max) but for that, which is less than two other cuts make of it.
//   - Area: the two points move the border of either piece over no more than delta_s width_t + delta_t width_s, and the
//     areas of three triangles in all have 4 roundings of width_s width_t each. Five times
//     2 (delta_s width_t + delta_t width_s) + 12 u width_s width_t is less than what a border passes over that is
//     shifted by 6 u and 21 u times the width.
//
// Three triangles in place of one have no more than twice the roundings. What is small enough may underflow.
ClampRoundings::ClampRoundings(const BoxST& box, int polygons) : cuts(2), sums(2), least(0x1p-1060) {
  const double width_s = box.width_s(), width_t = box.width_t();
  const double off_s = (6 + 21 * width_s) * u, off_t = (6 + 21 * width_t) * u;
  area = polygons * area_passed_by_border(width_s, width_t, off_s, off_t);
}

}  // namespace

void ViewError::see(PosedSurface& surface, Index face, bool of_master, const SeenCorners& corners,
                    const ProjectedFace* projected, WorkCounters& work) {
  // Before anything is left out: by a frame's error that is not small it is not known what lies beside the master.
  known_ = known_ && is_small(error_.of_frame(0));
  if (surely_unseen(error_, of_master, corners.points)) return;
  // Not a local variable: most of it stays unused where nothing is seen.
  scratch_->sights.emplace_back();
  FaceInView& sight = scratch_->sights.back();
  FaceEnclosure& f = sight.enclosure;
  const FaceInPrism seen{
      face,           of_master,           surface.surface().face(face),        surface.face_Me(face, work),
      corners.points, corners.is_shared(), surface.sharp_face_rounding_Me(face)};
  if (!find_face_enclosure(error_, seen, f)) {
    scratch_->sights.pop_back();
    return;
  }
  known_ = known_ && is_small(f.position_error);
  sight.projected = projected;
  sight.may_carry = !of_master && f.facing <= 0;
  if (sight.may_carry) greatest_depth_ = std::max(greatest_depth_, f.greatest);
}

FaceInView* ViewError::find(bool of_master, Index face) const {
  std::vector<FaceInView>& sights = scratch_->sights;
  const auto found = std::lower_bound(sights.begin(), sights.end(), std::pair(of_master, face),
                                      [](const FaceInView& sight, const std::pair<bool, Index>& key) {
                                        return std::pair(sight.enclosure.of_master, sight.enclosure.face) < key;
                                      });
  const bool is_there =
      found != sights.end() && found->enclosure.of_master == of_master && found->enclosure.face == face;
  return is_there ? &*found : nullptr;
}

// Where the neighbour beyond a side is not seen at all, neither is the side.
void ViewError::find_outline(FaceInView& sight, const PreparedSurface& surface) {
  const FaceEnclosure& f = sight.enclosure;
  sight.knows_outline = true;
  sight.sheet_error = f.depth_error;
  for (std::size_t side = 0; side < 3; ++side) {
    const Index neighbour = surface.neighbours_of(f.face)[side];
    bool goes_on = neighbour != f.face;
    if (goes_on) {
      if (const FaceInView* const beyond = find(f.of_master, neighbour); beyond != nullptr) {
        goes_on = f.facing != 0 && beyond->enclosure.facing == f.facing;
        if (goes_on) sight.sheet_error = std::max(sight.sheet_error, beyond->enclosure.depth_error);
      }
    }
    if (goes_on) continue;
    const std::array<Index, 2>& ends = surface.edge(surface.edges_of(f.face)[side]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = f.vertices[k], b = f.vertices[(k + 1) % 3];
      if ((a == ends[0] && b == ends[1]) || (a == ends[1] && b == ends[0])) sight.outline[k] = true;
    }
  }
}

/// Weights of p0, p1 and p2 less than these are within a distance, m, of the master's sides.
std::array<double, 3> ViewError::weights_within(double distance) const {
  return {distance * prism_.inward_Me(1).norm(), distance * prism_.inward_Me(2).norm(),
          distance * prism_.inward_Me(0).norm()};
}

double ViewError::area_leant_over(const FaceEnclosure& f) const {
  const auto [third, s, t] = weights_within(kSafetyFactor * lean_ * std::max(f.greatest, 0.0));
  double area = 0;
  if (f.box.low_s <= s) area += s * f.box.width_t();
  if (f.box.low_t <= t) area += t * f.box.width_s();
  if (1 - f.box.high_s - f.box.high_t <= third) area += third * std::min(f.box.width_s(), f.box.width_t());
  return std::min(area, f.box.area());
}

DepthRange ViewError::visible_depth(double computed, double floor, VisibleDepthScratch& scratch) const {
  const double leant = kSafetyFactor * lean_ * std::max(greatest_depth_, 0.0);
  return find_visible_depth(scratch_->sights, weights_within(leant), computed, floor, scratch);
}

// What it would be off by if no other face were there.
void ViewError::measure_alone(FaceInView& sight, const PreparedSurface& slave) {
  const FaceEnclosure& f = sight.enclosure;
  if (f.facing == 0) {
    find_side_errors(error_, sight.enclosure);
    sight.area_error = sliver(f, f, f.greatest, f.box).area;
    sight.volume_error = sight.area_error * f.greatest;
    return;
  }
  find_outline(sight, slave);
  SideStrips outline, smooth;
  if (sight.outline[0] || sight.outline[1] || sight.outline[2]) {
    find_side_errors(error_, sight.enclosure);
    outline = strips_along_sides(f, f.position_error.s, f.position_error.t, f, f.box, sight.outline);
  }
  // Where nothing jumps, errors are of second order, and what passes is of no account where forces are linear.
  if (continuous_) {
    smooth.area = strip_along_border(f.box, f.position_error.s, f.position_error.t);
    smooth.volume = smooth.area * f.greatest;
  } else {
    smooth = strips_along_sides(f, f.position_error.s, f.position_error.t, f, f.box,
                                {!sight.outline[0], !sight.outline[1], !sight.outline[2]});
  }
  const ZeroStrip zero = zero_strip(f.depth, {f.line_error, f.depth_error}, f.box);
  AreaAndVolume cuts = errors_of_cuts(f, sight.projected != nullptr ? &sight.projected->seen : nullptr);
  const double leant_over = lean_ > 0 ? area_leant_over(f) : 0;
  cuts.area += leant_over;
  cuts.volume += leant_over * f.greatest;
  sight.area_error = outline.area + cuts.area + zero.area;
  sight.volume_error =
      outline.volume + cuts.volume + zero.area * 2 * f.depth_error + smooth.area * 4 * sight.sheet_error;
  sight.passed_area = smooth.area;
  sight.passed_volume = smooth.volume;
}

// What both may hide of each other.
void ViewError::compare_pair(FaceInView& f, FaceInView& g, const PreparedSurface& slave,
                             const PreparedSurface& master) {
  const BoxST box = f.enclosure.box.common(g.enclosure.box);
  if (box.empty()) return;
  double overlap = box.area();
  if (f.enclosure.facing != 0 && g.enclosure.facing != 0) {
    overlap = greatest_overlap(f.enclosure, g.enclosure, box);
    if (overlap == 0) return;
  }
  for (FaceInView* const sight : {&f, &g}) {
    if (!sight->knows_outline) find_outline(*sight, sight->enclosure.of_master ? master : slave);
    find_side_errors(error_, sight->enclosure);
  }
  if (f.may_carry) charge(f, g, box, overlap);
  if (g.may_carry) charge(g, f, box, overlap);
}

void ViewError::compare(const PreparedSurface& slave, const PreparedSurface& master) {
  std::vector<FaceInView>& sights = scratch_->sights;
  std::vector<std::size_t>& order = scratch_->order;
  order.clear();
  for (std::size_t i = 0; i < sights.size(); ++i) {
    order.push_back(i);
    if (sights[i].may_carry) measure_alone(sights[i], slave);
  }
  std::sort(order.begin(), order.end(), [&sights](std::size_t a, std::size_t b) {
    return sights[a].enclosure.box.low_s < sights[b].enclosure.box.low_s;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    FaceInView& f = sights[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      FaceInView& g = sights[order[j]];
      if (g.enclosure.box.low_s > f.enclosure.box.high_s) break;
      if (f.may_carry || g.may_carry) compare_pair(f, g, slave, master);
    }
  }
}

// Between faces of one sheet what they hide together goes on, so that only the sheet's outline counts; near a side they
// have in common the depths of both differ by twice their errors at most.
void ViewError::charge(FaceInView& sight, const FaceInView& hider, const BoxST& box, double overlap) {
  const FaceEnclosure& f = sight.enclosure;
  const FaceEnclosure& g = hider.enclosure;
  if (f.facing == 0) return;  // Counted in full.
  const double greatest =
      std::clamp(f.depth.middle(box) + f.depth.half_range(box) + f.depth_error, 0.0, std::max(f.greatest, 0.0));
  double area = 0, volume = 0;
  if (g.facing == 0) {
    const SideStrips all = sliver(g, f, greatest, box);
    area = all.area;
    volume = all.volume;
  } else {
    const SideStrips outline = strips_along_sides(g, g.position_error.s, g.position_error.t, f, box, hider.outline);
    if (outline.apart) return;
    const CertainOrder order = certain_order(g, f);
    if (order == CertainOrder::after) return;
    const bool was_left_out = g.of_master && hider.projected == nullptr;
    if (was_left_out && least_depth(g, box) > greatest) return;
    const double beside_error = 4 * hider.sheet_error;  // Near sides beyond which the sheet goes on.
    std::array<bool, 3> inner;
    for (std::size_t k = 0; k < 3; ++k) inner[k] = !hider.outline[k];
    LineStrip one_depth, zero;
    if (order == CertainOrder::unsure) {
      LinearDepth beyond;  // How much farther f is than g.
      beyond.value = f.depth.middle(box) - g.depth.middle(box);
      beyond.s_0 = 0.5 * (box.low_s + box.high_s);
      beyond.t_0 = 0.5 * (box.low_t + box.high_t);
      beyond.per_s = f.depth.per_s - g.depth.per_s;
      beyond.per_t = f.depth.per_t - g.depth.per_t;
      const double rounding = rounding_of_crossing(f, g, error_), error = f.depth_error + rounding;
      if (beyond.value + beyond.half_range(box) < -(error + beside_error)) return;  // g certainly lies after f.
      one_depth = strip_along_line(beyond, {f.line_error + g.line_error + rounding, error + g.depth_error}, f, g, box);
      if (beyond.value - beyond.half_range(box) <= error + beside_error) {
        const double beside = zero_strip_at_sides(g, inner, beyond, error + beside_error, box);
        one_depth.area += beside;
        one_depth.volume += beside * greatest;
      }
    }
    // A face that hangs from the master's corners is at depth 0 only there, in both problems.
    if (!g.only_hangs) {
      const double cut = roundings_of_depth(g, f.box);
      zero = strip_along_line(g.depth, {g.line_error + cut, g.depth_error + cut}, f, g, box);
      if (std::abs(g.depth.middle(box)) - g.depth.half_range(box) <= beside_error) {
        const double beside = zero_strip_at_sides(g, inner, g.depth, beside_error, box);
        zero.area += beside;
        zero.volume += beside * greatest;
      }
    }
    area = std::min(outline.area + one_depth.area + zero.area, overlap);
    volume = std::min(outline.volume + one_depth.volume + zero.volume, area * greatest);
    if (was_left_out) {
      // The elements were made without it, the master being thick enough, or it lying after all they see: whatever it
      // may hide is missing.
      area = std::min(greatest_area(g), overlap);
      volume = area * greatest;
    }
    flush_ =
        flush_ || ((one_depth.everywhere || zero.everywhere) && overlap == box.area() && greatest > 4 * f.depth_error &&
                   area > 4 * strip_along_border(box, g.position_error.s, g.position_error.t));
  }
  sight.area_error += area;
  sight.volume_error += volume;
}

ElementError ViewError::of_element(const VisiblePart& part, const FaceError& face) {
  const Moments& moments = part.moments;
  const ClippingError& clipping_error = part.clipping_error;
  ElementError error;
  FaceInView* const sight = find(false, part.slave_face);
  const double twice_area = 2 * prism_.face().area;
  error.normal = face.normal;
  error.foot_Me = error_.of_point_in_master();
  if (sight == nullptr) {  // The exact problem has none.
    error.area = twice_area * moments.area;
    error.volume = twice_area * moments.depth;
    error.penetration = clamped(moments.greatest);
    error.foot_Me += prism_.edge_s_Me().cwiseAbs() + prism_.edge_t_Me().cwiseAbs();
    return error;
  }
  sight->has_element = true;
  const FaceEnclosure& f = sight->enclosure;
  const double width_s = f.box.width_s(), width_t = f.box.width_t();
  const double deepest = std::max(f.greatest, moments.greatest), greatest = clamped(deepest);
  const double passed_area = sight->passed_area;
  const double passed_volume = clamped_volume(sight->passed_volume, passed_area, deepest);
  const double differing = std::min(sight->area_error, f.box.area() + moments.area);
  const double area_error =
      differing + clipping_error.area + clipping_error.cut_area + kAreaRoundings * u * moments.area;
  ClampRoundings clamp;
  if (moments.greatest > greatest_allowed_) clamp = ClampRoundings(f.box, std::max(clipping_error.pieces, 1));
  const double off_plane =
      3 * u * (clipping_error.cuts + clamp.cuts) * (deepest + std::abs(f.depth.per_s) + std::abs(f.depth.per_t));
  const double depth_error =
      f.facing == 0 ? clamped(f.greatest) : std::min(f.field_error + off_plane, clamped(f.greatest));
  // A triangle's integral has 8 roundings, the sum one for each, of which a part has ten at most.
  const double volume_error =
      clamped_volume(sight->volume_error, differing + passed_area, deepest) + clipping_error.area * greatest +
      clamped_volume(clipping_error.cut_volume, clipping_error.cut_area, deepest) +
      (moments.area + area_error + passed_area) * depth_error +
      clamp.sums * (18 + 10 * clipping_error.pieces) * u * (moments.depth + area_error * greatest) +
      (clamp.area * greatest + clamp.least);
  const double mean = moments.depth / moments.area;
  error.area = twice_area * area_error + 2 * face.area * (moments.area + area_error + passed_area);
  error.volume = twice_area * volume_error + 2 * face.area * (moments.depth + volume_error + passed_volume);
  // Elastic forces are linear in the integrals, whatever passes.
  const double passes = continuous_ ? 0 : 1;
  error.mean = mean;
  error.passed_area = passes * twice_area * passed_area;
  error.passed_volume = passes * twice_area * passed_volume;
  const double area_off = area_error + passes * passed_area, volume_off = volume_error + passes * passed_volume;
  error.penetration = greatest;
  if (2 * area_off < moments.area) {
    error.penetration = std::min(greatest, (volume_off + mean * area_off) / (moments.area - area_off) + 8 * u * mean);
  }
  // s - s_foot is no greater than f's width, so the foot is off by that times the error of the volume over the volume.
  double share = 1;
  if (2 * volume_off < moments.depth) share = std::min(1.0, volume_off / (moments.depth - volume_off));
  const double rounding = kFootRoundings * u * clamp.sums * (1 + clipping_error.pieces) *
                              std::min(0x1p40, moments.area * greatest / moments.depth) +
                          clamp.least / moments.depth;
  error.foot_Me += (std::min(1.0, share * width_s + rounding)) * prism_.edge_s_Me().cwiseAbs() +
                   (std::min(1.0, share * width_t + rounding)) * prism_.edge_t_Me().cwiseAbs();
  return error;
}

void ViewError::leave_out(const VisiblePart& part) {
  FaceInView* const sight = find(false, part.slave_face);
  if (sight == nullptr) return;
  sight->area_error += part.left_out;
  sight->volume_error += part.left_out * std::max(sight->enclosure.greatest, 0.0);
}

ViewError::Beside ViewError::beside() const {
  Beside sum;
  for (const FaceInView& sight : scratch_->sights) {
    if (!sight.may_carry || sight.has_element) continue;
    const FaceEnclosure& f = sight.enclosure;
    const double greatest = clamped(f.greatest);
    const double depth_error = f.facing == 0 ? greatest : std::min(f.field_error, greatest);
    const double area = sight.area_error + sight.passed_area;
    sum.area += area;
    sum.volume += std::min(sight.volume_error + sight.passed_volume + area * depth_error, area * greatest);
    sum.passed_area += sight.passed_area;
    sum.passed_volume += clamped_volume(sight.passed_volume, sight.passed_area, f.greatest);
    sum.depth = std::max(sum.depth, greatest);
  }
  return sum;
}

}  // namespace pcm::fast
