// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compare/known_answers/known_answers.h"
#include "pcm/triangle_mesh.h"

/// What is varied, one thing at a time, while all else stays: icospheres of radius 1 m, of size 2 m therefore, their
/// centres half a size off the origins of their frames (about its centre a sphere has hardly a torque), the drawn
/// feature of F below the barycentre of a face of E (feature_pose.h). Every change along a sweep is exact in doubles,
/// so that what the table shows is no error of the meshes.
namespace pcm::compare::stability {

enum class Sweep : std::uint8_t {
  offset,  ///< of either body from the origin of its frame, in sizes; vertices are multiples of 2^-8 m, so that all of
           ///< them are there still at 2^44 sizes
  scale,   ///< of all lengths
  aspect,  ///< of both bodies, and of their faces, stretched along the x axes of their frames
  depth,   ///< of a face of F in a face of E, nearly parallel, in sizes
  vertex,  ///< depth of a vertex of F below the barycentre of a face of E, in sizes. The barycentric scheme's line goes
           ///< through the vertex, so that an ulp tells which face it leaves through: all of its poses are flipped
  faces,   ///< of either body: icospheres of 20 to 20,480 faces
};

inline constexpr std::array kSweeps = {Sweep::offset, Sweep::scale,  Sweep::aspect,
                                       Sweep::depth,  Sweep::vertex, Sweep::faces};

/// A word for file names and columns.
std::string_view name(Sweep sweep);
/// What is varied, in words, for the axis of a plot.
std::string_view title(Sweep sweep);

/// One value of a sweep: a power of two, or a level of subdivision of the sweep `faces`.
struct SweepPoint {
  Sweep sweep = Sweep::offset;
  int step = 0;  ///< exponent of two, or level

  double parameter() const;  ///< what the plots have on their axis, a ratio or a count
  std::string in_words() const;
};

/// In the order of the tables.
std::vector<SweepPoint> sweep_points(Sweep sweep, Extent extent);

/// What of F lies in the middle of a face of E.
enum class Feature : std::uint8_t { face, vertex };

/// The two bodies at one value of a sweep. A pose is drawn for `E` and `F`; both and the position are multiplied by
/// `scale` then, a power of two: so the poses of the sweep `scale` are the same but for that, bit for bit.
struct SweptBodies {
  TriangleMesh E;
  TriangleMesh F;
  Feature feature = Feature::face;
  double depth = 0;  ///< of the drawn point of F below the face of E, m
  double scale = 1;
};

SweptBodies bodies_at(const SweepPoint& point);

/// All vertices times a power of two, exactly, short of underflow.
TriangleMesh scaled(TriangleMesh mesh, double factor);

}  // namespace pcm::compare::stability
