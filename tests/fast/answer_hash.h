// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "pcm/contact.h"

/// Hashes over every bit of answers.
namespace pcm::fast::test {

/// FNV-1a.
class Hash {
 public:
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
    }
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const Eigen::Vector3d& x) {
    for (int k = 0; k < 3; ++k) add(x[k]);
  }
  void add(Index i) { add(static_cast<std::uint64_t>(i)); }
  void add(bool b) { add(std::uint64_t{b}); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

inline void add(Hash& hash, const ActiveArea& area) {
  for (const Index face : area.intersected) hash.add(face);
  for (const Index face : area.inner) hash.add(face);
  hash.add(area.area);
  hash.add(area.vector_area_Me);
}

inline void add(Hash& hash, const Element& element) {
  hash.add(static_cast<std::uint64_t>(element.master));
  for (const Index face : {element.master_face, element.slave_face}) hash.add(face);
  for (const double x : {element.area, element.penetration, element.normal_velocity, element.tangential_velocity,
                         element.normal_force, element.tangential_force})
    hash.add(x);
  for (const Eigen::Vector3d& x : {element.normal_Me, element.position_Me, element.force_Me}) hash.add(x);
}

inline void add(Hash& hash, const Statistics& statistics) {
  for (const double x : {statistics.patch_area, statistics.mean_penetration, statistics.max_pressure,
                         statistics.mean_pressure, statistics.max_normal_velocity, statistics.max_tangential_velocity})
    hash.add(x);
  hash.add(statistics.centre_of_pressure_Me);
}

inline void add(Hash& hash, const ForceBound& bound) {
  hash.add(bound.force_Me);
  hash.add(bound.torque_Me);
  hash.add(bound.flipped);
  hash.add(bound.penetration_at_least);
  hash.add(bound.penetration_at_most);
}

inline void add(Hash& hash, const Tangent& tangent) {
  for (Eigen::Index row = 0; row < tangent.rows(); ++row) {
    for (Eigen::Index column = 0; column < tangent.cols(); ++column) hash.add(tangent(row, column));
  }
}

/// Where the surfaces cross.
inline void add_polygons(Hash& hash, const Contact& contact) {
  for (const Crossing& crossing : contact.crossings) {
    hash.add(static_cast<std::uint64_t>(crossing.edge_side));
    for (const Index i : {crossing.edge[0], crossing.edge[1], crossing.face}) hash.add(i);
    hash.add(crossing.position_Me);
  }
  for (const Polygon& polygon : contact.polygons) {
    hash.add(polygon.closed);
    for (const Index i : {polygon.first, polygon.count, polygon.patch}) hash.add(i);
  }
}

/// All but tangents and the work it took.
inline void add(Hash& hash, const Contact& contact) {
  for (const bool b : {contact.touching, contact.nested, contact.ambiguous, contact.has_volume,
                       contact.penetration_exceeded, contact.bound.has_value()})
    hash.add(b);
  add_polygons(hash, contact);
  add(hash, contact.E);
  add(hash, contact.F);
  for (const Index i : {contact.patches, contact.undefined_areas, contact.element_count, contact.too_deep}) hash.add(i);
  hash.add(contact.volume);
  for (const Element& element : contact.elements) add(hash, element);
  hash.add(contact.max_penetration);
  hash.add(contact.force_Me);
  hash.add(contact.torque_Me);
  add(hash, contact.statistics);
  if (contact.bound) add(hash, *contact.bound);
}

/// The answer's lists, which a hash over their entries alone would not keep apart.
inline void add_lengths(Hash& hash, const Contact& contact) {
  for (const std::size_t length :
       {contact.crossings.size(), contact.polygons.size(), contact.E.intersected.size(), contact.E.inner.size(),
        contact.F.intersected.size(), contact.F.inner.size(), contact.elements.size()})
    hash.add(std::uint64_t{length});
}

}  // namespace pcm::fast::test
