// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/sliver_slopes.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/bounds/element_law.h"
#include "reference/numbers/dual.h"

namespace pcm::compare {
namespace {

using Of = reference::Coordinate::Of;

/// Products of areas, depths and levers leave the range of double where a pair is small, and what they are divided by
/// is as small: the bound would be lost on the way.
using Wide = long double;
static_assert(std::numeric_limits<Wide>::min_exponent < 8 * std::numeric_limits<double>::min_exponent);

/// a / b for bounds, b >= 0: nothing is nothing, whatever it is divided by.
Wide quotient(Wide a, Wide b) {
  return a == 0 ? 0 : b > 0 ? a / b : std::numeric_limits<Wide>::infinity();
}

/// Greatest values, of the oracle's sliver or a right engine's.
class SliverLoad {
 public:
  SliverLoad(const Question& question, const reference::Element& e, const ClippedBounds::OfElement& bound)
      : law_(question.law),
        on_E_(e.master == Side::E),
        stiffness_(series_stiffness(law_)),
        area_(Wide{e.area} + bound.bounds.area),
        depth_(std::min(std::max(bound.sight.deepest, e.greatest_penetration), law_.max_penetration)),
        width_(bound.sight.width),
        shift_(share_of_penetration(law_, e.master)),
        lever_((e.position_Me - question.pose.r).stableNorm() + bound.bounds.position + depth_),
        v_(question.velocity.v.stableNorm()),
        w_(question.velocity.w.stableNorm()),
        speed_(v_ + times(w_, lever_)) {}

  struct Slopes {
    double force, torque;
  };

  /// By a coordinate with which area and volume grow by no more than this.
  Slopes by(Of of, Wide d_area, Wide d_volume) const {
    const Wide u_d = law_.transition_depth;
    const Wide faded_area = u_d > 0 ? std::min(area_, area_ * depth_ / u_d) : area_;
    const Wide d_faded_area = u_d > 0 ? std::max(d_area, quotient(d_volume, u_d)) : d_area;
    // V times the way of C_k, and A f times that.
    const Wide way = 2 * times(width_, d_volume) + times(shift_ * depth_, d_volume + times(depth_, d_area));
    const Wide faded_way = quotient(way, u_d);

    const Wide d_v = rate_of_velocity(of);
    const Wide normal = stiffness_ * area_ * depth_ + law_.damping * faded_area * speed_;
    const Wide d_normal =
        stiffness_ * d_volume +
        times(law_.damping, times(speed_, d_faded_area) + times(faded_area, d_v) + times(w_, faded_way));
    const Wide normal_times_way = stiffness_ * way + times(law_.damping, times(speed_, faded_way));
    const Wide d_slip = times(normal, d_v) + times(w_, normal_times_way);
    const Wide friction = times(law_.friction, d_normal + quotient(2 * d_slip, law_.slip_velocity));

    const Wide all = 1 + Wide{law_.friction};
    Wide force = d_normal + friction, torque = all * normal_times_way;
    // Seen from F, force and torque turn with it; seen from E, the arm from Mf changes.
    if (!on_E_ && of == Of::rotation) force += all * normal;
    if (on_E_ && of == Of::position) torque += all * normal;
    torque += times(lever_, force);
    return {rounded_up(force), rounded_up(torque)};
  }

 private:
  /// Whatever is that small is a multiple of the least double on either side.
  static double rounded_up(Wide bound) {
    return static_cast<double>(kHigherOrder * bound) + std::numeric_limits<double>::denorm_min();
  }

  /// Of v_k at a point that stays where it is.
  Wide rate_of_velocity(Of of) const {
    if (of == Of::position) return on_E_ ? w_ : 0;
    if (of == Of::rotation) return on_E_ ? 0 : speed_;
    return of == Of::velocity ? 1 : lever_;
  }

  const ContactLaw& law_;
  bool on_E_;
  Wide stiffness_;
  Wide area_, depth_, width_;
  Wide shift_, lever_;
  Wide v_, w_, speed_;
};

}  // namespace

GreatestSlopes greatest_slopes_of_sliver(const Question& question, const reference::Element& element,
                                         const ClippedBounds::OfElement& bound, const PartGrowth& growth) {
  const SliverLoad load(question, element, bound);
  GreatestSlopes greatest;
  for (std::size_t k = 0; k < greatest.force.size(); ++k) {
    const Of of = static_cast<Of>(k / 3);
    const bool moves = of == Of::position || of == Of::rotation;
    const auto column = static_cast<Eigen::Index>(k);
    const SliverLoad::Slopes slopes = load.by(of, moves ? growth.area[column] : 0, moves ? growth.volume[column] : 0);
    greatest.force[k] = slopes.force;
    greatest.torque[k] = slopes.torque;
  }
  return greatest;
}

}  // namespace pcm::compare
