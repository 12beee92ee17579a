// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>

#include "fast/base/geometry.h"
#include "fast/predicates/penetration_predicates.h"

namespace pcm::fast {

/// How far what an element's force is made of may be from the exact problem's values (PCM section 1): the roundings of
/// the evaluation and those of F's vertices together. Either scheme fills it; fast/bounds/force_error.h makes bounds of
/// it.
struct ElementError {
  double area = 0;         ///< of A_k, m^2
  double penetration = 0;  ///< of u_k, m; before clamping, which never widens it, but 0 where u_k is surely clamped
  double mean = 0;         ///< u_k itself, where areas may pass, m
  /// Of A_k u_k, m^3, where that is known better than A_k and u_k say.
  double volume = std::numeric_limits<double>::infinity();
  /// What may pass between it and other elements of its master face (fast/bounds/repartition_error.h), m^2 and m^3: not
  /// part of the errors of area and volume, but of those of penetration and foot.
  double passed_area = 0;
  double passed_volume = 0;
  double normal = 0;                                  ///< length of the difference of n_k
  Eigen::Vector3d foot_Me = Eigen::Vector3d::Zero();  ///< of the point C_k is measured from, component by component, m
};

/// The errors of a FaceGeometry against the exact problem.
struct FaceError {
  double N = 0;                                             ///< length of the difference of N, at most, m^2
  double area = 0;                                          ///< m^2
  double normal = 0;                                        ///< length of the difference of n; 2 where n is unknown
  Eigen::Vector3d barycentre_Me = Eigen::Vector3d::Zero();  ///< component by component, m
  bool normal_known = false;  ///< N is known to a half of its length; otherwise n may point anywhere

  FaceError() = default;
  /// `rounding_Me`: how far each coordinate of the face's vertices may be from the exact problem's, 0 for E.
  FaceError(const FaceGeometry& face, const Eigen::Vector3d& rounding_Me);
};

/// A bound on the error of DepthBelow(master, f).value() against the exact problem, given that the exact problem's line
/// meets the exact problem's f there; infinite where the angle between line and face is not known well enough.
/// `rounding_Me` is F's, whichever of both faces it is that belongs to F. Condition: 1 / |n_e . n_f|.
double depth_error(const FaceGeometry& master, const FaceError& master_error, const FacePoints& f,
                   const Eigen::Vector3d& rounding_Me);

}  // namespace pcm::fast
