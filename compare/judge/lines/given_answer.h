// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/poses/crossing_pairs.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// What somebody's engine says about a pose: any subset of these facts, conventions as in docs/judge.md. What it does
/// not know is empty.
namespace pcm::compare {

struct GivenElement {
  Side master = Side::E;
  Index master_face = 0;
  Index slave_face = 0;
  std::optional<double> area;         ///< A_k (6), m^2
  std::optional<double> penetration;  ///< u_k (11), m, clamped
};

/// The contact on one of the surfaces.
struct GivenArea {
  std::optional<std::vector<Index>> intersected;  ///< ascending, as all faces here
  std::optional<std::vector<Index>> inner;
  std::optional<std::vector<Index>> active;  ///< both together, for engines that don't tell one from the other
  std::optional<double> area;                ///< clipped active area, m^2
};

struct GivenAnswer {
  std::optional<bool> touching;
  std::optional<std::vector<FacePair>> crossing_pairs;  ///< ascending
  GivenArea E;
  GivenArea F;
  std::optional<std::int64_t> polygons;
  std::optional<std::int64_t> closed_polygons;
  std::optional<double> volume;                       ///< m^3
  std::optional<std::int64_t> element_count;          ///< in place of `elements`
  std::optional<std::vector<GivenElement>> elements;  ///< by master (E first), then master face, then slave face
  std::optional<Eigen::Vector3d> force_Me;            ///< on E, N
  std::optional<Eigen::Vector3d> torque_Me;           ///< on E about Mf, N m
};

}  // namespace pcm::compare
