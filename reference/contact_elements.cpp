// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/contact_elements.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "reference/box_tree.h"
#include "reference/penetration_line.h"

namespace pcm::reference {
namespace {

/// Whether edge and face surely cross (1), surely do not (-1), or it depends on the rounding (0).
int robust_crossing(const ExactPose& pose, Vertex a, Vertex b, Side face_side, Index face) {
  const Triangle& t = pose.face(face_side, face);
  const Box p = pose.rounding_box({face_side, t[0]}), q = pose.rounding_box({face_side, t[1]}),
            s = pose.rounding_box({face_side, t[2]});
  const Box at_a = pose.rounding_box(a), at_b = pose.rounding_box(b);
  const int sides = robust_orientation(p, q, s, at_a) * robust_orientation(p, q, s, at_b);
  if (sides > 0) return -1;
  const int s0 = robust_orientation(at_a, at_b, p, q), s1 = robust_orientation(at_a, at_b, q, s);
  if (s0 * s1 < 0) return -1;
  const int s2 = robust_orientation(at_a, at_b, s, p);
  if (s1 * s2 < 0 || s2 * s0 < 0) return -1;
  return sides * s0 * s1 * s2 != 0 ? 1 : 0;
}

bool pair_is_robust(const ExactPose& pose, Index e, Index f) {
  for (const Side side : {Side::E, Side::F}) {
    const Triangle& t = pose.face(side, side == Side::E ? e : f);
    for (int i = 0; i < 3; ++i)
      if (robust_crossing(pose, {side, t[i]}, {side, t[(i + 1) % 3]}, other(side), side == Side::E ? f : e) == 0)
        return false;
  }
  return true;
}

bool activity_is_robust(const ExactPose& pose, Side master, const std::vector<Index>& active,
                        const std::vector<IndexPair>& candidates) {
  const bool closed_slave = pose.surface(other(master)).closed;
  return std::all_of(candidates.begin(), candidates.end(), [&](const IndexPair& pair) {
    const Index face = master == Side::E ? pair.first : pair.second;
    if (closed_slave && std::binary_search(active.begin(), active.end(), face)) return true;
    return pair_is_robust(pose, pair.first, pair.second);
  });
}

bool has_area(const ExactPose& pose, Side side, Index face) {
  const auto p = pose.corners<Exact>(side, face);
  const Vec3<Exact> normal = doubled_normal(p[0], p[1], p[2]);
  return sign_of(normal.x) != 0 || sign_of(normal.y) != 0 || sign_of(normal.z) != 0;
}

struct Hit {
  Index face = kNone;
  Meeting meeting;
  double within = std::numeric_limits<double>::infinity();  ///< upper bound of its q
};

/// The first slave face along the line; ties left by the shift go to the smaller index.
Hit find_first_hit(PenetrationLine& line, Side slave, const BoxTree& tree) {
  std::vector<Hit> hits;
  Hit first;  // to begin with, the one whose q surely is small: then the comparisons with it are easy ones
  tree.look_along([&line](const Box& box) { return line.reach(box); },
                  [&](Index face) {
                    const Meeting meeting = line.meets(slave, face);
                    if (!meeting.met) return first.within;
                    hits.push_back({face, meeting, line.farthest(slave, face)});
                    if (first.face == kNone || hits.back().within < first.within) first = hits.back();
                    return first.within;
                  });
  for (const Hit& hit : hits) {
    if (hit.face == first.face) continue;
    const int order = line.compare(slave, hit.face, slave, first.face);
    if (order < 0 || (order == 0 && hit.face < first.face)) first = hit;
  }
  return first;
}

/// Whether another face of the master is met strictly before the slave face.
bool leaves_master_first(PenetrationLine& line, Side slave, const Hit& hit, const BoxTree& tree) {
  bool left = false;
  tree.look_along([&line](const Box& box) { return line.reach(box); },
                  [&](Index face) {
                    left = face != line.face() && line.meets(line.master(), face).met &&
                           line.compare(line.master(), face, slave, hit.face) < 0;
                    return left ? -1.0 : hit.within;
                  });
  return left;
}

}  // namespace

ElementPairs find_elements(const ExactPose& pose, Side master, const Combinatorics& combinatorics) {
  const Side slave = other(master);
  const Proximity& near = *combinatorics.near;
  const std::vector<Index> active = (master == Side::E ? combinatorics.E : combinatorics.F).active();
  ElementPairs elements;
  elements.certified = activity_is_robust(pose, master, active, near.candidates());
  for (const Index face : active) {
    if (!has_area(pose, master, face)) continue;
    PenetrationLine line(pose, master, face);
    const Hit first = find_first_hit(line, slave, near.tree(slave));
    if (first.face != kNone && first.meeting.facing < 0) {
      if (leaves_master_first(line, slave, first, near.tree(master)))
        ++elements.too_deep;
      else if (first.meeting.ahead)
        elements.pairs.push_back({master, face, first.face});
    }
    elements.certified = elements.certified && line.certified();
  }
  return elements;
}

}  // namespace pcm::reference
