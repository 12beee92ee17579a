// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/active/face_cells.h"

#include <algorithm>
#include <iterator>

#include "reference/active/face_paths.h"

namespace pcm::reference {
namespace {

/// The crossings of a face as seen from its apex, from the corner after it to the one before it: those on one ray have
/// one rank. The sides of the face at the apex are rays too, the first and the last one.
class Rays {
 public:
  explicit Rays(FaceLines& lines)
      : after_((lines.apex() + 1) % 3), before_((lines.apex() + 2) % 3), rank_(lines.crossings().size(), kNone) {
    std::vector<Index> between;
    std::vector<Index> last;
    for (const Index c : ends_of_segments(lines)) {
      const bool on_first = lines.coordinate_sign(c, before_) == 0, on_last = lines.coordinate_sign(c, after_) == 0;
      if (on_first && !on_last) rank_[c] = 0;
      if (on_last && !on_first) last.push_back(c);
      if (!on_first && !on_last) between.push_back(c);
    }
    std::sort(between.begin(), between.end(), [&](Index a, Index b) { return lines.turn(a, b) > 0; });
    lines_ = {before_};
    for (std::size_t i = 0; i < between.size(); ++i) {
      if (i == 0 || lines.turn(between[i - 1], between[i]) != 0) lines_.push_back(lines.ray_of(between[i]));
      rank_[between[i]] = static_cast<Index>(lines_.size()) - 1;
    }
    lines_.push_back(after_);
    for (const Index c : last) rank_[c] = static_cast<Index>(lines_.size()) - 1;
  }

  Index wedges() const { return static_cast<Index>(lines_.size()) - 1; }
  /// The line of a ray: wedge i lies between rays i and i + 1.
  Index line(Index rank) const { return lines_[rank]; }
  /// Of a crossing; kNone at the apex itself.
  Index rank(Index crossing) const { return rank_[crossing]; }

 private:
  static std::vector<Index> ends_of_segments(FaceLines& lines) {
    std::vector<Index> ends;
    for (Index i = 0; i < lines.segment_count(); ++i)
      if (!lines.is_without_line(i)) ends.insert(ends.end(), lines.ends_of(i).begin(), lines.ends_of(i).end());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  int after_, before_;
  std::vector<Index> rank_;
  std::vector<Index> lines_;
};

/// Segments by the wedges that they pass through.
std::vector<std::vector<Index>> segments_through_wedges(FaceLines& lines, const Rays& rays) {
  std::vector<std::vector<Index>> through(rays.wedges());
  for (Index i = 0; i < lines.segment_count(); ++i) {
    const auto [a, b] = std::minmax({rays.rank(lines.ends_of(i)[0]), rays.rank(lines.ends_of(i)[1])});
    if (a == kNone || lines.is_without_line(i)) continue;
    for (Index wedge = a; wedge < b; ++wedge) through[wedge].push_back(i);
  }
  return through;
}

void set_corners(const FaceLines& lines, FaceCell& cell) {
  for (std::size_t i = 0; i < cell.size(); ++i)
    cell.corners.push_back(lines.meeting(cell.bounds[i], cell.bounds[cell.next(i)]));
}

/// The part of a cell on one side of a line, corner i lying on side sides[i] of it.
FaceCell part_within(const FaceLines& lines, const FaceCell& cell, Index line, const std::vector<int>& sides,
                     int sign) {
  if (std::find(sides.begin(), sides.end(), -sign) == sides.end()) return cell;
  FaceCell part{{}, {}, cell.change};
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const std::size_t end = cell.next(i);  // bound `end` runs from corner i to corner `end`
    if (sides[i] != sign && sides[end] != sign) continue;
    part.bounds.push_back(cell.bounds[end]);
    if (sides[end] != sign) part.bounds.push_back(line);
  }
  set_corners(lines, part);
  return part;
}

/// Cuts the cells in two where the segment's line passes through their insides; all of the line that does belongs to
/// the segment. What lies on the other side of it than the apex is one face farther from that.
std::vector<FaceCell> cut_along(FaceLines& lines, Index segment, const std::vector<FaceCell>& cells) {
  const Index line = lines.line_of(segment);
  const int apex_side = lines.apex_side(segment);
  std::vector<FaceCell> parts;
  for (const FaceCell& cell : cells) {
    std::vector<int> sides;
    for (const LineMeeting corner : cell.corners) sides.push_back(lines.side(line, corner));
    for (const int sign : {1, -1}) {
      if (std::find(sides.begin(), sides.end(), sign) == sides.end()) continue;
      parts.push_back(part_within(lines, cell, line, sides, sign));
      if (sign != apex_side) parts.back().change += apex_side;
    }
  }
  return parts;
}

}  // namespace

std::vector<FaceCell> cut_into_cells(const Orientation& orientation, Side side, Index face, FaceLines& lines) {
  const Rays rays(lines);
  const std::vector<std::vector<Index>> through = segments_through_wedges(lines, rays);
  std::vector<FaceCell> all;
  for (Index wedge = 0; wedge < rays.wedges(); ++wedge) {
    std::vector<FaceCell> cells(1);
    cells[0].bounds = {rays.line(wedge), lines.apex(), rays.line(wedge + 1)};
    set_corners(lines, cells[0]);
    for (const Index segment : through[wedge]) cells = cut_along(lines, segment, cells);
    std::move(cells.begin(), cells.end(), std::back_inserter(all));
  }
  for (Index segment = 0; segment < lines.segment_count(); ++segment) {
    if (lines.apex_side(segment) != 0) continue;
    for (FaceCell& cell : all)
      cell.change += FacePaths(orientation, side, face, lines, cell.corners).passage(lines.apex(), segment);
  }
  return all;
}

}  // namespace pcm::reference
