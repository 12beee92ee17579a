// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fast/bounds/face_enclosure.h"

namespace pcm::fast {

/// Parts of a master face where the exact problem and what is computed may differ: along sides, borders and lines of
/// one depth, as wide as these may be off (fast/bounds/clipped_error.h).

/// An upper bound of the area within the box that two faces share in either problem: 0 where a side of one certainly
/// separates them (vertices of both count as on it), and where it does so nearly, the strip of that side's uncertainty.
double greatest_overlap(const FaceEnclosure& a, const FaceEnclosure& b, const BoxST& box);

/// What the sides of a face may pass over within the box: its area, and the integral there of the depth of the face
/// `carrier`; and whether one of them certainly has all of the box on its far side. Side k may be off by
/// face.side_error and by (s, t), and by roundings: of the cuts that shaped the face, or of those it makes in another
/// that carries.
struct SideStrips {
  double area = 0;
  double volume = 0;  ///< m
  bool apart = false;
};
SideStrips strips_along_sides(const FaceEnclosure& face, double s, double t, const FaceEnclosure& carrier,
                              const BoxST& box, const std::array<bool, 3>& sides = {true, true, true});

/// The area within the box that a face whose facing is not sure has in either problem, down to the greatest depth of
/// the carrier there, and the integral of that.
SideStrips sliver(const FaceEnclosure& face, const FaceEnclosure& carrier, double depth, const BoxST& box);

/// How far two linear functions, of which the areas between their zeros are asked, are from each other, and how far
/// either is from the one they are given by, which is rounded itself.
struct LineError {
  double apart, off;
};

/// The same for the line where the planes of two faces have one depth, or where `g` is at depth 0: within the box and
/// both faces.
struct LineStrip {
  double area = 0;
  double volume = 0;        ///< of the depth of f, m
  bool everywhere = false;  ///< nowhere in the box is the sign sure
};
LineStrip strip_along_line(const LinearDepth& function, const LineError& error, const FaceEnclosure& f,
                           const FaceEnclosure& g, const BoxST& box);

/// How far off the depth of g is, m, where another face of the given box is cut along g's line of depth 0; 0 where g
/// has no such line.
double roundings_of_depth(const FaceEnclosure& g, const BoxST& box);

/// The area within the box between the places where two linear functions are 0, both near the given one.
struct ZeroStrip {
  double area = 0;
  bool everywhere = false;  ///< nowhere in the box is its sign sure
};
ZeroStrip zero_strip(const LinearDepth& function, const LineError& error, const BoxST& box);
/// The area where a function lies within `error` of 0 beside those sides of a face, as near as they may be shifted.
double zero_strip_at_sides(const FaceEnclosure& face, const std::array<bool, 3>& sides, const LinearDepth& function,
                           double error, const BoxST& box);

}  // namespace pcm::fast
