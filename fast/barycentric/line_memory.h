// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "fast/barycentric/line_margin.h"
#include "fast/prism/line_trace.h"

namespace pcm::fast {

/// What a master's penetration lines found at one pose, for those of the next pose near by: what they still find,
/// where that is settled; else where walks over the slave may start, and the faces that a line may meet while F moves a
/// little. To be asked about faces and told of them in their order, once a pose each.
class LineMemory {
 public:
  /// Faces that a line may meet until F has travelled farther than `until`, m: all of the slave, and other ones of the
  /// master, up to a distance along the line.
  struct Line {
    Index face = -1;
    Index slave_nearby = -1;  ///< a face of the slave near the line, -1: none
    Index element_on = -1;    ///< the slave's face of its element, -1: none; where that is settled
    double settled_until = -std::numeric_limits<double>::infinity();  ///< until F has travelled farther, m
    double until = -std::numeric_limits<double>::infinity();
    double slave_searched = 0, own_searched = 0;            ///< m
    std::size_t first = 0, slave_count = 0, own_count = 0;  ///< in `faces`, the slave's before the master's
  };

  explicit LineMemory(const LineMotion& motion = {}) : motion_(motion) {}

  /// Knows of no line.
  void clear() {
    past_.clear(), now_.clear();
    vertex_error_ = 0;
  }

  /// At the next pose, to which points of F have travelled so far, m. What is searched for holds for `ahead` more,
  /// and until then lines are no farther from where they are than `radius`, m; with 0 it is not worth remembering.
  /// `settle`: it is worth while to ask until when lines go on to find what they find.
  void start(double travelled, double ahead, double radius, bool settle = true) {
    std::swap(past_, now_);
    now_.clear();
    next_ = 0;
    travelled_ = travelled;
    ahead_ = ahead;
    radius_ = radius;
    settle_ = settle;
  }
  bool is_to_settle() const { return settle_; }
  bool is_to_remember_faces() const { return ahead_ > 0; }

  /// Travel is counted from here on.
  void start_travel_anew(double travelled) {
    for (Line& line : now_.lines) {
      line.until -= travelled;
      line.settled_until -= travelled;
    }
  }

  /// At this pose the master's vertices are off by as much, m: what was settled for less is not.
  void note_vertex_error(double error) {
    if (error <= vertex_error_) return;
    for (Line& line : past_.lines) line.settled_until = -std::numeric_limits<double>::infinity();
    vertex_error_ = 2 * error;
  }
  /// For which lines are settled, m.
  double vertex_error() const { return vertex_error_; }
  const LineMotion& motion() const { return motion_; }

  /// What is known of the line of a face; nullptr: nothing.
  const Line* recall(Index face) {
    while (next_ < past_.lines.size() && past_.lines[next_].face < face) ++next_;
    const bool known = next_ < past_.lines.size() && past_.lines[next_].face == face;
    return known ? &past_.lines[next_] : nullptr;
  }
  /// Whether it still finds what it found, which `element_on` tells.
  bool is_settled(const Line& line) const { return travelled_ < line.settled_until; }
  /// Whether the faces that it may meet are known.
  bool holds(const Line& line) const { return travelled_ < line.until; }
  /// How much farther F may travel until they are not, m.
  double held_for(const Line& line) const { return line.until - travelled_; }
  const Index* slave_faces(const Line& line) const { return past_.faces.data() + line.first; }
  const Index* own_faces(const Line& line) const { return slave_faces(line) + line.slave_count; }
  /// Of a line whose faces are known: none of the slave, however far.
  static bool meets_nothing(const Line& line) {
    return line.slave_count == 0 && line.slave_searched == std::numeric_limits<double>::infinity();
  }
  /// The one face of the slave that such a line may meet up to `slave_searched`, where there is but one and no face of
  /// the master is remembered, which the thickness has to tell; else -1.
  Index only_slave_face(const Line& line) const {
    return line.slave_count == 1 && line.own_count == 0 ? *slave_faces(line) : -1;
  }
  double radius() const { return radius_; }

  /// A line that was told by a walk.
  void keep(Index face, Index slave_nearby) {
    Line& line = now_.lines.emplace_back();
    line.face = face;
    line.slave_nearby = slave_nearby;
  }
  /// One of which all that is known holds on.
  void keep(const Line& known) {
    const std::size_t first = now_.faces.size();
    // First the faces, so that no line is without its own where memory ends.
    const Index* const faces = slave_faces(known);
    now_.faces.insert(now_.faces.end(), faces, faces + known.slave_count + known.own_count);
    now_.lines.push_back(known);
    now_.lines.back().first = first;
  }
  /// One for which those faces served that are known, and do so on.
  void keep(const Line& known, Index slave_nearby) {
    keep(known);
    now_.lines.back().slave_nearby = slave_nearby;
    now_.lines.back().settled_until = -std::numeric_limits<double>::infinity();
  }
  /// One that was searched for, with all faces within the radius.
  void keep(Index face, Index slave_nearby, const LineTrace& trace) {
    if (trace.slave_faces.size() + trace.own_faces.size() > kMostFaces) {
      keep(face, slave_nearby);
      return;
    }
    Line line;
    line.face = face;
    line.slave_nearby = slave_nearby;
    line.until = travelled_ + ahead_;
    line.slave_searched = trace.slave_searched;
    line.own_searched = trace.own_listed ? trace.own_searched : -std::numeric_limits<double>::infinity();
    line.first = now_.faces.size();
    line.slave_count = trace.slave_faces.size();
    line.own_count = trace.own_faces.size();
    now_.faces.insert(now_.faces.end(), trace.slave_faces.begin(), trace.slave_faces.end());
    now_.faces.insert(now_.faces.end(), trace.own_faces.begin(), trace.own_faces.end());
    now_.lines.push_back(line);
  }

  /// What the line kept last found is settled until F has travelled by so much from here, m.
  void settle(double travel, Index element_on) {
    now_.lines.back().settled_until = travelled_ + travel;
    now_.lines.back().element_on = element_on;
  }

 private:
  /// More are as well searched for.
  static constexpr std::size_t kMostFaces = 12;

  struct Lines {
    std::vector<Line> lines;  ///< by face, ascending
    std::vector<Index> faces;

    void clear() { lines.clear(), faces.clear(); }
  };

  LineMotion motion_;
  double vertex_error_ = 0;
  Lines past_, now_;
  std::size_t next_ = 0;
  double travelled_ = 0, ahead_ = 0, radius_ = 0;
  bool settle_ = true;
};

}  // namespace pcm::fast
