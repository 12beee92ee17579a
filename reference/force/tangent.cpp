// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/force/tangent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

/// How the element moves with the coordinate of the field, of r or a turn.
template <class T>
void note_motion(const ElementLoad<Dual<T>>& load, Side master, const Field<Dual<T>>& field, ElementMotion& motion) {
  const auto [of, axis] = field.coordinate;
  const bool turns = of == Coordinate::Of::rotation;
  const auto slope_of = [](const Vec3<Dual<T>>& x) { return Vec3<T>{x.x.slope, x.y.slope, x.z.slope}; };
  Vec3<T> seen = slope_of(load.position);
  if (master == Side::F) {
    const Vec3<T> arm{load.arm.x.value, load.arm.y.value, load.arm.z.value};
    seen = slope_of(load.arm) - cross(direction(turns ? axis : -1, field.number), arm);
  }
  const std::array<T, 5> slopes{load.area.slope, load.penetration.slope, seen.x, seen.y, seen.z};
  for (std::size_t row = 0; row < slopes.size(); ++row) {
    const NearDouble nearby = slopes[row].nearby();
    motion.slope(static_cast<Eigen::Index>(row), (turns ? 3 : 0) + axis) = nearby.value + 0.0;  // no -0
    motion.error(static_cast<Eigen::Index>(row), (turns ? 3 : 0) + axis) = nearby.error;
  }
}

/// The derivative by the coordinate of the field.
template <class T>
LoadSlope<T> slope_of(const std::vector<ForceQuestion>& masters, const Field<Dual<T>>& field,
                      std::vector<ElementMotion>& elements) {
  const bool moves_elements =
      field.coordinate.of == Coordinate::Of::position || field.coordinate.of == Coordinate::Of::rotation;
  std::size_t element = 0;
  const T zero = field.number(0.0);
  const Dual<T> share = field(masters.size() == 2 ? 0.5 : 1.0);
  LoadSlope<T> slope{{{zero, zero, zero}}, {{zero, zero, zero}}};
  for (const ForceQuestion& master : masters) {
    ConvertedPose<Dual<T>> pose(master.pose, field);
    const State<Dual<T>> state = state_of(master.pose.pose(), master.velocity, field);
    for (std::size_t i = 0; i < master.elements.size(); ++i) {
      const ElementLoad<Dual<T>> load =
          load_of(master.elements.geometry(i, pose), master.elements.pair(i).master, master.law, state, field);
      if (moves_elements) note_motion(load, master.elements.pair(i).master, field, elements[element++]);
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
    const LoadSlope<T> slope = slope_of(
        masters, Field<Dual<T>>{field, {static_cast<Coordinate::Of>(column / 3), column % 3}}, tangent.elements);
    const bool forces = enclose(slope.force, 0, column, tangent), torques = enclose(slope.torque, 3, column, tangent);
    narrow = narrow && forces && torques;
  }
  return narrow;
}

}  // namespace

Tangent tangent_of(const std::vector<ForceQuestion>& masters) {
  Tangent tangent;
  std::size_t count = 0;
  for (const ForceQuestion& master : masters) count += master.elements.size();
  tangent.elements.resize(count);
  if (!enclose_all(masters, Field<DoubleDouble>{}, tangent))
    enclose_all(masters, Field<Ball>{kRoundingPrecision}, tangent);
  return tangent;
}

}  // namespace pcm::reference
