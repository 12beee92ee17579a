// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/elements/barycentric_elements.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "reference/lines/penetration_line.h"
#include "reference/pose/box_tree.h"

namespace pcm::reference {
namespace {

/// Whether edge and face surely cross (1), surely do not (-1), or it may depend on the rounding (0).
int robust_crossing(const ExactPose& pose, Vertex a, Vertex b, Side face_side, Index face) {
  const Triangle& t = pose.face(face_side, face);
  const Box p = pose.rounding_box({face_side, t[0]}), q = pose.rounding_box({face_side, t[1]}),
            s = pose.rounding_box({face_side, t[2]});
  const Box at_a = pose.rounding_box(a), at_b = pose.rounding_box(b);
  const int sides = certain_orientation(p, q, s, at_a) * certain_orientation(p, q, s, at_b);
  if (sides > 0) return -1;
  const int s0 = certain_orientation(at_a, at_b, p, q), s1 = certain_orientation(at_a, at_b, q, s);
  if (s0 * s1 < 0) return -1;
  const int s2 = certain_orientation(at_a, at_b, s, p);
  if (s1 * s2 < 0 || s2 * s0 < 0) return -1;
  return sides * s0 * s1 * s2 != 0 ? 1 : 0;
}

/// Calls `visit` with `robust_crossing` of each edge of either face with the other one, until it returns true.
template <class Visit>
bool any_edge(const ExactPose& pose, const IndexPair& pair, const Visit& visit) {
  for (const Side side : {Side::E, Side::F}) {
    const auto [own, others] = side == Side::E ? pair : IndexPair{pair.second, pair.first};
    const Triangle& t = pose.face(side, own);
    for (int i = 0; i < 3; ++i)
      if (visit(robust_crossing(pose, {side, t[i]}, {side, t[(i + 1) % 3]}, other(side), others))) return true;
  }
  return false;
}

/// Whether the faces cross in the same edges for all vertices within their rounding boxes.
bool pair_is_robust(const ExactPose& pose, const IndexPair& pair) {
  return !any_edge(pose, pair, [](int crossing) { return crossing == 0; });
}

bool pair_surely_crosses(const ExactPose& pose, const IndexPair& pair) {
  return any_edge(pose, pair, [](int crossing) { return crossing == 1; });
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
  tree.look_along([&line](const Box& box) { return line.begin_of(box); },
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
  tree.look_along([&line](const Box& box) { return line.begin_of(box); },
                  [&](Index face) {
                    left = face != line.face() && line.meets(line.master(), face).met &&
                           line.compare(line.master(), face, slave, hit.face) < 0;
                    return left ? -1.0 : hit.within;
                  });
  return left;
}

/// What a master face would carry if it were active.
struct Load {
  Index slave_face = kNone;  ///< of its element
  bool too_deep = false;

  bool any() const { return slave_face != kNone || too_deep; }
};

Load look_along(PenetrationLine& line, Side slave, const Proximity& near) {
  const Hit first = find_first_hit(line, slave, near.tree(slave));
  if (first.face == kNone || first.meeting.facing >= 0) return {};
  if (leaves_master_first(line, slave, first, near.tree(line.master()))) return {kNone, true};
  return {first.meeting.ahead ? first.face : kNone, false};
}

/// The winding number of a closed slave about the barycentre, which must not lie on it: what the line leaves more often
/// than it enters.
int winding_about_barycentre(PenetrationLine line, Side slave, const BoxTree& tree) {
  int winding = 0;
  tree.look_along([&line](const Box& box) { return line.begin_of(box); },
                  [&](Index face) {
                    const Meeting meeting = line.meets(slave, face);
                    if (meeting.met) winding -= meeting.facing;
                    return std::numeric_limits<double>::infinity();
                  });
  return winding;
}

/// Certifies the faces of a master against a closed slave, one by one (barycentric_elements.h).
class Certifier {
 public:
  Certifier(const ExactPose& pose, Side master, const Combinatorics& combinatorics)
      : pose_(pose), master_(master), near_(*combinatorics.near), faces_(combinatorics.of(master)) {}

  /// For an active face that carries something: cases 1, 2, 4.
  bool stays_active(const PenetrationLine& line) const {
    if (std::binary_search(faces_.inner.begin(), faces_.inner.end(), line.face())) return true;
    if (winding_about_barycentre(line, other(master_), near_.tree(other(master_))) >= 1) return true;
    return std::any_of(near_.candidates().begin(), near_.candidates().end(), [&](const IndexPair& pair) {
      return face_of(pair) == line.face() && pair_surely_crosses(pose_, pair);
    });
  }

  /// For all that are not active: cases 1, 3.
  bool others_carry_nothing(const std::vector<Index>& active) const {
    std::set<Index> certified;
    return std::all_of(near_.candidates().begin(), near_.candidates().end(), [&](const IndexPair& pair) {
      const Index face = face_of(pair);
      if (std::binary_search(active.begin(), active.end(), face) || pair_is_robust(pose_, pair)) return true;
      if (!certified.insert(face).second) return true;
      PenetrationLine line(pose_, master_, face);
      return !look_along(line, other(master_), near_).any() && line.certified();
    });
  }

 private:
  Index face_of(const IndexPair& pair) const { return master_ == Side::E ? pair.first : pair.second; }

  const ExactPose& pose_;
  Side master_;
  const Proximity& near_;
  const ActiveFaces& faces_;
};

}  // namespace

ElementPairs find_elements(const ExactPose& pose, Side master, const Combinatorics& combinatorics) {
  const Side slave = other(master);
  const bool closed_slave = pose.surface(slave).closed;
  const Proximity& near = *combinatorics.near;
  const std::vector<Index> active = combinatorics.of(master).active();
  const Certifier certifier(pose, master, combinatorics);
  ElementPairs elements;
  elements.certified = closed_slave ? certifier.others_carry_nothing(active)
                                    : std::all_of(near.candidates().begin(), near.candidates().end(),
                                                  [&](const IndexPair& pair) { return pair_is_robust(pose, pair); });
  for (const Index face : active) {
    if (!has_area(pose, master, face)) {
      elements.certified = false;  // rounding may have taken it
      continue;
    }
    PenetrationLine line(pose, master, face);
    const Load load = look_along(line, slave, near);
    if (load.too_deep) ++elements.too_deep;
    if (load.slave_face != kNone) elements.pairs.push_back({master, face, load.slave_face});
    elements.certified =
        elements.certified && line.certified() && (!load.any() || !closed_slave || certifier.stays_active(line));
  }
  return elements;
}

}  // namespace pcm::reference
