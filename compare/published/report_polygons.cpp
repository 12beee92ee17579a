// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/report_polygons.h"

#include <algorithm>
#include <tuple>

namespace pcm::compare::published {
namespace {

auto key(const fast::Crossing& crossing) {
  return std::tie(crossing.edge_side, crossing.edge, crossing.face);
}

bool smaller(const fast::Crossing& a, const fast::Crossing& b) {
  return key(a) < key(b);
}

/// The points of a polygon, a closed one from its smallest on.
std::vector<fast::Crossing> points_of(const SegmentChain& chain, const Surface& surface_E, const Surface& surface_F,
                                      const std::vector<Segment>& segments) {
  std::vector<fast::Crossing> points;
  const auto add = [&](const Crossing& crossing) {
    const Surface& surface = crossing.edge_side == Side::E ? surface_E : surface_F;
    points.push_back({crossing.edge_side, surface.edge(crossing.edge), crossing.face, crossing.position_Me});
  };
  for (std::size_t s = chain.first; s < chain.first + chain.count; ++s) add(segments[s].ends[0]);
  if (chain.closed)
    std::rotate(points.begin(), std::min_element(points.begin(), points.end(), smaller), points.end());
  else
    add(segments[chain.first + chain.count - 1].ends[1]);
  return points;
}

}  // namespace

void report_polygons(const Surface& surface_E, const Surface& surface_F, Workspace& workspace) {
  struct Reported {
    std::vector<fast::Crossing> points;
    bool closed;
    Index patch;
  };
  std::vector<Reported> polygons;
  for (std::size_t c = 0; c < workspace.chains.size(); ++c)
    polygons.push_back({points_of(workspace.chains[c], surface_E, surface_F, workspace.segments),
                        workspace.chains[c].closed, root_of(workspace.patch_of, static_cast<Index>(c))});
  std::sort(polygons.begin(), polygons.end(),
            [](const Reported& a, const Reported& b) { return smaller(a.points.front(), b.points.front()); });
  fast::Contact& contact = workspace.contact;
  std::vector<Index> patches;
  for (const Reported& polygon : polygons) {
    const auto known = std::find(patches.begin(), patches.end(), polygon.patch);
    const auto patch = static_cast<Index>(known - patches.begin());
    if (known == patches.end()) patches.push_back(polygon.patch);
    contact.polygons.push_back({polygon.closed, static_cast<Index>(contact.crossings.size()),
                                static_cast<Index>(polygon.points.size()), patch});
    contact.crossings.insert(contact.crossings.end(), polygon.points.begin(), polygon.points.end());
  }
  contact.patches = static_cast<Index>(patches.size());
}

}  // namespace pcm::compare::published
