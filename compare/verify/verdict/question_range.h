// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pcm/inputs.h"

/// What can be asked: questions from files are refused as they are read, so that none is taken for a disagreement.
namespace pcm::compare {

/// The verdict's bounds are relative ones of products of up to two of the law's factors (stiffness, damping, friction)
/// with an area and a depth, or velocities: they hold as long as none of these products leaves the range of normal
/// doubles. Within these limits there is room for areas times depths from 2^-600 to 2^600.
inline constexpr double kLeastFactor = 0x1p-200, kGreatestFactor = 0x1p200;

/// A number of a law, with the key that files give it by, and what the verdict's bounds take beside 0 and infinity.
struct LawNumber {
  std::string_view key;
  double value;
  double least = kLeastFactor, greatest = kGreatestFactor;
};
std::vector<LawNumber> numbers_of(const ContactLaw& law);

/// Whether a law's number is 0, infinite or within these limits.
bool is_zero_infinite_or_between(double x, double least, double greatest);

/// Throws BadInput where the engine refuses the law, or where one of its numbers is out of range; that is called by
/// its key, or as `name` says.
void require_in_range(const ContactLaw& law, std::string (*name)(std::string_view key) = nullptr);
/// Throws BadInput where the engine, or one of its scenes, refuses the state.
void require_in_range(const Pose& pose, const Velocity& velocity);

}  // namespace pcm::compare
