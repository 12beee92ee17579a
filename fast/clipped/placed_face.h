// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "fast/posed/posed_pair.h"
#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// A face in the prism together with its vertices in Me.
struct PlacedFace {
  const ProjectedFace& projected;
  std::array<Eigen::Vector3d, 3> points_Me;  ///< of `projected.vertices`, so counterclockwise as the master sees them
  const MasterPrism& prism;
  double max_coordinate;  ///< of the pose, m (Placement)

  /// Of its sides.
  Uncertainty uncertainty() const { return prism.uncertainty(projected.corners, max_coordinate); }
};

PlacedFace placed_face(PosedPair& posed, Side master, const MasterPrism& prism, const ProjectedFace& face);

/// Heights of the vertices of g over the plane of f, times twice the area of f and another factor > 0, their signs
/// exact. Above is where the lines come from: the vertices of f run counterclockwise as the master sees them.
std::array<double, 3> heights_over(const PlacedFace& f, const PlacedFace& g, WorkCounters& work);

/// Where a face lies along the lines, compared with another one.
enum class Order : std::uint8_t { before, after, crossing };

/// How g lies to f, exactly; `f_over_g`, the heights of f's vertices over g, is filled where they cross. Where the two
/// planes are one, the face of smaller index is before the other one of the slave, and none of the master before any of
/// the slave.
Order order_of(const PlacedFace& g, const PlacedFace& f, std::array<double, 3>& f_over_g, WorkCounters& work);

/// Whether a plane meets a face whose vertices lie at these heights over it in a line, not in a vertex alone.
bool meet_in_line(const std::array<double, 3>& heights);

}  // namespace pcm::fast
