// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/part_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {
namespace {

using roundoff::u;

/// By coordinate.
using Speeds = Eigen::Array<double, 1, 6>;

/// Roundings of an integral along a side or over a triangle, and of its factors.
constexpr double kRoundings = 64;
constexpr double kNothingKnown = std::numeric_limits<double>::infinity();

/// From here to there along a line, m.
using Stretch = std::pair<double, double>;

struct MovingLine {
  Eigen::Vector2d from, along;  ///< m, and of length 1
  double length, off;
  Stretch borders;               ///< where faces may end on it or meet
  std::array<Speeds, 2> speeds;  ///< at its ends
  double speed_error;            ///< for a motion of 1, m
  Speeds any_way;                ///< greatest speeds of a point of it in any direction, times its pull
  std::array<double, 2> depths;  ///< of the slave face, m

  Speeds speed_at(double at) const {
    const double share = length > 0 ? at / length : 0;
    return (1 - share) * speeds[0] + share * speeds[1];
  }
  double depth_at(double at) const {
    const double share = length > 0 ? at / length : 0;
    return std::max((1 - share) * depths[0] + share * depths[1], 0.0);
  }
  Speeds greatest_speed() const { return speeds[0].abs().max(speeds[1].abs()) + speed_error; }
};

/// A point of the slave moves by dr + a x (x - r): by as much along a direction, for each coordinate.
Speeds speeds_along(const Eigen::Vector3d& pull_Me, const Eigen::Vector3d& arm_Me) {
  Speeds speeds;
  speeds << pull_Me.transpose().array(), arm_Me.cross(pull_Me).transpose().array();
  return speeds;
}

class ErrorSum {
 public:
  ErrorSum(const Question& question, const reference::Element& element, const ClippedBounds::OfElement& bound,
           const MasterView& view)
      : element_(element),
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
    // As in add_along and add_where_near, all of it.
    for (const MovingLine& line : lines_) {
      const Speeds moved = (2 * line.length + 8 * line.off) * line.greatest_speed() + 8 * line.off * line.any_way;
      growth.area += moved;
      growth.volume += greatest_depth(line) * moved;
    }
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

  void add_where_near(const MovingLine& a, const MovingLine& b) {
    const double near = a.off + b.off;
    const auto on_a = stretch_near(a, b, near), on_b = stretch_near(b, a, near);
    if (!on_a || !on_b) return;
    const double length = std::max(on_a->second - on_a->first, on_b->second - on_b->first);
    const double depth =
        clamped(std::max(deepest(a, *on_a), deepest(b, *on_b)) + sight_.depth_error + times(sight_.slope, near));
    const Speeds apart = difference(a, *on_a, b).max(difference(b, *on_b, a)) + (a.speed_error + b.speed_error);
    const Speeds moved = 2 * length * apart + 8 * near * (a.greatest_speed() + b.greatest_speed());
    area_ += moved;
    volume_ += depth * moved;
    moment_ += sight_.width * depth * moved;
  }

  /// Where a line is no farther than that from another one, and both may be a border.
  static std::optional<Stretch> stretch_near(const MovingLine& on, const MovingLine& other, double near) {
    const Eigen::Vector2d normal(-other.along.y(), other.along.x());
    const double height = normal.dot(on.from - other.from), rise = normal.dot(on.along);
    Stretch stretch{0, on.length};
    const auto limit = [&](double first, double last) {
      stretch = {std::max(stretch.first, first), std::min(stretch.second, last)};
    };
    if (rise != 0) {
      const double at = -height / rise, way = near / std::abs(rise);
      limit(at - way, at + way);
    } else if (std::abs(height) > near) {
      return std::nullopt;
    }
    const auto beside = [&](double way) { return on.along.dot(other.from + way * other.along - on.from); };
    if (!(other.borders.first <= other.borders.second)) return std::nullopt;
    const double one_end = beside(other.borders.first), other_end = beside(other.borders.second);
    limit(std::min(one_end, other_end) - near, std::max(one_end, other_end) + near);
    limit(on.borders.first - near, on.borders.second + near);
    if (!(stretch.first <= stretch.second)) return std::nullopt;
    return stretch;
  }

  static double deepest(const MovingLine& on, const Stretch& stretch) {
    return std::max(on.depth_at(stretch.first), on.depth_at(stretch.second));
  }

  /// Of the speeds to one side, of points of two lines side by side.
  static Speeds difference(const MovingLine& on, const Stretch& stretch, const MovingLine& other) {
    const double sign = on.along.dot(other.along) < 0 ? -1 : 1;
    const auto at = [&](double way) -> Speeds {
      const Eigen::Vector2d x = on.from + way * on.along;
      return (on.speed_at(way) - sign * other.speed_at(other.along.dot(x - other.from))).abs();
    };
    return at(stretch.first).max(at(stretch.second));
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
                                  const ClippedBounds::OfElement& bound, const MasterView& view) {
  return ErrorSum(question, element, bound, view).total();
}

PartGrowth greatest_part_growth(const Question& question, const reference::Element& element,
                                const ClippedBounds::OfElement& bound, const MasterView& view) {
  return ErrorSum(question, element, bound, view).greatest();
}

}  // namespace pcm::compare
