// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/surface/exit_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "fast/prism/depths_in_prism.h"
#include "fast/prism/master_prism.h"
#include "fast/prism/ray.h"
#include "fast/surface/open_nodes.h"
#include "fast/surface/own_sights.h"
#include "fast/surface/thickness.h"

/// A sheet of other faces, joined by their edges, lies beneath the master face. Its own border, seen along the lines,
/// nowhere enters the master face, so that over all of the face it covers every point, but for some of no area, the
/// same number of times, faces that are seen from their back counted negatively. Where that number is not 0 each line
/// meets the sheet, no deeper than its deepest corner. All that is asked of the sheet holds with a tolerance, and so
/// for vertices that are moved by as much: where they go does not matter.
namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Sheets of more faces than this are given up.
constexpr std::size_t kMostFaces = 128;

/// Where the faces are counted, off the lines that regular meshes put their edges on.
constexpr double kCountedAtS = 0.3125 - 0x1p-10, kCountedAtT = 0.25 + 0x1p-7;

struct SeenFace : SeenCorners {
  Index face;
  DepthsInPrism depths;  ///< in the prism wider by the tolerance
};

class SheetBeneath {
 public:
  SheetBeneath(const PreparedSurface& surface, Index master, const MasterPrism& prism, double tolerance)
      : surface_(surface),
        master_(master),
        prism_(prism),
        sights_(prism, surface.face(master)),
        tolerance_(tolerance) {}

  /// How deep it reaches; infinite where there is no such sheet.
  double depth() {
    double deepest = 0;
    int covered = 0;
    std::size_t looked_at = 0;
    while (covered == 0) {
      const std::optional<Index> nearest = nearest_at_count();
      if (!nearest || count_ == kMostFaces) return kInfinity;
      faces_[count_++] = *nearest;
      for (; looked_at < count_; ++looked_at) {
        const SeenFace seen = see(faces_[looked_at]);
        const std::optional<int> covers = covers_counted_point(seen);
        if (!lies_beneath(seen) || !covers || !add_neighbours(seen)) return kInfinity;
        covered += *covers;
        deepest = std::max(deepest, seen.depths.greatest);
      }
    }
    return deepest + tolerance_;
  }

 private:
  SeenFace see(Index face) {
    const SeenCorners corners = sights_.corners(surface_, face, work_);
    return {corners, face, depths_in_prism(prism_, corners.points, tolerance_)};
  }

  /// How far a weight may be off.
  double off(int weight) const { return tolerance_ * prism_.inward_length(static_cast<std::size_t>(weight + 1) % 3); }

  /// Whether all that the face may have over the master, but for the corners they share, lies beneath it.
  bool lies_beneath(const SeenFace& seen) const {
    if (seen.depths.least > tolerance_) return true;
    std::size_t shared = 0, corner = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (seen.shared[k] < 0) continue;
      ++shared;
      corner = k;
    }
    if (shared == 1) return rises_beside(seen, corner);
    return shared == 2 &&
           std::max({seen.points[0][kDepth], seen.points[1][kDepth], seen.points[2][kDepth]}) > tolerance_;
  }

  /// Whether what a face with one of the master's corners may have above the master's plane lies beyond one of the
  /// master's sides there. With the other corners at a and b from that one, depths h and weights w of that side, points
  /// x a + y b, x >= 0, y >= 0, with x h_a + y h_b <= 0 must have x w_a + y w_b < 0; of all these it is enough to ask
  /// the outermost.
  bool rises_beside(const SeenFace& seen, std::size_t corner) const {
    const PrismPoint& a = seen.points[(corner + 1) % 3];
    const PrismPoint& b = seen.points[(corner + 2) % 3];
    const double h_a = a[kDepth] - tolerance_, h_b = b[kDepth] - tolerance_;
    if (h_a > 0 && h_b > 0) return true;
    for (int weight = 0; weight < 3; ++weight) {
      if (weight == seen.shared[corner]) continue;
      const double w_a = a[weight] + off(weight), w_b = b[weight] + off(weight);
      const bool a_beside = h_a > 0 || w_a < 0;
      const bool b_beside = h_b > 0 || w_b < 0;
      const bool between_beside = h_a > 0 ? h_a * w_b - h_b * w_a < 0 : h_b > 0 ? h_b * w_a - h_a * w_b < 0 : true;
      if (a_beside && b_beside && between_beside) return true;
    }
    return false;
  }

  /// Whether the face lies over the point where faces are counted: 1 or -1, as it is seen from its front or from its
  /// back, or 0; nothing where the tolerance does not tell.
  std::optional<int> covers_counted_point(const SeenFace& seen) const {
    const double off_s = off(kS), off_t = off(kT);
    std::array<double, 3> s, t;
    for (std::size_t k = 0; k < 3; ++k) {
      s[k] = seen.points[k][kS] - kCountedAtS;
      t[k] = seen.points[k][kT] - kCountedAtT;
    }
    const auto [low_s, high_s] = std::minmax({s[0], s[1], s[2]});
    const auto [low_t, high_t] = std::minmax({t[0], t[1], t[2]});
    if (low_s > off_s || high_s < -off_s || low_t > off_t || high_t < -off_t) return 0;
    int left = 0, right = 0;  // Of how many sides the point lies there.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double turn = s[k] * t[next] - t[k] * s[next];
      const double error =
          4 * (off_s * (std::abs(t[k]) + std::abs(t[next]) + 2 * off_t) + off_t * (std::abs(s[k]) + std::abs(s[next])));
      left += turn > error ? 1 : 0;
      right += turn < -error ? 1 : 0;
    }
    if (left == 3) return 1;
    if (right == 3) return -1;
    if (left > 0 && right > 0) return 0;
    return {};
  }

  bool has(Index face) const {
    const auto end = faces_.begin() + static_cast<std::ptrdiff_t>(count_);
    return std::find(faces_.begin(), end, face) != end;
  }

  /// Of the faces beneath, not in the sheet yet, that surely lie over the point where faces are counted, the one that
  /// does not reach as deep as others.
  std::optional<Index> nearest_at_count() {
    const FaceGeometry& master = prism_.face();
    const Ray ray(master, prism_.p0_Me() + kCountedAtS * prism_.edge_s_Me() + kCountedAtT * prism_.edge_t_Me());
    const TreeRay tree_ray(ray.origin, ray.direction, 2 * tolerance_);
    std::optional<Index> nearest;
    double nearest_depth = kInfinity;
    OpenNodes<Index> open;
    open.push(0);
    while (!open.empty()) {
      const BoxNode& node = surface_.tree.node(open.pop());
      if (!(tree_ray.entry(node.box) < nearest_depth)) continue;
      if (!node.leaf()) {
        open.push(node.child);
        open.push(node.child + 1);
        continue;
      }
      if (node.face == master_ || has(node.face)) continue;
      const SeenFace seen = see(node.face);
      if (!(seen.depths.greatest < nearest_depth) || !lies_beneath(seen)) continue;
      if (covers_counted_point(seen).value_or(0) == 0) continue;
      nearest = node.face;
      nearest_depth = seen.depths.greatest;
    }
    return nearest;
  }

  /// Whether an edge, from corner k of the face on, is seen on the far side of one of the master's sides, but for
  /// corners of its own on that side.
  bool is_beside(const SeenFace& seen, std::size_t k) const {
    for (int weight = 0; weight < 3; ++weight) {
      const auto lies_beyond = [&](std::size_t corner) {
        return seen.shared[corner] >= 0 ? seen.shared[corner] != weight : seen.points[corner][weight] < -off(weight);
      };
      if (lies_beyond(k) && lies_beyond((k + 1) % 3)) return true;
    }
    return false;
  }

  /// Adds the faces beyond its edges, but where these are the master's or surely beside it. False where the sheet
  /// becomes too large.
  bool add_neighbours(const SeenFace& seen) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index neighbour = surface_.neighbours_of(seen.face)[k];
      if (neighbour == master_ || is_beside(seen, k) || has(neighbour)) continue;
      if (count_ == kMostFaces) return false;
      faces_[count_++] = neighbour;
    }
    return true;
  }

  const PreparedSurface& surface_;
  Index master_;
  const MasterPrism& prism_;
  OwnSights sights_;
  double tolerance_;  ///< by how much anything may be moved, m
  WorkCounters work_;
  std::array<Index, kMostFaces> faces_;
  std::size_t count_ = 0;
};

}  // namespace

double upper_bound_of_exit_depth(const PreparedSurface& surface, Index face) {
  if (!surface.closed) return kInfinity;
  const FaceGeometry geometry(surface.points_of(face));
  if (!thickness_holds(surface, 0, geometry)) return kInfinity;
  // Half of it for roundings of what is computed here, half for a pose's.
  const double tolerance = 2 * kThicknessTolerance * surface.max_coordinates.maxCoeff();
  return SheetBeneath(surface, face, MasterPrism(geometry), tolerance).depth();
}

}  // namespace pcm::fast
