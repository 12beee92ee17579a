// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/clipped_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "fast/barycentric/penetration_line.h"

namespace pcm::fast {

namespace {

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

/// The part of the master face that sees the slave face f first.
std::span<const ConvexPolygon> pieces_of_visible_part(const SeenFaces& seen, ClippedFaceScratch& scratch,
                                                      ClippingError& clipping_error) {
  if (overlaps_of(seen, seen.f).empty()) return {&seen.f.seen, 1};
  find_visible_pieces(seen, scratch.polygons, scratch.remaining, clipping_error);
  return scratch.polygons;
}

/// The same with all depths multiplied by `scale`, a power of two.
Moments scaled_moments_of(std::span<const ConvexPolygon> parts, double most, double scale,
                          std::vector<ConvexPolygon>& scaled) {
  scaled.assign(parts.begin(), parts.end());
  for (ConvexPolygon& part : scaled) {
    for (int i = 0; i < part.count; ++i) part[i][kDepth] *= scale;
  }
  return moments_of(scaled, scale * most);
}

/// Where no depth is greater than this, products with areas may underflow: depths are multiplied by kDepthScale then.
constexpr double kShallow = 0x1p-700, kDepthScale = 0x1p600;

/// Integrals of min(depth, most) in place of the depth.
void fill_visible_part(const ClippedFace& seen, std::span<const ConvexPolygon> pieces, double most, VisiblePart& part,
                       std::vector<ConvexPolygon>& scaled_pieces) {
  part.moments = moments_of(pieces, most);
  const Moments& moments = part.moments;
  part.area = moments.area * (2 * seen.geometry.area);
  const auto set_means = [&part](const Moments& sums, double unit) {
    if (!(sums.depth > 0)) return;
    part.penetration = std::max(sums.depth / sums.area * unit, std::numeric_limits<double>::denorm_min());
    part.centre_s = std::clamp(sums.s_depth / sums.depth, 0.0, 1.0);
    part.centre_t = std::clamp(sums.t_depth / sums.depth, 0.0, 1.0);
  };
  if (moments.greatest >= kShallow) {
    set_means(moments, 1);
  } else if (moments.greatest > 0) {
    set_means(scaled_moments_of(pieces, most, kDepthScale, scaled_pieces), 1 / kDepthScale);
  }
  part.penetration = std::min({part.penetration, moments.greatest, most});
  if (!part.is_element()) part.left_out = std::abs(moments.area) + part.clipping_error.area;
}

void find_parts(PosedPair& posed, const ClippedFace& seen, double most, bool with_motions,
                ClippedFaceScratch& scratch) {
  const std::vector<ProjectedFace>& faces = scratch.view.faces;
  find_overlaps(faces, scratch.by_low_s, scratch.overlaps);
  for (std::size_t i = 0; i < faces.size() && !faces[i].of_master; ++i) {
    if (!faces[i].leaves) continue;
    VisiblePart& part = scratch.parts.emplace_back(faces[i].face);
    if (!faces[i].carries) {
      part.left_out = 0.5 * std::abs(twice_area(faces[i].seen));
      continue;
    }
    const SeenFaces seen_faces{posed, seen.master, seen.face, *seen.prism, faces, scratch.overlaps, faces[i]};
    const std::span<const ConvexPolygon> pieces = pieces_of_visible_part(seen_faces, scratch, part.clipping_error);
    fill_visible_part(seen, pieces, most, part, scratch.scaled);
    if (with_motions && part.is_element())
      scratch.motions.push_back(motion_of_part({seen_faces, pieces, part.moments, most}, scratch.moving));
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

namespace {

/// From so many faces on threads have enough to do: these take some 200 us.
constexpr std::size_t kEnoughForThreads = 128;
constexpr std::size_t kFacesAtOnce = 16;

/// Calls `add(element, motion)` for each element of a face; `motion` is null where none was asked for.
template <class Add>
void for_each_element(const ClippedFace& seen, const Add& add) {
  const ElementMotion* motion = seen.motions.data();
  const bool with_motions = !seen.motions.empty();
  for (const VisiblePart& part : seen.parts) {
    if (!part.is_element()) continue;
    add(ClippedElement{{seen.face, part.slave_face, part.moments.greatest},
                       part.area,
                       part.penetration,
                       seen.geometry.n_Me,
                       seen.foot_Me(part)},
        with_motions ? motion++ : nullptr);
  }
}

void add_to(ElementQueue& queue, const ClippedElement& element, const ElementMotion* motion) {
  queue.add(element.faces, element.area, element.penetration, element.n_Me, element.foot_Me, motion);
}

/// What one thread finds of its shares.
class FacesOfThread {
 public:
  FacesOfThread(const Intersection& intersection, Side master, const ForceProblem& problem, ClippedOfThread& own)
      : intersection_(intersection), master_(master), problem_(problem), own_(own) {
    own.found.clear();
    own.motions.clear();
    own.beside.clear();
  }

  std::size_t found() const { return own_.found.size(); }
  void operator()(std::span<const Index> faces) {
    for (const Index face : faces) {
      const ClippedFace seen = clip_face(intersection_, master_, face, problem_.law, problem_.with_tangent, own_.face);
      record_beside_elements(seen, problem_.law, own_.beside);
      for_each_element(seen, [this](const ClippedElement& element, const ElementMotion* motion) {
        own_.found.push_back(element);
        if (motion != nullptr) own_.motions.push_back(*motion);
      });
    }
  }

 private:
  Intersection intersection_;
  Side master_;
  const ForceProblem& problem_;
  ClippedOfThread& own_;
};

MasterForce sum_by_threads(const Intersection& intersection, Side master, const ForceProblem& problem, PosedTeam& team,
                           ClippedScratch& scratch, ElementRecord& record) {
  scratch.shares.find<FacesOfThread>(intersection, master, problem, kFacesAtOnce, team);
  for (const ClippedOfThread& own : scratch.shares.of_threads()) record.add(own.beside);
  ElementQueue queue(problem, master, record, intersection.posed.work, scratch.lanes);
  scratch.shares.for_each_found([&](const ClippedOfThread& own, std::size_t i) {
    add_to(queue, own.found[i], problem.with_tangent ? &own.motions[i] : nullptr);
  });
  return queue.total();
}

}  // namespace

MasterForce sum_clipped_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                 PosedTeam& team, ClippedScratch& scratch, ElementRecord& record) {
  const bool for_threads = team.threads() > 1 && intersection.active_faces(master) >= kEnoughForThreads;
  if (for_threads) return sum_by_threads(intersection, master, problem, team, scratch, record);
  ElementQueue queue(problem, master, record, intersection.posed.work, scratch.lanes);
  for_each_active_face(intersection, master, [&](Index face) {
    const ClippedFace seen = clip_face(intersection, master, face, problem.law, problem.with_tangent, scratch.face);
    record_beside_elements(seen, problem.law, record);
    for_each_element(
        seen, [&queue](const ClippedElement& element, const ElementMotion* motion) { add_to(queue, element, motion); });
  });
  return queue.total();
}

}  // namespace pcm::fast
