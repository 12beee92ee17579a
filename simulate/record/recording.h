// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// What a run leaves behind to be looked at: plain data. SI units; W is the world's frame, z upwards.
namespace pcm::simulate {

struct RecordedSurface {
  std::string name;
  TriangleMesh mesh;                     ///< in the surface's frame S
  std::array<std::uint8_t, 3> colour{};  ///< red, green, blue (sRGB)
};

/// A contact element: a face of a pairing's master surface under pressure. A face may carry several.
struct RecordedElement {
  Index pairing = 0;
  Side master = Side::E;
  Index face = 0;       ///< of the master's surface
  double pressure = 0;  ///< Pa
};

/// The force of a contact as one arrow.
struct RecordedContact {
  Index pairing = 0;
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();  ///< where the force acts, m
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();     ///< on body E, N
};

/// The scene at one instant.
struct Frame {
  double t = 0;               ///< s
  std::vector<Pose> poses_W;  ///< one for each surface: x_W = A x_S + r
  std::vector<RecordedElement> elements;
  std::vector<RecordedContact> contacts;
};

/// A quantity over time, at instants of its own. Series of one `plot` share axes.
struct Series {
  std::string name, unit, plot;
  std::vector<double> t, value;  ///< equally many; a value that is not finite is a gap
  bool logarithmic = false;      ///< the plot's axis is, if that of any of its series is
};

struct RecordedPairing {
  std::string name;
  Index surface_E = 0, surface_F = 0;
};

struct Recording {
  std::string title;
  std::vector<RecordedSurface> surfaces;
  std::vector<RecordedPairing> pairings;
  std::vector<Frame> frames;  ///< at ascending times, not necessarily at equal distances
  std::vector<Series> series;
};

}  // namespace pcm::simulate
