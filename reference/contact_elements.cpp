// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/contact_elements.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/penetration_line.h"

namespace pcm::reference {
namespace {

/// Lines against the faces near them: pairs (line, face).
std::vector<IndexPair> faces_near_lines(const std::vector<PenetrationLine>& lines,
                                        const std::vector<std::optional<Index>>& until, const FaceBoxes& faces,
                                        const std::vector<bool>& wanted) {
  // Enough pieces that a whole line's box is not much larger than the faces it looks for; short lines need one.
  const int whole = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(faces.faces.size())) / 4), 1, 64);
  std::vector<Box> boxes;
  std::vector<Index> line_of;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!wanted[i]) continue;
    for (const Box& box : lines[i].pieces_within(faces.all, until[i] ? 1 : whole, until[i])) {
      boxes.push_back(box);
      line_of.push_back(static_cast<Index>(i));
    }
  }
  std::vector<IndexPair> pairs = meeting_boxes(boxes, faces.faces);
  for (auto& pair : pairs) pair.first = line_of[pair.first];
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

struct FirstHit {
  std::optional<Index> face;
  Meeting meeting;
};

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

}  // namespace

ElementPairs find_elements(const ExactPose& pose, Side master, const Combinatorics& combinatorics) {
  const Side slave = other(master);
  const ActiveFaces& active_faces = master == Side::E ? combinatorics.E : combinatorics.F;
  const FaceBoxes& own = master == Side::E ? combinatorics.boxes_E : combinatorics.boxes_F;
  const FaceBoxes& others = master == Side::E ? combinatorics.boxes_F : combinatorics.boxes_E;
  std::vector<Index> active;
  std::merge(active_faces.intersected.begin(), active_faces.intersected.end(), active_faces.inner.begin(),
             active_faces.inner.end(), std::back_inserter(active));
  ElementPairs elements;
  elements.certified = activity_is_robust(pose, master, active, combinatorics.candidates);

  std::vector<PenetrationLine> lines;
  for (const Index face : active)
    if (has_area(pose, master, face)) lines.emplace_back(pose, master, face);
  std::vector<std::optional<Index>> until(lines.size());
  std::vector<bool> wanted(lines.size(), true);

  // The first slave face along each line; ties left by the shift go to the smaller index.
  std::vector<FirstHit> first(lines.size());
  for (const auto& [i, face] : faces_near_lines(lines, until, others, wanted)) {
    const Meeting meeting = lines[i].meets(slave, face);
    if (!meeting.met) continue;
    if (first[i].face && lines[i].compare(slave, face, slave, *first[i].face) >= 0) continue;
    first[i] = {face, meeting};
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    wanted[i] = first[i].face && first[i].meeting.facing < 0;
    until[i] = first[i].face;
  }

  // The master's own faces, up to there.
  std::vector<bool> blocked(lines.size(), false);
  for (const auto& [i, face] : faces_near_lines(lines, until, own, wanted)) {
    if (blocked[i] || face == lines[i].face()) continue;
    if (lines[i].meets(master, face).met && lines[i].compare(master, face, slave, *until[i]) < 0) blocked[i] = true;
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    elements.certified = elements.certified && lines[i].certified();
    if (!wanted[i]) continue;
    if (blocked[i])
      ++elements.too_deep;
    else if (first[i].meeting.ahead)
      elements.pairs.push_back({master, lines[i].face(), *first[i].face});
  }
  return elements;
}

}  // namespace pcm::reference
