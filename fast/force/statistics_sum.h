// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "pcm/contact.h"

namespace pcm::fast {

/// Summary over elements (PCM section 9), element by element in their order; all zero where there is none.
class StatisticsSum {
 public:
  void add(const Element& element) {
    sums_.patch_area += element.area;
    volume_ += element.area * element.penetration;
    force_ += element.normal_force;
    moment_Me_ += element.normal_force * element.position_Me;
    if (element.area > 0) sums_.max_pressure = std::max(sums_.max_pressure, element.normal_force / element.area);
    sums_.max_normal_velocity = std::max(sums_.max_normal_velocity, std::abs(element.normal_velocity));
    sums_.max_tangential_velocity = std::max(sums_.max_tangential_velocity, element.tangential_velocity);
  }

  Statistics result() const {
    Statistics statistics = sums_;
    if (sums_.patch_area > 0) {
      statistics.mean_penetration = volume_ / sums_.patch_area;
      statistics.mean_pressure = force_ / sums_.patch_area;
    }
    if (force_ > 0) statistics.centre_of_pressure_Me = moment_Me_ / force_;
    return statistics;
  }

 private:
  Statistics sums_;
  double volume_ = 0, force_ = 0;
  Eigen::Vector3d moment_Me_ = Eigen::Vector3d::Zero();
};

}  // namespace pcm::fast
