// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "reference/elements/barycentric_elements.h"
#include "reference/elements/element_geometry.h"
#include "reference/numbers/ball.h"
#include "reference/numbers/double_double.h"
#include "reference/numbers/dual.h"
#include "reference/numbers/radical_sum.h"
#include "reference/pose/converted_pose.h"

namespace pcm::reference {

/// The contact elements that one master carries in one pose, as the force law sees them, of either scheme: faces, and
/// geometry both enclosed and, out of rational points, exact. Ordered by master face, then slave face.
class ElementSource {
 public:
  virtual ~ElementSource() = default;
  virtual std::size_t size() const = 0;
  virtual ElementPair pair(std::size_t i) const = 0;
  virtual ElementGeometry<DoubleDouble> geometry(std::size_t i, ConvertedPose<DoubleDouble>& pose) const = 0;
  virtual ElementGeometry<Ball> geometry(std::size_t i, ConvertedPose<Ball>& pose) const = 0;
  virtual ElementGeometry<Quadratic> geometry(std::size_t i, ConvertedPose<Rational>& pose) const = 0;
  /// With its derivative by the coordinate of the pose's field.
  virtual ElementGeometry<Dual<DoubleDouble>> geometry(std::size_t i,
                                                       ConvertedPose<Dual<DoubleDouble>>& pose) const = 0;
  virtual ElementGeometry<Dual<Ball>> geometry(std::size_t i, ConvertedPose<Dual<Ball>>& pose) const = 0;
  /// The length of the border of the part of the master face that is the element, m; 0 for the barycentre's.
  virtual DoubleDouble perimeter(std::size_t i, ConvertedPose<DoubleDouble>& pose) const = 0;
  virtual Ball perimeter(std::size_t i, ConvertedPose<Ball>& pose) const = 0;
  virtual RadicalSum perimeter(std::size_t i, ConvertedPose<Rational>& pose) const = 0;
};

/// Elements of the barycentric scheme: whole master faces, seen from their barycentres (8), (11). The pairs must
/// outlive this.
class BarycentricElements final : public ElementSource {
 public:
  explicit BarycentricElements(const std::vector<ElementPair>& pairs) : pairs_(pairs) {}
  std::size_t size() const override { return pairs_.size(); }
  ElementPair pair(std::size_t i) const override { return pairs_[i]; }
  ElementGeometry<DoubleDouble> geometry(std::size_t i, ConvertedPose<DoubleDouble>& pose) const override;
  ElementGeometry<Ball> geometry(std::size_t i, ConvertedPose<Ball>& pose) const override;
  ElementGeometry<Quadratic> geometry(std::size_t i, ConvertedPose<Rational>& pose) const override;
  ElementGeometry<Dual<DoubleDouble>> geometry(std::size_t i, ConvertedPose<Dual<DoubleDouble>>& pose) const override;
  ElementGeometry<Dual<Ball>> geometry(std::size_t i, ConvertedPose<Dual<Ball>>& pose) const override;
  DoubleDouble perimeter(std::size_t, ConvertedPose<DoubleDouble>& pose) const override { return pose.number(0.0); }
  Ball perimeter(std::size_t, ConvertedPose<Ball>& pose) const override { return pose.number(0.0); }
  RadicalSum perimeter(std::size_t, ConvertedPose<Rational>&) const override { return {}; }

 private:
  const std::vector<ElementPair>& pairs_;
};

}  // namespace pcm::reference
