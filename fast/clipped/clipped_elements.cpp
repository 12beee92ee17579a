// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/clipped_elements.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "fast/barycentric/penetration_line.h"

namespace pcm::fast {

namespace {

PlacedFace placed_face(PosedPair& posed, const ClippedFace& seen, const ProjectedFace& face) {
  const Side side = face.of_master ? seen.master : opposite(seen.master);
  return {face,
          {posed.vertex_Me(side, face.vertices[0]), posed.vertex_Me(side, face.vertices[1]),
           posed.vertex_Me(side, face.vertices[2])},
          *seen.prism,
          posed.placement.max_coordinate};
}

/// Integrals over parts of one face; of min(depth, most) in place of the depth. Area and greatest depth are none of the
/// clamp's.
Moments moments_of(std::span<const ConvexPolygon> parts, double most) {
  Moments moments;
  for (const ConvexPolygon& part : parts) moments.add(part);
  if (!(moments.greatest > most)) return moments;
  Moments clamped;
  for (const ConvexPolygon& part : parts) clamped.add_clamped(part, most);
  clamped.area = moments.area;
  clamped.greatest = moments.greatest;
  return clamped;
}

/// The part of the master face that sees the slave face at `index` of the projected ones first. `overlap` is at the
/// first one from this face on, and is left after the last one of it.
std::span<const ConvexPolygon> pieces_of_visible_part(PosedPair& posed, const ClippedFace& seen, std::size_t index,
                                                      ClippedFaceScratch& scratch,
                                                      std::vector<Overlap>::const_iterator& overlap,
                                                      ClippingError& clipping_error) {
  const ProjectedFace& f = scratch.view.faces[index];
  if (overlap == scratch.overlaps.end() || overlap->first != index) return {&f.seen, 1};
  const PlacedFace placed_f = placed_face(posed, seen, f);
  scratch.polygons.assign(1, f.seen);
  for (; overlap != scratch.overlaps.end() && overlap->first == index; ++overlap) {
    if (scratch.polygons.empty()) continue;
    const PlacedFace placed_g = placed_face(posed, seen, scratch.view.faces[overlap->second]);
    subtract_hidden(placed_f, placed_g, scratch.polygons, scratch.remaining, clipping_error, posed.work);
  }
  for (const ConvexPolygon& polygon : scratch.polygons) clipping_error.add_piece(polygon, f.seen);
  return scratch.polygons;
}

/// Integrals of min(depth, most) in place of the depth.
void fill_visible_part(const ClippedFace& seen, std::span<const ConvexPolygon> pieces, double most, VisiblePart& part) {
  part.moments = moments_of(pieces, most);
  const Moments& moments = part.moments;
  part.area = moments.area * (2 * seen.geometry.area);
  part.penetration = std::min({moments.depth / moments.area, moments.greatest, most});
  if (!part.is_element()) part.left_out = std::abs(moments.area) + part.clipping_error.area;
}

void find_parts(PosedPair& posed, const ClippedFace& seen, double most, bool with_motions,
                ClippedFaceScratch& scratch) {
  const std::vector<ProjectedFace>& faces = scratch.view.faces;
  find_overlaps(faces, scratch.by_low_s, scratch.overlaps);
  auto overlap = scratch.overlaps.cbegin();
  for (std::size_t i = 0; i < faces.size() && !faces[i].of_master; ++i) {
    if (!faces[i].leaves) continue;
    VisiblePart& part = scratch.parts.emplace_back(faces[i].face);
    if (!faces[i].carries) {
      part.left_out = 0.5 * std::abs(twice_area(faces[i].seen));
      continue;
    }
    const std::span<const ConvexPolygon> pieces =
        pieces_of_visible_part(posed, seen, i, scratch, overlap, part.clipping_error);
    fill_visible_part(seen, pieces, most, part);
    if (with_motions && part.is_element())
      scratch.motions.push_back(
          motion_of_part(posed, {seen.master, *seen.prism, faces, faces[i], pieces, part.moments, most}));
  }
}

/// Whether depths below the face may be lost to underflow, and its area: their signs then tell nothing.
bool underflows(const FaceGeometry& geometry) {
  const auto& p = geometry.points_Me;
  return std::max((p[1] - p[0]).lpNorm<Eigen::Infinity>(), (p[2] - p[0]).lpNorm<Eigen::Infinity>()) < kLeastDetail;
}

}  // namespace

ClippedFace clip_face(const Intersection& intersection, Side master, Index face, const ContactLaw& law,
                      bool with_motions, ClippedFaceScratch& scratch) {
  PosedPair& posed = intersection.posed;
  ClippedFace seen(master, face, face_with_sure_normal(posed.face_Me(master, face)), scratch.view, scratch.parts,
                   scratch.motions);
  scratch.parts.clear();
  scratch.motions.clear();
  scratch.view.faces.clear();
  // For the count of too_deep alone.
  const auto line_is_too_deep = [&] {
    return find_penetration(posed, master, face, seen.geometry, scratch.line_open).outcome ==
           Penetration::Outcome::too_deep;
  };
  const bool only_line_tells = underflows(seen.geometry);
  if (only_line_tells) seen.too_deep = line_is_too_deep();
  if (!(seen.geometry.area > 0)) return seen;
  seen.prism.emplace(seen.geometry);
  look_through(posed, master, face, *seen.prism, intersection.active.nested, scratch.looking, scratch.view);
  if (!only_line_tells && seen.view.slave_at_barycentre && seen.view.own_at_barycentre) {
    seen.too_deep = line_is_too_deep();
  }
  find_parts(posed, seen, law.max_penetration, with_motions, scratch);
  return seen;
}

void record_beside_elements(const ClippedFace& face, const ContactLaw& law, ElementRecord& record) {
  if (face.too_deep) ++record.too_deep;
  for (const VisiblePart& part : face.parts) {
    // Too small to be an element, but not too shallow.
    if (part.area > 0 && !part.is_element()) record.note_depth(part.moments.greatest, law);
  }
}

MasterForce sum_clipped_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                 ClippedScratch& scratch, ElementRecord& record) {
  PosedPair& posed = intersection.posed;
  ElementQueue queue(problem, master, record, posed.work, scratch.lanes);
  for_each_active_face(intersection, master, [&](Index face) {
    const ClippedFace seen = clip_face(intersection, master, face, problem.law, problem.with_tangent, scratch.face);
    record_beside_elements(seen, problem.law, record);
    auto motion = seen.motions.begin();
    for (const VisiblePart& part : seen.parts) {
      if (!part.is_element()) continue;
      queue.add({seen.face, part.slave_face, part.moments.greatest}, part.area, part.penetration, seen.geometry.n_Me,
                seen.foot_Me(part), problem.with_tangent ? &*motion++ : nullptr);
    }
  });
  return queue.total();
}

}  // namespace pcm::fast
