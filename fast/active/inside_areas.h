// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "fast/active/active_areas.h"
#include "fast/crossings/polygons.h"
#include "fast/simd/face_lanes.h"

namespace pcm::fast {

/// The areas of either surface inside the other body, which PCM section 5 calls clipped active areas, and the volume
/// between them.
struct InsideAreas {
  std::array<double, 2> area{};                                                                     ///< m^2
  std::array<Eigen::Vector3d, 2> vector_area_Me{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< m^2
  Index undefined = 0;  ///< intersected faces in which a border of the other surface ends: their area counts as 0
  bool has_volume = false;
  double volume = 0;  ///< m^3
};

/// The part of one intersected face inside the other body, as its area is summed up.
struct InsidePart {
  Eigen::Vector3d origin_Me = Eigen::Vector3d::Zero();
  Eigen::Vector3d twice_vector_area_Me = Eigen::Vector3d::Zero();
  bool started = false;
  bool undefined = false;  ///< a border of the other surface ends inside the face
};

/// Scratch memory of measure_inside_areas.
struct InsideAreaScratch {
  std::vector<InsidePart> parts;
  FastClearArray<Index> slot;  ///< by face: its place among the intersected ones
  ElementLanes lanes;
};

/// Computes these areas and the volume between them. The crossings must be located and listed by edge.
/// Area and vector area of a face are exact but for roundings of a few ulps of the lengths of its patch's edges times
/// the face's size.
InsideAreas measure_inside_areas(PosedPair& posed, const Crossings& crossings, const PolygonChains& chains,
                                 const ActiveAreas& areas, InsideAreaScratch& scratch);

}  // namespace pcm::fast
