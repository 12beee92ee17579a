// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "pcm/contact.h"

namespace pcm::fast::test {

/// Whether two numbers are the same double, zeros' signs included.
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
}
inline bool same(const Crossing& a, const Crossing& b) {
  return a.edge_side == b.edge_side && a.edge == b.edge && a.face == b.face && same(a.position_Me, b.position_Me);
}
inline bool same(const Polygon& a, const Polygon& b) {
  return a.closed == b.closed && a.first == b.first && a.count == b.count && a.patch == b.patch;
}
inline bool same(const ActiveArea& a, const ActiveArea& b) {
  return a.intersected == b.intersected && a.inner == b.inner && same(a.area, b.area) &&
         same(a.vector_area_Me, b.vector_area_Me);
}
inline bool same(const Element& a, const Element& b) {
  return a.master == b.master && a.master_face == b.master_face && a.slave_face == b.slave_face &&
         same(a.area, b.area) && same(a.penetration, b.penetration) && same(a.normal_velocity, b.normal_velocity) &&
         same(a.tangential_velocity, b.tangential_velocity) && same(a.normal_force, b.normal_force) &&
         same(a.tangential_force, b.tangential_force) && same(a.normal_Me, b.normal_Me) &&
         same(a.position_Me, b.position_Me) && same(a.force_Me, b.force_Me);
}
inline bool same(const Statistics& a, const Statistics& b) {
  return same(a.patch_area, b.patch_area) && same(a.mean_penetration, b.mean_penetration) &&
         same(a.max_pressure, b.max_pressure) && same(a.mean_pressure, b.mean_pressure) &&
         same(a.max_normal_velocity, b.max_normal_velocity) &&
         same(a.max_tangential_velocity, b.max_tangential_velocity) &&
         same(a.centre_of_pressure_Me, b.centre_of_pressure_Me);
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

inline bool same(const ForceBound& a, const ForceBound& b) {
  return same(a.force_Me, b.force_Me) && same(a.torque_Me, b.torque_Me) && a.flipped == b.flipped &&
         same(a.penetration_at_least, b.penetration_at_least) && same(a.penetration_at_most, b.penetration_at_most);
}
inline bool same(const Tangent& a, const Tangent& b) {
  return std::equal(a.data(), a.data() + a.size(), b.data(), [](double x, double y) { return same(x, y); });
}
template <class T>
bool same(const std::optional<T>& a, const std::optional<T>& b) {
  return a && b ? same(*a, *b) : a.has_value() == b.has_value();
}
/// But for the work they took.
inline bool same(const Contact& a, const Contact& b) {
  return same(a.bound, b.bound) && same(a.tangent, b.tangent) && a.touching == b.touching && a.nested == b.nested &&
         a.ambiguous == b.ambiguous && same(a.crossings, b.crossings) && same(a.polygons, b.polygons) &&
         a.patches == b.patches && same(a.E, b.E) && same(a.F, b.F) && a.undefined_areas == b.undefined_areas &&
         a.has_volume == b.has_volume && same(a.volume, b.volume) && same(a.elements, b.elements) &&
         a.element_count == b.element_count && a.too_deep == b.too_deep && same(a.max_penetration, b.max_penetration) &&
         a.penetration_exceeded == b.penetration_exceeded && same(a.force_Me, b.force_Me) &&
         same(a.torque_Me, b.torque_Me) && same(a.statistics, b.statistics);
}

/// The same, and which of them differs where some do.
inline void expect_same_answer(const Contact& a, const Contact& b) {
  EXPECT_EQ(a.touching, b.touching);
  EXPECT_EQ(a.nested, b.nested);
  EXPECT_EQ(a.ambiguous, b.ambiguous);
  EXPECT_TRUE(same(a.crossings, b.crossings));
  EXPECT_TRUE(same(a.polygons, b.polygons));
  EXPECT_EQ(a.patches, b.patches);
  EXPECT_TRUE(same(a.E, b.E));
  EXPECT_TRUE(same(a.F, b.F));
  EXPECT_EQ(a.undefined_areas, b.undefined_areas);
  EXPECT_EQ(a.has_volume, b.has_volume);
  EXPECT_TRUE(same(a.volume, b.volume)) << a.volume << ' ' << b.volume;
  EXPECT_TRUE(same(a.elements, b.elements));
  EXPECT_EQ(a.element_count, b.element_count);
  EXPECT_EQ(a.too_deep, b.too_deep);
  EXPECT_TRUE(same(a.max_penetration, b.max_penetration));
  EXPECT_EQ(a.penetration_exceeded, b.penetration_exceeded);
  EXPECT_TRUE(same(a.force_Me, b.force_Me)) << a.force_Me.transpose() << " and " << b.force_Me.transpose();
  EXPECT_TRUE(same(a.torque_Me, b.torque_Me)) << a.torque_Me.transpose() << " and " << b.torque_Me.transpose();
  EXPECT_TRUE(same(a.statistics, b.statistics));
  ASSERT_EQ(a.bound.has_value(), b.bound.has_value());
  if (a.bound) {
    EXPECT_TRUE(same(*a.bound, *b.bound));
  }
  EXPECT_TRUE(same(a.tangent, b.tangent));
}

}  // namespace pcm::fast::test
