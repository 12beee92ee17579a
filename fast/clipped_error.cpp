// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fast/vertex_rounding.h"

namespace pcm::fast {
namespace {

constexpr double u = kUnitRoundoff;

/// Shifts beyond this are no longer small (fast/prism_error.cpp).
constexpr double kGreatestShift = 0x1p-6;

/// How far off f's depth may be from g's plane, or g's from f's, by roundings where the line they meet in is cut.
double noise_of_crossing(const Footprint& f, const Footprint& g, const PrismError& error) {
  double farthest = 0, highest = 0;
  for (const PrismPoint& c : f.corners) {
    const PrismPoint from_g = c - g.corners[0];
    farthest = std::max(farthest, error.distance(std::abs(from_g[kS]), std::abs(from_g[kT]), std::abs(from_g[kDepth])));
    const double plane =
        g.depth.value + (g.depth.per_s * (c[kS] - g.depth.s_0) + g.depth.per_t * (c[kT] - g.depth.t_0));
    highest = std::max(highest, std::abs(plane - c[kDepth]));
  }
  return g.crossing_noise * farthest + f.relative_noise * highest;
}

}  // namespace

void SightError::see(Index face, bool own, const Triangle& vertices, const std::array<PrismPoint, 3>& corners,
                     const std::array<bool, 3>& shared) {
  // Not a local variable: most of it stays unused where nothing is seen.
  scratch_->sights.emplace_back();
  Sight& sight = scratch_->sights.back();
  Footprint& f = sight.footprint;
  if (!find_footprint(error_, face, own, vertices, corners, shared, 2 * prism_.face().area, f)) {
    scratch_->sights.pop_back();
    return;
  }
  known_ = known_ && f.shift.s < kGreatestShift && f.shift.t < kGreatestShift;
  sight.may_carry = !own && f.facing <= 0;
  if (sight.may_carry) greatest_depth_ = std::max(greatest_depth_, f.greatest);
}

const Footprint* SightError::find(bool own, Index face) const {
  const std::vector<Sight>& sights = scratch_->sights;
  const auto found = std::lower_bound(sights.begin(), sights.end(), std::pair(own, face),
                                      [](const Sight& sight, const std::pair<bool, Index>& key) {
                                        return std::pair(sight.footprint.own, sight.footprint.face) < key;
                                      });
  const bool is_there = found != sights.end() && found->footprint.own == own && found->footprint.face == face;
  return is_there ? &found->footprint : nullptr;
}

// Where the neighbour beyond a side is not seen at all, neither is the side.
void SightError::find_outline(Sight& sight, const Surface::Data& surface) {
  const Footprint& f = sight.footprint;
  sight.knows_outline = true;
  sight.sheet_error = f.depth_error;
  for (const Index edge : surface.edges_of(f.face)) {
    const std::array<Index, 2>& faces = surface.faces_at(edge);
    const Index neighbour = faces[0] == f.face ? faces[1] : faces[0];
    bool goes_on = neighbour >= 0;
    if (goes_on) {
      if (const Footprint* const beyond = find(f.own, neighbour); beyond != nullptr) {
        goes_on = f.facing != 0 && beyond->facing == f.facing;
        if (goes_on) sight.sheet_error = std::max(sight.sheet_error, beyond->depth_error);
      }
    }
    if (goes_on) continue;
    const std::array<Index, 2>& ends = surface.edge(edge);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = f.vertices[k], b = f.vertices[(k + 1) % 3];
      if ((a == ends[0] && b == ends[1]) || (a == ends[1] && b == ends[0])) sight.outline[k] = true;
    }
  }
}

void SightError::is_projected(bool own, Index face, std::size_t place) {
  std::vector<Sight>& sights = scratch_->sights;
  if (!sights.empty() && sights.back().footprint.face == face && sights.back().footprint.own == own) {
    sights.back().projected = static_cast<std::ptrdiff_t>(place);
  } else {
    all_entered_ = false;
  }
}

void SightError::compare(const Surface::Data& slave, const Surface::Data& master, ProjectionScratch& projected) {
  std::vector<Sight>& sights = scratch_->sights;
  std::vector<std::size_t>& order = scratch_->order;
  order.clear();
  for (std::size_t i = 0; i < sights.size(); ++i) {
    order.push_back(i);
    Sight& sight = sights[i];
    const Footprint& f = sight.footprint;
    if (!sight.may_carry) continue;
    if (f.facing == 0) {
      sight.area_error = sliver_area(f, f.greatest, f.box);
      sight.volume_error = sight.area_error * f.greatest;
      continue;
    }
    const double cuts = strip_along_border(f.box, f.cut_shift.s, f.cut_shift.t);
    const double border = strips_along_sides(f, f.shift.s, f.shift.t, f.box).area + cuts;
    const ZeroStrip zero = zero_strip(f.depth, f.depth_error, f.box);
    sight.area_error = border + zero.area;
    sight.volume_error = zero.area * 2 * f.depth_error;
    if (continuous_) {
      find_outline(sight, slave);
      const double jumps = strips_along_sides(f, f.shift.s, f.shift.t, f.box, sight.outline).area + cuts;
      sight.volume_error += jumps * f.greatest + border * 4 * sight.sheet_error;
    } else {
      sight.volume_error += border * f.greatest;
    }
  }
  std::sort(order.begin(), order.end(), [&sights](std::size_t a, std::size_t b) {
    return sights[a].footprint.box.low_s < sights[b].footprint.box.low_s;
  });
  projected.overlaps.clear();
  for (std::size_t i = 0; i < order.size(); ++i) {
    Sight& f = sights[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      Sight& g = sights[order[j]];
      if (g.footprint.box.low_s > f.footprint.box.high_s) break;
      if (!(f.may_carry || g.may_carry)) continue;
      const BoxST box = f.footprint.box.common(g.footprint.box);
      if (box.empty()) continue;
      double overlap = box.area();
      if (f.footprint.facing != 0 && g.footprint.facing != 0) {
        overlap = greatest_overlap(f.footprint, g.footprint, box);
        if (overlap == 0) continue;
      }
      if (f.projected >= 0 && g.projected >= 0) {
        add_overlaps(projected.faces, static_cast<std::size_t>(f.projected), static_cast<std::size_t>(g.projected),
                     projected.overlaps);
      }
      for (Sight* const sight : {&f, &g}) {
        if (!sight->knows_outline) find_outline(*sight, sight->footprint.own ? master : slave);
      }
      if (f.may_carry) charge(f, g, box, overlap);
      if (g.may_carry) charge(g, f, box, overlap);
    }
  }
  if (all_entered_) {
    std::sort(projected.overlaps.begin(), projected.overlaps.end());
  } else {
    find_overlaps(projected.faces, projected.order, projected.overlaps);
  }
}

// Between faces of one sheet what they hide together goes on, so that only the sheet's outline counts; near a side they
// have in common the depths of both differ by twice their errors at most.
void SightError::charge(Sight& sight, const Sight& hider, const BoxST& box, double overlap) {
  const Footprint& f = sight.footprint;
  const Footprint& g = hider.footprint;
  if (f.facing == 0) return;  // Counted in full.
  const double greatest =
      std::clamp(f.depth.middle(box) + f.depth.reach(box) + f.depth_error, 0.0, std::max(f.greatest, 0.0));
  sight.cut_shift.s = std::max(sight.cut_shift.s, g.roundings.s);
  sight.cut_shift.t = std::max(sight.cut_shift.t, g.roundings.t);
  double area = 0;
  if (g.facing == 0) {
    area = sliver_area(g, greatest, box);
  } else {
    if (strips_along_sides(g, g.shift.s, g.shift.t, box).apart) return;
    const CertainOrder order = certain_order(g, f);
    if (order == CertainOrder::after) return;
    const double beside_error = 4 * hider.sheet_error;  // Near sides beyond which the sheet goes on.
    std::array<bool, 3> inner;
    for (std::size_t k = 0; k < 3; ++k) inner[k] = !hider.outline[k];
    ZeroStrip one_depth;
    if (order == CertainOrder::unsure) {
      LinearDepth beyond;  // How much farther f is than g.
      beyond.value = f.depth.middle(box) - g.depth.middle(box);
      beyond.s_0 = 0.5 * (box.low_s + box.high_s);
      beyond.t_0 = 0.5 * (box.low_t + box.high_t);
      beyond.per_s = f.depth.per_s - g.depth.per_s;
      beyond.per_t = f.depth.per_t - g.depth.per_t;
      const double error = f.depth_error + noise_of_crossing(f, g, error_);
      if (beyond.value + beyond.reach(box) < -(error + beside_error)) return;  // g certainly lies after f.
      one_depth = zero_strip(beyond, error + g.depth_error, box);
      if (beyond.value - beyond.reach(box) <= error + beside_error) {
        one_depth.area += zero_strip_at_sides(g, inner, beyond, error + beside_error, box);
      }
    }
    ZeroStrip zero = zero_strip(g.depth, g.depth_error, box);
    if (std::abs(g.depth.middle(box)) - g.depth.reach(box) <= beside_error) {
      zero.area += zero_strip_at_sides(g, inner, g.depth, beside_error, box);
    }
    const double outline =
        strips_along_sides(g, g.shift.s + sight.cut_shift.s, g.shift.t + sight.cut_shift.t, box, hider.outline).area;
    area = std::min(outline + one_depth.area + zero.area, overlap);
    flush_ = flush_ || ((one_depth.everywhere || zero.everywhere) && overlap == box.area() &&
                        greatest > 4 * f.depth_error && area > 4 * strip_along_border(box, g.shift.s, g.shift.t));
  }
  sight.area_error += area;
  sight.volume_error += area * greatest;
}

Sight* SightError::find(Index slave_face) {
  std::vector<Sight>& sights = scratch_->sights;
  while (next_ < sights.size() && !sights[next_].footprint.own && sights[next_].footprint.face < slave_face) ++next_;
  const bool found =
      next_ < sights.size() && !sights[next_].footprint.own && sights[next_].footprint.face == slave_face;
  return found ? &sights[next_] : nullptr;
}

ElementError SightError::of_element(Index slave_face, const Moments& moments, const Neglect& neglect,
                                    const FaceError& face) {
  ElementError error;
  Sight* const sight = find(slave_face);
  const double twice_area = 2 * prism_.face().area;
  error.normal = face.normal;
  if (sight == nullptr) {  // The exact problem has none.
    error.area = twice_area * moments.area;
    error.volume = twice_area * moments.depth;
    error.penetration = moments.greatest;
    error.foot_Me = prism_.edge_s_Me().cwiseAbs() + prism_.edge_t_Me().cwiseAbs();
    return error;
  }
  sight->has_element = true;
  const Footprint& f = sight->footprint;
  const double width_s = f.box.width_s(), width_t = f.box.width_t();
  // Roundings of the parts beyond the first, cuts and integrals.
  const double cut_s = sight->cut_shift.s + 24 * u * width_s, cut_t = sight->cut_shift.t + 24 * u * width_t;
  const double cut = 2 * (neglect.width_s * cut_t + neglect.width_t * cut_s) + 48 * neglect.parts * cut_s * cut_t;
  const double area_error =
      std::min(sight->area_error, f.box.area() + moments.area) + neglect.area + cut + 16 * u * moments.area;
  const double depth_error = f.facing == 0 ? f.greatest : std::min(f.field_error, f.greatest);
  const double greatest = std::max(f.greatest, moments.greatest);
  const double volume_error = sight->volume_error + (neglect.area + cut) * greatest +
                              (moments.area + area_error) * (depth_error + 16 * u * greatest);
  const double mean = moments.depth / moments.area;
  error.area = twice_area * area_error + 2 * face.area * (moments.area + area_error);
  error.volume = twice_area * volume_error + 2 * face.area * (moments.depth + volume_error);
  error.penetration = greatest;
  if (2 * area_error < moments.area) {
    error.penetration =
        std::min(greatest, (volume_error + mean * area_error) / (moments.area - area_error) + 8 * u * mean);
  }
  // s - s_foot is no greater than f's width, so the foot is off by that times the error of the volume over the volume.
  double share = 1;
  if (2 * volume_error < moments.depth) share = std::min(1.0, volume_error / (moments.depth - volume_error));
  const double noise = 64 * u * (1 + neglect.parts) * std::min(0x1p40, moments.area * greatest / moments.depth);
  error.foot_Me = (std::min(1.0, share * width_s + noise)) * prism_.edge_s_Me().cwiseAbs() +
                  (std::min(1.0, share * width_t + noise)) * prism_.edge_t_Me().cwiseAbs();
  return error;
}

void SightError::leave_out(Index slave_face, double area) {
  Sight* const sight = find(slave_face);
  if (sight == nullptr) return;
  sight->area_error += area;
  sight->volume_error += area * std::max(sight->footprint.greatest, 0.0);
}

SightError::Beside SightError::beside() const {
  Beside sum;
  for (const Sight& sight : scratch_->sights) {
    if (!sight.may_carry || sight.has_element) continue;
    const Footprint& f = sight.footprint;
    const double depth_error = f.facing == 0 ? f.greatest : std::min(f.field_error, f.greatest);
    sum.area += sight.area_error;
    sum.volume += std::min(sight.volume_error + sight.area_error * depth_error, sight.area_error * f.greatest);
    sum.depth = std::max(sum.depth, f.greatest);
  }
  return sum;
}

}  // namespace pcm::fast
