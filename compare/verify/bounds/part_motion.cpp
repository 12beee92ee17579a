// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/part_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/bounds/moving_line.h"

namespace pcm::compare {
namespace {

using roundoff::u;

/// Roundings of an integral along a side or over a triangle, and of its factors.
constexpr double kRoundings = 64;
constexpr double kNothingKnown = std::numeric_limits<double>::infinity();

/// A point of the slave moves by dr + a x (x - r): by as much along a direction, for each coordinate.
Speeds speeds_along(const Eigen::Vector3d& pull_Me, const Eigen::Vector3d& arm_Me) {
  Speeds speeds;
  speeds << pull_Me.transpose().array(), arm_Me.cross(pull_Me).transpose().array();
  return speeds;
}

class ErrorSum {
 public:
  ErrorSum(const Question& question, const reference::Element& element, const ClippedBounds::OfElement& bound,
           const MasterView& view, ErrorOf of)
      : of_(of),
        element_(element),
        area_error_(bound.bounds.area),
        view_(view),
        r_Me_(question.pose.r),
        most_(question.law.max_penetration),
        sight_(bound.sight),
        growth_(view.depth_growth(element.slave_face)),
        counted_(std::min(std::max(sight_.deepest, element.greatest_penetration), most_)) {
    for (const SightLine& line : view.lines_in_sight(element.slave_face)) add(line);
  }

  PartGrowth greatest() const {
    if (!known_) return {Speeds::Constant(kNothingKnown), Speeds::Constant(kNothingKnown)};
    PartGrowth growth{Speeds::Zero(), (element_.area + area_error_) * (fastest_growth_ + growth_error())};
    for (const MovingLine& line : lines_) add_growth(line, growth);
    return {kHigherOrder * growth.area, kHigherOrder * growth.volume};
  }

  PartMotionError total() {
    if (!known_) {
      area_ = volume_ = moment_ = Speeds::Constant(kNothingKnown);
      return {area_, volume_, moment_};
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      add_along(lines_[i]);
      for (std::size_t j = 0; j < i; ++j) add_where_near(lines_[i], lines_[j]);
    }
    add_inside();
    return {kHigherOrder * area_, kHigherOrder * volume_, kHigherOrder * moment_};
  }

 private:
  void add(const SightLine& line) {
    known_ = known_ && std::isfinite(line.off) && std::isfinite(growth_.error);
    if (!known_) return;
    const auto arm = [&](const SeenPoint& x, double depth) {
      return Eigen::Vector3d(view_.point_Me({x.x(), x.y(), depth}) - r_Me_);
    };
    const Eigen::Vector3d growth_Me = view_.direction_Me(growth_.pull);
    for (const SeenPoint& x : {line.from, line.to})
      fastest_growth_ = fastest_growth_.max(speeds_along(growth_Me, arm(x, x.z())).abs());
    const Eigen::Vector3d pull_Me = view_.direction_Me(line.pull);
    const Eigen::Vector3d from = arm(line.from, line.from_depth), to = arm(line.to, line.to_depth);
    MovingLine moving;
    const Eigen::Vector2d way = (line.to - line.from).head<2>();
    moving.from = line.from.head<2>();
    moving.length = way.stableNorm();
    moving.along = moving.length > 0 ? Eigen::Vector2d(way / moving.length) : Eigen::Vector2d(1, 0);
    moving.off = line.off;
    moving.borders = {line.first, line.last};
    moving.speeds = {speeds_along(pull_Me, from), speeds_along(pull_Me, to)};
    reach_ = std::max({reach_, from.norm(), to.norm()});
    // Of where X is as well.
    // X is off along its line, along the lines of penetration as its depth is, and by the roundings of both.
    const double place_error = line.off + line.depth_error + sight_.depth_error + times(sight_.slope, line.off);
    moving.speed_error = line.pull_error * (1 + reach_) + line.pull.norm() * (place_error + coordinate_error());
    const double any = line.pull.norm(), any_turn = any * std::max(from.norm(), to.norm());
    moving.any_way << any, any, any, any_turn, any_turn, any_turn;
    moving.depths = {line.from.z(), line.to.z()};
    moving.continuation = line.continuation;
    moving.surely_before = line.surely_before;
    lines_.push_back(moving);
  }

  /// Of points reckoned in Me, from its origin, m.
  double coordinate_error() const { return kRoundings * u * (reach_ + view_.max_coordinate()); }

  double clamped(double depth) const { return std::min(depth, counted_); }
  /// Of the slave face where the line may lie, m.
  double depth_error_beside(const MovingLine& line) const {
    return clamped(sight_.depth_error + times(sight_.slope, line.off));
  }
  double greatest_depth(const MovingLine& line) const {
    return clamped(std::max(line.depths[0], line.depths[1]) + depth_error_beside(line));
  }

  /// A line that is border on both sides at most, between as many cells as there are lines. Off as the ends of a side
  /// are its direction is, by as much over its length: so a motion along it counts, too, on either side at either end,
  /// as much as the ends are off, across the line and along others that end there.
  void add_along(const MovingLine& line) {
    const Speeds speed = line.greatest_speed();
    const double n = static_cast<double>(lines_.size());
    const double lateral = depth_error_beside(line);
    const Speeds beside = 2 * line.length * speed;
    const Speeds rounded =
        2 * line.length * (line.speed_error + (kRoundings + n) * u * speed) + 8 * line.off * line.any_way;
    const double depth = greatest_depth(line);
    area_ += rounded;
    volume_ += depth * rounded + lateral * beside;
    moment_ += view_.longest_side() * depth * rounded + (sight_.width * lateral + line.off * depth) * beside;
  }

  /// As in add_along, all of it but what is settled: there, as in any part, only which of several lines is border is
  /// open.
  void add_growth(const MovingLine& line, PartGrowth& growth) const {
    const auto [length, distance] = settled(line);
    const Speeds speed = line.greatest_speed();
    const Speeds moved = (2 * (line.length - length) + 8 * (line.off + distance)) * speed + 8 * line.off * line.any_way;
    growth.area += moved;
    growth.volume += greatest_depth(line) * moved + 2 * length * clamped(times(sight_.slope, distance)) * speed;
    if (length == 0) return;
    for (const MovingLine& other : lines_) {
      const std::optional<Moved> open = &other == &line ? std::nullopt : where_near(line, other);
      if (!open) continue;
      growth.area += open->area;
      growth.volume += open->volume;
    }
  }

  /// Of an area and a volume.
  struct Moved {
    Speeds area, volume;
  };
  void add_where_near(const MovingLine& a, const MovingLine& b) {
    const std::optional<Moved> moved = where_near(a, b);
    if (!moved) return;
    area_ += moved->area;
    volume_ += moved->volume;
    moment_ += sight_.width * moved->volume;
  }
  std::optional<Moved> where_near(const MovingLine& a, const MovingLine& b) const {
    const double near = a.off + b.off;
    const auto on_a = stretch_near(a, b, near), on_b = stretch_near(b, a, near);
    if (!on_a || !on_b) return std::nullopt;
    const double length = std::max(on_a->length(), on_b->length());
    const double settled = std::min(settled_length(a, b, *on_a, near), settled_length(a, b, *on_b, near));
    const double depth =
        clamped(std::max(a.deepest(*on_a), b.deepest(*on_b)) + sight_.depth_error + times(sight_.slope, near));
    const Speeds apart =
        speed_difference(a, *on_a, b).max(speed_difference(b, *on_b, a)) + (a.speed_error + b.speed_error);
    const double turn = settled > 0 ? continuation_beside(a, b).turn : 0;
    const Speeds moved =
        2 * (length - settled) * apart + (8 * near + 2 * settled * turn) * (a.greatest_speed() + b.greatest_speed());
    return Moved{moved, depth * moved};
  }

  /// Along how much of a stretch, where both are no farther apart than that, what lies between them goes on beyond one
  /// of them, m. Near the ends of such a side the face beyond is too narrow to tell. Where they cross, each part that
  /// ends there has them do so where its own roundings say.
  double settled_length(const MovingLine& a, const MovingLine& b, const NearStretch& stretch, double apart) const {
    const double taper = continuation_beside(a, b).taper;
    if (of_ == ErrorOf::each || !stretch.side_by_side || !std::isfinite(taper)) return 0;
    return std::max(0.0, stretch.length() - 4 * apart * (1 + taper));
  }

  /// No two lines of a sliver are farther apart than that along a length, m.
  double greatest_distance(const MovingLine& a, const MovingLine& b) const {
    const double length = std::min(a.length, b.length), area = element_.area + area_error_;
    return a.off + b.off + (2 * area < sight_.width * length ? 2 * area / length : sight_.width);
  }
  /// Of a line of a sliver: along how much of it, m, it is settled with another one, and how far that may be.
  struct Settled {
    double length = 0, distance = 0;
  };
  /// Where it only cuts it lies between what is settled, before the sheet or on it, and parts nothing.
  Settled settled(const MovingLine& line) const {
    Settled longest;
    if (of_ == ErrorOf::each) return longest;
    MovingLine all_along = line;
    all_along.borders = {0, line.length};
    all_along.surely_before = true;
    for (const MovingLine& other : lines_) {
      if (&other == &line) continue;
      const double distance = greatest_distance(line, other);
      const auto beside = stretch_near(all_along, other, distance);
      if (!beside) continue;
      const double length = settled_length(all_along, other, *beside, distance);
      if (length > longest.length) longest = {length, distance};
    }
    return longest;
  }

  /// Of the depth's growth, for a motion of 1, m.
  double growth_error() const { return growth_.error * (1 + reach_) + growth_.pull.norm() * coordinate_error(); }

  /// The depth grows by N_f . d(X) / (n_k . N_f) where it is not clamped.
  void add_inside() {
    const double n = static_cast<double>(lines_.size()), area = element_.area + area_error_;
    const double depth_error = kHigherOrder * (sight_.depth_error + times(sight_.slope, 2 * sight_.strip));
    const double unsure = area_error_ + view_.area_about_depth(element_.slave_face, most_, depth_error);
    const Speeds error =
        std::min(unsure, area) * fastest_growth_ + area * (growth_error() + (kRoundings + n * n) * u * fastest_growth_);
    volume_ += error;
    moment_ += view_.longest_side() * error;
  }

  ErrorOf of_;
  const reference::Element& element_;
  double area_error_;  ///< m^2
  const MasterView& view_;
  Eigen::Vector3d r_Me_;
  double most_;
  const SlaveInView& sight_;
  MasterView::DepthGrowth growth_;
  double counted_;  ///< no depth counts more, m
  bool known_ = true;
  double reach_ = 0;  ///< no point that moves is farther from Mf, m
  Speeds fastest_growth_ = Speeds::Zero();
  std::vector<MovingLine> lines_;
  Speeds area_ = Speeds::Zero(), volume_ = Speeds::Zero(), moment_ = Speeds::Zero();
};

}  // namespace

PartMotionError part_motion_error(const Question& question, const reference::Element& element,
                                  const ClippedBounds::OfElement& bound, const MasterView& view, ErrorOf of) {
  return ErrorSum(question, element, bound, view, of).total();
}

PartGrowth greatest_part_growth(const Question& question, const reference::Element& element,
                                const ClippedBounds::OfElement& bound, const MasterView& view, ErrorOf of) {
  return ErrorSum(question, element, bound, view, of).greatest();
}

}  // namespace pcm::compare
