// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/own_faces.h"

#include <algorithm>

#include "fast/surface/thickness.h"

namespace pcm::fast {

namespace {

/// A pose that shears F by more than this makes faces that stand upright on others lean by more than roundings do.
constexpr double kGreatestSkew = 0x1p-48;

}  // namespace

OwnFacesBefore own_faces_before(const PosedPair& posed, Side master, const FaceGeometry& geometry, Index face,
                                double deepest) {
  const PreparedSurface& surface = posed.surface(master);
  const auto i = static_cast<std::size_t>(face);
  const ThicknessEverywhere& thickness = surface.thickness_everywhere;
  // F's parts are seen through roundings of its vertices, which may differ by more than the vertices do.
  const double vertex_error = master == Side::E ? 0 : posed.placement.position_error_F;
  const double known = master == Side::E ? thickness.exact[i] : thickness.rounded[i];
  if (!(deepest < known && thickness_holds(surface, vertex_error, geometry))) return OwnFacesBefore::some;
  if (surface.clear_of_neighbours[i] && deepest < thickness.tolerant[i]) return OwnFacesBefore::none;
  if (master == Side::E) return OwnFacesBefore::none;
  return posed.placement.skew > kGreatestSkew ? OwnFacesBefore::some : OwnFacesBefore::leaning;
}

SeenCorners see_own_corners(PosedPair& posed, Side master, Index master_face, const MasterPrism& prism, Index face) {
  const PreparedSurface& surface = posed.surface(master);
  const Triangle& master_vertices = surface.face(master_face);
  const Triangle& vertices = surface.face(face);
  SeenCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto shared = std::find(master_vertices.begin(), master_vertices.end(), vertices[k]);
    corners.is_shared[k] = shared != master_vertices.end();
    corners.points[k] = corners.is_shared[k] ? MasterPrism::corner(static_cast<int>(shared - master_vertices.begin()))
                                             : prism.see(posed.vertex_Me(master, vertices[k]), posed.work);
  }
  return corners;
}

}  // namespace pcm::fast
