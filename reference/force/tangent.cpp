// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/force/tangent.h"

#include <algorithm>
#include <cmath>

#include "reference/force/law.h"
#include "reference/numbers/correct_rounding.h"
#include "reference/numbers/double_double.h"
#include "reference/numbers/dual.h"

namespace pcm::reference {
namespace {

/// Enclosures are narrow enough where they are narrower than this part of the elements' own slopes, added up.
constexpr double kNarrow = 0x1p-70;

/// Of a force or torque, and how large those of the elements are, added up.
template <class T>
struct Slope {
  Vec3<T> sum;
  double size = 0;

  void add(const Vec3<Dual<T>>& x) {
    sum = sum + Vec3<T>{x.x.slope, x.y.slope, x.z.slope};
    size += std::max(
        {std::abs(x.x.slope.nearby().value), std::abs(x.y.slope.nearby().value), std::abs(x.z.slope.nearby().value)});
  }
};

template <class T>
struct LoadSlope {
  Slope<T> force, torque;
};

/// The derivative by the coordinate of the field.
template <class T>
LoadSlope<T> slope_of(const std::vector<ForceQuestion>& masters, const Field<Dual<T>>& field) {
  const T zero = field.number(0.0);
  const Dual<T> share = field(masters.size() == 2 ? 0.5 : 1.0);
  LoadSlope<T> slope{{{zero, zero, zero}}, {{zero, zero, zero}}};
  for (const ForceQuestion& master : masters) {
    ConvertedPose<Dual<T>> pose(master.pose, field);
    const State<Dual<T>> state = state_of(master.pose.pose(), master.velocity, field);
    for (std::size_t i = 0; i < master.elements.size(); ++i) {
      const ElementLoad<Dual<T>> load =
          load_of(master.elements.geometry(i, pose), master.elements.pair(i).master, master.law, state, field);
      const Vec3<Dual<T>> on_E = share * (load.force + sqrt(load.speed_squared) * load.drag);  // (21)
      slope.force.add(on_E);                                                                   // (23)
      slope.torque.add(cross(load.arm, on_E));                                                 // (22), (24)
    }
  }
  return slope;
}

/// False where an enclosure is not narrow.
template <class T>
bool enclose(const Slope<T>& slope, int first_row, int column, Tangent& tangent) {
  double widest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const NearDouble nearby = slope.sum[axis].nearby();
    tangent.slope(first_row + axis, column) = nearby.value + 0.0;  // no -0
    tangent.error(first_row + axis, column) = nearby.error;
    // The error of a double is its own.
    widest = std::max(widest, nearby.error - 0x1p-53 * std::abs(nearby.value));
  }
  return widest <= kNarrow * slope.size;
}

template <class T>
bool enclose_all(const std::vector<ForceQuestion>& masters, const Field<T>& field, Tangent& tangent) {
  bool narrow = true;
  for (int column = 0; column < 12; ++column) {
    const LoadSlope<T> slope =
        slope_of(masters, Field<Dual<T>>{field, {static_cast<Coordinate::Of>(column / 3), column % 3}});
    const bool forces = enclose(slope.force, 0, column, tangent), torques = enclose(slope.torque, 3, column, tangent);
    narrow = narrow && forces && torques;
  }
  return narrow;
}

}  // namespace

Tangent tangent_of(const std::vector<ForceQuestion>& masters) {
  Tangent tangent;
  if (!enclose_all(masters, Field<DoubleDouble>{}, tangent))
    enclose_all(masters, Field<Ball>{kRoundingPrecision}, tangent);
  return tangent;
}

}  // namespace pcm::reference
