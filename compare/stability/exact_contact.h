// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "pcm/contact.h"
#include "reference/active/inside_areas.h"
#include "reference/combinatorics/combinatorics.h"
#include "reference/elements/clipped_elements.h"
#include "reference/numbers/ball.h"
#include "reference/pose/exact_pose.h"

/// Answers of the exact problem as numbers of many bits rather than doubles, so that the difference of two that agree
/// to all digits of a double is still known to all of its own.
namespace pcm::compare::stability {

/// What errors and movements are told of.
enum class Quantity : std::uint8_t {
  force,        ///< on E; relative to the sum of |F_k|
  torque,       ///< on E about Mf; relative to the sum of |C_k - r| |F_k|
  area,         ///< of E inside F; relative to itself
  penetration,  ///< the greatest; relative to itself
};
inline constexpr std::array kQuantities = {Quantity::force, Quantity::torque, Quantity::area, Quantity::penetration};

std::string_view name(Quantity quantity);

/// A figure for each quantity.
using Figures = std::array<double, kQuantities.size()>;

/// The law of all poses: elastic, c_l = 1 N/m^3, both layers equal; E is the master.
ContactLaw stability_law();

/// An answer: enclosures of its numbers.
struct Values {
  reference::Vec3<reference::Ball> force_Me;   ///< N
  reference::Vec3<reference::Ball> torque_Me;  ///< N m
  reference::Ball area;                        ///< m^2
  reference::Ball penetration;                 ///< m
};

/// Of an answer in doubles, which must be finite.
Values values_of(const fast::Contact& contact, mpfr_prec_t precision);

/// What errors of force and torque are relative to, N, N m: the sums of |F_k| and of |C_k - r| |F_k|.
struct Scales {
  reference::Ball force;
  reference::Ball torque;
};

/// The two bodies as the oracle has them.
struct ExactBodies {
  ExactBodies(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : E(reference::make_surface(mesh_E)), F(reference::make_surface(mesh_F)) {}
  reference::Surface E;
  reference::Surface F;
};

/// A problem of one pose and scheme, the exact one where nothing else is said, solved by the steps of the oracle. For
/// one thread.
class ExactContact {
 public:
  /// The bodies must outlive this.
  ExactContact(const ExactBodies& bodies, const Pose& pose, Scheme scheme,
               reference::Problem problem = reference::Problem::exact);
  ExactContact(const ExactContact&) = delete;
  ExactContact& operator=(const ExactContact&) = delete;

  /// Whether there is a contact element.
  bool carries_force() const { return source_->size() > 0; }
  /// (master face, slave face) of each element, ascending.
  std::vector<std::array<Index, 2>> elements() const;

  /// Enclosures computed with so many bits; kept.
  const Values& values(mpfr_prec_t precision);
  const Scales& scales(mpfr_prec_t precision);
  /// Force, torque, area and penetration as Figures are relative to; rounded.
  Figures sizes();

 private:
  struct Computed {
    Values values;
    Scales scales;
  };
  const Computed& computed(mpfr_prec_t precision);

  reference::ExactPose pose_;
  reference::Combinatorics found_;
  reference::InsideAreas areas_;
  reference::ElementPairs pairs_;
  reference::ClippedFindings clipped_;
  std::unique_ptr<const reference::ElementSource> source_;
  std::map<mpfr_prec_t, Computed> computed_;
};

/// Length of the difference of each quantity, N, N m, m^2, m: correctly rounded but where it is less than 2^-200 of the
/// quantity's size, which counts as 0. Precision rises until it is known.
Figures differences(ExactContact& truth, const fast::Contact& contact);
Figures differences(ExactContact& truth, ExactContact& other);

}  // namespace pcm::compare::stability
