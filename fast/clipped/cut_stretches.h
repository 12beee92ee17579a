// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>
#include <vector>

#include "fast/prism/convex_polygon.h"
#include "pcm/triangle_mesh.h"

namespace pcm::fast {

/// A stretch of a piece's side from a to b, the piece on the left, on a line along which pieces were cut.
struct CutStretch {
  SideLine line;
  PrismPoint a, b;
};

/// The edge of a body from a vertex to one of greater index.
struct EdgeKey {
  bool of_master;
  Index low, high;
};

/// Where the pieces of what is seen of a face have sides on the line of an edge that hides nothing there, beyond its
/// ends or beyond the face: along these the pieces were cut from one another. What lay on one side may be hidden all
/// the same, by another face that has a border just there.
class CutStretches {
 public:
  void clear() { ends_.clear(); }
  bool empty() const { return ends_.empty(); }

  /// Of a stretch, at these places of the edge: 0 at its first vertex, 1 at the other one.
  void add(const EdgeKey& edge, const CutStretch& stretch, double place_a, double place_b) {
    ends_.push_back({edge, place_a, 1, stretch.line, stretch.a});
    ends_.push_back({edge, place_b, -1, stretch.line, stretch.b});
  }

  /// Stretches that have a piece on one side alone. Lines that differ by no more than the uncertainty count as one.
  void find_with_one_piece(const Uncertainty& uncertainty, std::vector<CutStretch>& found);

 private:
  struct End {
    EdgeKey edge;
    double place;
    int turn;  ///< of the balance of pieces, as places grow: those that have them in their way less the other ones
    SideLine line;
    PrismPoint point;

    bool is_on_edge_of(const End& other) const { return key() == other.key(); }
    bool operator<(const End& other) const {
      return std::tuple_cat(key(), std::tie(place)) < std::tuple_cat(other.key(), std::tie(other.place));
    }

   private:
    std::tuple<bool, Index, Index> key() const { return {edge.of_master, edge.low, edge.high}; }
  };
  std::vector<End> ends_;
};

/// Whether two points are farther apart than roundings.
bool are_apart(const PrismPoint& a, const PrismPoint& b, const Uncertainty& uncertainty);

/// Whether two points lie on the line from one to another, to within roundings.
bool lie_on_line(const PrismPoint& a, const PrismPoint& b, const PrismPoint& from, const PrismPoint& to,
                 const Uncertainty& uncertainty);

}  // namespace pcm::fast
