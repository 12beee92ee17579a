// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <map>
#include <optional>

#include "tests/reference/brute_force/scene.h"

namespace pcm::brute_force {

/// An edge of one surface passes through a face of the other.
struct Crossing {
  Side edge_side = Side::E;
  Edge edge{};
  Index face = 0;

  friend auto operator<=>(const Crossing&, const Crossing&) = default;
};

/// An intersection polygon in the circulation of (5); a closed one starts at its smallest crossing.
struct Polygon {
  bool closed = true;
  std::vector<Crossing> points;
  Index patch = 0;
};

/// How much of a face is inside the other surface, as fractions of the face's area. Faces of the other surface in the
/// face's own plane are the difference between its bounds.
struct Share {
  Rational below = 0;     ///< inside, of the face moved into its own body by a vanishing distance
  Rational equal = 0;     ///< covered by coplanar faces of the same normal: part of `below`
  Rational opposite = 0;  ///< covered by coplanar faces of opposite normal: not part of `below`
  Rational perturbed =
      0;            ///< inside, of the face moved by the tie rule (PCM section 5); open surfaces have only this one
  Vector moment{};  ///< integral of x over what `below` measures, divided by the face's area
  Vector equal_moment{};
};

struct ActiveArea {
  std::vector<Index> intersected;  ///< ascending
  std::vector<Index> inner;        ///< ascending
  std::vector<Share> shares;       ///< of every face
  double open = 0;                 ///< m^2, coplanar overlaps left out
  double closed = 0;               ///< m^2, coplanar overlaps counted in
  double area = 0;                 ///< m^2, opposite overlaps in neither surface's area, equal ones in E's
  std::array<double, 3> vector_area{};
  double perturbed_area = 0;  ///< m^2, overlaps as the tie rule has them
  std::array<double, 3> perturbed_vector_area{};
  Vector exact_vector_area{};  ///< of `area`, in units^2
};

/// A contact element of either scheme.
struct Element {
  Side master = Side::E;
  Index master_face = 0;
  Index slave_face = 0;
  Rational q;              ///< u_k = q |N|; clipped scheme: clamped point by point, to 200 digits where it is
  Rational alpha;          ///< A_k = alpha |N|
  Rational q_greatest;     ///< of all points of the element, before clamping
  Vector foot;             ///< what C_k (13) is measured from, in units
  Rational perimeter = 0;  ///< of the part of the master face, to 128 bits, in units; barycentric scheme: 0
};

struct Answer {
  Scene scene;
  std::map<Crossing, Vector> positions;  ///< in units
  bool touching = false;
  bool nested = false;
  bool ambiguous = false;
  std::vector<Polygon> polygons;
  Index patches = 0;
  Index undefined_areas = 0;  ///< faces that a border of the other surface ends in: no area is defined there
  ActiveArea E;
  ActiveArea F;
  std::optional<double> volume;            ///< of `area`
  std::optional<double> perturbed_volume;  ///< of `perturbed_area`
  std::array<Rational, 3> fluxes;          ///< of x n_x, y n_y, z n_z over both areas, in units^3: all equal the volume
  std::vector<Element> elements;           ///< by master (E first), then master face, then slave face
  Index too_deep = 0;

  const ActiveArea& active(Side side) const { return side == Side::E ? E : F; }
};

}  // namespace pcm::brute_force
