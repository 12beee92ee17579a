// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/bounds/master_view.h"
#include "fast/clipped/seen_edge.h"

/// The lines at which what a master face sees of a slave face may end, and how they move.
namespace pcm::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two faces whose depths differ by no more than this part of them are level: a right engine need not know the line in
/// which they meet. Twice the engine's, which pays for all roundings.
constexpr double kLevel = 0x1p-29;
static_assert(2 * fast::kLevel <= kLevel);

/// By a right angle.
Eigen::Vector2d turned_left(const Eigen::Vector2d& x) {
  return {-x.y(), x.x()};
}

SeenPoint in_plane(const Eigen::Vector2d& x) {
  return {x.x(), x.y(), 0};
}

}  // namespace

class MasterView::LineList {
 public:
  LineList(const MasterView& view, Index slave_face, double strip)
      : view_(view),
        slave_(opposite(view.master_)),
        slave_face_(slave_face),
        seen_slave_(view.seen(slave_, slave_face)),
        of_slave_(view.depth_field(slave_, slave_face, strip)),
        strip_(strip) {}

  /// The sides of a face; where two faces share one, once.
  void add_sides(Side side, Index face) {
    const Triangle& corners = view_.faces_.surface(side).mesh.faces[static_cast<std::size_t>(face)];
    const SeenFace seen = view_.seen(side, face);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      if (!known_sides_.insert({side, low, high}).second) continue;
      SightLine line;
      if (face == (side == slave_ ? slave_face_ : view_.master_face_))
        line.continuation = view_.continuation_beyond(side, face, k);
      line.surely_before = side == view_.master_ && face == view_.master_face_;
      add_side(line, side, seen[k], seen[(k + 1) % 3]);
    }
  }

  /// Where a face comes out of the master's plane: m . (x - corner) = 0 at depth 0.
  void add_depth_0(Side side, Index face) {
    if (share_a_side(view_.master_, view_.master_face_, side, face) ||
        !view_.faces_.corners_by_plane(view_.master_, view_.master_face_, side, face).meet())
      return;
    const DepthField field = view_.depth_field(side, face, strip_);
    const SeenPoint &m = field.normal, &corner = field.corner;
    const double sine = m.head<2>().norm(), reach = field.reach, turn = field.turn;
    const double height_error = 2 * view_.face_.plane_error * reach * std::abs(m.z());
    SightLine line;
    line.off = strip_ + kHigherOrder * (height_error + 2 * turn * (reach + view_.face_.longest)) / sine;
    const SeenFace over = view_.seen(side, face);
    if (!(line.off < view_.face_.longest)) {
      add_anywhere_over(over, side == slave_ ? kInfinity : 0);
      return;
    }
    const Eigen::Vector2d normal = m.head<2>() / sine;
    if (side == slave_) {
      line.pull = m / sine;
      line.pull_error = 2 * turn / (sine * sine);
    }
    add(line, in_plane(corner.head<2>() + m.z() * corner.z() / sine * normal), normal, 0, 0, &over);
  }

  /// Where a face passes through the slave face, whose height over that face's plane, m . (x - corner), is 0 there.
  void add_crossing(Side side, Index face) {
    if (share_a_side(slave_, slave_face_, side, face) ||
        !view_.faces_.corners_by_plane(slave_, slave_face_, side, face).meet() ||
        !view_.faces_.corners_by_plane(side, face, slave_, slave_face_).meet())
      return;
    const DepthField field = view_.depth_field(side, face, strip_);
    const SeenPoint &m = field.normal, &corner = field.corner;
    const Eigen::Vector2d rise = m.head<2>() + m.z() * of_slave_.slope;
    const double steep = rise.norm(), turn = field.turn, cosine = std::abs(of_slave_.normal.z());
    const double reach = field.reach + of_slave_.reach;
    const double turned = std::abs(m.z()) / cosine;
    const double height_error = 2 * reach * std::max(field.plane_error, of_slave_.plane_error * turned);
    SightLine line;
    line.off = strip_ +
               kHigherOrder *
                   (height_error + turn * (reach + of_slave_.reach) + std::abs(m.z()) * error_over_master(of_slave_)) /
                   steep;
    const SeenFace over = view_.seen(side, face);
    if (!(line.off < view_.face_.longest)) {
      add_anywhere_over(over, side == slave_ ? 1 : kInfinity);
      return;
    }
    const Eigen::Vector2d normal = rise / steep;
    if (side == slave_) {
      line.pull = in_plane(normal);
    } else {
      const SeenPoint growth = of_slave_.growth();
      line.pull = -m.z() / steep * growth;
      const double unsure = (turn * growth.norm() + std::abs(m.z()) * of_slave_.error_per_distance) / steep;
      line.pull_error = unsure < 0.5 ? 2 * (line.pull.norm() * unsure + turn * growth.norm() / steep +
                                            turned * of_slave_.error_per_distance / steep)
                                     : kInfinity;
    }
    const SeenPoint none = SeenPoint::Zero(), above{0, 0, of_slave_.at(none)};
    const SeenPoint through = in_plane(-m.dot(above - corner) / steep * normal);
    add(line, through, normal, of_slave_.at(through), of_slave_.slope.dot(-turned_left(normal)), &over);
  }

  /// Nothing is known.
  void lose() {
    lines_.push_back({});
    lines_.back().off = kInfinity;
  }

  std::vector<SightLine> take() { return std::move(lines_); }

 private:
  /// Then that is where their planes meet.
  bool share_a_side(Side side_a, Index a, Side side_b, Index b) const {
    if (side_a != side_b) return false;
    const auto corners = [&](Index face) {
      Triangle sorted = view_.faces_.surface(side_a).mesh.faces[static_cast<std::size_t>(face)];
      std::sort(sorted.begin(), sorted.end());
      return sorted;
    };
    const Triangle of_a = corners(a), of_b = corners(b);
    std::vector<Index> shared;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(shared));
    return shared.size() == 2;
  }
  /// A line of which nothing is known but that it lies over another face as well; its pull is no greater.
  void add_anywhere_over(const SeenFace& other, double pull) {
    if (!view_.is_wider_than(strip_)) {
      lose();
      return;
    }
    const std::vector<SeenPoint> over = view_.overlap(seen_slave_, other, 2 * strip_);
    if (over.empty()) return;
    if (!std::isfinite(pull)) {
      lose();
      return;
    }
    SightLine line;
    for (const SeenPoint& x : over) line.off = std::max(line.off, (x - over[0]).head<2>().norm());
    line.from = line.to = in_plane(over[0].head<2>());
    line.pull_error = pull;
    for (const SeenPoint& x : seen_slave_) line.from.z() = std::max(line.from.z(), x.z());
    line.to.z() = line.from_depth = line.to_depth = line.from.z();
    lines_.push_back(line);
  }

  /// Of the depth by the face's plane, anywhere over the master.
  double error_over_master(const DepthField& field) const {
    return field.error + times(field.error_per_distance, field.reach + view_.face_.longest);
  }

  /// A side whose direction roundings may have made belongs to a face that is seen no wider: what that hides lies
  /// between its other sides, and this one counts where it is.
  void add_side(SightLine line, Side side, const SeenPoint& a, const SeenPoint& b) {
    const double length = (b - a).head<2>().stableNorm();
    double farthest = 0;
    for (const SeenPoint& x : view_.own_) farthest = std::max(farthest, (x - a).head<2>().stableNorm());
    const double lever = 1 + 2 * (farthest + 2 * view_.face_.longest) / length;
    if (!(strip_ * lever < length / 16)) {
      if (side == slave_) line.pull_error = 1;
      line.off = strip_ + length;
      line.continuation = {};
      line.surely_before = false;
      line.from = line.to = in_plane(a.head<2>());
      line.from.z() = line.to.z() = std::max(0.0, of_slave_.at(a));
      line.from_depth = line.to_depth = a.z();
      lines_.push_back(line);
      return;
    }
    const Eigen::Vector2d normal = turned_left((b - a).head<2>() / length);
    const double slope = (b.z() - a.z()) / length;
    if (side == slave_) line.pull = in_plane(normal);
    // As sure as its ends between them.
    const auto [first, last] = span(in_plane(a.head<2>()), in_plane(-turned_left(normal)), strip_ * lever);
    line.off = strip_ * (1 + 2 * std::max({0.0, -first, last - length}) / length);
    line.depth_error = line.off * std::abs(slope);
    add(line, in_plane(a.head<2>()), normal, a.z(), slope, nullptr, hiding_stretch(line, a, b));
  }

  /// Where an edge from a to b may hide something of the slave face, as ways from a: not beyond its ends, above the
  /// master or beyond the face.
  std::pair<double, double> hiding_stretch(const SightLine& line, const SeenPoint& a, const SeenPoint& b) const {
    const double length = (b - a).head<2>().stableNorm(), end_error = 2 * strip_ + line.off;
    double first = -end_error, last = length + end_error;
    const auto limit = [&](double at_a, double at_b, double error) {
      const double rise = (at_b - at_a) / length, zero = -(at_a + error) / rise;
      if (rise > 0) first = std::max(first, zero);
      if (rise < 0) last = std::min(last, zero);
      if (rise == 0 && at_a + error < 0) last = -kInfinity;
    };
    const double depth_error = line.depth_error + end_error * (1 + std::abs(b.z() - a.z()) / length);
    const double lead_error = depth_error + error_over_master(of_slave_) + times(of_slave_.slope.norm(), end_error);
    limit(a.z(), b.z(), depth_error);
    if (std::isfinite(lead_error)) limit(of_slave_.at(a) - a.z(), of_slave_.at(b) - b.z(), lead_error);
    return {first, last};
  }

  /// Along which `normal` lies to the left; X lies `depth` deep at `through` and goes down by `slope`.
  /// Where the line is one of depths, it parts nothing but over the face that has it; `ends`: nor beyond these, m.
  void add(SightLine line, const SeenPoint& through, const Eigen::Vector2d& normal, double depth, double slope,
           const SeenFace* over = nullptr, std::pair<double, double> ends = {-kInfinity, kInfinity}) {
    const SeenPoint along = in_plane(-turned_left(normal));
    const auto [first, last] = span(through, along, std::isfinite(line.off) ? line.off : strip_, over);
    if (!(first <= last) && std::isfinite(line.off)) return;
    if (!std::isfinite(first + last + line.off + line.pull_error) || !line.pull.allFinite()) {
      lose();
      return;
    }
    const auto point = [&](double at) {
      SeenPoint x = through + at * along;
      x.z() = std::max(0.0, of_slave_.at(x));
      return x;
    };
    line.from = point(first);
    line.to = point(last);
    line.from_depth = depth + first * slope;
    line.to_depth = depth + last * slope;
    line.first = std::max(ends.first, first) - first;
    line.last = std::min(ends.second, last) - first;
    line.surely_before = line.surely_before || (over == nullptr && leads(line, through + first * along, along));
    lines_.push_back(line);
  }

  /// Whether a side lies before the slave face wherever it may begin to hide something of it.
  bool leads(const SightLine& line, const SeenPoint& from, const SeenPoint& along) const {
    if (!(line.first < line.last)) return true;
    const double length = (line.to - line.from).head<2>().stableNorm();
    const double error = kHigherOrder * (line.depth_error + error_over_master(of_slave_) +
                                         times(of_slave_.slope.norm(), line.off + 2 * strip_));
    const auto surely = [&](double at) {
      const double depth = line.from_depth + (length > 0 ? at / length : 0) * (line.to_depth - line.from_depth);
      return of_slave_.at(from + at * along) - depth > error;
    };
    return surely(line.first) && surely(line.last);
  }
  /// Where the slave face may be beneath the master as well.
  std::pair<double, double> span(const SeenPoint& through, const SeenPoint& along, double off,
                                 const SeenFace* over = nullptr) const {
    const double margin = 2 * strip_ + off;
    auto [first, last] = view_.span_within(through, along, seen_slave_, margin);
    if (over != nullptr) {
      const auto [first_over, last_over] = view_.span_within(through, along, *over, margin);
      first = std::max(first, first_over);
      last = std::min(last, last_over);
    }
    const double depth = of_slave_.at(through) + error_over_master(of_slave_) + times(of_slave_.slope.norm(), margin);
    const double deeper = of_slave_.slope.dot(along.head<2>());
    if (deeper > 0) first = std::max(first, -depth / deeper);
    if (deeper < 0) last = std::min(last, -depth / deeper);
    return {first, last};
  }

  const MasterView& view_;
  Side slave_;
  Index slave_face_;
  SeenFace seen_slave_;
  DepthField of_slave_;
  double strip_;
  std::set<std::tuple<Side, Index, Index>> known_sides_;
  std::vector<SightLine> lines_;
};

MasterView::DepthGrowth MasterView::depth_growth(Index slave_face) const {
  const DepthField field = depth_field(opposite(master_), slave_face, 0);
  if (!std::isfinite(field.error)) return {SeenPoint::Zero(), kInfinity};
  return {field.growth(), field.error_per_distance};
}

double MasterView::area_about_depth(Index slave_face, double depth, double error) const {
  if (!std::isfinite(depth)) return 0;
  const SeenFace slave = seen(opposite(master_), slave_face);
  std::vector<SeenPoint> part = seen_part(slave, 2 * most_strip(slave), 0);
  for (SeenPoint& x : part) x.z() -= depth;
  return no_more(area_near_zero(part, error), greatest_area());
}

// Two faces of the master see the same only if they lie in one plane exactly: else their lines part at the common side,
// and a border that lies between is seen by both, or by neither.
SightLine::Continuation MasterView::continuation_beyond(Side side, Index face, std::size_t k) const {
  const Triangle& corners = faces_.surface(side).mesh.faces[static_cast<std::size_t>(face)];
  const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
  const std::vector<Index>& at_side = faces_.surface(side).faces_at({low, high});
  if (at_side.size() != 2) return {};
  const Index beyond = at_side[0] == face ? at_side[1] : at_side[0];
  SightLine::Continuation continuation;
  if (side == master_) {
    const RoundedFaces::Face next = faces_.face(side, beyond);
    if (!(next.area > 0) || faces_.corners_by_plane(side, face, side, beyond).on != 3) return {};
    continuation.turn = (next.normal_Me - face_.normal_Me).norm() + face_.normal_error + next.normal_error;
  }
  const SeenFace here = seen(side, face), there = seen(side, beyond);
  const SeenPoint &from = here[k], way = here[(k + 1) % 3] - from;
  // Beyond is to the right of the master's sides, and to the left of those of a face that is seen from within.
  const double beyond_is = side == master_ ? -1 : 1;
  double area = 0;  // of the face beyond, doubled
  for (const SeenPoint& x : there) area = std::max(area, beyond_is * cross(way, x - from));
  if (!(area > 0)) return {};
  continuation.of = side == master_ ? SightLine::Continuation::Of::master : SightLine::Continuation::Of::slave;
  continuation.taper = way.head<2>().squaredNorm() / area;
  return continuation;
}

// Both faces at such an edge touch the hider with it, exactly, or the slave face lies in the hider's plane and counts
// as before it: from that edge on the slave's sheet is hidden. Moved one way the hider covers some of the slave face,
// as fast as the two meet, or all of it at once; moved the other way the face beyond comes to light, as fast as it and
// the hider meet: more than 1 / kLevel times as fast as they move. The oracle's derivative is of the latter; one that
// leaves out what begins to be seen, and moves the edge with its face, is as right.
bool MasterView::hides_level_face_beyond(Index slave_face, const NearFace& hider, double strip) const {
  const Side slave = opposite(master_);
  const DepthField of_hider = depth_field(hider.side, hider.face, strip);
  if (!std::isfinite(of_hider.error)) return false;
  const SeenFace seen_slave = seen(slave, slave_face), seen_hider = seen(hider.side, hider.face);
  const Triangle& corners = faces_.surface(slave).mesh.faces[static_cast<std::size_t>(slave_face)];
  const auto above_hider = [&](const SeenPoint& x) { return std::abs(x.z() - of_hider.at(x)); };
  const auto corners_on_hider = [&](Index face) {
    return faces_.corners_by_plane(hider.side, hider.face, slave, face).on;
  };
  const bool is_flush = corners_on_hider(slave_face) == 3;
  if (!is_flush && corners_on_hider(slave_face) != 2) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const SeenPoint &from = seen_slave[k], &to = seen_slave[(k + 1) % 3], &apex = seen_slave[(k + 2) % 3];
    const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
    for (const Index beyond : faces_.surface(slave).faces_at({low, high})) {
      if (beyond == slave_face || (hider.side == slave && hider.face == beyond) || corners_on_hider(beyond) != 2)
        continue;
      if (side_parts(slave, beyond, hider.side, hider.face, strip) ||
          side_parts(hider.side, hider.face, slave, beyond, strip))
        continue;
      const DepthField of_beyond = depth_field(slave, beyond, strip);
      if (!std::isfinite(of_beyond.error) || !(of_beyond.normal.z() > 0)) continue;
      const double error = of_hider.error_between(of_beyond) + of_beyond.error_between(of_hider);
      if (above_hider(from) > error || above_hider(to) > error) continue;
      double least = 0, most = 0, depth = std::max({std::abs(from.z()), std::abs(to.z()), std::abs(apex.z())});
      for (const SeenPoint& x : seen_hider) {
        least = std::min(least, of_beyond.at(x) - of_hider.at(x));
        most = std::max(most, of_beyond.at(x) - of_hider.at(x));
        depth = std::max(depth, std::abs(x.z()));
      }
      if (most - least > kLevel * depth + error || most + error <= 0) continue;
      if (is_flush || above_hider(apex) > kLevel * depth + error) return true;
    }
  }
  return false;
}

std::vector<SightLine> MasterView::lines_in_sight(Index slave_face) const {
  const SeenFace slave = seen(opposite(master_), slave_face);
  const double strip = most_strip(slave);
  const std::vector<SeenPoint> part = seen_part(slave, 0, 0);
  LineList lines(*this, slave_face, strip);
  lines.add_sides(master_, master_face_);
  lines.add_sides(opposite(master_), slave_face);
  lines.add_depth_0(opposite(master_), slave_face);
  if (part.empty()) {
    lines.lose();
    return lines.take();
  }
  for (const NearFace* const hider : find_hiders(slave_face, part, strip, true).faces) {
    lines.add_sides(hider->side, hider->face);
    lines.add_depth_0(hider->side, hider->face);
    lines.add_crossing(hider->side, hider->face);
    if (hides_level_face_beyond(slave_face, *hider, strip)) lines.lose();
  }
  return lines.take();
}

}  // namespace pcm::compare
