// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// What an engine can tell of a contact besides elements and force.
struct Knowledge {
  bool areas = true;  ///< clipped areas and the volume; what is nested, ambiguous or too deep
  bool faces = true;  ///< active faces and polygons
};

struct PolygonRecord {
  bool closed = true;
  Index patch = 0;
  std::vector<fast::Crossing> points;  ///< in the circulation of (5)
};

/// The active area on one surface.
struct AreaRecord {
  std::vector<Index> intersected, inner;  ///< faces, ascending
  std::optional<double> area;             ///< clipped, m^2; none where areas are not known
  std::optional<Eigen::Vector3d> vector_area_Me;
};

/// A contact with all that is told of it, in one form whoever answered, for files and tables. Vectors in Me, SI units;
/// the fields mean what those of fast::Contact do.
struct ContactRecord {
  Knowledge known;  ///< what is not known has its default value
  bool touching = false;
  bool nested = false;
  bool ambiguous = false;
  std::vector<PolygonRecord> polygons;
  Index patches = 0;
  AreaRecord E, F;
  std::optional<double> volume;  ///< m^3
  Index undefined_areas = 0;
  std::vector<fast::Element> elements;
  fast::Statistics statistics;
  Index too_deep = 0;
  double max_penetration = 0;  ///< m
  bool penetration_exceeded = false;
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on E about Mf, N m
};

ContactRecord contact_record(const fast::Contact& contact, const Knowledge& known);
/// Statistics are summed over the oracle's elements, in doubles.
ContactRecord contact_record(const reference::Answer& answer);

/// F_n / A_k, Pa; 0 where the area is.
double pressure(const fast::Element& element);

}  // namespace pcm::compare
