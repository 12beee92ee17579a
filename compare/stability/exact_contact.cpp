// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/exact_contact.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/active/area_values.h"
#include "reference/force/law.h"

namespace pcm::compare::stability {
namespace {

using reference::Ball;
using reference::Vec3;

/// Of the first enclosures, in bits; the greatest ones that are tried.
constexpr mpfr_prec_t kFirstPrecision = 384, kLastPrecision = 24576;

/// What counts as no difference, relative to the size.
constexpr double kNegligible = 0x1p-200;

using BallField = reference::Field<Ball>;

Ball length_of(const Vec3<Ball>& v) {
  return sqrt(dot(v, v));
}

Ball absolute(const Ball& x) {
  return sqrt(x * x);
}

std::optional<double> as_double(const Ball& x, const Ball& negligible) {
  if (const std::optional<double> rounded = x.rounded()) return rounded;
  if ((negligible - x).sign() == 1) return 0;
  return x.nearly_rounded();
}

using BallFigures = std::array<Ball, kQuantities.size()>;

std::optional<Figures> as_doubles(const BallFigures& x, const BallFigures& sizes, const BallField& field) {
  Figures doubles{};
  for (std::size_t k = 0; k < doubles.size(); ++k) {
    const std::optional<double> value = as_double(x[k], field(kNegligible) * sizes[k]);
    if (!value) return {};
    doubles[k] = *value;
  }
  return doubles;
}

BallFigures sizes_of(const Values& values, const Scales& scales) {
  return {scales.force, scales.torque, values.area, values.penetration};
}

/// The first precision that tells the answer.
Figures told(const std::function<std::optional<Figures>(mpfr_prec_t)>& figures_at) {
  for (mpfr_prec_t precision = kFirstPrecision; precision <= kLastPrecision; precision *= 4)
    if (const std::optional<Figures> figures = figures_at(precision)) return *figures;
  throw std::logic_error("a difference of exact answers that 24576 bits do not tell");
}

std::optional<Figures> differences_at(ExactContact& truth, const Values& other, mpfr_prec_t precision) {
  const Values& values = truth.values(precision);
  return as_doubles({length_of(other.force_Me - values.force_Me), length_of(other.torque_Me - values.torque_Me),
                     absolute(other.area - values.area), absolute(other.penetration - values.penetration)},
                    sizes_of(values, truth.scales(precision)), {precision});
}

}  // namespace

std::string_view name(Quantity quantity) {
  constexpr std::array<std::string_view, kQuantities.size()> kNames = {"force", "torque", "area", "penetration"};
  return kNames[static_cast<std::size_t>(quantity)];
}

ContactLaw stability_law() {
  ContactLaw law;
  law.stiffness = 1;
  return law;
}

Values values_of(const fast::Contact& contact, mpfr_prec_t precision) {
  const BallField field{precision};
  return {reference::converted(contact.force_Me, field), reference::converted(contact.torque_Me, field),
          field(contact.E.area), field(contact.max_penetration)};
}

ExactContact::ExactContact(const ExactBodies& bodies, const Pose& pose, Scheme scheme, reference::Problem problem)
    : pose_(problem, bodies.E, bodies.F, pose),
      found_(reference::find_combinatorics(pose_)),
      areas_(found_.inside_areas(pose_)) {
  if (scheme == Scheme::barycentric) {
    pairs_ = reference::find_elements(pose_, Side::E, found_);
    source_ = std::make_unique<reference::BarycentricElements>(pairs_.pairs);
  } else {
    clipped_ = reference::find_clipped_elements(pose_, Side::E, found_);
    source_ = std::make_unique<reference::ClippedElements>(clipped_.elements);
  }
}

std::vector<std::array<Index, 2>> ExactContact::elements() const {
  std::vector<std::array<Index, 2>> faces;
  for (std::size_t i = 0; i < source_->size(); ++i)
    faces.push_back({source_->pair(i).master_face, source_->pair(i).slave_face});
  std::sort(faces.begin(), faces.end());
  return faces;
}

const ExactContact::Computed& ExactContact::computed(mpfr_prec_t precision) {
  if (const auto known = computed_.find(precision); known != computed_.end()) return known->second;
  const BallField field{precision};
  reference::ConvertedPose<Ball> pose(pose_, field);
  const Ball zero = field(0.0);
  Computed sum{{pose.zero(), pose.zero(), zero, zero}, {zero, zero}};
  const ContactLaw law = stability_law();
  const reference::State<Ball> state = reference::state_of(pose_.pose(), Velocity{}, field);
  for (std::size_t i = 0; i < source_->size(); ++i) {
    const reference::ElementLoad<Ball> load =
        reference::load_of(source_->geometry(i, pose), Side::E, law, state, field);
    const Ball size = length_of(load.force);
    sum.values.force_Me = sum.values.force_Me + load.force;
    sum.values.torque_Me = sum.values.torque_Me + cross(load.arm, load.force);
    sum.values.penetration = max(sum.values.penetration, load.greatest_penetration);
    sum.scales.force = sum.scales.force + size;
    sum.scales.torque = sum.scales.torque + length_of(load.arm) * size;
  }
  for (const reference::FaceArea<Ball>& face : reference::face_areas(areas_, Side::E, pose))
    sum.values.area = sum.values.area + face.shares.counted * length_of(face.normal);
  return computed_.emplace(precision, std::move(sum)).first->second;
}

const Values& ExactContact::values(mpfr_prec_t precision) {
  return computed(precision).values;
}

const Scales& ExactContact::scales(mpfr_prec_t precision) {
  return computed(precision).scales;
}

Figures ExactContact::sizes() {
  return told([&](mpfr_prec_t precision) {
    const BallFigures sizes = sizes_of(values(precision), scales(precision));
    return as_doubles(sizes, sizes, {precision});
  });
}

Figures differences(ExactContact& truth, const fast::Contact& contact) {
  return told([&](mpfr_prec_t precision) { return differences_at(truth, values_of(contact, precision), precision); });
}

Figures differences(ExactContact& truth, ExactContact& other) {
  return told([&](mpfr_prec_t precision) { return differences_at(truth, other.values(precision), precision); });
}

}  // namespace pcm::compare::stability
