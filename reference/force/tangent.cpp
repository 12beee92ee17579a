// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/force/tangent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "reference/force/law.h"
#include "reference/numbers/correct_rounding.h"
#include "reference/numbers/double_double.h"
#include "reference/numbers/dual.h"

namespace pcm::reference {
namespace {

/// Of a master's derivative by one coordinate, of force or torque, this part of what the elements' slopes amount to may
/// be left open: an element whose share of that is more is enclosed anew in many more bits. It is less than a hundredth
/// of what one rounding of all slopes makes.
constexpr double kNarrow = 0x1p-60;

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

/// A master's elements at the pose, in one kind of numbers, each when first asked for.
template <class T>
class Geometries {
 public:
  /// `master` has to outlive it.
  explicit Geometries(const ForceQuestion& master, const Field<T>& field = {})
      : elements_(master.elements), pose_(master.pose, field), known_(master.elements.size()) {}

  const ElementGeometry<T>& at(std::size_t i) {
    if (!known_[i]) known_[i] = elements_.geometry(i, pose_);
    return *known_[i];
  }

 private:
  const ElementSource& elements_;
  ConvertedPose<T> pose_;
  std::vector<std::optional<ElementGeometry<T>>> known_;
};

/// Of a coordinate that does not change it.
template <class T>
ElementGeometry<Dual<T>> unchanged(const ElementGeometry<T>& g, const Field<Dual<T>>& field) {
  const Vec3<T> zero = direction(-1, field.number);
  const auto number = [&](const T& x) { return Dual<T>{x, zero.x}; };
  return {with_slope(g.N, zero), with_slope(g.slave_N, zero), number(g.alpha),
          number(g.q),           number(g.q_greatest),        with_slope(g.foot, zero)};
}

/// What elements add to the derivative by the coordinate of the field.
template <class T>
class ElementSlopes {
 public:
  /// `master` and `geometries` have to outlive it.
  ElementSlopes(const ForceQuestion& master, Geometries<T>& geometries, const Field<Dual<T>>& field)
      : master_(master),
        geometries_(geometries),
        field_(field),
        pose_(master.pose, field),
        state_(state_of(master.pose.pose(), master.velocity, field)) {}

  LoadSlope<T> of_element(std::size_t i, ElementMotion& motion) {
    const Side side = master_.elements.pair(i).master;
    const bool moves =
        field_.coordinate.of == Coordinate::Of::position || field_.coordinate.of == Coordinate::Of::rotation;
    const ElementLoad<Dual<T>> load =
        load_of(moves ? master_.elements.geometry(i, pose_) : unchanged(geometries_.at(i), field_), side, master_.law,
                state_, field_);
    if (moves) note_motion(load, side, field_, motion);
    const Vec3<Dual<T>> on_E = load.force + sqrt(load.speed_squared) * load.drag;  // (21)
    const Vec3<Dual<T>> torque = cross(load.arm, on_E);                            // (22)
    return {{on_E.x.slope, on_E.y.slope, on_E.z.slope}, {torque.x.slope, torque.y.slope, torque.z.slope}};
  }

 private:
  const ForceQuestion& master_;
  Geometries<T>& geometries_;
  Field<Dual<T>> field_;
  ConvertedPose<Dual<T>> pose_;
  State<Dual<T>> state_;
};

/// How large one of its components surely is, and how wide the enclosure of one of them.
struct Extent {
  double least = 0, radius = 0;

  explicit Extent(const Vec3<DoubleDouble>& x) {
    for (int axis = 0; axis < 3; ++axis) {
      const NearDouble nearby = x[axis].nearby();
      radius = std::max(radius, x[axis].radius());
      if (nearby.error < std::abs(nearby.value)) least = std::max(least, std::abs(nearby.value) - nearby.error);
    }
  }
};

Vec3<DoubleDouble> in_doubles(const Vec3<Ball>& x) {
  const auto number = [](const Ball& y) {
    const double high = y.nearby().value;
    return DoubleDouble::near(high, (y - Ball(high, kRoundingPrecision)).nearby());
  };
  return {number(x.x), number(x.y), number(x.z)};
}

/// The derivative by one coordinate of what each element of a master adds.
std::vector<LoadSlope<DoubleDouble>> slopes_of(const ForceQuestion& master, Geometries<DoubleDouble>& shortly,
                                               Geometries<Ball>& finely, Coordinate coordinate,
                                               std::vector<ElementMotion>& motions) {
  std::vector<LoadSlope<DoubleDouble>> slopes;
  double size_of_force = 0, size_of_torque = 0;
  ElementSlopes<DoubleDouble> in_two_doubles(master, shortly, {{}, coordinate});
  for (std::size_t i = 0; i < motions.size(); ++i) {
    slopes.push_back(in_two_doubles.of_element(i, motions[i]));
    size_of_force += Extent(slopes.back().force).least;
    size_of_torque += Extent(slopes.back().torque).least;
  }
  const double part = kNarrow / static_cast<double>(slopes.size());
  std::optional<ElementSlopes<Ball>> in_many_bits;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (Extent(slopes[i].force).radius <= part * size_of_force &&
        Extent(slopes[i].torque).radius <= part * size_of_torque)
      continue;
    if (!in_many_bits) in_many_bits.emplace(master, finely, Field<Dual<Ball>>{{kRoundingPrecision}, coordinate});
    const LoadSlope<Ball> slope = in_many_bits->of_element(i, motions[i]);
    slopes[i] = {in_doubles(slope.force), in_doubles(slope.torque)};
  }
  return slopes;
}

LoadSlope<DoubleDouble> no_slope() {
  const DoubleDouble zero(0.0);
  return {{zero, zero, zero}, {zero, zero, zero}};
}

}  // namespace

MasterTangent::MasterTangent(const ForceQuestion& question) : elements(question.elements.size()) {
  Geometries<DoubleDouble> shortly(question);
  Geometries<Ball> finely(question, {kRoundingPrecision});
  for (int column = 0; column < 12; ++column) {
    const Coordinate coordinate{static_cast<Coordinate::Of>(column / 3), column % 3};
    LoadSlope<DoubleDouble> sum = no_slope();
    for (const LoadSlope<DoubleDouble>& slope : slopes_of(question, shortly, finely, coordinate, elements))
      sum = {sum.force + slope.force, sum.torque + slope.torque};  // (23), (24)
    by_coordinate.push_back(sum);
  }
}

Tangent tangent_of(const std::vector<const MasterTangent*>& masters) {
  Tangent tangent;
  const DoubleDouble share(masters.size() == 2 ? 0.5 : 1.0);
  for (const MasterTangent* const master : masters)
    tangent.elements.insert(tangent.elements.end(), master->elements.begin(), master->elements.end());
  for (int column = 0; column < 12; ++column) {
    LoadSlope<DoubleDouble> sum = no_slope();
    for (const MasterTangent* const master : masters) {
      const LoadSlope<DoubleDouble>& slope = master->by_coordinate[static_cast<std::size_t>(column)];
      sum = {sum.force + share * slope.force, sum.torque + share * slope.torque};
    }
    for (int row = 0; row < 6; ++row) {
      const NearDouble nearby = (row < 3 ? sum.force[row] : sum.torque[row - 3]).nearby();
      tangent.slope(row, column) = nearby.value + 0.0;  // no -0
      tangent.error(row, column) = nearby.error;
    }
  }
  return tangent;
}

}  // namespace pcm::reference
